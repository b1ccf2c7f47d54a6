#include "cast_scene.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <cmath>

namespace {

using cast_scene::RequestOfScene;
using cast_scene::Storage;
using vo::test::Field;
using vo::test::Scene;

constexpr int kSize = 96;
const vo::VoxelSize kVolume{40, 33, 27};

/// Bumps of all values, 8 bits.
Field bumps(const vo::VoxelSize& size, int levels = 255)
{
    return vo::test::quantised(vo::test::fieldOf(size,
                                                 [](const glm::dvec3& p) {
                                                     return 0.5 +
                                                            0.3 * std::sin(0.5 * p.x) * std::cos(0.4 * p.y) +
                                                            0.2 * std::sin(0.6 * p.z + 0.2 * p.x);
                                                 }),
                               levels);
}

std::vector<float> greyTable(int entries, double opacity)
{
    std::vector<float> table;
    for (int i = 0; i < entries; ++i) {
        const double place = entries > 1 ? static_cast<double>(i) / (entries - 1) : 1.0;
        const auto grey = static_cast<float>(0.2 + 0.8 * place);
        const double alpha = place < 0.4 ? 0.0 : opacity * (place - 0.4) / 0.6;
        table.insert(table.end(), {grey, grey, grey, static_cast<float>(alpha)});
    }
    return table;
}

std::vector<float> colourTable(int entries, double opacity)
{
    std::vector<float> table = greyTable(entries, opacity);
    for (std::size_t i = 0; i < table.size(); i += 4) {
        table[i + 1] = 1.0f - table[i];
        table[i + 2] = 0.5f * table[i] * table[i];
    }
    return table;
}

Scene sceneOf(const Field& field)
{
    Scene scene;
    scene.volume = &field;
    scene.width = kSize;
    scene.height = kSize;
    scene.overlap = 1;
    scene.view = vo::test::orthographicView({20, 30}, field.size, kSize, kSize);
    scene.classification = vo::test::Classification::postInterpolation;
    scene.table = greyTable(256, 0.2);
    return scene;
}

vo::test::Comparison compared(const Scene& scene, const Storage& storage, RequestOfScene& own)
{
    vo::RayCaster caster;
    EXPECT_EQ(caster.refusal(own.request), "");
    vo::CastPicture picture;
    caster.cast(own.request, picture);
    const auto result =
        vo::test::compare(cast_scene::blended(picture, scene), vo::test::referencePicture(scene));
    (void)storage;
    std::printf("    %s\n", result.summary().c_str());
    return result;
}

vo::test::Comparison compared(const Scene& scene, const Storage& storage = {})
{
    RequestOfScene own(scene, storage);
    return compared(scene, storage, own);
}

TEST(RayCast, orthographicViewIsTheReference)
{
    const Field field = bumps(kVolume);
    EXPECT_GT(compared(sceneOf(field)).psnrMasked, 65.0);
}

TEST(RayCast, perspectiveViewIsTheReference)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 40.0);
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
}

TEST(RayCast, axisAlignedPlanesAreTheReference)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.planes = vo::test::SamplingPlanes::axisAligned;
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
    scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 50.0);
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
    scene.view = vo::test::orthographicView({0, 0}, field.size, kSize, kSize);
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
}

TEST(RayCast, shellsAreTheReference)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.planes = vo::test::SamplingPlanes::spherical;
    scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 60.0);
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
    scene.period = glm::dvec3(0.7, 1.0, 2.0);
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
}

TEST(RayCast, bricksAreOneVolume)
{
    const Field field = bumps(kVolume);
    for (const int split : {2, 4}) {
        Storage storage;
        storage.split = split;
        EXPECT_GT(compared(sceneOf(field), storage).psnrMasked, 65.0) << split;
    }
}

TEST(RayCast, eachBlendingIsTheReference)
{
    const Field field = bumps(kVolume);
    using enum vo::test::Compositing;
    for (const auto blending : {max, min, sum})
        for (const bool table : {true, false}) {
            Scene scene = sceneOf(field);
            scene.compositing = blending;
            if (blending == min) scene.background = {1.0, 1.0, 1.0};
            if (!table) scene.classification = vo::test::Classification::none;
            scene.table = colourTable(64, 0.5);
            scene.color = {0.5, 0.7, 0.9, 0.8};
            const auto result = compared(scene);
            // Sums grow with the number of samples, and their errors.
            EXPECT_GT(result.psnrMasked, 60.0) << static_cast<int>(blending) << table;
        }
}

TEST(RayCast, tablesOfAllSizesAreTheReference)
{
    const Field field = bumps(kVolume);
    for (const int entries : {1, 2, 7, 256, 4096, 16384}) {
        Scene scene = sceneOf(field);
        scene.table = colourTable(entries, 0.3);
        scene.color = {0.5, 0.7, 0.9, 0.8};
        EXPECT_GT(compared(scene).psnrMasked, 60.0) << entries;
    }
}

TEST(RayCast, samplesWithoutTableAreTheReference)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.classification = vo::test::Classification::none;
    scene.color = {0.5, 0.7, 0.9, 0.1};
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
    scene.opaqueTexture = true;
    Storage storage;
    storage.texel = vo::TexelFormat::luminance;
    EXPECT_GT(compared(scene, storage).psnrMasked, 65.0);
}

TEST(RayCast, tableBeforeInterpolationIsTheReference)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.classification = vo::test::Classification::preInterpolation;
    scene.table = colourTable(256, 0.3);
    EXPECT_GT(compared(scene).psnrMasked, 80.0);
}

} // namespace
