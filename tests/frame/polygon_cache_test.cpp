#include "frame/polygon_cache.h"

#include "../polygonize/scenes.h"

#include <gtest/gtest.h>

#include <map>

using namespace scenes;

namespace {

constexpr double kSize = 48.0;

vo::PolygonRequest requestOf(const TetraSet& set, std::span<const vo::Box> boxes, const vo::Camera& view)
{
    return {set.view(), boxes, view, everyVoxel()};
}

/// Area of all triangles, by brick.
std::map<int, double> areas(const vo::PolygonCache& cache, int values)
{
    std::map<int, double> sums;
    for (const vo::PolygonCache::Run& run : cache.runs())
        for (std::size_t i = run.first; i < run.first + run.count; i += 3) {
            std::array<glm::dvec3, 3> p;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::size_t end = (cache.indices()[i + corner] + 1u) * static_cast<std::size_t>(values);
                p[corner] = {cache.records()[end - 3], cache.records()[end - 2], cache.records()[end - 1]};
            }
            sums[run.brick] += 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
        }
    return sums;
}

std::map<int, double> areasOfPolygonize(const TetraSet& set, std::span<const vo::Box> boxes,
                                        const vo::Camera& view, const vo::SamplingRequest& sampling)
{
    Faces faces(set.values);
    vo::PolygonizeWorkspace workspace;
    vo::polygonize(set.view(), boxes, view, sampling, workspace, faces);
    std::map<int, double> sums;
    for (const Face& face : faces.all)
        sums[face.brick] += glm::length(face.area());
    return sums;
}

void expectSame(const std::map<int, double>& found, const std::map<int, double>& expected)
{
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [brick, area] : expected)
        EXPECT_NEAR(found.at(brick), area, 1e-5 * area + 1e-3) << "brick " << brick;
}

const vo::Camera kView = camera(kSize, gl_matrices::rotate(33, {1, 2, 0.3}), true);

} // namespace

TEST(PolygonCache, holdsWhatPolygonizeGives)
{
    for (const TetraSet& set : {cube(kSize), jitteredLattice(3, 2, kSize - 2, 0.0, 1),
                                jitteredLattice(4, -6, kSize + 6, 0.12, 7), cube(kSize).withValues(7)})
        for (const int perAxis : {1, 3})
            for (const vo::SamplingMode mode : {vo::SamplingMode::viewportAligned,
                                                vo::SamplingMode::axisAligned, vo::SamplingMode::spherical})
                for (const vo::SamplingSpace space :
                     {vo::SamplingSpace::object, vo::SamplingSpace::viewVolume,
                      vo::SamplingSpace::primitive}) {
                    SCOPED_TRACE(testing::Message() << set.view().tetraCount() << " tetrahedra, " << perAxis
                                                    << ", mode " << int(mode) << ", space " << int(space));
                    const std::vector<vo::Box> boxes = bricks(perAxis, kSize);
                    vo::PolygonRequest request = requestOf(set, boxes, kView);
                    request.sampling.mode = mode;
                    request.sampling.space = space;
                    if (mode == vo::SamplingMode::spherical) request.sampling.period = glm::dvec3(6.0);
                    vo::PolygonCache cache;
                    ASSERT_TRUE(cache.update(request, 0.0));
                    EXPECT_FALSE(cache.bricksInterleave());
                    expectSame(areas(cache, set.values),
                               areasOfPolygonize(set, boxes, kView, request.sampling));
                }
}

TEST(PolygonCache, bodyOfBarePositionsHasOnePolygonAPlane)
{
    const std::vector<vo::Box> box = bricks(1, kSize);
    vo::PolygonCache cache;
    const auto records = [&](const TetraSet& set) {
        cache.update(requestOf(set, box, kView), 0.0);
        return cache.records().size() / static_cast<std::size_t>(set.values);
    };
    const std::size_t asBody = records(cube(kSize));
    EXPECT_LE(asBody, static_cast<std::size_t>(6 * cache.samples()));
    EXPECT_GT(records(cube(kSize).withValues(3)), 2 * asBody) << "values are those of the tetrahedra";
}

TEST(PolygonCache, manyTetrahedraAreTakenAsABodyWhenTheyComeAgain)
{
    const std::vector<vo::Box> box = bricks(1, kSize);
    const TetraSet set = jitteredLattice(6, 0, kSize, 0.0, 1);
    vo::PolygonCache cache;
    ASSERT_TRUE(cache.update(requestOf(set, box, kView), 0.0));
    const std::map<int, double> before = areas(cache, 3);
    const std::size_t recordsBefore = cache.records().size();
    cache.invalidate();
    ASSERT_TRUE(cache.update(requestOf(set, box, kView), 0.0));
    EXPECT_LT(cache.records().size(), recordsBefore / 10);
    expectSame(areas(cache, 3), before);
}

TEST(PolygonCache, isMadeAnewWhenSomethingChanges)
{
    const std::vector<vo::Box> boxes = bricks(2, kSize), others = bricks(3, kSize);
    TetraSet set = cube(kSize);
    vo::PolygonCache cache;
    vo::PolygonRequest request = requestOf(set, boxes, kView);
    const auto anew = [&] { return cache.update(request, 0.0) && !cache.update(request, 0.0); };
    EXPECT_TRUE(anew());
    request.camera.eye.x += 1.0;
    EXPECT_TRUE(anew());
    request.sampling.period = glm::dvec3(2.0);
    EXPECT_TRUE(anew());
    request.clipBoxes = others;
    EXPECT_TRUE(anew());
    set.records[0] -= 1.0f;
    EXPECT_TRUE(anew());
    expectSame(areas(cache, 3), areasOfPolygonize(set, others, request.camera, request.sampling));
    set.indices.resize(8);
    request.tetras = set.view();
    EXPECT_TRUE(anew());
    expectSame(areas(cache, 3), areasOfPolygonize(set, others, request.camera, request.sampling));
    cache.invalidate();
    EXPECT_TRUE(anew());
}

TEST(PolygonCache, turnsBelowTheThresholdKeepThePolygons)
{
    const std::vector<vo::Box> boxes = bricks(1, kSize);
    const TetraSet set = cube(kSize);
    vo::PolygonCache cache;
    vo::PolygonRequest request = requestOf(set, boxes, camera(kSize, glm::dmat4(1), false));
    EXPECT_TRUE(cache.update(request, 2.0));
    request.camera = camera(kSize, gl_matrices::rotate(1.9, {0, 1, 0}), false);
    EXPECT_FALSE(cache.update(request, 2.0));
    request.camera = camera(kSize, gl_matrices::rotate(2.1, {0, 1, 0}), false);
    EXPECT_TRUE(cache.update(request, 2.0));
}

TEST(PolygonCache, runsOfVoxelCoordinatesAreOneSampleEach)
{
    const TetraSet set = cube(kSize).withVoxels([](const glm::dvec3& voxel) { return voxel; });
    const std::vector<vo::Box> boxes = bricks(2, kSize);
    vo::PolygonCache cache;
    cache.update(requestOf(set, boxes, kView), 0.0);
    ASSERT_TRUE(cache.bricksInterleave());
    const vo::PlaneFamily planes = vo::samplingPlanes(set.view(), kView, everyVoxel());
    double lastOffset = HUGE_VAL;
    for (const vo::PolygonCache::Run& run : cache.runs()) {
        const std::size_t record = 6u * cache.indices()[run.first];
        const glm::dvec3 p(cache.records()[record + 3], cache.records()[record + 4],
                           cache.records()[record + 5]);
        const double offset = glm::dot(planes.normal, p);
        EXPECT_LT(offset, lastOffset + 1e-3) << "farthest first";
        lastOffset = offset;
    }
    expectSame(areas(cache, 6), areasOfPolygonize(set, boxes, kView, everyVoxel()));
}
