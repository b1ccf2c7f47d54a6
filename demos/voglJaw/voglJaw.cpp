// voglJaw: a part of a volume that a closed surface bounds, with a place and a table of its own, and the rest
// of the volume without it (guide, pages 14-16: the jaw of a head is a part with its own transformation).
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <vo/utClosedSurface.h>
#include <vo/utParts.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

static std::string partTable;
static std::array<double, 3> shift{};
static double degrees = 0;
static std::optional<std::array<double, 3>> pivot;
static std::optional<double> edgeLength;
static bool isPartAlone = false, isRestAlone = false;

static std::array<double, 3> readPlace(vo::Arguments& arguments)
{
    std::array<double, 3> place;
    for (double& coordinate : place)
        coordinate = arguments.number(-1e6, 1e6, "a place in voxels");
    return place;
}

const VoglProgram voglProgram = {
    .purpose =
        "Draws a part of a volume, which the closed surface in a file (OFF, PLY, STL or OBJ, in voxels)\n"
        "bounds, with a place and a table of its own, and the rest of the volume without it.",
    .arguments = "VOLUME SURFACE",
    .example = "skull.tif skull-jaw.off -lutFile bone.lut -open 20",
    .leastArguments = 2,
    .mostArguments = 2,
    .expected = "the files of one volume and one surface",
    .options = {{"move",
                 {"X", "Y", "Z"},
                 "moves the part by so many voxels",
                 [](vo::Arguments& a) { shift = readPlace(a); }},
                {"open",
                 {"DEGREES"},
                 "turns the part about an axis along x, its front down",
                 [](vo::Arguments& a) { degrees = a.number(-360, 360, "an angle"); }},
                {"pivot",
                 {"X", "Y", "Z"},
                 "a voxel on that axis (default: where the part's top and back are)",
                 [](vo::Arguments& a) { pivot = readPlace(a); }},
                {"partLut",
                 {"FILE"},
                 "the part's table (default: that of the rest, in orange)",
                 [](vo::Arguments& a) { partTable = a.text(); }},
                {"edge",
                 {"LENGTH"},
                 "about how long edges of tetrahedra are, in voxels (default: a twentieth of the part)",
                 [](vo::Arguments& a) { edgeLength = a.number(1e-2, 1e6, "a length"); }},
                {"part", {}, "draws the part alone", [](vo::Arguments&) { isPartAlone = true; }},
                {"rest", {}, "draws the rest alone", [](vo::Arguments&) { isRestAlone = true; }}},
    .ownLoop = true,
};

static VoglVolume volume;
static VoglLookup partLookup;
static std::string surfaceFile;
static voIndexedTetraSet *part, *rest;
static voutParts* scene;
static int partNumber, restNumber;

// Its own, or the rest's in another colour.
static void readPartTable(const char* program)
{
    if (!partTable.empty()) {
        partLookup.read(program, partTable, std::nullopt);
        return;
    }
    partLookup.setTint(1, 0.55f, 0.15f);
    partLookup.read(program, options.lutFile, options.lut);
    partLookup.tintFile(1, 0.55f, 0.15f);
}

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    if (isPartAlone && isRestAlone) voglFail(argv[0], "-part and -rest exclude each other");
    surfaceFile = argv[2];
    readPartTable(argv[0]);
    const bool isColored = readLookupTable(argv[0]) == voRenderingModeScope::COLOR ||
                           partLookup.renderingMode() == voRenderingModeScope::COLOR;
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1]),
                            isColored ? voRenderingModeScope::COLOR : voRenderingModeScope::MONOCHROME);
    const int size[3] = {2 * volume.size[0], 2 * volume.size[1], 2 * volume.size[2]}; // room to move
    volume.maxSamplesNumber = voglCountPlanes(argv[0], size);
    return volume.bricks;
}

namespace {

[[noreturn]] void failAtSurface()
{
    const char* text = voError::getErrorString();
    voglFail("voglJaw", surfaceFile + ": " + (text ? text : "no tetrahedra"));
}

// The surface's errors are told in one line that names its file.
class OwnErrors
{
public:
    OwnErrors() : before_(voError::setErrorHandler(nullptr)) {}
    ~OwnErrors() { voError::setErrorHandler(before_); }

private:
    void (*before_)(void);
};

// Both sets from one mesh: they share the triangles between them.
void divideVolume()
{
    const OwnErrors ownErrors;
    voutClosedSurface surface(surfaceFile.c_str());
    if (surface.getVolume() == 0) failAtSurface();
    if (edgeLength) surface.setEdgeLength(float(*edgeLength));
    const float lower[3] = {0, 0, 0};
    const float upper[3] = {float(volume.size[0]), float(volume.size[1]), float(volume.size[2])};
    if (surface.tessellateInBox(lower, upper, part, rest)) failAtSurface();
    if (pivot) return;
    float partLower[3], partUpper[3];
    surface.getBounds(partLower, partUpper);
    pivot = {double(partLower[0]), double(partLower[1]), double(partUpper[2])};
}

// Turned where voxels have their spacing, so that the part keeps its shape.
std::array<GLdouble, 16> partMatrix()
{
    const double angle = -degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const double ratio = double(modelScale[1]) / double(modelScale[2]);
    const auto [px, py, pz] = *pivot;
    // y' = c (y - py) - s (z - pz) / ratio, z' = s ratio (y - py) + c (z - pz)
    return {1,
            0,
            0,
            0, //
            0,
            c,
            s * ratio,
            0, //
            0,
            -s / ratio,
            c,
            0, //
            shift[0],
            shift[1] + py - c * py + s / ratio * pz,
            shift[2] + pz - s * ratio * py - c * pz,
            1};
}

} // namespace

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    divideVolume();
    scene = new voutParts;
    restNumber = scene->add(rest, voInterleavedArrayTypeScope::V3F, volume.bricks);
    partNumber = scene->add(part, voInterleavedArrayTypeScope::V3F, volume.bricks);
    scene->setMatrix(partNumber, partMatrix().data());
    if (isPartAlone) scene->setVisible(restNumber, VO_FALSE);
    if (isRestAlone) scene->setVisible(partNumber, VO_FALSE);
    return rest;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
    partLookup.make(volume.bricks, volume.renderingMode, volume.loValue, volume.hiValue);
}

// The tetrahedra of the part, where it is now.
static void drawOutlines()
{
    GLdouble model[16], projection[16], own[16] = {};
    vo::getMatrices(model, projection);
    const auto matrix = partMatrix();
    for (std::size_t column = 0; column < 4; column++)
        for (std::size_t row = 0; row < 4; row++)
            for (std::size_t i = 0; i < 4; i++)
                own[4 * column + row] += model[4 * i + row] * matrix[4 * column + i];
    vo::loadMatrices(own, projection);
    voglDrawOutlines(part, volume.bricks, voInterleavedArrayTypeScope::V3F);
    vo::loadMatrices(model, projection);
}

void my_DrawVolume(voIndexedTetraSet*, voBrickSetCollection* aVolume)
{
    voglChooseStack(aVolume);
    drawOutlines();
    scene->setLookupTable(restNumber, voglLookup().get());
    scene->setLookupTable(partNumber, partLookup.get());
    GLdouble model[16], projection[16];
    vo::getMatrices(model, projection);
    float period[3];
    voglSamplingPeriod(period);
    voglBeginBlending();
    drawTimer.start();
    scene->draw(model, projection, voglSamplingMode(aVolume),
                options.viewSpace ? voSamplingSpaceScope::VIEW_VOLUME : voSamplingSpaceScope::OBJECT, period,
                volume.maxSamplesNumber);
    drawTimer.stop();
    voglEndBlending();
}

void my_Cleanup(voIndexedTetraSet*, voBrickSetCollection*)
{
    delete scene;
    delete rest;
    delete part;
    partLookup.free();
    deleteLookupTable();
    voglFreeVolume(volume);
}
