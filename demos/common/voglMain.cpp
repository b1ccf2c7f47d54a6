// The main program of the vogl demos: command line, trackball, table, window or picture, times.
#include "voglMain.h"

#include "frame_times.h"
#include "screen.h"
#include "trackball.h"
#include "voglLookup.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>
#include <vector>

vo::Options options;
float modelScale[3] = {1, 1, 1};
voutTimer polygonizeTimer, uploadTimer, drawTimer;

namespace {

voIndexedTetraSet* aTetraSet;
voBrickSetCollection* aVolume;
std::string programName;
vo::Model model;
vo::Orientation orientation;
vo::Trackball trackball;
std::vector<vo::FrameTime> frameTimes;
bool errorSeen = false;

const char* const kKeys =
    "Left drag     turn the volume\n"
    "Middle drag   move the table's center (to the right) and width (down); not with -lutFile\n"
    "r             back to the first view\n"
    "w             outlines on and off\n"
    "h             print this list\n"
    "Escape        leave\n";

void printHelp()
{
    const char* name = programName.c_str();
    std::printf("Usage: %s [OPTION...] VOLUME.tif\n\n"
                "Draws a volume in a window; with -output, or where there is no display, into a picture.\n\n"
                "Example: %s head.tif -color -lutFile brain.lut -view 0 180 -output head.png\n\n"
                "Options may stand anywhere and may be abbreviated.\n%s\nIn the window:\n%s",
                name, name, vo::optionsHelp(vo::OptionSet::All).c_str(), kKeys);
}

/// Longitudes that end where they began, one step a frame.
void turnOnce()
{
    const int frame = int(frameTimes.size()) + 1;
    const double turned = frame == options.frames ? 0 : 360.0 * frame / options.frames;
    orientation.longitude = options.longitude + turned;
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\rframe %d of %d ", frame, options.frames);
}

void noteTime(double seconds)
{
    frameTimes.push_back(
        {seconds, polygonizeTimer.getSeconds(), uploadTimer.getSeconds(), drawTimer.getSeconds()});
    if (int(frameTimes.size()) != options.frames) return;
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r");
    std::printf("%s\n", vo::describeFrameTimes(frameTimes).c_str());
    std::fflush(stdout);
}

void initialize()
{
    my_InitGfx(aTetraSet, aVolume);
}

bool draw(int width, int height)
{
    if (options.frames > 0) turnOnce();
    for (voutTimer* timer : {&polygonizeTimer, &uploadTimer, &drawTimer})
        timer->reset();
    voutTimer whole;
    whole.start();

    gl->Enable(GL_DEPTH_TEST);
    gl->ClearColor(0, 0, 0, 1);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const vo::ViewVolume view = vo::viewVolume(model, options.perspective, width, height);
    vo::loadProjection(view);
    vo::loadModelView(model, orientation, view);
    my_DrawVolume(aTetraSet, aVolume);

    drawTimer.start();
    gl->Finish();
    drawTimer.stop();
    whole.stop();
    if (options.frames > 0) noteTime(whole.getSeconds());
    return !errorSeen;
}

void cleanup()
{
    my_Cleanup(aTetraSet, aVolume);
}

void press(vo::Button button, double x, double y)
{
    if (button == vo::Button::Left) trackball.press(x, y, orientation);
}

void drag(vo::Button button, double x, double y, int width, int height)
{
    if (button == vo::Button::Left) orientation = trackball.drag(x, y);
    if (button == vo::Button::Middle) moveLookupRamp(x / width, 2 * y / height);
}

bool key(int code)
{
    switch (code) {
    case vo::kEscapeKey: return false;
    case 'h': std::printf("%s", kKeys); break;
    case 'r': orientation = {options.latitude, options.longitude}; break;
    case 'w': options.wireframe = !options.wireframe; break;
    default: break;
    }
    std::fflush(stdout);
    return true;
}

/// Reads the command line; what is wrong with it, if anything.
std::string readCommandLine(int argc, char** argv)
{
    const auto parsed = vo::parseOptions({argv + 1, argv + argc}, vo::OptionSet::All);
    if (!parsed) return parsed.failure().text;
    options = *parsed;
    if (options.help || options.version || options.files.size() == 1) return "";
    std::string found;
    for (const std::string& file : options.files)
        found += " " + file;
    return "expected the file of one volume (-help says more), found" +
           (found.empty() ? " none" : ":" + found);
}

void initModel()
{
    int size[3];
    aVolume->getCurrentBrickSet()->getVolumeSizes(size[0], size[1], size[2]);
    for (std::size_t i = 0; i < 3; ++i)
        model.size[i] = size[i];
    model.scale = options.scale;
    orientation = {options.latitude, options.longitude};
}

} // namespace

void my_ExceptionHandler(void)
{
    const int number = voError::getErrorNumber();
    const char* text = voError::getErrorString();
    std::fprintf(stderr, "%s: OpenGL Volumizer error %d: %s\n", programName.c_str(), number,
                 text ? text : "");
    errorSeen = true;
}

int main(int argc, char** argv)
{
    programName = argc > 0 ? argv[0] : "vogl";
    programName = programName.substr(programName.rfind('/') + 1);
    if (const std::string wrong = readCommandLine(argc, argv); !wrong.empty()) {
        std::fprintf(stderr, "%s: %s\n", programName.c_str(), wrong.c_str());
        return 1;
    }
    if (options.help) printHelp();
    if (options.version) std::printf("%s\n", voVersion());
    if (options.help || options.version) return vo::flushOutput(programName.c_str());
    for (int i = 0; i < 3; ++i)
        modelScale[i] = float(options.scale[std::size_t(i)]);

    voError::setErrorHandler(my_ExceptionHandler);
    char* arguments[] = {programName.data(), options.files[0].data(), nullptr};
    aVolume = my_InitAppearance(2, arguments);
    aTetraSet = my_InitGeometry(aVolume);
    if (errorSeen) return 1;
    initModel();
    const int shown = vo::showOnScreen({.program = programName,
                                        .width = options.width,
                                        .height = options.height,
                                        .core = options.core,
                                        .output = options.output,
                                        .frames = options.frames},
                                       {.initialize = initialize,
                                        .draw = draw,
                                        .cleanup = cleanup,
                                        .press = press,
                                        .drag = drag,
                                        .key = key});
    return shown ? shown : vo::flushOutput(programName.c_str());
}
