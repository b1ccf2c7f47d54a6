#include "geometry/convex_set.h"

#include "../polygonize/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using scenes::TetraSet;

namespace {

TetraSet moved(TetraSet set, const glm::dmat4& matrix)
{
    for (std::size_t i = 0; i < set.records.size(); i += 3) {
        const glm::dvec3 p(set.records[i], set.records[i + 1], set.records[i + 2]);
        const glm::dvec3 q(matrix * glm::dvec4(p, 1.0));
        for (int axis = 0; axis < 3; ++axis)
            set.records[i + static_cast<std::size_t>(axis)] = static_cast<float>(q[axis]);
    }
    return set;
}

TetraSet joined(const TetraSet& a, const TetraSet& b)
{
    TetraSet set = a;
    const int first = static_cast<int>(a.records.size()) / 3;
    set.records.insert(set.records.end(), b.records.begin(), b.records.end());
    for (const int index : b.indices)
        set.indices.push_back(first + index);
    return set;
}

TetraSet withoutTetra(TetraSet set, int tetra)
{
    set.indices.erase(set.indices.begin() + 4 * tetra, set.indices.begin() + 4 * tetra + 4);
    return set;
}

/// A tetrahedron from the origin to each triangle of an octahedron.
TetraSet octahedron()
{
    TetraSet set;
    set.add(glm::dvec3(0));
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {5.0, -5.0}) {
            glm::dvec3 p(0.0);
            p[axis] = side;
            set.add(p);
        }
    for (int corner = 0; corner < 8; ++corner)
        set.indices.insert(set.indices.end(),
                           {0, 1 + (corner & 1), 3 + (corner >> 1 & 1), 5 + (corner >> 2)});
    return set;
}

/// Every plane bounds the box [lower, upper] of one size per axis, each side once.
void expectBox(const std::optional<vo::ConvexSet>& found, const glm::dvec3& lower, const glm::dvec3& upper)
{
    ASSERT_TRUE(found);
    ASSERT_EQ(found->planes.size(), 6u);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            glm::dvec4 expected(0.0);
            expected[axis] = side;
            expected.w = side > 0 ? -upper[axis] : lower[axis];
            EXPECT_EQ(std::ranges::count(found->planes, expected), 1) << "axis " << axis << " side " << side;
        }
}

} // namespace

TEST(ConvexSet, cubeOfFiveTetrahedraHasSixPlanes)
{
    expectBox(vo::convexSet(scenes::cube({0, 1, 2}, {8, 9, 12}).view()), {0, 1, 2}, {8, 9, 12});
}

TEST(ConvexSet, latticeThatFillsBoxHasSixPlanes)
{
    const TetraSet lattice = scenes::jitteredLattice(4, -3, 29, 0.0, 1);
    expectBox(vo::convexSet(lattice.view()), glm::dvec3(-3), glm::dvec3(29));
}

TEST(ConvexSet, recordsWithValuesAreReadByPosition)
{
    expectBox(vo::convexSet(scenes::cube(8).withValues(7).view()), glm::dvec3(0), glm::dvec3(8));
}

TEST(ConvexSet, verticesRepeatedForEachTetrahedronAreOnePlace)
{
    const TetraSet shared = scenes::jitteredLattice(3, 0, 9, 0.0, 1);
    TetraSet set;
    for (const int index : shared.indices) {
        set.indices.push_back(static_cast<int>(set.records.size()) / 3);
        const float* p = shared.view().record(index);
        for (int axis = 0; axis < 3; ++axis) // a zero of either sign
            set.records.push_back(p[axis] == 0.0f && set.indices.size() % 2 ? -0.0f : p[axis]);
    }
    expectBox(vo::convexSet(set.view()), glm::dvec3(0), glm::dvec3(9));
}

TEST(ConvexSet, facesOfOctahedronPointOutwards)
{
    const auto found = vo::convexSet(octahedron().view());
    ASSERT_TRUE(found);
    ASSERT_EQ(found->planes.size(), 8u);
    for (const glm::dvec4& plane : found->planes) {
        EXPECT_NEAR(glm::length(glm::dvec3(plane)), 1.0, 1e-15);
        EXPECT_NEAR(plane.w, -5.0 / std::sqrt(3.0), 1e-12);
    }
}

TEST(ConvexSet, roundedCornersOfTurnedBoxesStayInOnePlane)
{
    std::mt19937 random(5);
    for (int i = 0; i < 50; ++i) {
        const glm::dmat4 turn = gl_matrices::translate({40, -170, 230}) * scenes::randomRotation(random);
        for (const TetraSet& set :
             {scenes::cube({0, 0, 0}, {250, 100, 60}), scenes::jitteredLattice(4, 0, 128, 0.0, 1)}) {
            const auto found = vo::convexSet(moved(set, turn).view());
            ASSERT_TRUE(found);
            EXPECT_EQ(found->planes.size(), 6u);
        }
    }
}

TEST(ConvexSet, thinBoxKeepsBothFaces)
{
    expectBox(vo::convexSet(scenes::cube({0, 0, 0}, {512, 512, 1e-4f}).view()), glm::dvec3(0),
              {512, 512, 1e-4f});
}

TEST(ConvexSet, missingTetrahedronIsNoticedWhereverItIs)
{
    const TetraSet lattice = scenes::jitteredLattice(3, 0, 9, 0.0, 1);
    for (int tetra = 0; tetra < lattice.view().tetraCount(); ++tetra)
        ASSERT_FALSE(vo::convexSet(withoutTetra(lattice, tetra).view())) << tetra;
    EXPECT_TRUE(vo::convexSet(withoutTetra(scenes::cube(8), 1).view())) << "without a corner it is convex";
    EXPECT_FALSE(vo::convexSet(withoutTetra(scenes::cube(8), 0).view())) << "without the middle it is not";
}

TEST(ConvexSet, overlapGivesNothing)
{
    const TetraSet cube = scenes::cube(8);
    TetraSet repeated = cube;
    repeated.indices.insert(repeated.indices.end(), {0, 2, 5, 7});
    EXPECT_FALSE(vo::convexSet(repeated.view())) << "a tetrahedron twice";
    EXPECT_FALSE(vo::convexSet(joined(cube, cube).view())) << "a cube twice";
    EXPECT_FALSE(vo::convexSet(joined(cube, scenes::jitteredLattice(1, 0, 8, 0.0, 1)).view()))
        << "a cube in two ways";
    const glm::dmat4 quarter = gl_matrices::translate({8, 0, 0}) * gl_matrices::rotate(90, {0, 0, 1});
    EXPECT_FALSE(vo::convexSet(joined(cube, moved(cube, quarter)).view())) << "and with the other diagonals";
    EXPECT_FALSE(vo::convexSet(joined(cube, scenes::cube(glm::dvec3(2), glm::dvec3(6))).view()))
        << "a cube in a cube";
    EXPECT_FALSE(vo::convexSet(joined(cube, scenes::cube(glm::dvec3(4), glm::dvec3(12))).view()));
}

TEST(ConvexSet, unionThatIsNotConvexGivesNothing)
{
    const TetraSet cube = scenes::cube(8);
    EXPECT_FALSE(vo::convexSet(joined(cube, scenes::cube({20, 0, 0}, {28, 8, 8})).view())) << "apart";
    EXPECT_FALSE(vo::convexSet(scenes::jitteredLattice(3, 0, 9, 0.1, 1).view())) << "rough faces";
    TetraSet dented = octahedron();
    dented.records[0] = -2.0f; // a corner moved behind the middle leaves a dent
    dented.records[3] = -1.0f;
    EXPECT_FALSE(vo::convexSet(dented.view()));
}

TEST(ConvexSet, flatOrNotFiniteGivesNothing)
{
    EXPECT_FALSE(vo::convexSet(vo::TetraView{}));
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()})
        for (std::size_t value = 0; value < 24; value += 5) {
            TetraSet set = scenes::cube(8);
            set.records[value] = bad;
            EXPECT_FALSE(vo::convexSet(set.view()));
        }
    for (const std::array<int, 4>& order : {std::array{0, 1, 2, 3}, std::array{1, 0, 2, 3}}) {
        TetraSet flat = scenes::cube(8);
        flat.indices.insert(flat.indices.end(), order.begin(), order.end());
        EXPECT_FALSE(vo::convexSet(flat.view()));
    }
    TetraSet point = scenes::cube(8);
    point.indices.insert(point.indices.end(), {4, 4, 4, 4});
    EXPECT_FALSE(vo::convexSet(point.view()));
}

TEST(ConvexSet, vertexNotInUseIsOfNoAccount)
{
    TetraSet set = scenes::cube(8);
    set.add(glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    expectBox(vo::convexSet(set.view()), glm::dvec3(0), glm::dvec3(8));
}
