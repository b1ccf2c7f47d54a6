// Sets and strips of cells, by what holds of their tetrahedra: see tetra_checks.h.
#include "tetra_checks.h"

#include "../legacy/expect_error.h"

#include <vo/utGeometry.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <type_traits>

namespace {

using namespace vo::test;
using glm::dvec3;

/// Vertices with values that depend on the place linearly, and cells on them.
struct Mesh
{
    explicit Mesh(int valuesPerVertex = 3) : values(valuesPerVertex) {}

    int values;
    std::vector<float> records;
    std::vector<int> indices;

    int vertexCount() const { return static_cast<int>(records.size()) / values; }
    int indexCount() const { return static_cast<int>(indices.size()); }

    static double valueAt(int column, const dvec3& p)
    {
        return 0.1 * column + (column % 3 - 0.5) * p.x + 0.3 * p.y - 0.2 * column * p.z;
    }
    int add(const dvec3& p)
    {
        for (int column = 0; column < values - 3; ++column)
            records.push_back(static_cast<float>(valueAt(column, p)));
        for (int axis = 0; axis < 3; ++axis)
            records.push_back(static_cast<float>(p[axis]));
        return vertexCount() - 1;
    }
    void addCell(const std::vector<int>& corners)
    {
        indices.insert(indices.end(), corners.begin(), corners.end());
    }
};

template <typename Set>
Tetras tetrasOf(const Mesh& mesh)
{
    Set set(mesh.records.data(), mesh.vertexCount(), mesh.values, mesh.indices.data(), mesh.indexCount());
    const Tetras tetras = taken(set.tessellate());
    expectNoError();
    return tetras;
}

template <typename Set>
Tetras hexasBy(const Mesh& mesh, int tetrasPerHexa)
{
    Set set(mesh.records.data(), mesh.vertexCount(), mesh.values, mesh.indices.data(), mesh.indexCount());
    set.setTetrasPerHexa(tetrasPerHexa);
    EXPECT_EQ(set.getTetrasPerHexa(), tetrasPerHexa);
    const Tetras tetras = taken(set.tessellate());
    expectNoError();
    return tetras;
}

/// The records of the mesh come first, unchanged, and what was added has values as linear as theirs.
void expectRecordsKept(const Mesh& mesh, const Tetras& tetras)
{
    ASSERT_EQ(tetras.values, mesh.values);
    ASSERT_GE(tetras.records.size(), static_cast<std::size_t>(mesh.vertexCount()));
    for (std::size_t i = 0; i < tetras.records.size(); ++i)
        for (int column = 0; column < mesh.values; ++column) {
            const auto at = i * static_cast<std::size_t>(mesh.values) + static_cast<std::size_t>(column);
            const float value = tetras.records[i][static_cast<std::size_t>(column)];
            if (at < mesh.records.size()) {
                ASSERT_EQ(value, mesh.records[at]);
            } else if (column < mesh.values - 3) {
                ASSERT_NEAR(value, Mesh::valueAt(column, tetras.position(static_cast<int>(i))), 2e-5);
            }
        }
}

// The eight corners of a box, in the guide's order, and turns of it.

constexpr int kBox[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/// The corners of a box in another order that names the same box: from any corner, in any of the six orders
/// of the axes (three of which are mirrored).
std::vector<int> renamed(const std::vector<int>& box, int corner, int order)
{
    static const int axes[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    std::vector<int> result;
    for (const auto& place : kBox) {
        int from[3];
        for (int axis = 0; axis < 3; ++axis)
            from[axes[order][axis]] = place[axis] ^ (corner >> axis & 1);
        for (int c = 0; c < 8; ++c)
            if (std::equal(from, from + 3, kBox[c])) result.push_back(box[static_cast<std::size_t>(c)]);
    }
    return result;
}

/// Boxes of a grid with its inner vertices moved about, numbered and named in any order.
struct Grid
{
    int n[3];
    std::vector<dvec3> places;

    Grid(int x, int y, int z) : n{x, y, z} {}
    int vertex(int i, int j, int k) const { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; }
    double volume() const { return n[0] * n[1] * n[2]; }
    double area() const { return 2 * (n[0] * n[1] + n[1] * n[2] + n[2] * n[0]); }
};

Mesh shuffledGrid(const Grid& grid, int values, double move, std::mt19937& random, bool namesInOrder = false)
{
    std::uniform_real_distribution<double> part(-move, move);
    std::vector<dvec3> places;
    for (int k = 0; k <= grid.n[2]; ++k)
        for (int j = 0; j <= grid.n[1]; ++j)
            for (int i = 0; i <= grid.n[0]; ++i) {
                dvec3 p(i, j, k);
                for (int axis = 0; axis < 3; ++axis)
                    if (p[axis] > 0 && p[axis] < grid.n[axis]) p[axis] += part(random);
                places.push_back(p);
            }
    std::vector<std::size_t> order(places.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    if (!namesInOrder) std::shuffle(order.begin(), order.end(), random);
    Mesh mesh(values);
    std::vector<int> number(places.size());
    for (const std::size_t place : order)
        number[place] = mesh.add(places[place]);
    for (int k = 0; k < grid.n[2]; ++k)
        for (int j = 0; j < grid.n[1]; ++j)
            for (int i = 0; i < grid.n[0]; ++i) {
                std::vector<int> box;
                for (const auto& c : kBox)
                    box.push_back(
                        number[static_cast<std::size_t>(grid.vertex(i + c[0], j + c[1], k + c[2]))]);
                mesh.addCell(namesInOrder ? box
                                          : renamed(box, static_cast<int>(random() % 8),
                                                    static_cast<int>(random() % 6)));
            }
    return mesh;
}

TEST(VoutHexaSet, splitsTheGuidesCubeAsTheGuideDoes)
{
    Mesh cube;
    for (const auto& c : kBox)
        cube.add({c[0], c[1], c[2]});
    cube.addCell({0, 1, 2, 3, 4, 5, 6, 7});
    const Tetras tetras = tetrasOf<voutIndexedHexaSet>(cube);
    std::vector<std::array<int, 4>> ours = tetras.corners;
    std::vector<std::array<int, 4>> guides{
        {0, 2, 5, 7}, {3, 2, 0, 7}, {1, 2, 5, 0}, {2, 7, 6, 5}, {5, 4, 0, 7}};
    for (auto* tetra : {&ours, &guides}) {
        for (auto& corners : *tetra)
            std::sort(corners.begin(), corners.end());
        std::sort(tetra->begin(), tetra->end());
    }
    EXPECT_EQ(ours, guides);
}

TEST(VoutHexaSet, gridsOfAnyShapeAndNamesAreSolidByEverySplit)
{
    std::mt19937 random(1);
    for (int round = 0; round < 12; ++round) {
        const Grid grid(1 + static_cast<int>(random() % 3), 1 + static_cast<int>(random() % 3),
                        1 + static_cast<int>(random() % 3));
        const Mesh mesh = shuffledGrid(grid, 3 + static_cast<int>(random() % 11), 0.15, random);
        for (const int split : {5, 6, 24}) {
            SCOPED_TRACE("round " + std::to_string(round) + ", split " + std::to_string(split));
            const Tetras tetras = hexasBy<voutIndexedHexaSet>(mesh, split);
            expectSolid(tetras, grid.volume(), grid.area());
            EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(split * grid.volume()));
            expectRecordsKept(mesh, tetras);
        }
    }
}

TEST(VoutHexaSet, middlesAreTheOnlyVerticesThatSplittingAdds)
{
    std::mt19937 random(2);
    const Grid grid(3, 2, 2);
    const Mesh mesh = shuffledGrid(grid, 9, 0.1, random);
    const auto given = static_cast<std::size_t>(mesh.vertexCount());
    EXPECT_EQ(hexasBy<voutIndexedHexaSet>(mesh, 5).records.size(), given);
    EXPECT_EQ(hexasBy<voutIndexedHexaSet>(mesh, 6).records.size(), given);
    const std::size_t faces = 4 * 2 * 2 + 3 * 3 * 2 + 3 * 2 * 3;
    EXPECT_EQ(hexasBy<voutIndexedHexaSet>(mesh, 24).records.size(), given + 12 + faces);
}

TEST(VoutHexaSet, middlesHaveTheMeanOfAllValues)
{
    // Colours that are not linear in the place: corners alternate, as in the guide's figure 2-16.
    Mesh mesh(6);
    for (const auto& c : kBox) {
        mesh.add({c[0], c[1], c[2]});
        const float red = static_cast<float>((c[0] + c[1] + c[2]) % 2);
        std::fill(mesh.records.end() - 6, mesh.records.end() - 3, red);
    }
    mesh.addCell({0, 1, 2, 3, 4, 5, 6, 7});
    const Tetras tetras = hexasBy<voutIndexedHexaSet>(mesh, 24);
    ASSERT_EQ(tetras.records.size(), 15u);
    for (std::size_t i = 8; i < 15; ++i)
        for (std::size_t column = 0; column < 3; ++column)
            EXPECT_EQ(tetras.records[i][column], 0.5f);
}

TEST(VoutHexaSet, partsThatTouchNowhereAreSplitByThemselves)
{
    Mesh mesh;
    for (int part = 0; part < 2; ++part) {
        std::vector<int> box;
        for (const auto& c : kBox)
            box.push_back(mesh.add({c[0] + 3 * part, c[1], c[2]}));
        mesh.addCell(renamed(box, part, 0));
    }
    for (const int split : {5, 6, 24})
        expectSolid(hexasBy<voutIndexedHexaSet>(mesh, split), 2, 12);
}

/// Three rhombic boxes round the edge in the middle of a hexagon of side 1 and height 1.
Mesh hexagon()
{
    Mesh mesh;
    for (const double z : {0.0, 1.0}) {
        mesh.add({0, 0, z});
        for (int i = 0; i < 6; ++i)
            mesh.add({std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), z});
    }
    for (int i = 0; i < 6; i += 2) {
        const int a = 1 + i, b = 1 + (i + 1) % 6, c = 1 + (i + 2) % 6;
        mesh.addCell({0, a, b, c, 7, 7 + a, 7 + b, 7 + c});
    }
    return mesh;
}

TEST(VoutHexaSet, boxesThatCannotTakeTurnsStillMatch)
{
    // The colours of a hexagon's corners alternate, so that three boxes can take turns...
    const double base = 1.5 * std::sqrt(3.0);
    for (const int split : {5, 6, 24}) {
        const Tetras tetras = hexasBy<voutIndexedHexaSet>(hexagon(), split);
        expectSolid(tetras, base, 2 * base + 6);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(3 * split));
    }
    // ...but not round a ring of three, each joined to the next by a whole face.
    Mesh ring;
    for (int i = 0; i < 3; ++i)
        for (const double radius : {1.0, 2.0})
            for (const double z : {0.0, 1.0})
                ring.add({radius * std::cos(i * 2 * std::numbers::pi / 3),
                          radius * std::sin(i * 2 * std::numbers::pi / 3), z});
    for (int i = 0; i < 3; ++i) {
        const int a = 4 * i, b = 4 * ((i + 1) % 3);
        ring.addCell({a, a + 2, b + 2, b, a + 1, a + 3, b + 3, b + 1});
    }
    const double inner = 0.75 * std::sqrt(3.0), ringBase = 3 * inner, around = 3 * std::sqrt(3.0) * 3;
    for (const int split : {5, 6, 24}) {
        const Tetras tetras = hexasBy<voutIndexedHexaSet>(ring, split);
        expectSolid(tetras, ringBase, 2 * ringBase + around);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(split == 24 ? 72 : 18));
    }
}

TEST(VoutHexaSet, shapesThatNeedAVertexInTheMiddleGetOne)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-0.42, 0.42);
    int withMiddle = 0, split = 0;
    for (int round = 0; round < 6000; ++round) {
        Mesh mesh(7);
        std::vector<int> box;
        for (const auto& c : kBox)
            box.push_back(
                mesh.add(dvec3(c[0], c[1], c[2]) + dvec3(part(random), part(random), part(random))));
        mesh.addCell(box);
        voutIndexedHexaSet set(mesh.records.data(), 8, 7, mesh.indices.data(), 8);
        voIndexedTetraSet* made = set.tessellate();
        if (!made) {
            expectBadValue("hexahedron 0 is partly inside out");
            continue;
        }
        const Tetras tetras = taken(made);
        ++split;
        ASSERT_EQ(wrongHandedness(tetras), "") << round;
        ASSERT_EQ(unmatchedFaces(tetras), "") << round;
        ASSERT_EQ(overlaps(tetras), "") << round;
        if (tetras.records.size() == 8) continue;
        ++withMiddle;
        ASSERT_EQ(tetras.records.size(), 9u);
        ASSERT_EQ(tetras.corners.size(), 12u);
        expectRecordsKept(mesh, tetras);
    }
    EXPECT_GT(withMiddle, 3);
    EXPECT_GT(split, 1000);
}

TEST(VoutHexaSet, cornersThatCoincideMakeSimplerCells)
{
    // A wedge and a pyramid.
    Mesh mesh;
    for (const auto& c : kBox)
        mesh.add({c[0], c[1], c[2]});
    mesh.addCell({0, 1, 2, 3, 4, 5, 5, 4});
    for (const int split : {5, 6})
        expectSolid(hexasBy<voutIndexedHexaSet>(mesh, split), 0.5, 1 + 1 + std::sqrt(2.0) + 1);
    mesh.indices = {0, 1, 2, 3, 4, 4, 4, 4};
    for (const int split : {5, 6})
        expectSolid(hexasBy<voutIndexedHexaSet>(mesh, split), 1.0 / 3, 1 + 1 + std::sqrt(2.0));
    mesh.indices = {0, 1, 2, 3, 0, 1, 2, 3};
    EXPECT_TRUE(hexasBy<voutIndexedHexaSet>(mesh, 5).corners.empty());
}

TEST(VoutHexaStrip, isTheSetOfTheSameBoxes)
{
    std::mt19937 random(4);
    for (int round = 0; round < 5; ++round) {
        const Grid grid(1, 1, 1 + static_cast<int>(random() % 6));
        const Mesh boxes = shuffledGrid(grid, 6, 0.2, random, true);
        Mesh strip(6);
        strip.records = boxes.records;
        for (int k = 0; k <= grid.n[2]; ++k)
            for (int c = 0; c < 4; ++c)
                strip.indices.push_back(grid.vertex(kBox[c][0], kBox[c][1], k));
        for (const int split : {5, 6, 24}) {
            const Tetras tetras = hexasBy<voutIndexedHexaStrip>(strip, split);
            expectSolid(tetras, grid.volume(), grid.area());
            expectRecordsKept(strip, tetras);
            EXPECT_EQ(tetras.corners, hexasBy<voutIndexedHexaSet>(boxes, split).corners);
        }
    }
}

/// A linear map of space that keeps or turns handedness.
glm::dmat3 randomMap(std::mt19937& random)
{
    std::uniform_real_distribution<double> part(-1, 1);
    for (;;) {
        glm::dmat3 map;
        for (int i = 0; i < 3; ++i)
            map[i] = {part(random), part(random), part(random)};
        if (std::abs(glm::determinant(map)) > 0.2) return map;
    }
}

/// A solid through a linear map; its surface has to be turned inside out by one that mirrors.
Surface mapped(Surface surface, const glm::dmat3& map)
{
    for (auto& polygon : surface.polygons) {
        for (dvec3& p : polygon)
            p = map * p;
        if (glm::determinant(map) < 0) std::reverse(polygon.begin(), polygon.end());
    }
    return surface;
}

/// A tower over a polygon.
Surface tower(const std::vector<dvec3>& polygon, double height)
{
    Surface surface;
    std::vector<dvec3> top, bottom(polygon.rbegin(), polygon.rend());
    for (const dvec3& p : polygon)
        top.push_back(p + dvec3(0, 0, height));
    surface.polygons = {top, bottom};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t j = (i + 1) % polygon.size();
        surface.polygons.push_back({polygon[i], polygon[j], top[j], top[i]});
    }
    return surface;
}

TEST(VoutPrismBaseStrip, isATower)
{
    std::mt19937 random(5);
    for (int round = 0; round < 10; ++round) {
        const glm::dmat3 map = randomMap(random);
        const std::vector<dvec3> triangle{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}};
        const int levels = 1 + static_cast<int>(random() % 5);
        Mesh mesh(9);
        for (int level = 0; level <= levels; ++level)
            for (const dvec3& p : triangle)
                mesh.indices.push_back(mesh.add(map * (p + dvec3(0, 0, level))));
        const Tetras tetras = tetrasOf<voutIndexedPrismBaseStrip>(mesh);
        expectSolid(tetras, mapped(tower(triangle, levels), map));
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(3 * levels));
        expectRecordsKept(mesh, tetras);
    }
}

TEST(VoutPrismFaceStrip, isATriangleStripMadeUpright)
{
    std::mt19937 random(6);
    for (int round = 0; round < 10; ++round) {
        const glm::dmat3 map = randomMap(random);
        const int prisms = 1 + static_cast<int>(random() % 6);
        Mesh mesh(6);
        std::vector<dvec3> lower, upper;
        for (int edge = 0; edge < prisms + 2; ++edge) {
            const dvec3 p(0.5 * edge, edge % 2, 0);
            (edge % 2 ? upper : lower).push_back(p);
            mesh.indices.push_back(mesh.add(map * p));
            mesh.indices.push_back(mesh.add(map * (p + dvec3(0, 0, 2))));
        }
        lower.insert(lower.end(), upper.rbegin(), upper.rend());
        const Tetras tetras = tetrasOf<voutIndexedPrismFaceStrip>(mesh);
        expectSolid(tetras, mapped(tower(lower, 2), map));
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(3 * prisms));
        expectRecordsKept(mesh, tetras);
    }
}

TEST(VoutPrismEdgeStrip, isPrismsThatShareAnEdge)
{
    std::mt19937 random(7);
    for (int round = 0; round < 10; ++round) {
        const glm::dmat3 map = randomMap(random);
        const int prisms = 1 + static_cast<int>(random() % 5);
        Mesh mesh(6);
        const auto upright = [&](double x, double y) {
            mesh.indices.push_back(mesh.add(map * dvec3(x, y, 0)));
            mesh.indices.push_back(mesh.add(map * dvec3(x, y, 1)));
        };
        Surface all;
        upright(0, 0);
        for (int i = 0; i < prisms; ++i) {
            upright(i + 0.5, 1);
            upright(i + 1, 0);
            const Surface one = tower({{i, 0, 0}, {i + 1, 0, 0}, {i + 0.5, 1, 0}}, 1);
            all.polygons.insert(all.polygons.end(), one.polygons.begin(), one.polygons.end());
        }
        const Tetras tetras = tetrasOf<voutIndexedPrismEdgeStrip>(mesh);
        expectSolid(tetras, mapped(all, map));
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(3 * prisms));
        EXPECT_EQ(boundaryVertices(tetras).size(), static_cast<std::size_t>(mesh.vertexCount()));
    }
}

TEST(VoutPyramidStrip, isPyramidsRoundOneTip)
{
    std::mt19937 random(8);
    for (int round = 0; round < 10; ++round) {
        const glm::dmat3 map = randomMap(random);
        const int pyramids = 1 + static_cast<int>(random() % 5);
        Mesh mesh(7);
        const dvec3 tip(0.3, 0.4, 1);
        mesh.indices.push_back(mesh.add(map * tip));
        for (int i = 0; i <= pyramids; ++i)
            for (const double y : {0.0, 1.0})
                mesh.indices.push_back(mesh.add(map * dvec3(i, y, 0)));
        const double n = pyramids;
        const Surface surface{{{{0, 0, 0}, {0, 1, 0}, {n, 1, 0}, {n, 0, 0}},
                               {{0, 0, 0}, {n, 0, 0}, tip},
                               {{n, 0, 0}, {n, 1, 0}, tip},
                               {{n, 1, 0}, {0, 1, 0}, tip},
                               {{0, 1, 0}, {0, 0, 0}, tip}}};
        const Tetras tetras = tetrasOf<voutIndexedPyramidStrip>(mesh);
        expectSolid(tetras, mapped(surface, map));
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(2 * pyramids));
        expectRecordsKept(mesh, tetras);
    }
}

TEST(VoutTetraFaceStrip, isRegularTetrahedraRoundAHelix)
{
    // The helix of Boerdijk and Coxeter: all edges are 1.
    const double radius = 0.3 * std::sqrt(3.0), turn = std::acos(-2.0 / 3), climb = 1 / std::sqrt(10.0);
    for (const int tetraCount : {1, 2, 3, 12}) {
        Mesh mesh(10);
        for (int i = 0; i < tetraCount + 3; ++i)
            mesh.indices.push_back(
                mesh.add({radius * std::cos(turn * i), radius * std::sin(turn * i), climb * i}));
        const Tetras tetras = tetrasOf<voutIndexedTetraFaceStrip>(mesh);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(tetraCount));
        expectSolid(tetras, tetraCount * std::sqrt(2.0) / 12, (2 * tetraCount + 2) * std::sqrt(3.0) / 4);
        expectRecordsKept(mesh, tetras);
    }
}

TEST(VoutTetraEdgeStrip, isTetrahedraThatShareAnEdge)
{
    // Edges of length 2 above one another, each across the one before: six edges a tetrahedron, one of them
    // shared.
    for (const int tetraCount : {1, 2, 5}) {
        Mesh mesh(6);
        for (int i = 0; i <= tetraCount; ++i)
            for (const double side : {-1.0, 1.0})
                mesh.indices.push_back(mesh.add({i % 2 ? 0 : side, i % 2 ? side : 0, i}));
        const Tetras tetras = tetrasOf<voutIndexedTetraEdgeStrip>(mesh);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(tetraCount));
        expectSolid(tetras, tetraCount * 2.0 / 3, tetraCount * 4 * std::sqrt(2.0));
        expectRecordsKept(mesh, tetras);
    }
}

TEST(VoutSets, ofDifferentCellsOnTheSameVerticesMatch)
{
    // A box, a prism at each of two sides, a pyramid on a third, and a second box below.
    std::mt19937 random(9);
    for (int round = 0; round < 20; ++round) {
        std::vector<dvec3> places;
        for (const auto& c : kBox)
            places.push_back({c[0], c[1], c[2]});
        places.insert(places.end(), {{2, 0, 0}, {2, 0, 1}, {-1, 1, 0}, {-1, 1, 1}, {0.5, 0.5, 2}});
        for (const auto& c : {0, 1, 2, 3})
            places.push_back({kBox[c][0], kBox[c][1], -1});
        std::vector<std::size_t> order(places.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::shuffle(order.begin(), order.end(), random);
        Mesh mesh(5);
        std::vector<int> v(places.size());
        for (const std::size_t place : order)
            v[place] = mesh.add(places[place]);

        Mesh boxes = mesh, prisms = mesh, pyramids = mesh;
        boxes.addCell({v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]});
        boxes.addCell({v[13], v[14], v[15], v[16], v[0], v[1], v[2], v[3]});
        prisms.addCell({v[1], v[8], v[2], v[5], v[9], v[6]});
        prisms.addCell({v[3], v[10], v[0], v[7], v[11], v[4]});
        pyramids.addCell({v[4], v[5], v[6], v[7], v[12]});
        Tetras all = hexasBy<voutIndexedHexaSet>(boxes, 6);
        all.append(tetrasOf<voutIndexedPrismSet>(prisms));
        all.append(tetrasOf<voutIndexedPyramidSet>(pyramids));
        EXPECT_EQ(all.corners.size(), 12u + 6 + 2);
        const double prismArea = 2 * 0.5 + 1 + std::sqrt(2.0), pyramidArea = 4 * 0.5 * std::sqrt(1.25);
        expectSolid(all, 2 + 1 + 1.0 / 3,
                    2 * prismArea + pyramidArea + 2 /* front and back */ + 5 /* below */);
    }
}

// What every set and strip shares.

template <typename Set>
class EverySet : public testing::Test
{
};
using Sets = testing::Types<voutIndexedTetraFaceStrip, voutIndexedTetraEdgeStrip, voutIndexedHexaSet,
                            voutIndexedHexaStrip, voutIndexedPrismSet, voutIndexedPrismFaceStrip,
                            voutIndexedPrismBaseStrip, voutIndexedPrismEdgeStrip, voutIndexedPyramidSet,
                            voutIndexedPyramidStrip>;
TYPED_TEST_SUITE(EverySet, Sets);

/// Indices of one cell on the corners of kBox.
template <typename Set>
std::vector<int> cellIndices()
{
    if (std::is_base_of_v<voutIndexedHexaSet, Set> || std::is_base_of_v<voutIndexedHexaStrip, Set>)
        return {0, 1, 2, 3, 4, 5, 6, 7};
    if (std::is_same_v<Set, voutIndexedPyramidSet>) return {0, 1, 2, 3, 4};
    if (std::is_same_v<Set, voutIndexedPyramidStrip>) return {4, 0, 1, 3, 2};
    if (std::is_same_v<Set, voutIndexedPrismSet> || std::is_same_v<Set, voutIndexedPrismBaseStrip>)
        return {0, 1, 2, 4, 5, 6};
    if (std::is_same_v<Set, voutIndexedPrismFaceStrip> || std::is_same_v<Set, voutIndexedPrismEdgeStrip>)
        return {0, 4, 1, 5, 2, 6};
    return {0, 1, 2, 4};
}

std::vector<float> boxRecords()
{
    std::vector<float> records;
    for (const auto& c : kBox)
        for (const int coordinate : c)
            records.push_back(static_cast<float>(coordinate));
    return records;
}

TYPED_TEST(EverySet, isAGeometryThatCannotBeCopied)
{
    EXPECT_TRUE((std::is_base_of_v<voutIndexedSet, TypeParam>));
    EXPECT_TRUE((std::is_base_of_v<voutGeometry, TypeParam>));
    EXPECT_FALSE(std::is_copy_constructible_v<TypeParam>);
    EXPECT_FALSE(std::is_copy_assignable_v<TypeParam>);
    EXPECT_TRUE(std::has_virtual_destructor_v<TypeParam>);
}

TYPED_TEST(EverySet, withoutIndicesIsEmpty)
{
    TypeParam set(10, 3, 100);
    voutGeometry& solid = set;
    const Tetras tetras = taken(solid.tessellate());
    EXPECT_TRUE(tetras.corners.empty());
    expectNoError();
}

TYPED_TEST(EverySet, wrongNumbersOfIndicesAreRefused)
{
    std::vector<float> records = boxRecords();
    std::vector<int> indices = cellIndices<TypeParam>();
    const int right = static_cast<int>(indices.size());
    for (const int count : {1, right - 1}) {
        TypeParam set(records.data(), 8, 3, indices.data(), count);
        EXPECT_EQ(set.tessellate(), nullptr);
        expectBadValue(std::to_string(count) + " indices, " + std::to_string(right) +
                       " and any number of times");
    }
}

TYPED_TEST(EverySet, indicesOutsideAreRefused)
{
    std::vector<float> records = boxRecords();
    for (const int wrong : {-1, 8, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
        std::vector<int> indices = cellIndices<TypeParam>();
        indices[3] = wrong;
        TypeParam set(records.data(), 8, 3, indices.data(), static_cast<int>(indices.size()));
        EXPECT_EQ(set.tessellate(), nullptr);
        expectBadValue("vertex " + std::to_string(wrong) + " is outside 0 to 7");
        EXPECT_EQ(set.tesselate(), nullptr);
        expectBadValue("is outside");
    }
}

TYPED_TEST(EverySet, positionsThatAreNoNumbersAreRefused)
{
    for (const float wrong :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::vector<float> records = boxRecords();
        records[1] = wrong;
        std::vector<int> indices = cellIndices<TypeParam>();
        TypeParam set(records.data(), 8, 3, indices.data(), static_cast<int>(indices.size()));
        EXPECT_EQ(set.tessellate(), nullptr);
        expectBadValue("vertex 0 is not at a finite position");
    }
}

TYPED_TEST(EverySet, missingPartsAreReportedAndLeaveItEmpty)
{
    std::vector<float> records = boxRecords();
    std::vector<int> indices{0, 1, 2, 3, 4, 5, 6, 7};
    const auto expectEmpty = [](TypeParam& set, const char* text) {
        expectBadValue(text);
        ASSERT_NE(set.getVertexData(), nullptr);
        ASSERT_NE(set.getIndices(), nullptr);
        EXPECT_EQ(set.getIndices()->getCount(), 0);
        EXPECT_TRUE(taken(set.tessellate()).corners.empty());
        expectNoError();
    };
    TypeParam noData(static_cast<float*>(nullptr), 8, 3, indices.data(), 8);
    expectEmpty(noData, "data is NULL");
    TypeParam noIndices(records.data(), 8, 3, static_cast<int*>(nullptr), 8);
    expectEmpty(noIndices, "indices are NULL");
    const float* constant = nullptr;
    const int* constantIndices = indices.data();
    TypeParam noConstants(constant, 8, 3, constantIndices, 8);
    expectEmpty(noConstants, "data is NULL");
    voIndices parts(8, indices.data());
    TypeParam noParts(static_cast<voVertexData*>(nullptr), &parts);
    expectEmpty(noParts, "data is NULL");
    TypeParam negative(-1, 3, -1);
    expectBadValue("countMax is -1");
    EXPECT_EQ(negative.tessellate(), nullptr);
    expectBadValue("no position");
}

TYPED_TEST(EverySet, recordsWithoutPositionsAreRefused)
{
    std::vector<float> records = boxRecords();
    std::vector<int> indices = cellIndices<TypeParam>();
    TypeParam set(records.data(), 8, 2, indices.data(), static_cast<int>(indices.size()));
    EXPECT_EQ(set.tessellate(), nullptr);
    expectBadValue("records of 2 values have no position");
}

TYPED_TEST(EverySet, givesANewSetEachTimeThatOutlivesIt)
{
    std::vector<float> records = boxRecords();
    std::vector<int> indices = cellIndices<TypeParam>();
    auto set =
        std::make_unique<TypeParam>(records.data(), 8, 3, indices.data(), static_cast<int>(indices.size()));
    voIndexedTetraSet* first = set->tessellate();
    voIndexedTetraSet* second = set->tesselate();
    expectNoError();
    EXPECT_NE(first, second);
    set.reset();
    std::fill(records.begin(), records.end(), 0.0f);
    const Tetras a = taken(first), b = taken(second);
    EXPECT_GT(volumeOf(a), 0.1);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.records, b.records);
}

TYPED_TEST(EverySet, isFilledThroughItsParts)
{
    TypeParam room(8, 3, 8);
    const std::vector<float> records = boxRecords();
    std::copy(records.begin(), records.end(), room.getVertexData()->getDataPtr());
    room.getVertexData()->setCount(8);
    room.getIndices()->setCount(static_cast<int>(cellIndices<TypeParam>().size()));
    EXPECT_EQ(room.getVertexData()->getCount(), 8);
    EXPECT_TRUE(taken(room.tessellate()).corners.empty()) << "all indices are 0";
    room.empty();
    EXPECT_EQ(room.getVertexData()->getCount(), 0);
    EXPECT_EQ(room.getIndices()->getCount(), 0);

    voVertexData data(8, 3);
    data.setCount(8);
    voIndices indices(8);
    indices.setCount(8);
    TypeParam borrowed(&data, &indices);
    EXPECT_EQ(borrowed.getVertexData(), &data);
    EXPECT_EQ(borrowed.getIndices(), &indices);
    borrowed.empty();
    EXPECT_EQ(data.getCount(), 8) << "vertices of somebody else stay";
    EXPECT_EQ(indices.getCount(), 0);
}

TEST(VoutHexaSet, otherSplitsAreRefused)
{
    voutIndexedHexaSet set(0, 3, 0);
    voutIndexedHexaStrip strip(0, 3, 0);
    EXPECT_EQ(set.getTetrasPerHexa(), 5);
    for (const int wrong : {0, -5, 7, 12}) {
        set.setTetrasPerHexa(wrong);
        expectBadValue("tetrahedra in a box, 5, 6 or 24 are possible");
        strip.setTetrasPerHexa(wrong);
        expectBadValue("tetrahedra in a box");
    }
    EXPECT_EQ(set.getTetrasPerHexa(), 5);
    EXPECT_EQ(strip.getTetrasPerHexa(), 5);
}

TEST(VoutHexaSet, boxesInsideOutInPartAreRefused)
{
    Mesh mesh;
    for (const auto& c : kBox)
        mesh.add({c[0], c[1], c[2]});
    mesh.addCell({0, 1, 2, 3, 4, 5, 6, 7});
    mesh.addCell({0, 1, 2, 3, 4, 7, 6, 5});
    for (const int split : {5, 6, 24}) {
        voutIndexedHexaSet set(mesh.records.data(), 8, 3, mesh.indices.data(), 16);
        set.setTetrasPerHexa(split);
        EXPECT_EQ(set.tessellate(), nullptr);
        expectBadValue("hexahedron 1 is partly inside out");
    }
}

} // namespace
