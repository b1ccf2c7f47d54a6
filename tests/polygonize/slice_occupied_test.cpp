#include "polygonize/slice_occupied.h"

#include "scenes.h"
#include "stack_faces.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

namespace {

using vo::Box;

constexpr int kSide = 48;

/// Random cells, a third of them occupied.
vo::OccupiedCells someCells(unsigned seed, double part = 0.33)
{
    vo::OccupiedCells cells;
    cells.count = {kSide / 8, kSide / 8, kSide / 8};
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> chance;
    for (std::size_t i = 0; i < cells.count.count(); ++i)
        cells.occupied.push_back(chance(random) < part);
    return cells;
}

vo::PlaneFamily planesAcross(const glm::dvec3& direction, int count)
{
    vo::PlaneFamily planes;
    planes.normal = glm::normalize(direction);
    double low = 0.0, high = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        (planes.normal[axis] < 0 ? low : high) += planes.normal[axis] * kSide;
    planes.spacing = (high - low) / count;
    planes.first = high - 0.5 * planes.spacing;
    planes.count = count;
    return planes;
}

struct Triangle
{
    int brick;
    int plane;
    std::array<glm::dvec3, 3> corners;
};

class OccupiedSlices : public testing::TestWithParam<glm::dvec3>
{
protected:
    void slice(int bricksPerSide, const vo::OccupiedCells& cells)
    {
        boxes_ = scenes::bricks(bricksPerSide, kSide);
        planes_ = planesAcross(GetParam(), 29);
        ASSERT_TRUE(slicer_.slice({glm::dvec3(0.0), glm::dvec3(kSide)}, boxes_, cells, planes_, slices_));
        triangles_.clear();
        for (const auto& run : slices_.runs)
            for (std::size_t i = run.first; i < run.first + run.count; i += 3) {
                const int plane = stack_faces::planeOf(corner(i), planes_);
                triangles_.push_back({run.brick, plane, {corner(i), corner(i + 1), corner(i + 2)}});
            }
    }

    glm::dvec3 corner(std::size_t index) const
    {
        const float* p = slices_.positions.data() + 3 * std::size_t{slices_.indices[index]};
        return {p[0], p[1], p[2]};
    }

    glm::dvec3 areaVector(const Triangle& t) const
    {
        return 0.5 * glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
    }

    /// How many triangles of its brick and plane hold a point; -1 when it is too close to an edge to tell.
    int timesCovered(int plane, const glm::dvec3& p) const
    {
        int times = 0;
        for (const Triangle& t : triangles_) {
            if (t.plane != plane) continue;
            const glm::dvec3 area = areaVector(t);
            const double size = glm::length(area);
            if (size < 1e-9) continue;
            bool inside = true;
            for (std::size_t i = 0; i < 3; ++i) {
                const double side = glm::dot(
                    glm::cross(t.corners[(i + 1) % 3] - t.corners[i], p - t.corners[i]), area / size);
                if (std::abs(side) < 1e-3) return -1;
                inside = inside && side > 0.0;
            }
            times += inside;
        }
        return times;
    }

    /// Points of planes at random, within the outer box of the bricks.
    template <typename Use>
    void forRandomPoints(const Use& use)
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> anywhere(boxes_.front().lower.x, boxes_.back().upper.x);
        int axis = 0;
        for (int i = 1; i < 3; ++i)
            if (std::abs(planes_.normal[i]) > std::abs(planes_.normal[axis])) axis = i;
        for (int i = 0; i < 3000; ++i) {
            const int plane = static_cast<int>(random() % static_cast<unsigned>(planes_.count));
            glm::dvec3 p(anywhere(random), anywhere(random), anywhere(random));
            p[axis] += (planes_.offset(plane) - glm::dot(planes_.normal, p)) / planes_.normal[axis];
            if (p[axis] < boxes_.front().lower[axis] || p[axis] > boxes_.back().upper[axis]) continue;
            use(plane, p);
        }
    }

    std::vector<Box> boxes_;
    vo::PlaneFamily planes_;
    vo::OccupiedSlicer slicer_;
    vo::OccupiedSlices slices_;
    std::vector<Triangle> triangles_;
};

TEST_P(OccupiedSlices, coverEveryOccupiedCellOnceAndNothingTwice)
{
    for (const int bricks : {1, 3}) {
        const vo::OccupiedCells cells = someCells(11, 0.06);
        slice(bricks, cells);
        int inside = 0, outside = 0;
        forRandomPoints([&](int plane, const glm::dvec3& p) {
            const int times = timesCovered(plane, p);
            if (times < 0) return;
            const auto at = [&](int axis) { return static_cast<std::size_t>(p[axis] / 8.0); };
            const bool occupied = cells.occupied[at(0) + 6 * (at(1) + 6 * at(2))];
            if (occupied) {
                EXPECT_EQ(times, 1) << p.x << " " << p.y << " " << p.z;
            } else {
                EXPECT_LE(times, 1) << p.x << " " << p.y << " " << p.z;
                outside += times == 0;
            }
            inside += occupied;
        });
        EXPECT_GT(inside, 30);
        EXPECT_GT(outside, 100) << "some of what is empty has to be left out";
    }
}

TEST_P(OccupiedSlices, noVertexLiesWithinAnEdgeOfATriangle)
{
    for (const int bricks : {1, 3}) {
        slice(bricks, someCells(12));
        std::map<int, std::vector<const Triangle*>> byPlane;
        for (const Triangle& t : triangles_)
            if (glm::length(areaVector(t)) > 1e-9) byPlane[t.plane].push_back(&t);
        for (const auto& [plane, triangles] : byPlane)
            for (const Triangle* a : triangles)
                for (const glm::dvec3& p : a->corners)
                    for (const Triangle* b : triangles)
                        for (std::size_t i = 0; i < 3; ++i) {
                            const glm::dvec3 from = b->corners[i], to = b->corners[(i + 1) % 3];
                            if (p == from || p == to) continue;
                            const double length = glm::length(to - from);
                            const double along = glm::dot(p - from, to - from) / length;
                            const double aside = glm::length(glm::cross(p - from, to - from)) / length;
                            ASSERT_FALSE(along > 1e-4 && along < length - 1e-4 && aside < 1e-4)
                                << "plane " << plane << ": " << p.x << " " << p.y << " " << p.z;
                        }
    }
}

TEST_P(OccupiedSlices, ofFullCellsAreThePlanesThemselves)
{
    slice(3, someCells(1, 2.0));
    forRandomPoints([&](int plane, const glm::dvec3& p) {
        const int times = timesCovered(plane, p);
        EXPECT_TRUE(times == 1 || times == -1);
    });
    EXPECT_NEAR(slices_.area / slices_.wholeArea, 1.0, 0.03);
    slice(3, someCells(1, 0.1));
    EXPECT_LT(slices_.area / slices_.wholeArea, 0.8);
    EXPECT_GT(slices_.perimeter * slices_.perimeter, 16.0 * slices_.area) << "more than one square has";
}

TEST_P(OccupiedSlices, lieInTheirPlaneAndTheirBrickAndRunCounterclockwise)
{
    slice(3, someCells(13));
    ASSERT_FALSE(triangles_.empty());
    int lastBrick = -1, lastPlane = 0;
    for (const Triangle& t : triangles_) {
        for (const glm::dvec3& p : t.corners) {
            EXPECT_NEAR(glm::dot(planes_.normal, p), planes_.offset(t.plane), 1e-4);
            const Box& box = boxes_[static_cast<std::size_t>(t.brick)];
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(p[axis], box.lower[axis]);
                EXPECT_LE(p[axis], box.upper[axis]);
            }
        }
        EXPECT_LE(glm::dot(areaVector(t), planes_.normal), 1e-4) << "the normal points away from the viewer";
        if (t.brick == lastBrick) {
            EXPECT_GE(t.plane, lastPlane) << "far to near";
        }
        EXPECT_GE(t.brick, lastBrick);
        lastBrick = t.brick;
        lastPlane = t.plane;
    }
}

INSTANTIATE_TEST_SUITE_P(Directions, OccupiedSlices,
                         testing::Values(glm::dvec3(0.3, 0.5, 0.8), glm::dvec3(-0.9, 0.2, -0.3),
                                         glm::dvec3(0.1, -1.0, 0.05), glm::dvec3(1, 1, 1),
                                         glm::dvec3(0, 0, -1), glm::dvec3(1, 1e-16, 1e-17),
                                         glm::dvec3(0, 0.6, 0.8)));

TEST(OccupiedSlicer, planesInSeamsBelongToOneBrick)
{
    // Planes at every half voxel from 1/2 to 47.5, seams among them.
    vo::PlaneFamily planes;
    planes.normal = glm::dvec3(1e-17, 1e-16, 1);
    planes.first = kSide - 0.5;
    planes.spacing = 0.5;
    planes.count = 2 * kSide - 1;
    const std::vector<Box> boxes = scenes::bricks(2, kSide);
    vo::OccupiedSlicer slicer;
    vo::OccupiedSlices slices;
    ASSERT_TRUE(slicer.slice({glm::dvec3(0.0), glm::dvec3(kSide)}, boxes, someCells(1, 2.0), planes, slices));
    double area = 0.0;
    for (std::size_t i = 0; i < slices.indices.size(); i += 3) {
        std::array<glm::dvec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const float* q = slices.positions.data() + 3 * std::size_t{slices.indices[i + k]};
            p[k] = {q[0], q[1], q[2]};
        }
        area += 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    }
    const double side = boxes.back().upper.x - boxes.front().lower.x;
    const int inside = static_cast<int>(std::floor(side / 0.5)) + 1;
    EXPECT_NEAR(area, inside * side * side, 1e-3);
}

TEST(OccupiedSlicer, boxesWithGapsAreRefused)
{
    const std::vector<Box> boxes = {{glm::dvec3(0), glm::dvec3(10)},
                                    {glm::dvec3(12, 0, 0), glm::dvec3(20, 10, 10)}};
    vo::OccupiedSlicer slicer;
    vo::OccupiedSlices slices;
    EXPECT_FALSE(slicer.slice({glm::dvec3(0.0), glm::dvec3(kSide)}, boxes, someCells(1),
                              planesAcross({0, 0, 1}, 5), slices));
}

} // namespace
