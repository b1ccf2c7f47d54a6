// Slices of a volume of which most is clear.

#include "cast/clear_space.h"
#include "draw/occupied_layers.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>

#include <random>

namespace {

using namespace vo;

const glm::dvec3 kSize(70.0, 60.0, 50.0), kMiddle(6.0, 54.0, 6.0);
constexpr double kRadius = 9.0;

/// One byte a voxel: those within kRadius of kMiddle are 255.
std::shared_ptr<const VoxelTexture> ball(bool nearest)
{
    auto voxels = std::make_shared<VoxelTexture>();
    voxels->size = {70, 60, 50};
    voxels->nearest = nearest;
    for (int z = 0; z < 50; ++z)
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 70; ++x) {
                const double distance = glm::distance(glm::dvec3(x, y, z) + 0.5, kMiddle);
                voxels->texels.push_back(distance < kRadius ? std::byte{255} : std::byte{0});
            }
    return voxels;
}

StyledScene ballScene(const std::shared_ptr<const VoxelTexture>& voxels)
{
    StyledScene scene;
    scene.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -4.0)), 0.7,
                                     glm::dvec3(0.48, 0.6, 0.64));
    scene.clipFromEye = glm::perspective(1.0, 1.0, 0.1, 10.0);
    StyledVolume& volume = scene.volumes.emplace_back();
    volume.dimensions = {1.4f, 1.2f, 1.0f};
    volume.voxels = voxels;
    volume.spacing = 0.05;
    volume.chains = {{}};
    return scene;
}

glm::dvec3 cornerOf(const VolumeLayers& layers, std::size_t index)
{
    const float* at = layers.stack.records.data() + 3 * std::size_t{layers.stack.indices[index]};
    return {at[0], at[1], at[2]};
}

/// In the volume, or up to so far beyond it.
bool isIn(const glm::dvec3& point, double beyond)
{
    return glm::all(glm::greaterThan(point, glm::dvec3(-beyond))) &&
           glm::all(glm::lessThan(point, kSize + beyond));
}

/// How many triangles of a layer have a point, as seen along z.
int trianglesAt(const VolumeLayers& layers, const SliceLayer& layer, const glm::dvec2& point)
{
    int count = 0;
    for (std::size_t i = layer.first; i < layer.first + layer.count; i += 3) {
        double sides[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 a(cornerOf(layers, i + k)), b(cornerOf(layers, i + (k + 1) % 3));
            sides[k] = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
        }
        const bool inside =
            (sides[0] > 0 && sides[1] > 0 && sides[2] > 0) || (sides[0] < 0 && sides[1] < 0 && sides[2] < 0);
        count += inside;
    }
    return count;
}

double areaOf(const VolumeLayers& layers)
{
    double area = 0.0;
    for (std::size_t i = 0; i < layers.stack.indices.size(); i += 3)
        area += 0.5 * glm::length(glm::cross(cornerOf(layers, i + 1) - cornerOf(layers, i),
                                             cornerOf(layers, i + 2) - cornerOf(layers, i)));
    return area;
}

/// Points of planes in the ball, between voxels too, which are each in one triangle of their plane.
void expectBallIsCut(const StyledScene& scene, const VolumeLayers& layers)
{
    const PlaneRange planes = planesOf(scene, scene.volumes[0]);
    const glm::dvec3 normal(planes.depthRow);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> offset(-kRadius, kRadius);
    int found = 0;
    for (const SliceLayer& layer : layers.layers)
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 free = kMiddle + glm::dvec3(offset(random), offset(random), 0.0);
            const double z =
                (layer.depth - planes.depthRow.w - normal.x * free.x - normal.y * free.y) / normal.z;
            const glm::dvec3 point(free.x, free.y, z);
            if (glm::distance(point, kMiddle) > kRadius || !isIn(point, -1e-3)) continue;
            ++found;
            EXPECT_EQ(trianglesAt(layers, layer, glm::dvec2(point)), 1) << layer.depth << ", " << i;
        }
    EXPECT_GT(found, 20);
}

TEST(cutOccupiedLayers, cutsWhatIsSeenAndLittleElse)
{
    for (const bool nearest : {false, true}) {
        const StyledScene scene = ballScene(ball(nearest));
        const StyledVolume& volume = scene.volumes[0];
        const PaddedVoxels voxels(*volume.voxels, 1);
        const ClearBlocks clear = clearBlocksOf(volume, voxels.blocks(), {});
        ASSERT_FALSE(clear.empty());
        OccupiedSlicer slicer;
        VolumeLayers layers;
        ASSERT_TRUE(cutOccupiedLayers(scene, volume, clear, slicer, layers));
        expectBallIsCut(scene, layers);
        for (std::size_t i = 0; i < layers.stack.indices.size(); ++i)
            EXPECT_TRUE(isIn(cornerOf(layers, i), 1e-4)) << i;
        for (std::size_t i = 1; i < layers.layers.size(); ++i)
            EXPECT_NEAR(layers.layers[i - 1].depth - layers.layers[i].depth, volume.spacing, 1e-9);
        // Blocks of 8 voxels, joined by twos along one axis, are at most so much wider than the ball.
        const double edge = 2.0 * kRadius + 2.0 * 16.0,
                     step = glm::length(glm::dvec3(planesOf(scene, volume).depthRow));
        EXPECT_LT(areaOf(layers), edge * edge * edge * step / volume.spacing);
    }
}

TEST(cutOccupiedLayers, declinesWhereLittleIsClear)
{
    auto full = std::make_shared<VoxelTexture>(*ball(false));
    std::fill(full->texels.begin(), full->texels.end(), std::byte{255});
    full->texels[0] = std::byte{0};
    const StyledScene scene = ballScene(full);
    const PaddedVoxels voxels(*full, 1);
    const ClearBlocks clear = clearBlocksOf(scene.volumes[0], voxels.blocks(), {});
    OccupiedSlicer slicer;
    VolumeLayers layers;
    EXPECT_FALSE(!clear.empty() && cutOccupiedLayers(scene, scene.volumes[0], clear, slicer, layers));
}

} // namespace
