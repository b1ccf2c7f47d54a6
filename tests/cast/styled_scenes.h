// Small scenes, and what is read from their pictures.

#pragma once

#include "style/styled_scene.h"

#include <functional>
#include <memory>

namespace styled_scenes {

constexpr double kPi = 3.14159265358979323846;

/// Floats: value(place of the voxel's centre, component).
std::shared_ptr<vo::VoxelTexture> textureOf(const vo::VoxelSize& size, int components,
                                            const std::function<float(const glm::vec3&, int)>& value);
/// The same in bytes.
std::shared_ptr<vo::VoxelTexture> bytesOf(const vo::VoxelSize& size, int components,
                                          const std::function<float(const glm::vec3&, int)>& value);
/// Luminance and alpha, everywhere the same.
std::shared_ptr<vo::VoxelTexture> constantTexture(float luminance, float alpha);
/// A box of 8 voxels a side, sampled once a voxel.
vo::StyledVolume boxOf(std::shared_ptr<const vo::VoxelTexture> texture,
                       const glm::vec3& dimensions = glm::vec3(8.0f));
/// Orthographic, from 20 along +z: planes lie at half voxels of boxes round whole places.
vo::StyledScene orthoScene(int size = 40, double half = 10.0);
vo::StyledScene perspectiveScene(int size = 40);

vo::ScenePicture castOf(const vo::StyledScene& scene, int threads = 1);
glm::vec4 pixelOf(const vo::ScenePicture& picture, int x, int y);
glm::vec4 middleOf(const vo::ScenePicture& picture);
float middleDepth(const vo::ScenePicture& picture);

} // namespace styled_scenes
