#include "cast_scene.h"

#include "cast/empty_blocks.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <hwy/targets.h>

#include <cmath>
#include <functional>
#include <random>

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

vo::ShadingPlan planOf(const std::vector<float>& entries)
{
    vo::Table table;
    table.rgba = entries;
    vo::CastShading shading;
    shading.table = &table;
    return shadingPlan(shading, vo::TexelFormat::intensity, false);
}

/// Colours halfway to the next step, of samples that all have the same value, between two entries and, 170,
/// at one.
TEST(RayCast, smoothTablesAreWithinTheErrorOfTheirSteps)
{
    for (const int byte : {150, 153, 170}) {
        const Field field = vo::test::fieldOf(kVolume, [&](const glm::dvec3&) { return byte / 255.0; });
        for (const bool perspective : {false, true}) {
            Scene scene = sceneOf(field);
            if (perspective) scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 40.0);
            scene.table = colourTable(64, 0.24);
            scene.color = {1.0, 1.0, 1.0, 1.0};
            ASSERT_GT(planOf(scene.table).smoothSteps, 1);
            const auto result = compared(scene);
            EXPECT_LT(result.largestMasked, 1.0 / 2040.0 + 1.0 / 2046.0);
        }
    }
}

TEST(RayCast, tablesAreSmoothWhoseColoursChangeLittleAndOpacitiesAreSmall)
{
    std::vector<float> table = colourTable(256, 0.2);
    EXPECT_GT(planOf(table).smoothSteps, 0);
    EXPECT_EQ(planOf(colourTable(256, 0.3)).smoothSteps, 0);
    EXPECT_EQ(planOf(colourTable(8, 0.2)).smoothSteps, 0);
    table[4 * 100] += 0.05f;
    EXPECT_EQ(planOf(table).smoothSteps, 0);
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

/// The scene where `shown` holds, in the box that an overlap of 1 leaves; its samples by `change`.
Scene restricted(const Scene& scene, std::function<bool(const glm::dvec3&)> shown,
                 std::function<void(const glm::dvec3&, std::array<double, 4>&)> change = {})
{
    Scene result = scene;
    result.sampleAt = [&scene, shown, change](const glm::dvec3& p) -> std::optional<std::array<double, 4>> {
        const glm::dvec3 size(scene.volume->size.x, scene.volume->size.y, scene.volume->size.z);
        for (int axis = 0; axis < 3; ++axis)
            if (p[axis] < 0.5 - 1e-5 || p[axis] > size[axis] - 0.5 + 1e-5) return std::nullopt;
        if (!shown(p)) return std::nullopt;
        std::array<double, 4> sample = vo::test::referenceSample(scene, p);
        if (change) change(p, sample);
        return sample;
    };
    return result;
}

double psnrAgainst(const Scene& truth, const RequestOfScene& own)
{
    vo::RayCaster caster;
    EXPECT_EQ(caster.refusal(own.request), "");
    vo::CastPicture picture;
    caster.cast(own.request, picture);
    const auto result =
        vo::test::compare(cast_scene::blended(picture, truth), vo::test::referencePicture(truth));
    EXPECT_GT(result.opaquePixels, 200u);
    return result.psnrMasked;
}

TEST(RayCast, clipPlanesCutSampleBySample)
{
    const Field field = bumps(kVolume);
    const Scene scene = sceneOf(field);
    RequestOfScene own(scene, {});
    // Two planes in eye space, aslant.
    const glm::vec4 planes[] = {{0.6f, 0.8f, 0.0f, 2.3f}, {-0.3f, 0.2f, 0.9f, 4.7f}};
    own.request.clipPlanes = planes;
    const Scene truth = restricted(scene, [&](const glm::dvec3& p) {
        const glm::dvec4 eye = own.request.model * glm::dvec4(p, 1.0);
        return glm::dot(glm::dvec4(planes[0]), eye) >= 0.0 && glm::dot(glm::dvec4(planes[1]), eye) >= 0.0;
    });
    EXPECT_GT(psnrAgainst(truth, own), 65.0);
    EXPECT_LT(psnrAgainst(scene, own), 40.0);
}

TEST(RayCast, opaqueThingsHideWhatIsBehind)
{
    const Field field = bumps(kVolume);
    for (const bool perspective : {false, true})
        for (const bool reversed : {false, true}) {
            Scene scene = sceneOf(field);
            if (perspective) scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 40.0);
            RequestOfScene own(scene, {});
            own.request.depth.nearDepth = reversed ? 0.9 : 0.1;
            own.request.depth.farDepth = reversed ? 0.1 : 0.8;
            const auto depthOf = [&](const glm::dvec3& p) {
                const glm::dvec4 clip = own.request.projection * own.request.model * glm::dvec4(p, 1.0);
                const double place = 0.5 * clip.z / clip.w + 0.5;
                return own.request.depth.nearDepth +
                       (own.request.depth.farDepth - own.request.depth.nearDepth) * place;
            };
            const glm::dvec3 centre = 0.5 * glm::dvec3(kVolume.x, kVolume.y, kVolume.z);
            // The left half hides from the middle on, the right half nothing (or all, seen the other way).
            const auto middle = static_cast<float>(depthOf(centre + 0.123));
            std::vector<float> depths(kSize * kSize, 1.0f);
            for (std::size_t i = 0; i < depths.size(); ++i)
                if (i % kSize < kSize / 2) depths[i] = middle;
            own.request.depth.depths = depths;
            const Scene truth = restricted(scene, [&](const glm::dvec3& p) {
                const glm::dvec4 clip = own.request.projection * own.request.model * glm::dvec4(p, 1.0);
                return clip.x / clip.w >= 0.0 || depthOf(p) < static_cast<double>(middle);
            });
            EXPECT_GT(psnrAgainst(truth, own), 65.0) << perspective << reversed;
            EXPECT_LT(psnrAgainst(scene, own), 40.0) << perspective << reversed;
        }
}

/// A request with a crooked unit of length, times `size`, and its truth.
struct Gauged
{
    Gauged(const Scene& scene, double size) : own(scene, {})
    {
        const glm::dmat3 gauge(glm::dvec3(0.4, 0.1, 0.0) * size, glm::dvec3(0.0, 0.9, 0.2) * size,
                               glm::dvec3(0.3, 0.0, 1.7) * size);
        own.request.opacityGauge = gauge;
        const auto camera = vo::findCamera(own.request.model, own.request.projection);
        truth = restricted(
            scene, [](const glm::dvec3&) { return true; },
            [gauge, camera](const glm::dvec3& p, std::array<double, 4>& sample) {
                const glm::dvec3 d = camera->towards(p);
                sample[3] = 1.0 - std::pow(1.0 - sample[3], glm::length(d) / glm::length(gauge * d));
            });
    }

    RequestOfScene own;
    Scene truth;
};

TEST(RayCast, opacityPerLengthFollowsEachRay)
{
    const Field field = bumps(kVolume);
    for (const bool perspective : {false, true}) {
        Scene scene = sceneOf(field);
        scene.planes = vo::test::SamplingPlanes::axisAligned;
        if (perspective) scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 60.0);
        const Gauged gauged(scene, 0.5);
        EXPECT_GT(psnrAgainst(gauged.truth, gauged.own), 65.0) << perspective;
        EXPECT_LT(psnrAgainst(scene, gauged.own), 45.0) << perspective;
    }
}

/// Smooth tables take the length of parallel rays into their entries; steep ones cannot.
TEST(RayCast, opacityPerLengthOfTablesFollowsParallelRays)
{
    const Field field = bumps(kVolume);
    for (const int entries : {256, 3, 2})
        for (const double size : {0.4, 1.0, 1.7}) {
            Scene scene = sceneOf(field);
            scene.classification = vo::test::Classification::postInterpolation;
            scene.table = colourTable(entries, 0.6);
            const Gauged gauged(scene, size);
            EXPECT_GT(psnrAgainst(gauged.truth, gauged.own), 75.0) << entries << " " << size;
        }
}

std::vector<vo::test::Tetrahedron> boxOfTetrahedra(const glm::dvec3& lower, const glm::dvec3& upper)
{
    std::vector<vo::test::Tetrahedron> tetras;
    for (const std::array<int, 4>& corners :
         {std::array{0, 3, 5, 6}, std::array{1, 0, 3, 5}, std::array{2, 0, 6, 3}, std::array{4, 0, 5, 6},
          std::array{7, 3, 6, 5}}) {
        vo::test::Tetrahedron& tetra = tetras.emplace_back();
        for (std::size_t i = 0; i < 4; ++i)
            for (int axis = 0; axis < 3; ++axis)
                tetra[i][axis] = corners[i] >> axis & 1 ? upper[axis] : lower[axis];
    }
    return tetras;
}

/// With half a voxel between planes, every other one lies where two slices meet.
TEST(RayCast, stacksAreNotInterpolatedAcross)
{
    const Field field = bumps(kVolume);
    const vo::test::Angles views[] = {{5, 85}, {10, 5}, {80, 10}};
    for (int axis = 0; axis < 3; ++axis)
        for (const double period : {1.0, 0.5}) {
            Scene scene = sceneOf(field);
            scene.stackAxis = axis;
            scene.planes = vo::test::SamplingPlanes::axisAligned;
            scene.period = glm::dvec3(period);
            scene.geometry =
                boxOfTetrahedra(glm::dvec3(0.25), glm::dvec3(kVolume.x, kVolume.y, kVolume.z) - 0.25);
            scene.view = vo::test::orthographicView(views[axis], field.size, kSize, kSize);
            for (const int split : {1, 2}) {
                Storage storage;
                storage.split = split;
                EXPECT_GT(compared(scene, storage).psnrMasked, 65.0) << axis << " " << period << " " << split;
            }
        }
}

TEST(RayCast, eachFormatIsTheReference)
{
    const Field bytes = bumps(kVolume), shorts = bumps(kVolume, 65535);
    const Field other = vo::test::quantised(vo::test::ballField(kVolume));
    const Field colours =
        vo::test::combined({bytes, other, vo::test::quantised(vo::test::axisRampField(kVolume, 1)), other});
    const Field pairs = vo::test::combined({bytes, other});
    using vo::Channels, vo::VoxelType, vo::TexelFormat;
    struct Case
    {
        const Field* field;
        vo::VoxelFormat format;
        TexelFormat texel;
    };
    const Case cases[] = {
        {&shorts, {Channels::luminance, VoxelType::uint16}, TexelFormat::intensity},
        {&shorts, {Channels::intensity, VoxelType::float32}, TexelFormat::intensity},
        {&shorts, {Channels::intensity, VoxelType::uint32}, TexelFormat::intensity},
        {&colours, {Channels::rgba, VoxelType::uint8}, TexelFormat::rgba},
        {&colours, {Channels::abgr, VoxelType::uint8}, TexelFormat::rgba},
        {&colours, {Channels::rgba, VoxelType::float32}, TexelFormat::rgba},
        {&pairs, {Channels::luminanceAlpha, VoxelType::uint8}, TexelFormat::luminanceAlpha},
        {&pairs, {Channels::luminanceAlpha, VoxelType::uint16}, TexelFormat::luminanceAlpha},
    };
    for (const Case& c : cases)
        for (const bool table : {true, false}) {
            Scene scene = sceneOf(*c.field);
            scene.table = colourTable(256, 0.3);
            if (!table) scene.classification = vo::test::Classification::none;
            scene.color = {0.5, 0.7, 0.9, 0.3};
            Storage storage;
            storage.format = c.format;
            storage.texel = c.texel;
            EXPECT_GT(compared(scene, storage).psnrMasked, 65.0) << (&c - cases) << table;
        }
}

TEST(RayCast, eyeInsideTheVolumeSeesWhatIsAhead)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.view.projection = vo::test::perspective(70.0, 1.0, 0.25, 100.0);
    scene.view.model =
        vo::test::multiply(vo::test::rotation(25.0, 1, 2, 0), vo::test::translation(-19.3, -16.1, -14.2));
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
}

TEST(RayCast, partsOfTheVolumeAreCutByTetrahedra)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.geometry = {
        {glm::dvec3(3, 2, 1), glm::dvec3(38, 5, 4), glm::dvec3(8, 31, 6), glm::dvec3(12, 9, 26)}};
    EXPECT_GT(compared(scene).psnrMasked, 65.0);
}

TEST(RayCast, opaqueTableEndsRaysWithinTheStatedError)
{
    const Field field = bumps(kVolume);
    Scene scene = sceneOf(field);
    scene.table = colourTable(256, 1.0);
    const auto result = compared(scene);
    EXPECT_GT(result.psnrMasked, 60.0);
    EXPECT_LT(result.largestMasked, 1.0 / 2048.0);
}

vo::CastPicture pictureOf(const RequestOfScene& own, bool skipping = true)
{
    vo::RayCaster caster;
    caster.setSkipping(skipping);
    EXPECT_EQ(caster.refusal(own.request), "");
    vo::CastPicture picture;
    caster.cast(own.request, picture);
    return picture;
}

double largestDifference(const vo::CastPicture& a, const vo::CastPicture& b)
{
    EXPECT_EQ(a.rgbt.size(), b.rgbt.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(a.rgbt.size(), b.rgbt.size()); ++i)
        if (a.rgbt[i] != b.rgbt[i])
            largest = std::max(largest, std::abs(static_cast<double>(a.rgbt[i] - b.rgbt[i])));
    return largest;
}

/// A few balls in nothing.
Field balls()
{
    return vo::test::quantised(vo::test::fieldOf({90, 70, 60}, [](const glm::dvec3& p) {
        double most = 0.0;
        for (const glm::dvec3& centre :
             {glm::dvec3(20, 20, 20), glm::dvec3(70, 50, 30), glm::dvec3(44, 60, 50)})
            most = std::max(most, 1.0 - glm::length(p - centre) / 14.0);
        return most;
    }));
}

TEST(RayCast, skippingLeavesThePictureAsItIs)
{
    const Field field = balls();
    using enum vo::CastBlending;
    for (const auto blending : {over, max, min, sum, alphaSum})
        for (const bool table : {true, false})
            for (const bool perspective : {true, false}) {
                Scene scene = sceneOf(field);
                if (perspective)
                    scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 40.0);
                if (!table) scene.classification = vo::test::Classification::none;
                scene.table = greyTable(256, 0.9);
                RequestOfScene own(scene, {});
                own.request.blending = blending;
                EXPECT_EQ(largestDifference(pictureOf(own), pictureOf(own, false)), 0.0)
                    << static_cast<int>(blending) << table << perspective;
            }
}

/// For every range of bytes that occurs: whether a table of bands shows one of them.
TEST(EmptyBlocks, areThoseOfWhichTheTableShowsNothing)
{
    std::mt19937 random(4);
    const Field field = vo::test::quantised(vo::test::fieldOf({50, 40, 30}, [&](const glm::dvec3& p) {
        return 0.5 + 0.4 * std::sin(0.3 * p.x) * std::cos(0.2 * p.y) + 0.002 * (random() % 50);
    }));
    std::size_t blocks = 0, clear = 0;
    for (int tables = 0; tables < 40; ++tables) {
        Scene scene = sceneOf(field);
        scene.table.assign(4 * 256, 1.0f);
        for (std::size_t i = 0, end = 0; i < 256; ++i) {
            if (i == end) end = i + 1 + random() % (tables % 2 ? 8 : 90);
            scene.table[4 * i + 3] = end % 2 && tables != 39 ? 0.5f : 0.0f;
        }
        RequestOfScene own(scene, {});
        std::string refusal;
        const vo::VoxelGrid grid(own.request.bricks, own.request.clipBoxes, 2, refusal);
        ASSERT_EQ(refusal, "");
        vo::EmptyBlocks empty;
        findEmptyBlocks(grid, shadingPlan(own.request.shading, vo::TexelFormat::intensity, false),
                        own.request.blending, 2, empty);
        for (std::size_t i = 0; 2 * i < grid.blockRanges().size(); ++i) {
            const auto low = std::size_t(grid.blockRanges()[2 * i] / 128);
            const auto high = std::size_t(grid.blockRanges()[2 * i + 1] / 128);
            bool shows = false;
            for (std::size_t value = low; value <= high; ++value)
                shows = shows || scene.table[4 * value + 3] > 0.0f;
            ASSERT_EQ(empty.distance[i] == 0, shows) << tables << ": " << low << " to " << high;
            clear += !shows;
            ++blocks;
        }
    }
    EXPECT_GT(clear, blocks / 10);
    EXPECT_LT(clear, blocks / 2);
}

TEST(RayCast, pictureIsTheSameForEachInstructionSetAndThreadCount)
{
    const Field field = bumps(kVolume), shorts = bumps(kVolume, 65535);
    for (const bool large : {false, true})
        for (const auto blending : {vo::CastBlending::over, vo::CastBlending::max}) {
            Scene scene = sceneOf(large ? shorts : field);
            scene.view = vo::test::perspectiveView({20, 30}, field.size, kSize, kSize, 40.0);
            scene.table = colourTable(200, 0.5);
            Storage storage;
            if (large) storage.format.type = vo::VoxelType::uint16;
            RequestOfScene own(scene, storage);
            own.request.blending = blending;
            own.request.opacityGauge = glm::dmat3(1.3);
            const vo::CastPicture first = pictureOf(own);
            own.request.threads = 1;
            EXPECT_EQ(largestDifference(first, pictureOf(own)), 0.0);
            for (const std::int64_t target : {HWY_SCALAR, HWY_SSE4, HWY_AVX2, HWY_AVX3}) {
                if (!(hwy::SupportedTargets() & target)) continue;
                hwy::SetSupportedTargetsForTest(target);
                EXPECT_LE(largestDifference(first, pictureOf(own)), 1e-4) << target;
                hwy::SetSupportedTargetsForTest(0);
            }
        }
}

TEST(RayCast, newVoxelsAndTablesShow)
{
    const Field field = bumps(kVolume);
    const Scene scene = sceneOf(field);
    RequestOfScene own(scene, {});
    vo::RayCaster caster;
    vo::CastPicture first, second;
    EXPECT_EQ(caster.refusal(own.request), "");
    caster.cast(own.request, first);
    own.table.rgba = colourTable(256, 0.2);
    caster.cast(own.request, second);
    EXPECT_GT(largestDifference(first, second), 0.1);
    EXPECT_EQ(largestDifference(second, pictureOf(own)), 0.0);

    for (std::byte& voxel : own.memory.front())
        voxel = std::byte{255} ^ voxel;
    ++own.bricks.front().version;
    EXPECT_EQ(caster.refusal(own.request), "");
    caster.cast(own.request, second);
    EXPECT_EQ(largestDifference(second, pictureOf(own)), 0.0);
    const std::size_t before = caster.bytes();
    caster.forget(own.bricks.front().id);
    EXPECT_LT(caster.bytes(), before);
    EXPECT_EQ(caster.bytes(), 0u);
}

TEST(RayCast, whatRaysCannotDoIsRefused)
{
    const Field field = bumps(kVolume);
    const auto refused = [&](const Storage& storage, const std::function<void(RequestOfScene&)>& change) {
        RequestOfScene own(sceneOf(field), storage);
        change(own);
        vo::RayCaster caster;
        return caster.refusal(own.request);
    };
    EXPECT_NE(refused({}, [](RequestOfScene& own) { own.request.layout.texCoord = 0; }), "");
    EXPECT_NE(refused({}, [](RequestOfScene& own) { own.request.layout.color = 0; }), "");
    EXPECT_NE(
        refused({}, [](RequestOfScene& own) { own.request.sampling.space = vo::SamplingSpace::primitive; }),
        "");
    EXPECT_NE(refused({}, [](RequestOfScene& own) { own.request.model = glm::dmat4(0.0); }), "");
    EXPECT_NE(refused({},
                      [](RequestOfScene& own) {
                          own.request.tetras.indices = own.request.tetras.indices.subspan(4);
                      }),
              "");
    Storage eight;
    eight.split = 2;
    EXPECT_NE(refused(eight, [](RequestOfScene& own) { own.memory[3].back() ^= std::byte{1}; }),
              refused(eight, [](RequestOfScene&) {}));
    EXPECT_NE(refused(eight,
                      [](RequestOfScene& own) {
                          own.request.bricks = own.request.bricks.first(7);
                          own.request.clipBoxes = own.request.clipBoxes.first(7);
                      }),
              "");
    eight.overlap = 0;
    EXPECT_NE(refused(eight, [](RequestOfScene&) {}), "");
}

} // namespace
