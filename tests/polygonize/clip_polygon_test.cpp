#include "polygonize/clip_polygon.h"

#include "polygonize/box_lattice.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>
#include <set>

namespace {

vo::CutPolygon polygonOf(const std::vector<glm::dvec3>& points)
{
    vo::CutPolygon polygon;
    polygon.clear(3);
    for (const glm::dvec3& p : points) {
        const double record[3]{p.x, p.y, p.z};
        polygon.push(record);
    }
    return polygon;
}

double areaOf(const vo::CutPolygon& polygon)
{
    const auto at = [&](int i) {
        return glm::dvec3(polygon.position(i)[0], polygon.position(i)[1], polygon.position(i)[2]);
    };
    glm::dvec3 sum(0);
    for (int i = 1; i + 1 < polygon.count; ++i)
        sum += 0.5 * glm::cross(at(i) - at(0), at(i + 1) - at(0));
    return glm::length(sum);
}

const vo::CutPolygon kSquare = polygonOf({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});

} // namespace

TEST(ClipPolygon, polygonInsideStaysAsItIs)
{
    vo::CutPolygon out;
    vo::clipToSlab(kSquare, 0, 0, 4, out);
    ASSERT_EQ(out.count, 4);
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(std::equal(out.record(i), out.record(i) + 3, kSquare.record(i)));
}

TEST(ClipPolygon, bothSidesOfASlabAreCutAtOnce)
{
    vo::CutPolygon out;
    vo::clipToSlab(kSquare, 0, 1, 3, out);
    EXPECT_EQ(out.count, 4);
    EXPECT_EQ(areaOf(out), 8.0);
}

TEST(ClipPolygon, touchingPolygonsLeaveNothing)
{
    vo::CutPolygon out;
    vo::clipToSlab(kSquare, 0, 4, 9, out);
    EXPECT_EQ(out.count, 0) << "an edge";
    vo::clipToSlab(polygonOf({{0, 0, 0}, {4, 2, 0}, {0, 4, 0}}), 0, 4, 9, out);
    EXPECT_EQ(out.count, 0) << "a vertex";
    vo::clipToSlab(kSquare, 1, 2, 2, out);
    EXPECT_EQ(out.count, 0) << "a line across";
    vo::clipToSlab(kSquare, 0, 5, 9, out);
    EXPECT_EQ(out.count, 0);
    vo::clipToSlab(polygonOf({}), 0, 5, 9, out);
    EXPECT_EQ(out.count, 0);
}

TEST(ClipPolygon, polygonInTheFaceOfABoxStays)
{
    vo::CutPolygon scratch, out;
    vo::clipToBox(kSquare, {{1, 1, 0}, {9, 9, 5}}, scratch, out);
    EXPECT_EQ(areaOf(out), 9.0);
    vo::clipToBox(kSquare, {{1, 1, -5}, {9, 9, 0}}, scratch, out);
    EXPECT_EQ(areaOf(out), 9.0);
}

TEST(ClipPolygon, hexagonOfACubeHasItsArea)
{
    vo::CutPolygon scratch, out;
    // x + y + z = 1.5 across the unit cube.
    vo::clipToBox(polygonOf({{-9, -9, 19.5}, {-9, 19.5, -9}, {19.5, -9, -9}}), {{0, 0, 0}, {1, 1, 1}},
                  scratch, out);
    EXPECT_EQ(out.count, 6);
    EXPECT_NEAR(areaOf(out), 0.75 * std::sqrt(3.0), 1e-14);
}

TEST(ClipPolygon, clippedCoordinatesAreExactlyOnThePlane)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-10, 10);
    vo::CutPolygon out;
    for (int i = 0; i < 2000; ++i) {
        const vo::CutPolygon triangle = polygonOf({{uniform(random), uniform(random), uniform(random)},
                                                   {uniform(random), uniform(random), uniform(random)},
                                                   {uniform(random), uniform(random), uniform(random)}});
        vo::clipToSlab(triangle, i % 3, -0.1, 0.3, out);
        for (int v = 0; v < out.count; ++v) {
            const double c = out.position(v)[i % 3];
            EXPECT_GE(c, -0.1);
            EXPECT_LE(c, 0.3);
        }
    }
}

TEST(ClipPolygon, neighbouringSlabsShareTheSeamBitForBit)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(-10, 10);
    vo::CutPolygon below, above, turned;
    for (int i = 0; i < 2000; ++i) {
        std::vector<glm::dvec3> points(3);
        for (glm::dvec3& p : points)
            p = {uniform(random), uniform(random), uniform(random)};
        vo::clipToSlab(polygonOf(points), 1, -3, 0.7, below);
        std::reverse(points.begin(), points.end());
        vo::clipToSlab(polygonOf(points), 1, 0.7, 5, above);
        const auto seam = [](const vo::CutPolygon& polygon) {
            std::set<std::array<double, 3>> found;
            for (int v = 0; v < polygon.count; ++v)
                if (const double* p = polygon.position(v); p[1] == 0.7) found.insert({p[0], p[1], p[2]});
            return found;
        };
        EXPECT_EQ(seam(below), seam(above));
    }
}

TEST(ClipPolygon, halfSpaceKeepsItsPositiveSide)
{
    vo::CutPolygon out;
    vo::clipToHalfSpace(kSquare, {1, 1, 0, -2}, out);
    EXPECT_EQ(out.count, 5);
    EXPECT_EQ(areaOf(out), 14.0);
    vo::clipToHalfSpace(kSquare, {-1, -1, 0, 2}, out);
    EXPECT_EQ(areaOf(out), 2.0);
    vo::clipToHalfSpace(kSquare, {-1, -1, 0, 4}, out);
    EXPECT_EQ(out.count, 3) << "through two corners";
    vo::clipToHalfSpace(kSquare, {1, 0, 0, -5}, out);
    EXPECT_EQ(out.count, 0);
    vo::clipToHalfSpace(kSquare, {0, 0, 1, 0}, out);
    EXPECT_EQ(out.count, 4) << "in the plane";
}

TEST(ClipPolygon, manyVerticesAndValuesGrowTheRoom)
{
    vo::CutPolygon polygon, out;
    polygon.clear(64);
    std::vector<double> record(64);
    for (int i = 0; i < 100; ++i) {
        const double angle = 0.0628318530717958647 * i;
        record[0] = i;
        record[61] = std::cos(angle);
        record[62] = std::sin(angle);
        polygon.push(record.data());
    }
    vo::clipToSlab(polygon, 0, -0.5, 2, out);
    EXPECT_GT(out.count, 60);
    EXPECT_EQ(polygon.record(99)[0], 99);
}

TEST(BoxLattice, coordinatesNearAnyFaceSnapToTheNearest)
{
    vo::BoxLattice lattice;
    const vo::Box boxes[]{{{0.5, 0, 0}, {8.5, 1, 1}}, {{8.5, 0, 0}, {15.5, 1, 1}}};
    lattice.assign(boxes);
    vo::CutPolygon polygon =
        polygonOf({{0.5 + 9e-6, 0.5, 0.5}, {8.5 - 9e-6, 0.5, 0.5}, {15.5 + 1.1e-5, -9e-6, 1 + 9e-6}});
    lattice.snap(polygon);
    EXPECT_EQ(polygon.position(0)[0], 0.5);
    EXPECT_EQ(polygon.position(1)[0], 8.5);
    EXPECT_EQ(polygon.position(2)[0], 15.5 + 1.1e-5);
    EXPECT_EQ(polygon.position(2)[1], 0.0);
    EXPECT_EQ(polygon.position(2)[2], 1.0);
    EXPECT_EQ(polygon.position(1)[1], 0.5);
}

TEST(BoxLattice, cellsFindTheirBoxes)
{
    vo::BoxLattice lattice;
    // Two of four cells, one of them twice.
    const vo::Box boxes[]{{{0, 0, 0}, {1, 1, 1}}, {{1, 2, 0}, {3, 5, 1}}, {{0, 0, 0}, {1, 1, 1}}};
    lattice.assign(boxes);
    ASSERT_EQ(lattice.intervals(0).size(), 2u);
    ASSERT_EQ(lattice.intervals(1).size(), 2u);
    ASSERT_EQ(lattice.intervals(2).size(), 1u);
    EXPECT_EQ(lattice.intervals(0)[0].next, 1);
    EXPECT_EQ(lattice.intervals(1)[0].next, -1) << "a gap follows";
    const auto twice = lattice.boxes({0, 0, 0});
    ASSERT_EQ(twice.size(), 2u);
    EXPECT_EQ(twice[0].box, 0);
    EXPECT_EQ(twice[1].box, 2);
    EXPECT_EQ(lattice.boxes({1, 1, 0})[0].box, 1);
    EXPECT_TRUE(lattice.boxes({0, 1, 0}).empty());
}
