#include "styled_scenes.h"

#include "cast/cast_scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace styled_scenes {

using vo::ScenePicture;
using vo::StyledScene;
using vo::StyledVolume;

std::shared_ptr<vo::VoxelTexture> textureOf(const vo::VoxelSize& size, int components,
                                            const std::function<float(const glm::vec3&, int)>& value)
{
    auto texture = std::make_shared<vo::VoxelTexture>();
    texture->size = size;
    texture->components = components;
    texture->kind = vo::TexelKind::float32;
    std::vector<float> texels;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int c = 0; c < components; ++c) {
                    const glm::vec3 place = (glm::vec3(x, y, z) + 0.5f) / glm::vec3(size.x, size.y, size.z);
                    texels.push_back(value(place, c));
                }
    texture->texels.resize(texels.size() * sizeof(float));
    std::memcpy(texture->texels.data(), texels.data(), texture->texels.size());
    return texture;
}

std::shared_ptr<vo::VoxelTexture> bytesOf(const vo::VoxelSize& size, int components,
                                          const std::function<float(const glm::vec3&, int)>& value)
{
    const auto floats = textureOf(size, components, value);
    auto texture = std::make_shared<vo::VoxelTexture>();
    texture->size = size;
    texture->components = components;
    for (std::size_t i = 0; i < floats->texels.size(); i += sizeof(float)) {
        float number;
        std::memcpy(&number, floats->texels.data() + i, sizeof number);
        texture->texels.push_back(
            static_cast<std::byte>(std::lround(255.0f * std::clamp(number, 0.0f, 1.0f))));
    }
    return texture;
}

std::shared_ptr<vo::VoxelTexture> constantTexture(float luminance, float alpha)
{
    return textureOf({8, 8, 8}, 2, [=](const glm::vec3&, int c) { return c == 0 ? luminance : alpha; });
}

StyledVolume boxOf(std::shared_ptr<const vo::VoxelTexture> texture, const glm::vec3& dimensions)
{
    StyledVolume volume;
    volume.voxels = std::move(texture);
    volume.dimensions = dimensions;
    volume.unitLength = volume.spacing = 1.0;
    return volume;
}

StyledScene orthoScene(int size, double half)
{
    StyledScene scene;
    scene.width = scene.height = size;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -20.0});
    scene.clipFromEye = glm::ortho(-half, half, -half, half, 1.0, 100.0);
    return scene;
}

StyledScene perspectiveScene(int size)
{
    StyledScene scene = orthoScene(size);
    scene.clipFromEye = glm::perspective(kPi / 3.0, 1.0, 1.0, 100.0);
    return scene;
}

ScenePicture castOf(const StyledScene& scene, int threads)
{
    ScenePicture picture;
    vo::castScene(scene, threads, picture);
    return picture;
}

glm::vec4 pixelOf(const ScenePicture& picture, int x, int y)
{
    const float* rgba = &picture.rgba[4 * static_cast<std::size_t>(y * picture.width + x)];
    return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

glm::vec4 middleOf(const ScenePicture& picture)
{
    return pixelOf(picture, picture.width / 2, picture.height / 2);
}

float middleDepth(const ScenePicture& picture)
{
    return picture.depth[static_cast<std::size_t>(picture.height / 2 * picture.width + picture.width / 2)];
}

} // namespace styled_scenes
