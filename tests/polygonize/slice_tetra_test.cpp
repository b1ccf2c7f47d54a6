#include "polygonize/slice_tetra.h"

#include "exact_section.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace {

/// A tetrahedron of positions with one value before each, positively oriented.
struct Tetra
{
    std::array<std::array<double, 4>, 4> records{{{1, 0, 0, 0}, {2, 8, 0, 0}, {3, 0, 8, 0}, {4, 0, 0, 8}}};

    vo::CutPolygon slice(const std::array<double, 4>& distances,
                         const std::array<std::size_t, 4>& order) const
    {
        const double* vertices[4];
        double ordered[4];
        for (std::size_t i = 0; i < 4; ++i) {
            vertices[i] = records[order[i]].data();
            ordered[i] = distances[order[i]];
        }
        vo::CutPolygon polygon;
        vo::sliceTetra(vertices, ordered, 4, polygon);
        return polygon;
    }
    vo::CutPolygon slice(const std::array<double, 4>& distances) const
    {
        return slice(distances, {0, 1, 2, 3});
    }
};

glm::dvec3 position(const vo::CutPolygon& polygon, int i)
{
    const double* p = polygon.position(i);
    return {p[0], p[1], p[2]};
}

glm::dvec3 areaOf(const vo::CutPolygon& polygon)
{
    glm::dvec3 sum(0);
    for (int i = 1; i + 1 < polygon.count; ++i)
        sum += 0.5 * glm::cross(position(polygon, i) - position(polygon, 0),
                                position(polygon, i + 1) - position(polygon, 0));
    return sum;
}

} // namespace

TEST(SliceTetra, vertexAloneInFrontGivesTriangle)
{
    const vo::CutPolygon polygon = Tetra().slice({1, -1, -1, -1});
    ASSERT_EQ(polygon.count, 3);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(glm::length(position(polygon, i)), 4.0);
}

TEST(SliceTetra, pairsGiveQuadrilateralInOrder)
{
    const vo::CutPolygon polygon = Tetra().slice({1, 1, -1, -1});
    ASSERT_EQ(polygon.count, 4);
    // Rectangle 4 by 4 sqrt(2): a wrong order would cross itself and have less.
    EXPECT_NEAR(glm::length(areaOf(polygon)), 16 * std::sqrt(2.0), 1e-12);
}

TEST(SliceTetra, allOnOneSideGivesNothing)
{
    EXPECT_EQ(Tetra().slice({1, 2, 3, 4}).count, 0);
    EXPECT_EQ(Tetra().slice({-1, -2, -3, -4}).count, 0);
    EXPECT_EQ(Tetra().slice({0, 0, 0, 0}).count, 0);
    EXPECT_EQ(Tetra().slice({0, 0, 0, 1}).count, 0) << "a face on the plane belongs to the other side";
}

TEST(SliceTetra, faceOnThePlaneIsYieldedFromBehind)
{
    const vo::CutPolygon polygon = Tetra().slice({0, 0, 0, -1});
    ASSERT_EQ(polygon.count, 3);
    EXPECT_EQ(glm::length(areaOf(polygon)), 32.0);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(position(polygon, i).z, 0.0);
}

TEST(SliceTetra, sliceThroughVertexGivesTriangle)
{
    const vo::CutPolygon polygon = Tetra().slice({0, 1, -1, -1});
    ASSERT_EQ(polygon.count, 3);
    int corners = 0;
    for (int i = 0; i < 3; ++i)
        corners += position(polygon, i) == glm::dvec3(0);
    EXPECT_EQ(corners, 1);
}

TEST(SliceTetra, sliceThroughEdgeGivesTriangle)
{
    EXPECT_EQ(Tetra().slice({0, 0, 1, -1}).count, 3);
    EXPECT_EQ(Tetra().slice({0, 0, -1, -1}).count, 0) << "the edge alone";
    EXPECT_EQ(Tetra().slice({0, -1, -1, -1}).count, 0) << "the vertex alone";
}

TEST(SliceTetra, orientationFollowsThatOfTheTetrahedron)
{
    // All 24 vertex orders and all sides: even orders run counterclockwise seen from behind.
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    const Tetra tetra;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    do {
        int inversions = 0;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                inversions += order[i] > order[j];
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 normal(uniform(random), uniform(random), uniform(random));
            const double offset = 4 * uniform(random);
            std::array<double, 4> distances;
            for (std::size_t v = 0; v < 4; ++v)
                distances[v] =
                    glm::dot(normal, {tetra.records[v][1], tetra.records[v][2], tetra.records[v][3]}) -
                    offset;
            const vo::CutPolygon polygon = tetra.slice(distances, order);
            if (polygon.count == 0) continue;
            const double facing = glm::dot(areaOf(polygon), normal);
            EXPECT_LE(inversions % 2 ? -facing : facing, 1e-12);
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(SliceTetra, valuesAreCutWithThePosition)
{
    const vo::CutPolygon polygon = Tetra().slice({3, -1, -1, -1});
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec3 p = position(polygon, i);
        EXPECT_DOUBLE_EQ(polygon.record(i)[0], 1 + p.x / 8 + 2 * p.y / 8 + 3 * p.z / 8);
    }
}

TEST(CutEdge, bothDirectionsGiveTheSameBits)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-50, 50);
    for (int i = 0; i < 100000; ++i) {
        const double a[4]{uniform(random), uniform(random), uniform(random), uniform(random)};
        const double b[4]{uniform(random), uniform(random), uniform(random), i % 2 ? a[3] : uniform(random)};
        const double da = std::abs(uniform(random));
        const double db = -std::abs(uniform(random));
        double there[4], back[4];
        vo::cutEdge(a, b, da, db, 4, there);
        vo::cutEdge(b, a, db, da, 4, back);
        ASSERT_EQ(std::memcmp(there, back, sizeof there), 0);
    }
}

TEST(CutEdge, endOnThePlaneIsReturnedUnchanged)
{
    const double a[3]{0.1, 0.2, 1e9 / 3}, b[3]{0.7, 0.1, 0.3}; // a + (b - a) is not b
    double point[3];
    vo::cutEdge(a, b, 0.0, -3.0, 3, point);
    EXPECT_TRUE(std::equal(point, point + 3, a));
    vo::cutEdge(a, b, -3.0, 0.0, 3, point);
    EXPECT_TRUE(std::equal(point, point + 3, b));
    vo::cutEdge(a, b, 1e-300, -1.0, 3, point);
    EXPECT_TRUE(std::equal(point, point + 3, a)) << "so close that rounding makes it the end";
}
