// voglSimple: the smallest program that shows a volume from a file and lets the mouse turn it (guide, chapter
// 4).

// Before any header of <vo/...>.
#include "gl.h"

#include "volume_view/options.h"
#include "screen.h"

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

#include <algorithm>
#include <cmath>
#include <stdio.h>
#include <string>

voIndexedTetraSet* aTetraSet;  // the volume's shape
voBrickSetCollection* aVolume; // the volume's appearance

float modelCentroid[3];
float modelRadius; // half the diagonal
float modelScale[3] = {1.0, 1.0, 1.0};
bool wireframe = false;

double latitude = 0, longitude = 0, lastLatitude = 0, lastLongitude = 0;
double lastX = 0, lastY = 0;
bool errorSeen = false;

extern voBrickSetCollection* my_InitAppearance(int argc, char** argv);
extern voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*);
extern void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*);
extern void my_Draw(voIndexedTetraSet*, voBrickSetCollection*);
extern void my_Cleanup(voIndexedTetraSet*, voBrickSetCollection*);

static void my_ExceptionHandler(void)
{
    const int number = voError::getErrorNumber();
    fprintf(stderr, "OpenGL Volumizer error %d: %s\n", number, voError::getErrorString());
    errorSeen = true;
}

static void Initialize()
{
    my_InitGfx(aTetraSet, aVolume);
}

static bool Draw(int width, int height)
{
    gl->MatrixMode(GL_PROJECTION);
    gl->LoadIdentity();
    const double unit = double(modelRadius) / std::min(width, height);
    gl->Ortho(-unit * width, unit * width, -unit * height, unit * height, -2 * modelRadius, 2 * modelRadius);
    gl->MatrixMode(GL_MODELVIEW);

    gl->Enable(GL_DEPTH_TEST);
    gl->ClearColor(0.0, 0.0, 0.0, 1.0);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->LoadIdentity();
    gl->Rotated(-latitude - 90, 1.0, 0.0, 0.0);
    gl->Rotated(-longitude, 0.0, 0.0, 1.0);
    gl->Scalef(modelScale[0], modelScale[1], modelScale[2]);
    gl->Translatef(-modelCentroid[0], -modelCentroid[1], -modelCentroid[2]);

    my_Draw(aTetraSet, aVolume);
    return !errorSeen;
}

static void Cleanup()
{
    my_Cleanup(aTetraSet, aVolume);
}

static bool KeybdInput(int key)
{
    if (key == 'h') printf("Left drag   turn the volume\nh           print this list\nEscape      leave\n");
    return key != vo::kEscapeKey;
}

static void ButtonInput(vo::Button, double x, double y, int, int)
{
    lastLatitude = latitude;
    lastLongitude = longitude;
    lastX = x;
    lastY = y;
}

static void MotionInput(vo::Button button, double x, double y, int, int)
{
    if (button != vo::Button::Left) return;
    latitude = lastLatitude + (lastY - y) / 10.0;
    longitude = lastLongitude + (lastX - x) / 10.0;
}

static void centerModel()
{
    int size[3];
    aVolume->getCurrentBrickSet()->getVolumeSizes(size[0], size[1], size[2]);
    for (int i = 0; i < 3; i++)
        modelCentroid[i] = float(size[i]) / 2;
    modelRadius = std::hypot(modelCentroid[0], modelCentroid[1], modelCentroid[2]);
}

int main(int argc, char** argv)
{
    const auto parsed = vo::parseOptions({argv + 1, argv + argc}, vo::OptionSet::Simple);
    if (!parsed || (parsed->files.size() != 1 && !parsed->help && !parsed->version)) {
        fprintf(stderr, "voglSimple: %s\n",
                parsed ? "expected the file of one volume (-help says more)" : parsed.failure().text.c_str());
        return 1;
    }
    vo::Options options = *parsed;
    if (options.help || options.version) {
        printf("%s\n", options.version
                           ? voVersion()
                           : ("Usage: voglSimple [OPTION...] VOLUME.tif\n\nExample: voglSimple head.tif "
                              "-view 0 180 -output head.png\n\n" +
                              vo::optionsHelp(vo::OptionSet::Simple))
                                 .c_str());
        return vo::flushOutput("voglSimple");
    }
    latitude = options.latitude;
    longitude = options.longitude;
    wireframe = options.wireframe;

    voError::setErrorHandler(my_ExceptionHandler);
    char* arguments[] = {argv[0], options.files[0].data(), nullptr};
    aVolume = my_InitAppearance(2, arguments);
    aTetraSet = my_InitGeometry(aVolume);
    if (errorSeen) return 1;
    centerModel();
    return vo::showOnScreen(
        {.program = "voglSimple", .width = options.width, .height = options.height, .output = options.output},
        {.initialize = Initialize,
         .draw = Draw,
         .cleanup = Cleanup,
         .press = ButtonInput,
         .drag = MotionInput,
         .key = KeybdInput});
}
