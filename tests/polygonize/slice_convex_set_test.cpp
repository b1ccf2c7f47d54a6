#include "polygonize/slice_convex_set.h"

#include "cuts.h"
#include "scenes.h"
#include "stack_faces.h"

#include <gtest/gtest.h>

#include <set>

using namespace scenes;
using cuts::Cut, cuts::forViews, cuts::kSize;

namespace {

double volume(const vo::ConvexBody& body)
{
    double sum = 0.0;
    for (std::uint32_t side = 0, first = 0; side < body.from.size(); ++side) {
        const glm::dvec3 &a = body.corners[body.from[first]], &b = body.corners[body.from[side]],
                         &c = body.corners[body.from[body.next[side]]];
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
        if (body.next[side] <= side) first = side + 1;
    }
    return sum;
}

void expectTwinsAgree(const vo::ConvexBody& body)
{
    for (std::uint32_t side = 0; side < body.from.size(); ++side) {
        const std::uint32_t twin = body.twin[side];
        ASSERT_LT(twin, body.from.size());
        EXPECT_EQ(body.from[twin], body.from[body.next[side]]);
        EXPECT_EQ(body.from[body.next[twin]], body.from[side]);
    }
}

Cut sliceAsBody(const TetraSet& set, std::span<const vo::Box> boxes, const vo::Camera& camera,
                const vo::SamplingRequest& request)
{
    const auto body = vo::convexSet(set.view());
    EXPECT_TRUE(body);
    Cut result;
    const vo::SamplingAxis axis = vo::samplingAxis(set.view(), camera, request);
    result.planes = vo::samplingPlanes(set.view(), axis, camera, request);
    vo::Box bounds{set.view().position(0), set.view().position(0)};
    for (const int vertex : set.indices)
        bounds = {glm::min(bounds.lower, set.view().position(vertex)),
                  glm::max(bounds.upper, set.view().position(vertex))};
    vo::BoxLattice lattice;
    lattice.assign(boxes);
    EXPECT_TRUE(lattice.standApart());
    vo::ConvexSlicer slicer;
    vo::PolygonStack stack;
    slicer.slice(*body, bounds, result.planes, axis.set.nearest, lattice, stack);
    for (std::size_t i = 0; i + 1 < stack.runs.size(); ++i)
        EXPECT_LT(stack.runs[i].brick, stack.runs[i + 1].brick);
    result.faces = stack_faces::faces(stack, 3, result.planes);
    return result;
}

/// How many sides lie in seams of the boxes, all of them closed.
int expectClosedSeams(const Faces& faces, std::span<const vo::Box> boxes)
{
    const vo::Box all = hull(boxes);
    return cuts::expectClosedSeams(faces, [&](const Face& face, const glm::dvec3& a, const glm::dvec3& b) {
        return cuts::liesInFace(boxes[static_cast<std::size_t>(face.brick)], a, b) &&
               !cuts::liesInFace(all, a, b);
    });
}

std::vector<TetraSet> convexSets()
{
    TetraSet wedge = cube(glm::dvec3(3, 5, 2), glm::dvec3(44, 40, 47));
    wedge.indices.resize(16); // without one corner tetrahedron
    return {cube(kSize), largeTetra(kSize), cube(glm::dvec3(7, 11, 9), glm::dvec3(31, 37, 40)), wedge};
}

} // namespace

TEST(ConvexBody, partsOfSplitsAddUpAndAreClosed)
{
    vo::BodyCutter cutter;
    vo::ConvexBody body, below, above;
    cutter.makeBox({{1, 2, 3}, {5, 8, 6}}, body);
    EXPECT_DOUBLE_EQ(volume(body), 4 * 6 * 3);
    expectTwinsAgree(body);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 n(normal(random), normal(random), normal(random));
        const glm::dvec3 p =
            glm::dvec3(3, 5, 4.5) + 0.4 * glm::dvec3(normal(random), normal(random), normal(random));
        std::vector<double> distances;
        for (const glm::dvec3& corner : body.corners)
            distances.push_back(glm::dot(n, corner - p));
        cutter.split(body, distances, -1, 0.0, below, above);
        EXPECT_NEAR(volume(below) + volume(above), volume(body), 1e-9);
        expectTwinsAgree(below);
        expectTwinsAgree(above);
        if (volume(below) > 20.0) std::swap(body, below);
        if (i % 10 == 9) cutter.makeBox({{1, 2, 3}, {5, 8, 6}}, body);
    }
}

TEST(ConvexBody, splitBesideOrThroughAFaceLeavesOnePart)
{
    vo::BodyCutter cutter;
    vo::ConvexBody body, below, above;
    cutter.makeBox({glm::dvec3(0), glm::dvec3(1)}, body);
    for (const double at : {0.0, -1.0, 1.0, 2.0}) {
        std::vector<double> distances;
        for (const glm::dvec3& corner : body.corners)
            distances.push_back(corner.x - at);
        cutter.split(body, distances, 0, at, below, above);
        EXPECT_EQ(below.empty(), at <= 0.0);
        EXPECT_EQ(above.empty(), at >= 1.0);
        EXPECT_DOUBLE_EQ(volume(below) + volume(above), 1.0);
    }
}

TEST(ConvexSlicer, facesAreTheSectionsOfTheTetrahedra)
{
    for (const TetraSet& set : convexSets())
        for (const int perAxis : {1, 3}) {
            const std::vector<vo::Box> boxes = bricks(perAxis, kSize);
            forViews(3, 41, [&](const vo::Camera& view) {
                cuts::expectAreasOfSections(sliceAsBody(set, boxes, view, everyVoxel()), set, hull(boxes), 3);
            });
        }
}

TEST(ConvexSlicer, planeHasOneConvexFaceInABox)
{
    for (const TetraSet& set : convexSets())
        forViews(3, 42, [&](const vo::Camera& view) {
            const std::vector<vo::Box> boxes = bricks(2, kSize);
            const Cut sliced = sliceAsBody(set, boxes, view, everyVoxel());
            std::set<std::pair<int, int>> seen;
            ASSERT_FALSE(sliced.faces.all.empty());
            for (const Face& face : sliced.faces.all) {
                EXPECT_TRUE(seen.insert({face.brick, face.sample}).second);
                EXPECT_LE(glm::dot(face.area(), view.depthNormal), 1e-4) << "counterclockwise for the viewer";
                const vo::Box& box = boxes[static_cast<std::size_t>(face.brick)];
                for (int i = 0; i < face.count(); ++i)
                    for (int axis = 0; axis < 3; ++axis) {
                        EXPECT_GE(face.point(i)[axis], box.lower[axis] - 1e-5);
                        EXPECT_LE(face.point(i)[axis], box.upper[axis] + 1e-5);
                    }
            }
        });
}

TEST(ConvexSlicer, seamVerticesAreEqualBitForBit)
{
    for (const TetraSet& set : convexSets())
        forViews(3, 43, [&](const vo::Camera& view) {
            const std::vector<vo::Box> boxes = bricks(3, kSize);
            EXPECT_GT(expectClosedSeams(sliceAsBody(set, boxes, view, everyVoxel()).faces, boxes), 100);
        });
}

TEST(ConvexSlicer, headOnPlanesInFacesAndSeamsLoseNothing)
{
    for (const int perAxis : {1, 2, 3})
        for (const double x : {0.0, 90.0, 180.0, 270.0})
            for (const double y : {0.0, 90.0, 180.0, 270.0})
                for (const double noise : {0.0, 1e-16, -3e-16, 2e-8}) {
                    SCOPED_TRACE(testing::Message() << perAxis << " bricks, turned " << x << " " << y);
                    const std::vector<vo::Box> boxes = bricks(perAxis, kSize);
                    const Cut sliced = sliceAsBody(
                        cube(kSize), boxes, camera(kSize, headOnTurn(x, y, noise), false), everyVoxel(48));
                    ASSERT_EQ(sliced.planes.count, kSize);
                    ASSERT_EQ(sliced.faces.all.size(), boxes.size() / static_cast<std::size_t>(perAxis) * 48);
                    for (const double area : sliced.faces.areas(sliced.planes.count))
                        ASSERT_NEAR(area, 47.0 * 47.0, 1e-3);
                }
}

TEST(ConvexSlicer, boxesKeepLowerFacesAndDropUpperOnesWithANeighbour)
{
    const vo::Camera view = parallelCamera({1, 0, 0});
    const std::vector<vo::Box> two = lattice({0.5, 8.5, 15.5}, {0.5, 15.5}, {0.5, 15.5});
    const Cut sliced = sliceAsBody(cube(16), two, view, everyVoxel());
    for (const Face& face : sliced.faces.all)
        EXPECT_EQ(face.brick, face.point(0).x < 8.5 ? 0 : 1);
    for (const double area : sliced.faces.areas(16))
        EXPECT_EQ(area, 15.0 * 15.0);

    std::vector<vo::Box> three = lattice({0.5, 8.5, 15.5}, {0.5, 8.5, 15.5}, {0.5, 15.5});
    three.pop_back();
    const std::vector<double> areas = sliceAsBody(cube(16), three, view, everyVoxel()).faces.areas(16);
    EXPECT_EQ(areas[7], 15.0 * 15.0) << "x = 8.5";
    EXPECT_EQ(areas[6], 8.0 * 15.0) << "x = 9.5";
}

TEST(ConvexSlicer, equalBoxesEachReceiveTheFaces)
{
    std::vector<vo::Box> boxes = bricks(1, kSize);
    boxes.push_back(boxes[0]);
    forViews(1, 44, [&](const vo::Camera& view) {
        const Cut sliced = sliceAsBody(cube(kSize), boxes, view, everyVoxel());
        std::array<std::vector<float>, 2> records;
        for (const Face& face : sliced.faces.all) {
            std::vector<float>& own = records.at(static_cast<std::size_t>(face.brick));
            own.insert(own.end(), face.records.begin(), face.records.end());
        }
        EXPECT_EQ(records[0], records[1]);
        EXPECT_FALSE(records[0].empty());
    });
}

TEST(ConvexSlicer, stackPlanesAtBothEndsAndInAFlatBoxAreDrawn)
{
    for (const double side : {1.0, -1.0}) {
        const vo::Camera view = parallelCamera({0, 0, side});
        const Cut both =
            sliceAsBody(cube(glm::dvec3(0.5), glm::dvec3(15.5)), bricks(1, 16), view, everySlice(2));
        ASSERT_EQ(both.planes.count, 16);
        for (const Face& face : both.faces.all)
            EXPECT_LT(glm::dot(face.area(), view.depthNormal), 0.0);
        for (const double area : both.faces.areas(16))
            EXPECT_EQ(area, 15.0 * 15.0);

        const Cut flat = sliceAsBody(cube(glm::dvec3(0), glm::dvec3(8, 8, 1)),
                                     lattice({0.5, 7.5}, {0.5, 3.5, 7.5}, {0.5, 0.5}), view, everySlice(2));
        ASSERT_EQ(flat.planes.count, 1);
        EXPECT_EQ(flat.faces.areas(1)[0], 49.0);
    }
}

TEST(ConvexSlicer, boxesThatOverlapDoNotStandApart)
{
    vo::BoxLattice lattice;
    lattice.assign(bricks(3, kSize));
    EXPECT_TRUE(lattice.standApart());
    const std::vector<vo::Box> boxes{{glm::dvec3(0), glm::dvec3(4)},
                                     {glm::dvec3(3, 0, 0), glm::dvec3(8, 4, 4)}};
    lattice.assign(boxes);
    EXPECT_FALSE(lattice.standApart());
}
