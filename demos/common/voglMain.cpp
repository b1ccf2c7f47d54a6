// The main program of the vogl demos: command line, trackball, table, window or picture, times.
#include "voglMain.h"

#include "frame_times.h"
#include "screen.h"
#include "trackball.h"
#include "voglLookup.h"

#include "volume_view/defaults.h"
#include "volume_view/frame_names.h"

#include <algorithm>
#include <array>
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
VoglView view;
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

void printKeys()
{
    std::printf("%s%s", voglProgram.keys, kKeys);
}

void printHelp()
{
    const char* name = programName.c_str();
    std::printf("Usage: %s [OPTION...] %s\n\n%s\n\nExample: %s %s\n\n"
                "Options may stand anywhere and may be abbreviated.\n%s\nIn the window:\n",
                name, voglProgram.arguments, voglProgram.purpose, name, voglProgram.example,
                vo::optionsHelp(vo::OptionSet::All, voglProgram.options).c_str());
    printKeys();
}

/// Longitudes that end where they began, one step a frame.
void turnOnce()
{
    const int frame = int(frameTimes.size()) + 1;
    const double turned = frame == options.frames ? 0 : 360.0 * frame / options.frames;
    view.orientation.longitude = options.longitude + turned;
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
    view.width = width;
    view.height = height;
    view.volume = vo::viewVolume(view.model, options.perspective, width, height);
    vo::loadProjection(view.volume);
    vo::loadModelView(view.model, view.orientation, view.volume);
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

bool forProgram(vo::Button button, bool pressed, double x, double y, int width, int height)
{
    return voglProgram.pointer && voglProgram.pointer(button, pressed, x / width, 1 - y / height);
}

void press(vo::Button button, double x, double y, int width, int height)
{
    if (forProgram(button, true, x, y, width, height)) return;
    if (button == vo::Button::Left) trackball.press(x, y, view.orientation);
}

void drag(vo::Button button, double x, double y, int width, int height)
{
    if (forProgram(button, false, x, y, width, height)) return;
    if (button == vo::Button::Left) view.orientation = trackball.drag(x, y);
    if (button == vo::Button::Middle) moveLookupRamp(x / width, 2 * y / height);
}

bool key(int code)
{
    if (voglProgram.key && voglProgram.key(code)) return true;
    switch (code) {
    case vo::kEscapeKey: return false;
    case 'h': printKeys(); break;
    case 'r': view.orientation = {options.latitude, options.longitude}; break;
    case 'w': options.wireframe = !options.wireframe; break;
    default: break;
    }
    std::fflush(stdout);
    return true;
}

/// Reads the command line; what is wrong with it, if anything.
std::string readCommandLine(int argc, char** argv)
{
    const auto parsed = vo::parseOptions({argv + 1, argv + argc}, vo::OptionSet::All, voglProgram.options);
    if (!parsed) return parsed.failure().text;
    options = *parsed;
    if (options.frames > 0)
        if (const auto named = vo::checkFrameName("-output", options.output); !named)
            return named.failure().text;
    const int count = int(options.files.size());
    if (options.help || options.version ||
        (count >= voglProgram.leastArguments && count <= voglProgram.mostArguments))
        return "";
    std::string found;
    for (const std::string& file : options.files)
        found += " " + file;
    return std::string("expected ") + voglProgram.expected + " (-help says more), found" +
           (found.empty() ? " none" : ":" + found);
}

/// The volume's, or without one where the tetrahedra end.
std::array<double, 3> sceneSize()
{
    std::array<double, 3> size{1, 1, 1};
    if (aVolume) {
        int voxels[3];
        aVolume->getCurrentBrickSet()->getVolumeSizes(voxels[0], voxels[1], voxels[2]);
        std::copy_n(voxels, 3, size.begin());
        return size;
    }
    voVertexData& vertices = *aTetraSet->getVertexData();
    for (int vertex = 0; vertex < vertices.getCount(); ++vertex)
        for (std::size_t i = 0; i < 3; ++i)
            size[i] = std::max(size[i], double(vertices[vertex][vertices.getValuesPerVertex() - 3 + int(i)]));
    return size;
}

void initModel()
{
    const std::array<double, 3> size = sceneSize();
    for (std::size_t i = 0; i < 3; ++i) {
        view.model.size[i] = size[i];
        view.model.scale[i] = double(modelScale[i]);
    }
    view.model.margin = voglProgram.margin;
    view.orientation = {options.latitude, options.longitude};
}

} // namespace

const VoglView& voglView()
{
    return view;
}

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
    for (std::size_t i = 0; options.scale && i < 3; ++i)
        modelScale[i] = float((*options.scale)[i]);

    if (voglProgram.ownLoop && options.engine == vo::Options::Engine::Cast)
        std::fprintf(stderr, "%s: draws its polygons in a loop of its own; -engine cast changes nothing\n",
                     programName.c_str());

    voError::setErrorHandler(my_ExceptionHandler);
    std::vector<char*> arguments{programName.data()};
    for (std::string& file : options.files)
        arguments.push_back(file.data());
    arguments.push_back(nullptr);
    aVolume = my_InitAppearance(int(arguments.size()) - 1, arguments.data());
    aTetraSet = my_InitGeometry(aVolume);
    if (errorSeen) return 1;
    if (const std::string vain = vo::withoutEffect(options); !vain.empty())
        std::fprintf(stderr, "%s: %s\n", programName.c_str(), vain.c_str());
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
