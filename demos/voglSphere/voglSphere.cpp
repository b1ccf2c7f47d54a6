// voglSphere: a ball cut out of a volume.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

static std::optional<double> radius;
static std::optional<std::array<double, 3>> center;
static int level = 3;
static bool pointer(vo::Button button, bool pressed, double x, double y);

static void readCenter(vo::Arguments& arguments)
{
    for (double& coordinate : center.emplace())
        coordinate = arguments.number(-1e6, 1e6, "a place in voxels");
}

const VoglProgram voglProgram = {
    .purpose =
        "Draws a ball of a volume: tetrahedra from its centre to the triangles of an icosahedron that\n"
        "was refined -level times.",
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
                 [](vo::Arguments& a) { level = a.integer(0, 5, "a level"); }}},
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

using Direction = std::array<double, 3>;

Direction unit(const Direction& d)
{
    const double length = std::hypot(d[0], d[1], d[2]);
    return {d[0] / length, d[1] / length, d[2] / length};
}

// A unit sphere of triangles: three vertex numbers each.
struct Triangles
{
    std::vector<Direction> vertices;
    std::vector<int> indices;
};

Triangles icosahedron()
{
    const double g = (1 + std::sqrt(5.0)) / 2; // golden ratio
    Triangles result{{{-1, g, 0},
                      {1, g, 0},
                      {-1, -g, 0},
                      {1, -g, 0},
                      {0, -1, g},
                      {0, 1, g},
                      {0, -1, -g},
                      {0, 1, -g},
                      {g, 0, -1},
                      {g, 0, 1},
                      {-g, 0, -1},
                      {-g, 0, 1}},
                     {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                      4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                      6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1}};
    for (Direction& vertex : result.vertices)
        vertex = unit(vertex);
    return result;
}

// Four triangles for each one; the middles of the edges are moved out to the sphere.
Triangles refined(const Triangles& coarse)
{
    Triangles fine{coarse.vertices, {}};
    std::map<std::pair<int, int>, int> middles; // an edge belongs to two triangles
    const auto middle = [&](int a, int b) {
        const auto [found, isNew] = middles.try_emplace(std::minmax(a, b), int(fine.vertices.size()));
        if (isNew) {
            const Direction p = fine.vertices[std::size_t(a)], q = fine.vertices[std::size_t(b)];
            fine.vertices.push_back(unit({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
        }
        return found->second;
    };
    for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
        const int a = coarse.indices[i], b = coarse.indices[i + 1], c = coarse.indices[i + 2];
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        fine.indices.insert(fine.indices.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    return fine;
}

Triangles sphere;

// Puts the vertices on the sphere that is asked for; the last one is its centre.
void placeVertices(voVertexData& vertices)
{
    const int count = int(sphere.vertices.size());
    for (int vertex = 0; vertex <= count; vertex++)
        for (std::size_t i = 0; i < 3; i++) {
            const double reach = vertex < count ? *radius * sphere.vertices[std::size_t(vertex)][i] : 0;
            vertices[vertex][i] = float((*center)[i] + reach / double(modelScale[i]));
        }
}

// Centre and radius where the options say none, and what is wrong with those that they say.
void checkBall()
{
    const Direction size{double(volume.size[0]), double(volume.size[1]), double(volume.size[2])};
    Direction scaled{};
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
    sphere = icosahedron();
    for (int i = 0; i < level; i++)
        sphere = refined(sphere);

    const int vertexCount = int(sphere.vertices.size()) + 1;
    const int tetraCount = int(sphere.indices.size()) / 3;
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(vertexCount, 3, 4 * tetraCount);
    for (int tetra = 0; tetra < tetraCount; tetra++) {
        for (int corner = 0; corner < 3; corner++)
            (*aTetraSet->getIndices())[4 * tetra + corner] = sphere.indices[std::size_t(3 * tetra + corner)];
        (*aTetraSet->getIndices())[4 * tetra + 3] = vertexCount - 1;
    }
    placeVertices(*aTetraSet->getVertexData());
    aTetraSet->getVertexData()->setCount(vertexCount);
    aTetraSet->getIndices()->setCount(4 * tetraCount);
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
