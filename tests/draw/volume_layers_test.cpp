// How many planes of a volume a picture shows.

#include "draw/volume_layers.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace vo;

/// A box from depth 3 to depth 5, planes at 3.125, 3.375, ..., 4.875.
StyledScene boxScene(double near, double far)
{
    StyledScene scene;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -4.0));
    scene.clipFromEye = glm::ortho(-2.0, 2.0, -2.0, 2.0, near, far);
    StyledVolume volume;
    volume.dimensions = glm::vec3(2.0f);
    volume.spacing = 0.25;
    auto voxels = std::make_shared<VoxelTexture>();
    voxels->texels.resize(1);
    volume.voxels = voxels;
    scene.volumes.push_back(volume);
    return scene;
}

void expectPlanes(const StyledScene& scene, std::size_t count, double nearest, double farthest)
{
    VolumeLayers layers;
    countPlanes(scene, scene.volumes[0], layers);
    ASSERT_EQ(layers.layers.size(), 1u);
    EXPECT_EQ(layers.layers[0].count, count);
    EXPECT_NEAR(layers.layers[0].depth, nearest, 1e-9);
    EXPECT_NEAR(layers.layers[0].depth + layers.layers[0].reach, farthest, 1e-9);
}

TEST(countPlanes, countsThoseOfWhatIsSeen)
{
    expectPlanes(boxScene(1.0, 10.0), 8, 3.0, 5.0);
    expectPlanes(boxScene(3.5, 10.0), 6, 3.5, 5.0);
    expectPlanes(boxScene(1.0, 4.4), 6, 3.0, 4.4);
    StyledScene clipped = boxScene(1.0, 10.0);
    clipped.volumes[0].clipPlanes = {{0.0, 0.0, -1.0, 0.2}};
    expectPlanes(clipped, 5, 3.8, 5.0);
    VolumeLayers layers;
    const StyledScene behind = boxScene(6.0, 10.0);
    countPlanes(behind, behind.volumes[0], layers);
    EXPECT_TRUE(layers.layers.empty());
}

} // namespace
