#include "cast/cast_scene.h"
#include "styled_scenes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>
#include <limits>

namespace {

using namespace styled_scenes;
using vo::ScenePicture;
using vo::StyledScene;
using vo::StyledVolume;

TEST(castScene, constantVolumeIsAsOpaqueAsItIsLong)
{
    for (const double spacing : {1.0, 0.5, 0.125}) {
        StyledScene scene = orthoScene();
        scene.background.opacity = 0.0f;
        scene.volumes.push_back(boxOf(constantTexture(0.5f, 0.1f)));
        scene.volumes[0].spacing = spacing;
        const glm::vec4 pixel = middleOf(castOf(scene));
        const double opacity = 1.0 - std::pow(0.9, 8.0);
        EXPECT_NEAR(pixel.a, opacity, 1e-5);
        EXPECT_NEAR(pixel.r, 0.5 * opacity, 1e-5);
    }
}

TEST(castScene, lengthIsMeasuredInTheVolumesOwnSpace)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(constantTexture(1.0f, 0.1f)));
    scene.volumes[0].worldFromLocal = glm::scale(glm::dmat4(1.0), {1.0, 1.0, 2.0});
    EXPECT_NEAR(middleOf(castOf(scene)).r, 1.0 - std::pow(0.9, 8.0), 1e-5);
}

TEST(castScene, slantedRaysInPerspectiveAreLonger)
{
    StyledScene scene = perspectiveScene();
    scene.volumes.push_back(boxOf(constantTexture(1.0f, 0.1f), {80.0f, 80.0f, 8.0f}));
    const ScenePicture picture = castOf(scene);
    for (const int x : {0, 10, 20, 39}) {
        const double slope = std::tan(kPi / 6.0);
        const glm::dvec3 ray(slope * ((x + 0.5) / 20.0 - 1.0), slope * (0.5 / 20.0), 1.0);
        EXPECT_NEAR(pixelOf(picture, x, 20).r, 1.0 - std::pow(0.9, 8.0 * glm::length(ray)), 1e-4);
    }
}

TEST(castScene, backgroundShowsThroughWhatIsClear)
{
    StyledScene scene = orthoScene();
    scene.background.sky = {{0.25f, 0.5f, 0.75f}};
    scene.volumes.push_back(boxOf(constantTexture(0.0f, 0.1f)));
    const ScenePicture picture = castOf(scene);
    EXPECT_EQ(pixelOf(picture, 0, 0), glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
    const double through = std::pow(0.9, 8.0);
    EXPECT_NEAR(middleOf(picture).g, 0.5 * through, 1e-5);
    EXPECT_NEAR(middleOf(picture).a, 1.0, 1e-6);
}

TEST(castScene, skyAndGroundChangeByAngle)
{
    StyledScene scene;
    scene.width = 1;
    scene.height = 181;
    scene.clipFromEye = glm::perspective(kPi / 2.0, 1.0 / 181.0, 1.0, 10.0);
    scene.background.skyAngles = {1.0f, 1.5f};
    scene.background.sky = {glm::vec3(1.0f), {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    scene.background.groundAngles = {1.2f};
    scene.background.ground = {glm::vec3(0.0f), {0.0f, 0.0f, 1.0f}};
    const ScenePicture picture = castOf(scene);
    for (int y = 0; y < 181; ++y) {
        const double angle = kPi / 2.0 - std::atan((y + 0.5) / 90.5 - 1.0); // from the zenith
        glm::dvec3 expected(0.0, 1.0, 0.0);
        if (kPi - angle <= 1.2)
            expected = {0.0, 0.0, (kPi - angle) / 1.2};
        else if (angle < 1.0)
            expected = {1.0, 1.0 - angle, 1.0 - angle};
        else if (angle < 1.5)
            expected = {1.0 - (angle - 1.0) / 0.5, (angle - 1.0) / 0.5, 0.0};
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(pixelOf(picture, 0, y)[c], expected[c], 1e-3) << "row " << y << " channel " << c;
    }
}

TEST(castScene, ballIsARoundDisc)
{
    StyledScene scene = orthoScene(100);
    const auto ball = [](const glm::vec3& place, int c) {
        return c == 0 || glm::length(place - 0.5f) < 0.4f ? 1.0f : 0.0f;
    };
    scene.volumes.push_back(boxOf(textureOf({32, 32, 32}, 2, ball), glm::vec3(16.0f)));
    scene.volumes[0].unitLength = scene.volumes[0].spacing = 0.5;
    const ScenePicture picture = castOf(scene);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const double radius = std::hypot((x + 0.5) / 5.0 - 10.0, (y + 0.5) / 5.0 - 10.0);
            const float red = pixelOf(picture, x, y).r;
            EXPECT_TRUE(radius > 5.6 || red > 0.99f) << x << " " << y;
            EXPECT_TRUE(radius < 7.2 || red == 0.0f) << x << " " << y;
        }
}

TEST(castScene, overlappingVolumesAreMergedByDepth)
{
    // Red from z = 4 down to -4, green from 0 down to -8: red, then both in turn, then green.
    StyledScene scene = orthoScene();
    const auto colored = [](int channel) {
        return textureOf({8, 8, 8}, 4, [=](const glm::vec3&, int c) {
            return c == 3 ? 0.1f : c == channel ? 1.0f : 0.0f;
        });
    };
    scene.volumes = {boxOf(colored(1)), boxOf(colored(0))};
    scene.volumes[0].worldFromLocal = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -4.0});
    double through = 1.0;
    glm::dvec2 expected(0.0);
    for (double z = 3.5; z > -8.0; z -= 1.0) {
        if (z < 0.0) expected.y += through * 0.1, through *= 0.9;
        if (z > -4.0) expected.x += through * 0.1, through *= 0.9;
    }
    const glm::vec4 pixel = middleOf(castOf(scene));
    EXPECT_NEAR(pixel.r, expected.x, 1e-5);
    EXPECT_NEAR(pixel.g, expected.y, 1e-5);
}

TEST(castScene, depthIsWhereHalfIsOpaque)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(constantTexture(1.0f, 0.2f)));
    const ScenePicture picture = castOf(scene);
    // 1 - 0.8^4 is the first above 1/2: planes lie at 16.5, 17.5, 18.5 and 19.5.
    EXPECT_FLOAT_EQ(middleDepth(picture), 19.5f);
    EXPECT_EQ(picture.depth[0], std::numeric_limits<float>::infinity());
}

TEST(castScene, clipPlanesCutVolumes)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(constantTexture(1.0f, 0.1f)));
    scene.volumes[0].clipPlanes = {{0.0, 0.0, -1.0, 1.0}, {1.0, 0.0, 0.0, 2.0}};
    const ScenePicture picture = castOf(scene);
    EXPECT_NEAR(middleOf(picture).r, 1.0 - std::pow(0.9, 5.0), 1e-5);
    EXPECT_EQ(pixelOf(picture, 15, 20).r, 0.0f);
    EXPECT_GT(pixelOf(picture, 16, 20).r, 0.0f);
}

TEST(castScene, halvesAtAClipPlaneThroughCentersShareNoPixel)
{
    // Pixels are 1 wide, the middle of the ninth lies at 1/2: all numbers are exact.
    StyledScene scene = orthoScene(16, 8.0);
    scene.volumes.assign(2, boxOf(constantTexture(1.0f, 0.1f)));
    scene.volumes[0].clipPlanes = {{1.0, 0.0, 0.0, -0.5}};
    scene.volumes[1].clipPlanes = {{-1.0, 0.0, 0.0, 0.5}};
    const ScenePicture picture = castOf(scene);
    for (int x = 4; x < 12; ++x)
        EXPECT_NEAR(pixelOf(picture, x, 8).r, 1.0 - std::pow(0.9, 8.0), 1e-5) << x;
}

TEST(castScene, nearAndFarPlanesCutVolumes)
{
    StyledScene scene = orthoScene();
    scene.clipFromEye = glm::ortho(-10.0, 10.0, -10.0, 10.0, 18.0, 23.0);
    scene.volumes.push_back(boxOf(constantTexture(1.0f, 0.1f)));
    EXPECT_NEAR(middleOf(castOf(scene)).r, 1.0 - std::pow(0.9, 5.0), 1e-5);
}

TEST(castScene, threadsChangeNoBit)
{
    StyledScene scene = perspectiveScene(150);
    scene.volumes.push_back(boxOf(textureOf({20, 20, 20}, 1, [](const glm::vec3& p, int) {
        return 0.5f + 0.5f * std::sin(9.0f * p.x + 5.0f * p.y * p.z);
    })));
    scene.volumes[0].spacing = 0.3;
    const ScenePicture one = castOf(scene, 1);
    const ScenePicture many = castOf(scene, 4);
    EXPECT_EQ(one.rgba, many.rgba);
    EXPECT_EQ(one.depth, many.depth);
}

/// A square of 12 across +z, seen from there.
vo::StyledSurface squareOf(double z, float transparency)
{
    vo::StyledSurface surface;
    surface.worldFromLocal = glm::translate(glm::dmat4(1.0), {0.0, 0.0, z});
    surface.positions = {{-6, -6, 0}, {6, -6, 0}, {6, 6, 0}, {-6, 6, 0}};
    surface.normals.assign(4, {0, 0, 1});
    surface.triangles = {0, 1, 2, 0, 2, 3};
    surface.lit = false;
    surface.emissive = {0.0f, 0.0f, 1.0f};
    surface.transparency = transparency;
    return surface;
}

TEST(castSurfaces, translucentTriangleStandsBetweenSamples)
{
    for (const bool perspective : {false, true}) {
        StyledScene scene = perspective ? perspectiveScene() : orthoScene();
        scene.volumes.push_back(boxOf(constantTexture(1.0f, 0.1f)));
        scene.surfaces.push_back(squareOf(0.7, 0.75f));
        const glm::vec4 pixel = middleOf(castOf(scene));
        // Four samples before it (z from 3.5 to 0.5 without the last), five behind.
        const double front = std::pow(0.9, 3.0);
        const double behind = 1.0 - std::pow(0.9, 5.0);
        EXPECT_NEAR(pixel.r, 1.0 - front + front * 0.75 * behind, 1e-3);
        EXPECT_NEAR(pixel.b, pixel.r + front * 0.25, 1e-3);
    }
}

/// Too many for a tile at once. Each is redder than the one before it.
TEST(castSurfaces, hundredsOfLayersAreInTheirOrder)
{
    constexpr int kLayers = 700;
    constexpr double kOpacity = 0.004;
    StyledScene scene = orthoScene();
    scene.surfaces.push_back(squareOf(-6.0, 0.0f));
    double red = 0.0, through = 1.0;
    for (int i = 0; i < kLayers; ++i) {
        const int layer = i * 331 % kLayers;
        scene.surfaces.push_back(squareOf(5.0 - 0.01 * layer, static_cast<float>(1.0 - kOpacity)));
        scene.surfaces.back().emissive = {static_cast<float>(layer) / kLayers, 0.0f, 0.0f};
        red += through * kOpacity * i / kLayers;
        through *= 1.0 - kOpacity;
    }
    const ScenePicture picture = castOf(scene);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 8 && x < 32 && y >= 8 && y < 32;
            ASSERT_NEAR(pixelOf(picture, x, y).r, inside ? red : 0.0, 1e-4) << x << " " << y;
            ASSERT_NEAR(pixelOf(picture, x, y).b, inside ? through : 0.0, 1e-4) << x << " " << y;
        }
}

/// Layers that lean forward, the upper halves of which are in front of a square, the lower ones behind it.
TEST(castSurfaces, layersHideWhatIsBehindThemAlone)
{
    StyledScene scene = orthoScene();
    for (int i = 0; i < 200; ++i) {
        scene.surfaces.push_back(squareOf(-3.0 - 0.001 * i, 0.9f));
        scene.surfaces.back().worldFromLocal =
            glm::rotate(scene.surfaces.back().worldFromLocal, 0.5, {1.0, 0.0, 0.0});
    }
    scene.surfaces.push_back(squareOf(-2.0, 0.5f));
    scene.surfaces.back().emissive = {0.0f, 1.0f, 0.0f};
    const ScenePicture picture = castOf(scene);
    EXPECT_NEAR(pixelOf(picture, 20, 12).g, 0.5, 1e-5);
    EXPECT_NEAR(pixelOf(picture, 20, 12).b, 0.5, 1e-3);
    EXPECT_NEAR(pixelOf(picture, 20, 28).g, 0.0, 1e-3);
    EXPECT_NEAR(pixelOf(picture, 20, 28).b, 1.0, 1e-3);
}

TEST(castSurfaces, opaqueOneHidesWhatIsBehind)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(constantTexture(1.0f, 0.1f)));
    scene.surfaces = {squareOf(-1.0, 0.0f), squareOf(2.0, 0.0f), squareOf(-3.0, 0.5f)};
    const ScenePicture picture = castOf(scene);
    EXPECT_NEAR(middleOf(picture).r, 1.0 - 0.81, 1e-5);
    EXPECT_NEAR(middleOf(picture).b, 1.0, 1e-5);
    EXPECT_FLOAT_EQ(middleDepth(picture), 18.0f);
}

TEST(castSurfaces, trianglesCoverEachPixelOnceAndNoOther)
{
    // The diagonal runs through the middles of pixels; the edges lie between them.
    StyledScene scene = orthoScene();
    scene.surfaces.push_back(squareOf(0.0, 0.5f));
    const ScenePicture picture = castOf(scene);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 8 && x < 32 && y >= 8 && y < 32;
            EXPECT_FLOAT_EQ(pixelOf(picture, x, y).b, inside ? 0.5f : 0.0f) << x << " " << y;
        }
}

TEST(castSurfaces, solidOnesAreSeenFromOutsideAlone)
{
    StyledScene scene = orthoScene();
    scene.surfaces.push_back(squareOf(0.0, 0.0f));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), kPi, {0.0, 1.0, 0.0});
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0});
    const std::vector<std::pair<glm::dmat4, float>> cases{
        {glm::dmat4(1.0), 1.0f}, {turn, 0.0f}, {mirror, 1.0f}, {turn * mirror, 0.0f}};
    for (const auto& [matrix, seen] : cases) {
        scene.surfaces[0].worldFromLocal = matrix;
        scene.surfaces[0].solid = true;
        EXPECT_EQ(middleOf(castOf(scene)).b, seen);
        scene.surfaces[0].solid = false;
        EXPECT_EQ(middleOf(castOf(scene)).b, 1.0f);
    }
}

TEST(castSurfaces, areLitFromTheirSide)
{
    StyledScene scene = orthoScene();
    vo::StyledSurface square = squareOf(0.0, 0.0f);
    square.lit = true;
    square.solid = false;
    square.emissive = {0.1f, 0.0f, 0.0f};
    square.diffuse = {0.5f, 0.25f, 1.0f};
    square.ambientIntensity = 0.4f;
    vo::StyleLight light;
    light.direction = {0.6f, 0.0f, -0.8f};
    light.intensity = 0.5f;
    light.ambientIntensity = 0.5f;
    square.lights = {light};
    scene.surfaces.push_back(square);
    for (const double angle : {0.0, kPi}) {
        scene.surfaces[0].worldFromLocal = glm::rotate(glm::dmat4(1.0), angle, {0.0, 1.0, 0.0});
        const glm::vec4 pixel = middleOf(castOf(scene));
        const double strength = 0.5 * 0.4 + 0.5 * 0.8;
        EXPECT_NEAR(pixel.r, 0.1 + 0.5 * strength, 1e-5);
        EXPECT_NEAR(pixel.g, 0.25 * strength, 1e-5);
        EXPECT_NEAR(pixel.b, 1.0 * strength, 1e-5);
    }
}

TEST(castSurfaces, colorsChangeInPerspective)
{
    // A floor from under the eye to far ahead, brighter with its distance.
    StyledScene scene = perspectiveScene();
    vo::StyledSurface floor;
    floor.positions = {{-100, -5, 40}, {100, -5, 40}, {100, -5, -60}, {-100, -5, -60}};
    floor.normals.assign(4, {0, 1, 0});
    floor.triangles = {0, 1, 2, 0, 2, 3};
    const float ends[4] = {0.0f, 0.0f, 1.0f, 1.0f};
    for (const float end : ends)
        floor.colors.emplace_back(end, 0.0f, 0.0f, 1.0f);
    vo::StyleLight light;
    light.direction = {0, -1, 0};
    floor.lights = {light};
    scene.surfaces.push_back(floor);
    const ScenePicture picture = castOf(scene);
    for (int y = 0; y < 20; ++y) {
        const double depth = 5.0 / (std::tan(kPi / 6.0) * (1.0 - (y + 0.5) / 20.0));
        const bool seen = depth <= 80.0;
        EXPECT_NEAR(pixelOf(picture, 20, y).r, seen ? (20.0 + depth) / 100.0 : 0.0, 1e-4) << y;
    }
}

TEST(castSurfaces, clipPlanesCutThem)
{
    StyledScene scene = orthoScene();
    scene.surfaces.push_back(squareOf(0.0, 0.0f));
    scene.surfaces[0].clipPlanes = {{1.0, 0.0, 0.0, 0.0}};
    const ScenePicture picture = castOf(scene);
    EXPECT_EQ(pixelOf(picture, 19, 20).b, 0.0f);
    EXPECT_EQ(pixelOf(picture, 20, 20).b, 1.0f);
}

TEST(castSurfaces, facesThatLieInClipPlanesAreWhole)
{
    StyledScene scene = perspectiveScene();
    for (const double z : {0.0, 0.1}) {
        scene.surfaces = {squareOf(z, 0.0f)};
        const ScenePicture whole = castOf(scene);
        scene.surfaces[0].clipPlanes = {{0.0, 0.0, -1.0, z}};
        EXPECT_EQ(castOf(scene).rgba, whole.rgba) << z;
        scene.surfaces[0].clipPlanes = {{0.0, 0.0, -1.0, z - 1e-6}};
        EXPECT_EQ(middleOf(castOf(scene)).b, 0.0f) << z;
    }
}

TEST(castSurfaces, nonsenseIsLeftOut)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::function<void(vo::StyledSurface&)>> spoils{
        [](vo::StyledSurface& s) { s.triangles = {0, 1, 7, 0, -2, 3, 1}; },
        [](vo::StyledSurface& s) { s.positions.resize(2), s.normals.resize(2); },
        [](vo::StyledSurface& s) { s.normals.resize(3); },
        [](vo::StyledSurface& s) { s.colors.resize(1); },
        [](vo::StyledSurface& s) { s.positions.assign(4, {}); },
        [=](vo::StyledSurface& s) { s.positions.assign(4, glm::vec3(nan)); },
        [](vo::StyledSurface& s) { s.worldFromLocal = glm::dmat4(0.0); },
    };
    for (const auto& spoil : spoils) {
        StyledScene scene = orthoScene();
        scene.surfaces.push_back(squareOf(0.0, 0.0f));
        spoil(scene.surfaces[0]);
        EXPECT_EQ(middleOf(castOf(scene)).b, 0.0f);
    }
}

TEST(castPoints, stipplesAreOpaquePixelsBySurfaces)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(constantTexture(0.25f, 1.0f)));
    scene.volumes[0].stipple.emplace();
    scene.volumes[0].stipple->interiorFactor = 0.0f;
    ScenePicture picture = castOf(scene);
    EXPECT_EQ(middleOf(picture), glm::vec4(0.25f, 0.25f, 0.25f, 1.0f));
    EXPECT_GE(middleDepth(picture), 16.0f);
    EXPECT_LT(middleDepth(picture), 17.0f);
    EXPECT_EQ(pixelOf(picture, 0, 0), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    scene.surfaces = {squareOf(5.0, 0.5f), squareOf(0.0, 0.0f)};
    EXPECT_EQ(middleOf(castOf(scene)), glm::vec4(0.125f, 0.125f, 0.625f, 1.0f));
    scene.surfaces[1] = squareOf(4.5, 0.0f);
    EXPECT_EQ(middleOf(castOf(scene)), glm::vec4(0.0f, 0.0f, 1.0f, 1.0f));
}

TEST(castScene, nonsenseIsLeftOut)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto empty = std::make_shared<vo::VoxelTexture>();
    const auto spoiled = [&](const std::function<void(StyledScene&)>& spoil) {
        StyledScene scene = perspectiveScene(8);
        scene.background.sky = {{0.0f, 0.0f, 1.0f}};
        scene.volumes.push_back(boxOf(constantTexture(1.0f, 1.0f)));
        spoil(scene);
        return castOf(scene);
    };
    const std::vector<std::function<void(StyledVolume&)>> spoils{
        [&](StyledVolume& v) { v.voxels = nullptr; },
        [&](StyledVolume& v) { v.voxels = empty; },
        [&](StyledVolume& v) { v.dimensions.y = 0.0f; },
        [&](StyledVolume& v) { v.dimensions.x = static_cast<float>(nan); },
        [&](StyledVolume& v) { v.worldFromLocal[1][1] = nan; },
        [&](StyledVolume& v) { v.worldFromLocal = glm::dmat4(0.0); },
        [&](StyledVolume& v) { v.spacing = nan; },
        [&](StyledVolume& v) { v.spacing = 1e-300; },
        [&](StyledVolume& v) { v.unitLength = 0.0; },
        [&](StyledVolume& v) { v.chains.clear(); },
    };
    for (const auto& spoil : spoils)
        EXPECT_EQ(middleOf(spoiled([&](StyledScene& s) { spoil(s.volumes[0]); })), glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(middleOf(spoiled([&](StyledScene& s) { s.clipFromEye[0][0] = nan; })), glm::vec4(0.0f));
    EXPECT_EQ(middleOf(spoiled([&](StyledScene& s) { s.eyeFromWorld = glm::dmat4(0.0); })), glm::vec4(0.0f));
    EXPECT_TRUE(spoiled([&](StyledScene& s) { s.width = 0; }).rgba.empty());
    EXPECT_TRUE(spoiled([&](StyledScene& s) { s.height = -5; }).rgba.empty());
}

TEST(castScene, oneVoxelIsAConstantVolume)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(textureOf({1, 1, 1}, 1, [](const glm::vec3&, int) { return 0.25f; })));
    scene.volumes[0].unitLength = 8.0;
    EXPECT_NEAR(middleOf(castOf(scene)).a, 1.0, 1e-6);
    EXPECT_NEAR(middleOf(castOf(scene)).r, 0.25 * 0.25, 1e-5);
}

TEST(castScene, valuesThatAreNoNumbersDoNoHarm)
{
    StyledScene scene = orthoScene(8);
    scene.volumes.push_back(boxOf(textureOf({4, 4, 4}, 1, [](const glm::vec3& p, int) {
        return p.x < 0.5f ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    })));
    for (const float number : castOf(scene).rgba)
        EXPECT_FALSE(std::isnan(number));
}

} // namespace
