#include "polygonize/slice_stack.h"

#include "cuts.h"
#include "scenes.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <limits>
#include <tuple>

using namespace scenes;
using cuts::forViews, cuts::kSize, cuts::turnedIntoUnitCube;

namespace {

struct Polygon
{
    int brick;
    std::vector<float> records;

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Begins with the least record: which one is the first says nothing.
std::vector<float> turned(const std::vector<float>& records, std::size_t size)
{
    std::vector<float> least = records, other = records;
    for (std::size_t i = size; i < records.size(); i += size) {
        std::ranges::rotate(other, other.begin() + static_cast<std::ptrdiff_t>(size));
        least = std::min(least, other);
    }
    return least;
}

/// The polygons in the order of the stack, without vertices that repeat the one before; those of fewer than
/// three vertices left out.
std::vector<Polygon> polygonsOf(const vo::PolygonStack& stack, int values)
{
    const auto size = static_cast<std::size_t>(values);
    const auto same = [&](const float* a, const float* b) {
        return std::equal(a + size - 3, a + size, b + size - 3);
    };
    std::vector<Polygon> polygons;
    std::size_t expectedFirst = 0;
    for (const vo::PolygonStack::Run& run : stack.runs) {
        EXPECT_EQ(run.first, expectedFirst) << "runs follow each other";
        expectedFirst += run.count;
        for (std::size_t i = run.first; i < run.first + run.count;) {
            const std::uint32_t first = stack.indices[i + 2];
            std::uint32_t last = first + 1;
            for (; i < run.first + run.count && stack.indices[i + 2] == first; i += 3) {
                EXPECT_EQ(stack.indices[i], last);
                EXPECT_EQ(stack.indices[i + 1], ++last);
            }
            EXPECT_LT(last, stack.records.size() / size);
            std::vector<float> kept;
            for (std::uint32_t vertex = first; vertex <= last; ++vertex) {
                const float* record = stack.records.data() + vertex * size;
                if (kept.empty() || !same(record, kept.data() + kept.size() - size))
                    kept.insert(kept.end(), record, record + size);
            }
            while (kept.size() > size && same(kept.data() + kept.size() - size, kept.data()))
                kept.resize(kept.size() - size);
            if (kept.size() >= 3 * size) polygons.push_back({run.brick, turned(kept, size)});
        }
    }
    EXPECT_EQ(stack.indices.size(), expectedFirst);
    return polygons;
}

/// What polygonize() gives, in the same order.
std::vector<Polygon> expectedPolygons(const TetraSet& set, std::span<const vo::Box> boxes,
                                      const vo::Camera& camera, const vo::SamplingRequest& request,
                                      vo::StackOrder order, int& samples)
{
    Faces faces(set.values);
    vo::PolygonizeWorkspace workspace;
    samples = vo::polygonize(set.view(), boxes, camera, request, workspace, faces).samples;
    std::ranges::stable_sort(faces.all, {}, [&](const Face& face) {
        return order == vo::StackOrder::byBrick ? std::pair(face.brick, face.sample)
                                                : std::pair(face.sample, face.brick);
    });
    std::vector<Polygon> polygons;
    for (const Face& face : faces.all)
        polygons.push_back({face.brick, turned(face.records, static_cast<std::size_t>(set.values))});
    return polygons;
}

void expectPolygonsOfPolygonize(const TetraSet& set, std::span<const vo::Box> boxes, const vo::Camera& camera,
                                const vo::SamplingRequest& request, vo::StackSlicer& slicer, int threads = 0)
{
    for (const vo::StackOrder order : {vo::StackOrder::byBrick, vo::StackOrder::bySample}) {
        vo::PolygonStack stack;
        const vo::PolygonizeResult result =
            slicer.slice(set.view(), boxes, camera, request, order, threads, stack);
        int samples = 0;
        const std::vector<Polygon> expected = expectedPolygons(set, boxes, camera, request, order, samples);
        EXPECT_EQ(result.samples, samples);
        EXPECT_TRUE(result.complete);
        const std::vector<Polygon> found = polygonsOf(stack, set.values);
        ASSERT_EQ(found.size(), expected.size());
        const auto [one, other] = std::ranges::mismatch(found, expected);
        if (one == found.end()) continue;
        EXPECT_EQ(one->brick, other->brick);
        ASSERT_EQ(one->records, other->records);
    }
}

std::vector<TetraSet> sets()
{
    TetraSet mirrored = jitteredLattice(3, 3, kSize - 5, 0.1, 4);
    for (std::size_t i = 0; i < mirrored.indices.size(); i += 8)
        std::swap(mirrored.indices[i + 2], mirrored.indices[i + 3]);
    for (const int vertex : {0, 1, 2, 3, 5, 5, 5, 5}) // flat ones
        mirrored.indices.push_back(vertex);
    return {cube(kSize), largeTetra(kSize), jitteredLattice(5, -6.0, kSize + 6.0, 0.12, 7), mirrored,
            jitteredLattice(4, 2, kSize - 3, 0.1, 3).withValues(7)};
}

} // namespace

TEST(StackSlicer, polygonsAreThoseOfPolygonizeBitForBit)
{
    vo::StackSlicer slicer;
    for (const TetraSet& set : sets())
        for (const int perAxis : {1, 3})
            forViews(1, 51, [&](const vo::Camera& view) {
                SCOPED_TRACE(testing::Message()
                             << set.view().tetraCount() << " tetrahedra, bricks per axis " << perAxis);
                expectPolygonsOfPolygonize(set, bricks(perAxis, kSize), view, everyVoxel(), slicer);
            });
}

TEST(StackSlicer, everyModeAndSpaceOfPlanesIsThatOfPolygonize)
{
    vo::StackSlicer slicer;
    for (const vo::SamplingMode mode : {vo::SamplingMode::viewportAligned, vo::SamplingMode::axisAligned})
        for (const vo::SamplingSpace space :
             {vo::SamplingSpace::object, vo::SamplingSpace::viewVolume, vo::SamplingSpace::primitive})
            for (const int stackAxis : {-1, 0, 1, 2}) {
                SCOPED_TRACE(testing::Message()
                             << "mode " << int(mode) << ", space " << int(space) << ", stack " << stackAxis);
                vo::SamplingRequest request = everyVoxel();
                request.mode = mode;
                request.space = space;
                request.stackAxis = stackAxis;
                forViews(1, 52, [&](const vo::Camera& view) {
                    expectPolygonsOfPolygonize(jitteredLattice(4, 2, kSize - 3, 0.1, 3), bricks(2, kSize),
                                               view, request, slicer);
                });
            }
}

TEST(StackSlicer, planesInFacesSeamsAndVerticesAreThoseOfPolygonize)
{
    vo::StackSlicer slicer;
    for (const TetraSet& set :
         {cube(kSize), jitteredLattice(3, 0.0, kSize, 0.0, 1), jitteredLattice(6, 0.5, kSize - 0.5, 0.0, 1)})
        for (const double x : {0.0, 90.0, 180.0})
            for (const double noise : {0.0, 1e-16}) {
                const glm::dmat4 turn = headOnTurn(x, 90 - x, noise);
                for (const double period : {1.0, 2.0}) {
                    vo::SamplingRequest request = everyVoxel();
                    request.period = glm::dvec3(period);
                    expectPolygonsOfPolygonize(set, bricks(2, kSize), camera(kSize, turn, false), request,
                                               slicer);
                }
            }
    // Planes on the first and the last face of the set.
    for (const double side : {1.0, -1.0}) {
        for (const auto& boxes : {bricks(1, 16), std::vector<vo::Box>{{glm::dvec3(-1), glm::dvec3(17)}}})
            expectPolygonsOfPolygonize(cube(glm::dvec3(0.5), glm::dvec3(15.5)), boxes,
                                       parallelCamera({0, 0, side}), everySlice(2), slicer);
    }
}

TEST(StackSlicer, planesBeforeInAndBehindAFaceAreThoseOfPolygonize)
{
    vo::StackSlicer slicer;
    const std::vector<double> seams{0.5, 24.5, kSize - 0.5}, ends{0.5, kSize - 0.5};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<vo::Box> boxes =
            lattice(axis == 0 ? seams : ends, axis == 1 ? seams : ends, axis == 2 ? seams : ends);
        for (const bool both : {true, false}) {
            if (!both) boxes.pop_back();
            for (const double side : {1.0, -1.0}) {
                SCOPED_TRACE(testing::Message() << "axis " << axis << ", both " << both << ", side " << side);
                glm::dvec3 along(0), oblique(0.3, -0.2, 0.5);
                along[axis] = side;
                for (const glm::dvec3& direction : {along, side * oblique})
                    expectPolygonsOfPolygonize(cube(glm::dvec3(2), glm::dvec3(kSize - 2)), boxes,
                                               parallelCamera(direction), everySlice(axis), slicer);
            }
        }
    }
}

TEST(StackSlicer, boxesMayRepeatOverlapMissOrBeFlat)
{
    vo::StackSlicer slicer;
    std::vector<vo::Box> twice = bricks(1, kSize), oneTwice = bricks(2, kSize), missing = oneTwice;
    twice.push_back(twice[0]);
    oneTwice.push_back(oneTwice[0]);
    missing.erase(missing.begin() + 3);
    const std::vector<vo::Box> overlapping{{glm::dvec3(0), glm::dvec3(30)},
                                           {glm::dvec3(20), glm::dvec3(kSize)},
                                           {glm::dvec3(10), glm::dvec3(12)}};
    const std::vector<vo::Box> flat = lattice({0.5, 20.5, kSize - 0.5}, {0.5, kSize - 0.5}, {8.0, 8.0});
    const std::vector<vo::Box> apart{{glm::dvec3(0), glm::dvec3(20)}, {glm::dvec3(26), glm::dvec3(kSize)}};
    for (const auto& boxes : {twice, oneTwice, missing, overlapping, flat, apart, std::vector<vo::Box>{}})
        forViews(1, 53, [&](const vo::Camera& view) {
            expectPolygonsOfPolygonize(jitteredLattice(9, 1, kSize - 1, 0.1, 3), boxes, view, everyVoxel(),
                                       slicer);
        });
}

TEST(StackSlicer, bricksCutVoxelCoordinatesWhereRecordsHaveThem)
{
    const TetraSet set = jitteredLattice(5, -6.0, kSize + 6.0, 0.12, 7).withVoxels(turnedIntoUnitCube, {9});
    vo::SamplingRequest request = everyVoxel();
    request.period = glm::dvec3(1 / kSize);
    vo::StackSlicer slicer;
    expectPolygonsOfPolygonize(set, bricks(3, kSize), camera(1, gl_matrices::rotate(33, {1, 2, 0}), true),
                               request, slicer);
}

TEST(StackSlicer, recordsOfEverySizeAreThoseOfPolygonize)
{
    vo::StackSlicer slicer;
    vo::SamplingRequest request = everyVoxel();
    const vo::Camera view = camera(kSize, gl_matrices::rotate(33, {1, 2, 0}), true);
    for (const TetraSet& set : {cube(kSize), jitteredLattice(3, -6.0, kSize + 6.0, 0.12, 7)})
        for (const int more : {0, 1, 3, 4, 6, 7}) {
            SCOPED_TRACE(testing::Message() << more << " values more");
            request.period = glm::dvec3(1.0);
            expectPolygonsOfPolygonize(set.withValues(more), bricks(2, kSize), view, request, slicer);
            request.period = glm::dvec3(1 / kSize);
            const std::vector<float> before(static_cast<std::size_t>(more), 0.5f);
            expectPolygonsOfPolygonize(set.withVoxels(turnedIntoUnitCube, before), bricks(3, kSize),
                                       camera(1, gl_matrices::rotate(33, {1, 2, 0}), true), request, slicer);
        }
}

TEST(StackSlicer, threadsAndPartsChangeNothing)
{
    const TetraSet set = jitteredLattice(12, 1, kSize - 1, 0.1, 9); // parts enough for several threads
    vo::StackSlicer slicer;
    forViews(1, 54, [&](const vo::Camera& view) {
        for (const int threads : {1, 2, 0})
            expectPolygonsOfPolygonize(set, bricks(2, kSize), view, everyVoxel(), slicer, threads);
    });
}

TEST(StackSlicer, verticesAreTheSameOnEveryTarget)
{
    const TetraSet set = jitteredLattice(4, 2, kSize - 3, 0.1, 3);
    vo::StackSlicer slicer;
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
        hwy::SetSupportedTargetsForTest(targets & -targets);
        SCOPED_TRACE(hwy::TargetName(targets & -targets));
        forViews(1, 55, [&](const vo::Camera& view) {
            for (const TetraSet& records : {set, set.withValues(2), jitteredLattice(4, 0, kSize, 0.0, 3)})
                expectPolygonsOfPolygonize(records, bricks(2, kSize), view, everyVoxel(), slicer);
        });
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST(StackSlicer, cornersMayLieAtOnePlace)
{
    std::mt19937 random(57);
    std::uniform_real_distribution<double> coordinate(1.0, kSize - 1.0);
    TetraSet set;
    set.values = 5;
    for (int tetra = 0; tetra < 200; ++tetra) {
        const glm::dvec3 twice(coordinate(random), coordinate(random), coordinate(random));
        for (int corner = 0; corner < 4; ++corner) {
            set.indices.push_back(4 * tetra + corner);
            set.records.push_back(static_cast<float>(random() % 2));
            set.records.push_back(static_cast<float>(random() % 5));
            const bool same = corner == tetra % 4 || corner == (tetra + 1 + tetra / 4 % 3) % 4;
            set.add(same ? twice : glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
        }
    }
    vo::StackSlicer slicer;
    forViews(1, 58, [&](const vo::Camera& view) {
        expectPolygonsOfPolygonize(set, bricks(1, kSize), view, everyVoxel(), slicer);
        vo::PolygonStack stack;
        slicer.slice(set.view(), bricks(1, kSize), view, everyVoxel(), vo::StackOrder::byBrick, 0, stack);
        EXPECT_GT(stack.indices.size(), 0u) << "rounding gives some of them a volume";
    });
}

TEST(StackSlicer, planesThatAreGivenAreCutLikeOthers)
{
    const TetraSet set = jitteredLattice(4, 2, kSize - 3, 0.1, 3);
    const std::vector<vo::Box> boxes = bricks(2, kSize);
    vo::StackSlicer slicer;
    forViews(1, 56, [&](const vo::Camera& view) {
        vo::PolygonStack found, expected;
        const vo::StackOrder order = vo::StackOrder::byBrick;
        slicer.slice(set.view(), boxes, vo::samplingPlanes(set.view(), view, everyVoxel()), order, 0, found);
        slicer.slice(set.view(), boxes, view, everyVoxel(), order, 0, expected);
        EXPECT_FALSE(found.indices.all().empty());
        EXPECT_TRUE(std::ranges::equal(found.records.all(), expected.records.all()));
        EXPECT_TRUE(std::ranges::equal(found.indices.all(), expected.indices.all()));
    });
}

TEST(StackSlicer, nothingToCutGivesNothing)
{
    vo::StackSlicer slicer;
    const vo::Camera view = camera(kSize, glm::dmat4(1), true);
    TetraSet spoilt = cube(kSize);
    spoilt.records[4] = std::numeric_limits<float>::quiet_NaN();
    for (const TetraSet& set : {TetraSet{}, flatTetra(), spoilt})
        expectPolygonsOfPolygonize(set, bricks(2, kSize), view, everyVoxel(), slicer);
}
