// voglSphere: a ball cut out of a volume.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <vo/utSolids.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

static std::optional<double> radius;
static std::optional<std::array<double, 3>> center;
static int level = 3;
static std::optional<std::array<int, 2>> slicesAndStacks;
static bool pointer(vo::Button button, bool pressed, double x, double y);

static void readCenter(vo::Arguments& arguments)
{
    for (double& coordinate : center.emplace())
        coordinate = arguments.number(-1e6, 1e6, "a place in voxels");
}

static void readSlices(vo::Arguments& arguments)
{
    const int slices = arguments.integer(3, 512, "a number of slices");
    slicesAndStacks = {slices, arguments.integer(2, 512, "a number of stacks")};
}

const VoglProgram voglProgram = {
    .purpose =
        "Draws a ball of a volume: tetrahedra from its centre to the triangles of an icosahedron that\n"
        "was refined -level times, or to those of -slices.",
    .example = "head.tif -lut 80 120 -radius 55 -view 10 125",
    .options = {{"radius",
                 {"R"},
                 "radius in units of -scale (default: half of the volume's shortest side)",
                 [](vo::Arguments& a) { radius = a.number(1e-3, 1e6, "a length"); }},
                {"center",
                 {"X", "Y", "Z"},
                 "centre in voxels, inside the volume (default: that of the volume)",
                 readCenter},
                {"level",
                 {"N"},
                 "each level makes four triangles of one, beginning with 20 (default 3)",
                 [](vo::Arguments& a) { level = a.integer(0, 5, "a level"); }},
                {"slices",
                 {"SLICES", "STACKS"},
                 "instead of an icosahedron: slices round an axis along z and stacks along it",
                 readSlices}},
    .keys = "Right drag    radius (up)\n",
    .pointer = pointer,
};

static VoglVolume volume;
static VoglPolygons* polygons;
static bool radiusChanged = false;

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1]));
    return volume.bricks;
}

namespace {

// The records of a ball of radius 1 about the origin.
std::vector<float> unitBall;

voIndexedTetraSet* makeUnitBall()
{
    std::unique_ptr<voutGeometry> ball;
    if (slicesAndStacks)
        ball = std::make_unique<voutSphere>(0.f, 0.f, 0.f, 1.f, (*slicesAndStacks)[0], (*slicesAndStacks)[1]);
    else
        ball = std::make_unique<voutGeoSphere>(0.f, 0.f, 0.f, 1.f, level);
    voIndexedTetraSet* tetras = ball->tessellate();
    const float* records = tetras->getVertexData()->getDataPtr();
    unitBall.assign(records, records + 3 * tetras->getVertexData()->getCount());
    return tetras;
}

// Puts the vertices of the unit ball where the options want them.
void placeVertices(voVertexData& vertices)
{
    for (int vertex = 0; vertex < vertices.getCount(); vertex++)
        for (std::size_t i = 0; i < 3; i++) {
            const double reach = *radius * double(unitBall[std::size_t(3 * vertex) + i]);
            vertices[vertex][i] = float((*center)[i] + reach / double(modelScale[i]));
        }
}

// Centre and radius where the options say none, and what is wrong with those that they say.
void checkBall()
{
    const std::array<double, 3> size{double(volume.size[0]), double(volume.size[1]), double(volume.size[2])};
    std::array<double, 3> scaled{};
    for (std::size_t i = 0; i < 3; i++)
        scaled[i] = size[i] * double(modelScale[i]);
    if (!center) center = {size[0] / 2, size[1] / 2, size[2] / 2};
    if (!radius) radius = std::min({scaled[0], scaled[1], scaled[2]}) / 2;
    const double diagonal = std::hypot(scaled[0], scaled[1], scaled[2]);
    char text[200];
    for (std::size_t i = 0; i < 3; i++) {
        if ((*center)[i] >= 0 && (*center)[i] <= size[i]) continue;
        snprintf(text, sizeof text, "option -center: expected a place from 0 0 0 to %g %g %g, found %g %g %g",
                 size[0], size[1], size[2], (*center)[0], (*center)[1], (*center)[2]);
        voglFail("voglSphere", text);
    }
    if (*radius <= diagonal) return;
    snprintf(text, sizeof text, "option -radius: expected at most %g, the volume's diagonal, found %g",
             diagonal, *radius);
    voglFail("voglSphere", text);
}

// The planes that cut the ball, which may be larger than the volume.
void makePolygons(voIndexedTetraSet* aTetraSet)
{
    delete polygons;
    polygons = new VoglPolygons(aTetraSet, volume, voInterleavedArrayTypeScope::V3F);
}

} // namespace

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    checkBall();
    voIndexedTetraSet* aTetraSet = makeUnitBall();
    placeVertices(*aTetraSet->getVertexData());
    // The ball may be larger than the volume, and is cut by more planes then.
    volume.maxSamplesNumber = 2 * volume.maxSamplesNumber;
    makePolygons(aTetraSet);
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

static bool pointer(vo::Button button, bool, double, double y)
{
    if (button != vo::Button::Right) return false;
    radius = std::max(y, 0.01) * vo::boundingRadius(voglView().model);
    radiusChanged = true;
    return true;
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    if (radiusChanged) {
        placeVertices(*aTetraSet->getVertexData());
        makePolygons(aTetraSet);
        radiusChanged = false;
    }
    voglDrawFrame(aTetraSet, aVolume, *polygons);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete polygons;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
