#include "cast/empty_blocks.h"
#include "cast/sample_ramps.h"

#include "support/views.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using namespace vo::test;

constexpr int kWidth = 40, kHeight = 30;
constexpr vo::VoxelSize kSize{20, 24, 17};

/// A box of tetrahedra, seen in some way.
struct RampScene
{
    std::vector<float> corners;
    std::vector<int> indices{0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
    vo::CastRequest request;

    explicit RampScene(const View& view)
    {
        const auto x = static_cast<float>(kSize.x), y = static_cast<float>(kSize.y),
                   z = static_cast<float>(kSize.z);
        corners = {0, 0, 0, x, 0, 0, x, y, 0, 0, y, 0, 0, 0, z, x, 0, z, x, y, z, 0, y, z};
        request.model = glm::make_mat4(view.model.data());
        request.projection = glm::make_mat4(view.projection.data());
        request.width = kWidth;
        request.height = kHeight;
        request.tetras = {corners, 3, indices};
        request.sampling.period = glm::dvec3(0.8);
        request.sampling.maxSamples = 1000;
    }

    vo::Camera camera() const { return *vo::findCamera(request.model, request.projection); }
    std::optional<vo::SampleRamps> ramps() const { return vo::sampleRamps(vo::rayFrame(request, camera())); }
};

glm::dvec3 sampleAt(const vo::SampleRamps& ramps, int x, int y, int j)
{
    glm::dvec3 p(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        p[axis] = ramps.base[i](x, y) + j * ramps.step[i](x, y);
    }
    return p;
}

TEST(SampleRamps, lieOnThePlanesUnderThePixelsCentres)
{
    for (const View& view : {orthographicView({20, 30}, kSize, kWidth, kHeight),
                             perspectiveView({-40, 130}, kSize, kWidth, kHeight, 60)}) {
        const RampScene scene(view);
        const vo::PlaneFamily planes =
            vo::samplingPlanes(scene.request.tetras, scene.camera(), scene.request.sampling);
        const std::optional<vo::SampleRamps> ramps = scene.ramps();
        ASSERT_TRUE(ramps);
        ASSERT_EQ(ramps->count, planes.count);
        for (const int x : {0, 13, kWidth - 1})
            for (const int y : {0, 8, kHeight - 1})
                for (const int j : {0, 5, planes.count - 1}) {
                    const glm::dvec3 p = sampleAt(*ramps, x, y, j);
                    EXPECT_NEAR(glm::dot(planes.normal, p), planes.offset(planes.count - 1 - j), 1e-9);
                    const glm::dvec4 seen =
                        scene.request.projection * scene.request.model * glm::dvec4(p, 1.0);
                    EXPECT_NEAR((seen.x / seen.w + 1.0) * 0.5 * kWidth, x + 0.5, 1e-9);
                    EXPECT_NEAR((seen.y / seen.w + 1.0) * 0.5 * kHeight, y + 0.5, 1e-9);
                }
    }
}

TEST(SampleRamps, areBoundedByTheViewVolumeClipPlanesAndFacesOfABox)
{
    const vo::Box box{{2, 3, 4}, {15, 17, 11}};
    const std::vector<glm::vec4> clipPlanes{{1, 0.5, 0.25, 3}};
    for (View view : {orthographicView({20, 30}, kSize, kWidth, kHeight),
                      perspectiveView({-40, 130}, kSize, kWidth, kHeight, 60)}) {
        view.model = multiply(translation(0, 0, 10), view.model);
        RampScene scene(view);
        scene.request.clipPlanes = clipPlanes;
        const std::optional<vo::SampleRamps> ramps = scene.ramps();
        ASSERT_TRUE(ramps);
        const auto faces = vo::boxBounds(*ramps, box);
        int inBox = 0, inView = 0, outOfView = 0;
        for (int x = 0; x < kWidth; ++x)
            for (int y = 0; y < kHeight; ++y)
                for (int j = 0; j < ramps->count; ++j) {
                    const auto holds = [&](const vo::SampleBound& bound) {
                        return bound.base(x, y) + j * bound.step(x, y) <= 0.0;
                    };
                    const glm::dvec3 p = sampleAt(*ramps, x, y, j);
                    for (int axis = 0; axis < 3; ++axis) {
                        const auto i = static_cast<std::size_t>(axis);
                        ASSERT_EQ(holds(faces[i]), p[axis] >= box.lower[axis]);
                        ASSERT_EQ(holds(faces[i + 3]), p[axis] <= box.upper[axis]);
                    }
                    const glm::dvec4 eye = scene.request.model * glm::dvec4(p, 1.0);
                    const glm::dvec4 clip = scene.request.projection * eye;
                    const bool seen =
                        std::abs(clip.z) <= clip.w && glm::dot(glm::dvec4(clipPlanes[0]), eye) >= 0.0;
                    ASSERT_EQ(std::ranges::all_of(ramps->bounds, holds), seen);
                    inBox += std::ranges::all_of(faces, holds);
                    (seen ? inView : outOfView) += 1;
                }
        EXPECT_GT(inBox, 100);
        EXPECT_GT(inView, 100);
        EXPECT_GT(outOfView, 100);
    }
}

TEST(SampleRamps, areNoneWhereStepsDifferOtherwise)
{
    RampScene scene(perspectiveView({20, 30}, kSize, kWidth, kHeight, 60));
    scene.request.sampling.mode = vo::SamplingMode::spherical;
    EXPECT_FALSE(scene.ramps());
    scene.request.sampling.mode = vo::SamplingMode::axisAligned;
    EXPECT_FALSE(scene.ramps());
    RampScene parallel(orthographicView({20, 30}, kSize, kWidth, kHeight));
    for (const auto mode : {vo::SamplingMode::spherical, vo::SamplingMode::axisAligned}) {
        parallel.request.sampling.mode = mode;
        EXPECT_TRUE(parallel.ramps());
    }
}

TEST(BlockDistances, areThoseAlongTheAxisThatIsFarthest)
{
    constexpr int kMost = 9;
    std::mt19937 random(7);
    for (const glm::ivec3 count : {glm::ivec3(13, 9, 11), glm::ivec3(1, 30, 2), glm::ivec3(1, 1, 1)})
        for (const unsigned rarity : {3u, 100u, 100000u}) {
            std::vector<std::uint8_t> distance(static_cast<std::size_t>(count.x * count.y * count.z));
            std::vector<glm::ivec3> zeros;
            const auto number = [&](const glm::ivec3& p) {
                return static_cast<std::size_t>((p.z * count.y + p.y) * count.x + p.x);
            };
            const auto forEach = [&](const auto& visit) {
                for (int z = 0; z < count.z; ++z)
                    for (int y = 0; y < count.y; ++y)
                        for (int x = 0; x < count.x; ++x)
                            visit(glm::ivec3(x, y, z));
            };
            forEach([&](const glm::ivec3& p) {
                const bool zero = random() % rarity == 0;
                if (zero) zeros.push_back(p);
                distance[number(p)] = zero ? 0 : kMost;
            });
            vo::findBlockDistances(count, distance.data());
            forEach([&](const glm::ivec3& p) {
                int expected = kMost;
                for (const glm::ivec3& zero : zeros)
                    expected = std::min(expected, std::max({std::abs(p.x - zero.x), std::abs(p.y - zero.y),
                                                            std::abs(p.z - zero.z)}));
                ASSERT_EQ(distance[number(p)], expected) << p.x << " " << p.y << " " << p.z;
            });
        }
}

} // namespace
