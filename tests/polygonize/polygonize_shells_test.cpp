#include "polygonize/polygonize.h"
#include "polygonize/sampling_shells.h"

#include "scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

using namespace scenes;

namespace {

constexpr double kSize = 16;
const glm::dvec3 kOutside(20, 9, 27), kInside(7.3, 8.1, 6.2);

vo::Camera cameraAt(const glm::dvec3& eye)
{
    using namespace gl_matrices;
    return vo::findCamera(rotate(33, {1, 2, 0}) * translate(-eye), perspective(100, 1, 0.5, 90)).value();
}

vo::SamplingRequest request(vo::SamplingSpace space = vo::SamplingSpace::object)
{
    vo::SamplingRequest result = everyVoxel();
    result.mode = vo::SamplingMode::spherical;
    result.space = space;
    return result;
}

struct Cut
{
    Cut(const TetraSet& set, std::span<const vo::Box> boxes, const glm::dvec3& eye,
        const vo::SamplingRequest& wanted)
        : shells(vo::samplingShells(set.view(), cameraAt(eye), wanted)), faces(set.values)
    {
        vo::PolygonizeWorkspace workspace;
        result = vo::polygonize(set.view(), boxes, cameraAt(eye), wanted, workspace, faces);
    }

    vo::ShellFamily shells;
    Faces faces;
    vo::PolygonizeResult result;
};

double radiusOf(const vo::ShellFamily& shells, const glm::dvec3& p)
{
    return glm::length((p - shells.eye) / shells.scale);
}

/// How often the ray from the eye meets the faces of a sample, edges left aside.
int meetings(const Faces& faces, int sample, const glm::dvec3& eye, const glm::dvec3& direction)
{
    int count = 0;
    for (const Face& face : faces.all) {
        if (face.sample != sample) continue;
        bool inside = true;
        for (int i = 0; i < face.count() && inside; ++i) {
            const glm::dvec3 a = face.point(i) - eye, b = face.point(i + 1 < face.count() ? i + 1 : 0) - eye;
            inside = glm::dot(glm::cross(a, b), direction) < 0; // counterclockwise for the eye
        }
        count += inside;
    }
    return count;
}

bool isInBox(const glm::dvec3& p, double lower, double upper)
{
    return p.x > lower && p.y > lower && p.z > lower && p.x < upper && p.y < upper && p.z < upper;
}

TEST(SamplingShells, fillTheExactExtentOfTheSet)
{
    const TetraSet set = cube(kSize);
    const vo::ShellFamily outside = vo::samplingShells(set.view(), cameraAt({8, 8, 40}), request());
    const double farthest = std::sqrt(40.0 * 40 + 2 * 64), extent = farthest - 24;
    EXPECT_EQ(outside.count, int(std::ceil(extent)));
    EXPECT_NEAR(outside.spacing, extent / outside.count, 1e-12);
    EXPECT_NEAR(outside.radius(0), farthest - 0.5 * outside.spacing, 1e-12);
    // Nearest are an edge, a corner, or the eye's own place.
    const auto nearest = [&](const glm::dvec3& eye) {
        const vo::ShellFamily s = vo::samplingShells(set.view(), cameraAt(eye), request());
        return s.radius(s.count - 1) - 0.5 * s.spacing;
    };
    EXPECT_NEAR(nearest({-3, 8, 20}), 5, 1e-12);
    EXPECT_NEAR(nearest({-2, -3, 22}), 7, 1e-12);
    EXPECT_NEAR(nearest({7, 8, 9}), 0, 1e-12);
    EXPECT_NEAR(nearest({16, 8, 9}), 0, 1e-12);
}

TEST(SamplingShells, countsAreBoundedAndExactWithoutPeriod)
{
    const TetraSet set = cube(kSize);
    vo::SamplingRequest wanted = request();
    wanted.maxSamples = 5;
    EXPECT_EQ(vo::samplingShells(set.view(), cameraAt(kOutside), wanted).count, 5);
    wanted.period.reset();
    wanted.maxSamples = 77;
    EXPECT_EQ(vo::samplingShells(set.view(), cameraAt(kOutside), wanted).count, 77);
    EXPECT_EQ(vo::samplingShells(TetraSet().view(), cameraAt(kOutside), wanted).count, 0);
}

TEST(SamplingShells, viewVolumeGoesFromItsFarthestCornerToTheNearPlane)
{
    const vo::ShellFamily shells =
        vo::samplingShells(cube(kSize).view(), cameraAt(kOutside), request(vo::SamplingSpace::viewVolume));
    const double slope = std::tan(50 * M_PI / 180);
    const double farthest = 90 * std::sqrt(1 + 2 * slope * slope);
    EXPECT_NEAR(shells.radius(0), farthest, 1e-9);
    EXPECT_NEAR(shells.radius(shells.count - 1), 0.5, 1e-9);
    EXPECT_EQ(shells.count, int(std::ceil(farthest - 0.5)) + 1);
}

TEST(SamplingShells, periodScalesTheSpaceOfTheShells)
{
    vo::SamplingRequest wanted = request();
    wanted.period = glm::dvec3(0.5, 2, 1);
    const TetraSet set = cube(kSize);
    const glm::dvec3 eye(8, 8, 40);
    const vo::ShellFamily shells = vo::samplingShells(set.view(), cameraAt(eye), wanted);
    EXPECT_NEAR(shells.radius(0) + 0.5 * shells.spacing, std::sqrt(16.0 * 16 + 4.0 * 4 + 40.0 * 40), 1e-12);
    EXPECT_NEAR(shells.radius(shells.count - 1) - 0.5 * shells.spacing, 24, 1e-12);
}

TEST(SamplingShells, nearPlaneIsMeasuredInTheScaledSpaceToo)
{
    vo::SamplingRequest wanted = request(vo::SamplingSpace::viewVolume);
    wanted.period = glm::dvec3(0.5, 3, 1);
    const vo::Camera camera = cameraAt(kOutside);
    const vo::ShellFamily shells = vo::samplingShells(cube(kSize).view(), camera, wanted);
    std::array<glm::dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = (camera.corners[i] - kOutside) / *wanted.period;
    const glm::dvec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    EXPECT_NEAR(shells.radius(shells.count - 1), std::abs(glm::dot(normal, p[0])), 1e-6);
}

TEST(ShellGrid, verticesAreTheSameAfterAFullTurnAndAtThePoles)
{
    vo::ShellFamily shells;
    shells.first = 3;
    shells.count = 1;
    vo::ShellGrid grid;
    grid.assign(shells, 0);
    EXPECT_GT(grid.rings(), 10);
    grid.select({0, grid.rings() - 1, -grid.sectors() - 2, 2 * grid.sectors()});
    for (int ring = 0; ring <= grid.rings(); ++ring)
        for (int sector = 0; sector < grid.sectors(); ++sector) {
            const glm::dvec3 vertex = grid.vertex(ring, sector);
            EXPECT_EQ(grid.vertex(ring, sector - grid.sectors()), vertex);
            EXPECT_EQ(grid.vertex(ring, sector + grid.sectors()), vertex);
            if (ring == 0 || ring == grid.rings()) {
                EXPECT_EQ(grid.vertex(ring, 0), vertex);
            }
        }
    vo::ShellGrid part;
    part.assign(shells, 0);
    part.select({3, 4, 5, 6});
    EXPECT_EQ(part.vertex(5, 7), grid.vertex(5, 7));
}

TEST(PolygonizeShells, facetsStayNearTheirShell)
{
    for (const glm::dvec3& eye : {kOutside, kInside, glm::dvec3(8, 8, 400)}) {
        vo::SamplingRequest wanted = request();
        for (const glm::dvec3& period : {glm::dvec3(1), glm::dvec3(0.5, 2, 1)}) {
            wanted.period = period;
            const auto boxes = bricks(2, kSize);
            const Cut cut(cube(kSize), boxes, eye, wanted);
            ASSERT_GT(cut.faces.all.size(), 100u);
            const double allowed = 0.02 * cut.shells.spacing + 2e-5;
            double most = 0, least = 0;
            for (const Face& face : cut.faces.all) {
                glm::dvec3 middle(0);
                for (int i = 0; i < face.count(); ++i)
                    middle += face.point(i) / double(face.count());
                for (int i = 0; i <= face.count(); ++i) {
                    const glm::dvec3 p = i < face.count() ? face.point(i) : middle;
                    const double off = radiusOf(cut.shells, p) - cut.shells.radius(face.sample);
                    most = std::max(most, off);
                    least = std::min(least, off);
                }
            }
            EXPECT_LE(most, allowed);
            EXPECT_GE(least, -allowed);
            // The error is on both sides, and used.
            EXPECT_GT(most, 0.5 * 0.02 * cut.shells.spacing);
        }
    }
}

TEST(PolygonizeShells, everyRayMeetsEveryShellOnce)
{
    std::mt19937 random(4);
    std::normal_distribution<double> component;
    for (const glm::dvec3& eye : {kOutside, kInside})
        for (const bool large : {false, true}) {
            const TetraSet set = large ? jitteredLattice(2, -2, kSize + 2, 0.2, 3) : cube(kSize);
            const auto boxes = bricks(3, kSize);
            const Cut cut(set, boxes, eye, request());
            int inside = 0;
            for (int i = 0; i < 60; ++i) {
                glm::dvec3 target =
                    0.5 * kSize + 3.0 * glm::dvec3(component(random), component(random), component(random));
                const glm::dvec3 direction = glm::normalize(target - eye);
                for (int k = 0; k < cut.result.samples; ++k) {
                    const glm::dvec3 p = eye + direction * cut.shells.radius(k);
                    const bool within = isInBox(p, 0.55, kSize - 0.55);
                    if (!within && isInBox(p, 0.45, kSize - 0.45)) continue;
                    EXPECT_EQ(meetings(cut.faces, k, eye, direction), within ? 1 : 0);
                    inside += within;
                }
            }
            EXPECT_GT(inside, 200);
        }
}

using Position = std::array<float, 3>;

/// Edges of a sample that are not there the other way round too.
std::vector<std::pair<Position, Position>> openEdges(const Faces& faces, int sample)
{
    std::map<std::pair<Position, Position>, int> edges;
    const auto at = [](const Face& face, int i) {
        const float* p = face.position(i % face.count());
        return Position{p[0], p[1], p[2]};
    };
    for (const Face& face : faces.all)
        for (int i = 0; face.sample == sample && i < face.count(); ++i) {
            ++edges[{at(face, i), at(face, i + 1)}];
            --edges[{at(face, i + 1), at(face, i)}];
        }
    std::vector<std::pair<Position, Position>> open;
    for (const auto& [edge, count] : edges)
        if (count != 0) open.push_back(edge);
    return open;
}

TEST(PolygonizeShells, neighboursShareTheirVerticesBitForBit)
{
    const auto boxes = bricks(3, kSize);
    const TetraSet set = jitteredLattice(2, -2, kSize + 2, 0.2, 3);
    for (const glm::dvec3& eye : {kOutside, kInside, glm::dvec3(8, 8, 8)}) {
        const Cut cut(set, boxes, eye, request());
        int closed = 0, onTheBorder = 0;
        for (int k = 0; k < cut.result.samples; ++k) {
            const auto open = openEdges(cut.faces, k);
            closed += open.empty();
            for (const auto& [a, b] : open) {
                bool border = false;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (const float face : {0.5f, float(kSize) - 0.5f})
                        border = border || (a[axis] == face && b[axis] == face);
                EXPECT_TRUE(border) << k << ": " << a[0] << " " << a[1] << " " << a[2] << " to " << b[0]
                                    << " " << b[1] << " " << b[2];
                ++onTheBorder;
            }
        }
        EXPECT_GT(onTheBorder, 100);
        EXPECT_GE(closed, eye == kOutside ? 0 : 3) << "whole shells inside the volume";
    }
}

TEST(PolygonizeShells, tetrahedraOfAnyVertexOrderShareTheirVertices)
{
    const TetraSet set = cube(glm::dvec3(-9), glm::dvec3(9));
    const std::vector<double> seams{-7.5, -2, 7.5};
    const auto boxes = lattice(seams, seams, seams);
    for (const glm::dvec3& eye : {glm::dvec3(0), glm::dvec3(1, 2, 3)}) {
        const Cut cut(set, boxes, eye, request());
        for (int k = 0; k < cut.result.samples; ++k)
            for (const auto& [a, b] : openEdges(cut.faces, k)) {
                bool border = false;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    border = border || (std::abs(a[axis]) == 7.5f && a[axis] == b[axis]);
                EXPECT_TRUE(border) << k;
            }
    }
}

TEST(PolygonizeShells, shellsInsideATetrahedronAreWhole)
{
    const TetraSet set = jitteredLattice(2, -2, kSize + 2, 0.2, 3);
    const vo::Box all{glm::dvec3(-100), glm::dvec3(100)};
    vo::SamplingRequest wanted = request();
    wanted.period = glm::dvec3(0.5);
    for (int tetra = 0; tetra < set.view().tetraCount(); tetra += 5) {
        glm::dvec3 eye(0);
        for (std::size_t i = 0; i < 4; ++i)
            eye += 0.25 * set.view().position(set.indices[std::size_t(tetra) * 4 + i]);
        const Cut cut(set, {&all, 1}, eye, wanted);
        const int nearest = cut.result.samples - 1;
        EXPECT_TRUE(openEdges(cut.faces, nearest).empty());
        double area = 0;
        for (const Face& face : cut.faces.all)
            if (face.sample == nearest) area += glm::length(face.area());
        const double radius = 0.5 * cut.shells.radius(nearest);
        EXPECT_NEAR(area / (4 * M_PI * radius * radius), 1, 0.05); // flat facets of a tiny shell
    }
}

TEST(PolygonizeShells, eyeJustInsideATetrahedronSeesItAllRound)
{
    // All corners are less than 100 degrees from the y axis, but the eye has the tetrahedron on every side.
    // The other tetrahedron puts the poles of the shells near that axis.
    TetraSet set;
    for (const glm::dvec3& p : {glm::dvec3(0, 3, 0),
                                {5, -0.5, 0},
                                {-2.5, -0.5, 4.33},
                                {-2.5, -0.5, -4.33},
                                {20, 0, 6},
                                {21, 0, 6},
                                {20, 1, 6},
                                {20, 0, 7}})
        set.add(p);
    set.indices = {0, 1, 2, 3, 4, 5, 6, 7};
    const vo::Box all{glm::dvec3(-300), glm::dvec3(300)};
    vo::SamplingRequest wanted = request();
    wanted.period = glm::dvec3(0.1);
    const Cut cut(set, {&all, 1}, glm::dvec3(0), wanted);
    EXPECT_TRUE(openEdges(cut.faces, cut.result.samples - 4).empty());  // 0.35 voxels away
    EXPECT_FALSE(openEdges(cut.faces, cut.result.samples - 8).empty()); // 0.75
}

/// One facet, in the face that the two halves of a box share, or outside.
TEST(PolygonizeFacets, facetInASharedFaceIsYieldedOnce)
{
    struct OneFacet : vo::FacetSource
    {
        std::vector<glm::dvec3> corners;
        void facetsOf(int, const vo::Box&, vo::FacetList& facets) override
        {
            facets.corners = corners;
            facets.counts = {int(corners.size())};
        }
    } source;
    TetraSet set; // two tetrahedra that share the triangle in z = 4
    for (const glm::dvec3& p : {glm::dvec3(0, 0, 4), {8, 0, 4}, {0, 8, 4}, {1, 1, 0}, {1, 1, 8}})
        set.add(p);
    const vo::Box all{glm::dvec3(0), glm::dvec3(kSize)};
    source.corners = {{1, 1, 4}, {3, 1, 4}, {3, 3, 4}, {1, 3, 4}};
    for (const auto& indices : {std::vector<int>{0, 1, 2, 3, 0, 1, 2, 4}, {3, 1, 2, 0, 2, 4, 1, 0}}) {
        set.indices = indices;
        vo::PolygonizeWorkspace workspace;
        Faces faces;
        const auto result = vo::polygonize(set.view(), {&all, 1}, source, 2, workspace, faces);
        EXPECT_EQ(result.samples, 2);
        EXPECT_EQ(faces.all.size(), 2u);
        for (const Face& face : faces.all)
            EXPECT_NEAR(face.area().z, 4, 1e-6);
    }
}

TEST(PolygonizeShells, valuesAreInterpolatedLinearly)
{
    const auto boxes = bricks(2, kSize);
    const TetraSet set = jitteredLattice(2, -2, kSize + 2, 0.2, 3).withValues(5);
    for (const glm::dvec3& eye : {kOutside, kInside}) {
        const Cut cut(set, boxes, eye, request());
        ASSERT_GT(cut.faces.all.size(), 100u);
        for (const Face& face : cut.faces.all)
            for (int i = 0; i < face.count(); ++i)
                for (int j = 0; j < 5; ++j)
                    EXPECT_NEAR(double(face.position(i)[j - 5]), linear(j, face.point(i)), 2e-5);
    }
}

TEST(PolygonizeShells, primitivesHaveTheirOwnExtent)
{
    TetraSet set;
    for (const glm::dvec3& p : {glm::dvec3(1, 1, 1),
                                {4, 1, 1},
                                {1, 4, 1},
                                {1, 1, 3},
                                {10, 10, 10},
                                {15, 10, 10},
                                {10, 15, 10},
                                {10, 10, 15}})
        set.add(p);
    set.indices = {0, 1, 2, 3, 4, 5, 6, 7};
    const vo::Box all{glm::dvec3(0), glm::dvec3(kSize)};
    vo::SamplingRequest wanted = request(vo::SamplingSpace::primitive);
    const Cut cut(set, {&all, 1}, {0, 0, 0}, wanted);
    // From the corners' smallest distances to their largest.
    const double near[2] = {std::sqrt(3.0), std::sqrt(300.0)}, far[2] = {std::sqrt(18.0), std::sqrt(425.0)};
    int counts[2];
    for (int tetra = 0; tetra < 2; ++tetra)
        counts[tetra] = int(std::ceil(far[tetra] - near[tetra]));
    EXPECT_EQ(cut.result.samples, counts[1]);
    std::array<std::map<int, int>, 2> found;
    for (const Face& face : cut.faces.all) {
        const int tetra = face.point(0).x > 5;
        const double step = (far[tetra] - near[tetra]) / counts[tetra];
        ++found[std::size_t(tetra)][face.sample];
        EXPECT_NEAR(glm::length(face.point(0)), far[tetra] - (face.sample + 0.5) * step, 0.021 * step);
    }
    EXPECT_EQ(found[0].size(), std::size_t(counts[0]));
    EXPECT_EQ(found[1].size(), std::size_t(counts[1]));
}

TEST(PolygonizeShells, flatAndInfiniteTetrahedraGiveNothing)
{
    TetraSet set = cube(kSize);
    const std::size_t faces = Cut(set, bricks(2, kSize), kOutside, request()).faces.all.size();
    for (const glm::dvec3& p :
         {glm::dvec3(NAN), glm::dvec3(INFINITY), glm::dvec3(3, 3, 3), glm::dvec3(5, 5, 5)})
        set.add(p);
    for (const int bad : {8, 9})
        set.indices.insert(set.indices.end(), {0, 1, 2, bad});
    set.indices.insert(set.indices.end(), {0, 10, 11, 10});
    EXPECT_EQ(Cut(set, bricks(2, kSize), kOutside, request()).faces.all.size(), faces);
    // An eye in a corner of the set.
    EXPECT_GT(Cut(cube(kSize), bricks(2, kSize), glm::dvec3(0), request()).faces.all.size(), 100u);
}

TEST(PolygonizeShells, sinkWithoutRoomStopsTheWork)
{
    struct Full : vo::FaceSink
    {
        int left = 10;
        bool append(int, int, std::span<const float>) override { return left-- > 0; }
    } sink;
    vo::PolygonizeWorkspace workspace;
    const auto boxes = bricks(2, kSize);
    const TetraSet set = cube(kSize);
    const auto result = vo::polygonize(set.view(), boxes, cameraAt(kOutside), request(), workspace, sink);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(sink.left, -1);
}

} // namespace
