// Cells into tetrahedra: none inside out, no cracks, nothing lost.
#include "mesh_files.h"

#include <gtest/gtest.h>

namespace {

using namespace vo::test;
using vo::CellKind;

/// That the tetrahedra fill a box of n x n x n: each face lies on the box's sides or between two.
void expectFilled(const vo::SplitMesh& split, int n, const std::string& what)
{
    double sum = 0;
    std::map<std::array<std::int64_t, 3>, int> faces;
    for (const auto& tetra : split.tetras) {
        const double volume = volumeOf(split, tetra);
        EXPECT_GT(volume, 0) << what;
        sum += volume;
        for (std::size_t left = 0; left < 4; ++left) {
            std::array<std::int64_t, 3> face{tetra[(left + 1) % 4], tetra[(left + 2) % 4],
                                             tetra[(left + 3) % 4]};
            std::sort(face.begin(), face.end());
            ++faces[face];
        }
    }
    EXPECT_NEAR(sum, double(n) * n * n, 1e-9 * n * n * n) << what;
    std::int64_t outer = 0;
    for (const auto& [face, count] : faces) {
        if (count == 2) continue;
        ASSERT_EQ(count, 1) << what;
        ++outer;
        bool onSide = false;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const double side : {0.0, double(n)})
                onSide = onSide || std::ranges::all_of(face, [&](std::int64_t point) {
                             return split.points[static_cast<std::size_t>(point)][axis] == side;
                         });
        ASSERT_TRUE(onSide) << what << ": a crack";
    }
    EXPECT_EQ(outer, 12 * n * n) << what;
}

TEST(SplitMesh, mixedCellsFillTheirBox)
{
    std::set<CellKind> kinds;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const MixedMesh mixed(3, 0.02 * (seed % 12), seed);
        kinds.insert(mixed.mesh.kinds.begin(), mixed.mesh.kinds.end());
        expectFilled(vo::splitMesh(mixed.mesh), 3, "seed " + std::to_string(seed));
    }
    EXPECT_EQ(kinds.size(), 4u);
}

/// The parts of a cell on its own, whose corners have these numbers, in boxes of whole numbers.
std::size_t partsOf(CellKind kind, const std::vector<Point>& corners,
                    const std::vector<std::int64_t>& numbers)
{
    vo::Mesh mesh;
    mesh.kinds = {kind};
    mesh.points.resize(corners.size());
    mesh.corners = numbers;
    for (std::size_t i = 0; i < corners.size(); ++i)
        mesh.points[static_cast<std::size_t>(numbers[i])] = corners[i];
    const vo::SplitMesh split = vo::splitMesh(mesh);
    EXPECT_TRUE(split.middleOfCell.empty());
    double sum = 0;
    for (const auto& tetra : split.tetras) {
        EXPECT_GT(volumeOf(split, tetra), 0);
        sum += volumeOf(split, tetra);
    }
    EXPECT_NEAR(sum, kind == CellKind::hexa ? 1 : kind == CellKind::prism ? 0.5 : 1.0 / 3, 1e-12);
    return split.tetras.size();
}

TEST(SplitMesh, everyNumberingOfARegularCellNeedsNoMiddle)
{
    const std::vector<Point> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const std::vector<Point> prism{cube[0], cube[1], cube[2], cube[4], cube[5], cube[6]};
    const std::vector<Point> pyramid{cube[0], cube[1], cube[2], cube[3], {0.5, 0.5, 1}};
    std::set<std::size_t> counts;
    std::vector<std::int64_t> numbers{0, 1, 2, 3, 4, 5, 6, 7};
    do
        counts.insert(partsOf(CellKind::hexa, cube, numbers));
    while (std::next_permutation(numbers.begin(), numbers.end()));
    EXPECT_EQ(counts, (std::set<std::size_t>{5, 6}));
    numbers = {0, 1, 2, 3, 4, 5};
    do
        EXPECT_EQ(partsOf(CellKind::prism, prism, numbers), 3u);
    while (std::next_permutation(numbers.begin(), numbers.end()));
    numbers = {0, 1, 2, 3, 4};
    do
        EXPECT_EQ(partsOf(CellKind::pyramid, pyramid, numbers), 2u);
    while (std::next_permutation(numbers.begin(), numbers.end()));
}

TEST(SplitMesh, cellsOutOfShapeGetAMiddle)
{
    // A cube with a corner pushed in so far that corner 0, from which the faces are cut, no longer sees all.
    vo::Mesh mesh;
    mesh.kinds = {CellKind::hexa};
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.4, 0.6, 0.4},
                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    mesh.corners = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.pointFields = {{"linear", 1, false, {}}};
    for (const Point& p : mesh.points)
        mesh.pointFields[0].values.push_back(2 * p[0] - p[1] + 3 * p[2]);
    const vo::SplitMesh split = vo::splitMesh(mesh);
    EXPECT_EQ(split.middleOfCell, std::vector<std::int64_t>{0});
    EXPECT_EQ(split.tetras.size(), 12u);
    for (const auto& tetra : split.tetras)
        EXPECT_GT(volumeOf(split, tetra), 0);
    const Point& middle = split.points.at(8);
    const auto values = vo::valuesAtPoints(mesh, split, mesh.pointFields[0]);
    EXPECT_NEAR(values.at(8), 2 * middle[0] - middle[1] + 3 * middle[2], 1e-12);
}

TEST(SplitMesh, repeatedCornersMakeSmallerCells)
{
    vo::Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}};
    mesh.kinds = {CellKind::hexa};
    mesh.corners = {0, 1, 2, 3, 4, 5, 5, 4}; // a prism
    double sum = 0;
    const vo::SplitMesh split = vo::splitMesh(mesh);
    for (const auto& tetra : split.tetras) {
        EXPECT_GT(volumeOf(split, tetra), 0);
        sum += volumeOf(split, tetra);
    }
    EXPECT_NEAR(sum, 0.5, 1e-12);
}

} // namespace
