// Scenes of volumes with styles through OpenGL: closed forms.

#include "draw/draw_scene.h"
#include "offscreen/offscreen.h"
#include "style/styles.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

using namespace vo;

constexpr int kPixels = 64;

TexturePointer bytes(VoxelSize size, int components, const std::function<int(glm::ivec3, int)>& value)
{
    auto texture = std::make_shared<VoxelTexture>();
    texture->size = size;
    texture->components = components;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int c = 0; c < components; ++c)
                    texture->texels.push_back(static_cast<std::byte>(value({x, y, z}, c)));
    return texture;
}

/// A volume two wide round the origin, seen along -z from 4 in front of it.
StyledScene sceneOf(TexturePointer voxels, bool perspective)
{
    StyledScene scene;
    scene.width = scene.height = kPixels;
    scene.background.opacity = 0.0f;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -4.0));
    scene.clipFromEye =
        perspective ? glm::perspective(0.5, 1.0, 1.0, 10.0) : glm::ortho(-1.5, 1.5, -1.5, 1.5, 1.0, 10.0);
    StyledVolume volume;
    volume.dimensions = glm::vec3(2.0f);
    const VoxelSize& size = voxels->size;
    volume.unitLength = 2.0 / std::max({size.x, size.y, size.z});
    volume.spacing = volume.unitLength;
    volume.voxels = std::move(voxels);
    scene.volumes.push_back(volume);
    return scene;
}

class SceneDrawing : public testing::TestWithParam<OffscreenProfile>
{
protected:
    void SetUp() override
    {
        OffscreenRequest request;
        request.profile = GetParam();
        request.width = request.height = kPixels;
        request.floatColor = true;
        std::string whyNot;
        context_ = openOffscreen(request, &whyNot);
        ASSERT_TRUE(context_) << whyNot;
    }

    const GladGLContext& gl() const { return context_->gl(); }
    std::vector<float> picture(const StyledScene& scene)
    {
        gl().ClearColor(0, 0, 0, 0);
        gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawer_.draw(scene);
        return context_->readFloats();
    }

    std::unique_ptr<OffscreenContext> context_;
    SceneDrawer drawer_;
};

INSTANTIATE_TEST_SUITE_P(Profiles, SceneDrawing,
                         testing::Values(OffscreenProfile::Core, OffscreenProfile::Compatibility),
                         [](const auto& test) {
                             return test.param == OffscreenProfile::Core ? "core" : "compatibility";
                         });

const float* pixelAt(const std::vector<float>& picture, int x, int y)
{
    return picture.data() + 4 * (y * kPixels + x);
}

TEST_P(SceneDrawing, constantVolumeHasTheOpacityOfItsLength)
{
    const double value = 51 / 255.0;
    const StyledScene scene = sceneOf(bytes({16, 16, 16}, 1, [](glm::ivec3, int) { return 51; }), false);
    const std::vector<float> drawn = picture(scene);
    // 16 voxels deep; colour and opacity are the value.
    const double alpha = 1.0 - std::pow(1.0 - value, 16.0);
    EXPECT_NEAR(pixelAt(drawn, 32, 32)[3], alpha, 1e-4);
    EXPECT_NEAR(pixelAt(drawn, 32, 32)[0], value * alpha, 1e-4);
    EXPECT_EQ(pixelAt(drawn, 2, 32)[3], 0.0f);
}

TEST_P(SceneDrawing, slantedRaysOfAPerspectiveAreLonger)
{
    const double value = 10 / 255.0;
    const StyledScene scene = sceneOf(bytes({16, 16, 16}, 1, [](glm::ivec3, int) { return 10; }), true);
    const std::vector<float> drawn = picture(scene);
    const auto expected = [&](double pixel) {
        const double slope = (2.0 * (pixel + 0.5) / kPixels - 1.0) * std::tan(0.25);
        const double middle = std::tan(0.25) / kPixels;
        const double length = std::sqrt(1.0 + slope * slope + middle * middle);
        return 1.0 - std::pow(1.0 - value, 16.0 * length);
    };
    EXPECT_NEAR(pixelAt(drawn, 32, 32)[3], expected(32), 1e-4);
    EXPECT_NEAR(pixelAt(drawn, 50, 32)[3], expected(50), 1e-4);
}

} // namespace
