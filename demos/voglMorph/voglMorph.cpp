// voglMorph: a volume twisted and bent. Each vertex says where it lies in the volume beside where it lies in
// space; between vertices both are interpolated.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

static double twist = 90, bend = 0;
static double lastTwist, lastBend; // that are drawn
static int gridSize = 8;
static bool pointer(vo::Button button, bool pressed, double x, double y);

const VoglProgram voglProgram = {
    .purpose = "Draws a volume out of shape: twisted about its z axis and bent over, by a grid of cells of\n"
               "five tetrahedra whose vertices are moved while the voxels at them stay.",
    .example = "head.tif -lut 80 120 -twist 120 -view 0 150",
    .options = {{"twist",
                 {"DEGREES"},
                 "turn the top against the bottom about the z axis (default 90)",
                 [](vo::Arguments& a) { twist = a.number(-3600, 3600, "an angle in degrees"); }},
                {"bend",
                 {"DEGREES"},
                 "bend both ends of the z axis towards -x, by this angle in all (default 0)",
                 [](vo::Arguments& a) { bend = a.number(-360, 360, "an angle in degrees"); }},
                {"grid",
                 {"N"},
                 "cells along each axis (default 8)",
                 [](vo::Arguments& a) { gridSize = a.integer(1, 32, "a number of cells"); }}},
    .keys = "Right drag    twist (to the right) and bend (up)\n",
    .pointer = pointer,
};

static VoglVolume volume;
static VoglPolygons* polygons;
static bool warpChanged = false;

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1]));
    return volume.bricks;
}

namespace {

const voInterleavedArrayType format = voInterleavedArrayTypeScope::T3F_V3F;
using Point = std::array<double, 3>;

// Where a point of the volume goes. Both are measured from its centre, in scaled units.
Point warp(const Point& p)
{
    const double height = volume.size[2] * double(modelScale[2]);
    const double turned = twist * std::numbers::pi / 180 * (p[2] / height);
    const double x = cos(turned) * p[0] - sin(turned) * p[1], y = sin(turned) * p[0] + cos(turned) * p[1];
    if (bend == 0) return {x, y, p[2]};
    const double radius = height / (bend * std::numbers::pi / 180); // of the arc that the axis becomes
    const double angle = p[2] / radius;
    return {(radius + x) * cos(angle) - radius, y, (radius + x) * sin(angle)};
}

// Fills in the positions that belong to the voxel coordinates. All stays in the sphere round the volume,
// which the view shows: what would leave it is drawn smaller.
void placeVertices(voVertexData& vertices)
{
    Point centre, scale{};
    for (std::size_t i = 0; i < 3; i++) {
        centre[i] = volume.size[i] / 2.0;
        scale[i] = double(modelScale[i]);
    }
    const double sphere = vo::boundingRadius({{2 * centre[0], 2 * centre[1], 2 * centre[2]}, scale});
    std::vector<Point> warped;
    double farthest = sphere;
    for (int vertex = 0; vertex < vertices.getCount(); vertex++) {
        Point p;
        for (std::size_t i = 0; i < 3; i++)
            p[i] = (double(vertices[vertex][i]) - centre[i]) * scale[i];
        warped.push_back(warp(p));
        farthest = std::max(farthest, std::hypot(warped.back()[0], warped.back()[1], warped.back()[2]));
    }
    for (int vertex = 0; vertex < vertices.getCount(); vertex++)
        for (std::size_t i = 0; i < 3; i++)
            vertices[vertex][3 + i] =
                float(warped[std::size_t(vertex)][i] * (sphere / farthest) / scale[i] + centre[i]);
}

// Six times the volume of a tetrahedron, negative when its vertices run the other way round.
double sixfoldVolume(voIndexedTetraSet* aTetraSet, int tetra, int column)
{
    double e[3][3];
    const float* first = (*aTetraSet)[4 * tetra] + column;
    for (int edge = 0; edge < 3; edge++)
        for (int i = 0; i < 3; i++)
            e[edge][i] = double((*aTetraSet)[4 * tetra + edge + 1][column + i]) - double(first[i]);
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
           e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

// Tetrahedra that were turned inside out lie where others lie, too.
bool foldsOver(voIndexedTetraSet* aTetraSet)
{
    for (int tetra = 0; tetra < aTetraSet->getIndices()->getCount() / 4; tetra++)
        if (sixfoldVolume(aTetraSet, tetra, 0) * sixfoldVolume(aTetraSet, tetra, 3) <= 0) return true;
    return false;
}

// A grid of cells, each cut into five tetrahedra. Neighbours are cut as mirror images, so that the diagonals
// of the face between them are one: faces of moved vertices are not flat.
voIndexedTetraSet* makeGrid(int n)
{
    static const int even[] = {0, 3, 5, 6, 1, 0, 3, 5, 2, 0, 3, 6, 4, 0, 5, 6, 7, 3, 5, 6};
    const int line = n + 1, plane = line * line;
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(plane * line, 6, 20 * n * n * n);
    voVertexData& vertices = *aTetraSet->getVertexData();
    vertices.setCount(plane * line);
    for (int vertex = 0; vertex < plane * line; vertex++) {
        const int at[3] = {vertex % line, vertex / line % line, vertex / plane};
        for (int i = 0; i < 3; i++)
            vertices[vertex][i] = float(double(at[i]) * volume.size[i] / n);
    }
    voIndices& indices = *aTetraSet->getIndices();
    indices.setCount(20 * n * n * n);
    for (int cell = 0; cell < n * n * n; cell++) {
        const int x = cell % n, y = cell / n % n, z = cell / (n * n);
        const int mirrored = (x + y + z) % 2; // in x, which is the lowest bit of a corner's number
        for (int i = 0; i < 20; i++) {
            const int corner = even[i] ^ mirrored;
            indices[20 * cell + i] =
                (z + (corner >> 2)) * plane + (y + (corner >> 1 & 1)) * line + x + (corner & 1);
        }
    }
    return aTetraSet;
}

} // namespace

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    voIndexedTetraSet* aTetraSet = makeGrid(gridSize);
    placeVertices(*aTetraSet->getVertexData());
    if (foldsOver(aTetraSet))
        voglFail("voglMorph",
                 "options -twist, -bend and -grid: expected less of the first two, or more cells; "
                 "the volume would fold over itself");
    lastTwist = twist;
    lastBend = bend;
    polygons = new VoglPolygons(aTetraSet, volume, format);
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

// The warp that the pointer asked for; one that folds over is not taken.
static void changeWarp(voIndexedTetraSet* aTetraSet)
{
    placeVertices(*aTetraSet->getVertexData());
    if (foldsOver(aTetraSet)) {
        twist = lastTwist;
        bend = lastBend;
        placeVertices(*aTetraSet->getVertexData());
    }
    lastTwist = twist;
    lastBend = bend;
    warpChanged = false;
    delete polygons;
    polygons = new VoglPolygons(aTetraSet, volume, format);
}

static bool pointer(vo::Button button, bool, double x, double y)
{
    if (button != vo::Button::Right) return false;
    twist = 360 * (x - 0.5);
    bend = 180 * (y - 0.5);
    warpChanged = true;
    return true;
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    if (warpChanged) changeWarp(aTetraSet);
    voglDrawFrame(aTetraSet, aVolume, *polygons);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete polygons;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
