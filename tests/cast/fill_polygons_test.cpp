// Filled polygons against the float64 reference on the same planes, and against closed forms.

#include "cast/fill_scene.h"
#include "support/compare.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>

namespace {

using namespace vo;
using namespace vo::test;

constexpr int kPixels = 80;

std::vector<float> colorTable(int size = 256)
{
    std::vector<float> table;
    for (int i = 0; i < size; ++i) {
        const double v = i / (size - 1.0);
        for (const double entry : {0.5 + 0.5 * std::sin(6.0 * v), v * v, 1.0 - v, 0.12 * v})
            table.push_back(static_cast<float>(entry));
    }
    return table;
}

Field testField(const VoxelSize& size, int levels = 255)
{
    Field field = letterFField(size);
    const Field ball = ballField(size), noise = noiseField(size, 3);
    for (std::size_t i = 0; i < field.values.size(); ++i)
        field.values[i] = std::max(field.values[i], ball.values[i] * (0.7f + 0.3f * noise.values[i]));
    return quantised(field, levels);
}

/// A twist and a swelling that keep the volume in its ball.
Deformation twisted(const VoxelSize& size, int cells = 3)
{
    const glm::dvec3 middle = 0.5 * glm::dvec3(size.x, size.y, size.z);
    return {cells, [middle](const glm::dvec3& voxel) {
                const glm::dvec3 p = voxel - middle;
                const double angle = 0.9 * p.z / middle.z;
                const double bulge = 0.95 - 0.2 * (p.z / middle.z) * (p.z / middle.z);
                return middle + bulge * glm::dvec3(p.x * std::cos(angle) - p.y * std::sin(angle),
                                                   p.x * std::sin(angle) + p.y * std::cos(angle), 0.8 * p.z);
            }};
}

class FillPolygons : public testing::Test
{
protected:
    FillPolygons()
    {
        scene.volume = &field;
        scene.width = kPixels;
        scene.height = kPixels - 8;
        scene.overlap = 1;
        scene.classification = Classification::postInterpolation;
        scene.table = colorTable();
        look({35, 50});
    }

    void look(const Angles& angles, double degrees = 0.0)
    {
        scene.view = degrees > 0.0 ? perspectiveView(angles, field.size, scene.width, scene.height, degrees)
                                   : orthographicView(angles, field.size, scene.width, scene.height);
    }

    void expectReference(const FillOptions& options, const Picture& reference, double decibels = 60.0)
    {
        FillScene fill(scene, options);
        expectPicture(fill.drawn(), reference, decibels);
    }

    void expectPicture(const std::vector<float>& drawn, const Picture& reference, double decibels = 60.0)
    {
        const Comparison comparison = compare(drawn, reference);
        SCOPED_TRACE(comparison.summary());
        EXPECT_GT(comparison.opaquePixels, 250u);
        EXPECT_GE(comparison.psnrMasked, decibels);
        EXPECT_LE(comparison.fractionOff, 0.02);
        worst = std::min(worst, comparison.psnrMasked);
        RecordProperty("worst_dB", std::to_string(worst));
    }

    Field field = testField({24, 19, 21});
    Scene scene;
    double worst = 1e9;
};

TEST_F(FillPolygons, aVolumeInItsPlaceEqualsTheReference)
{
    for (const double degrees : {0.0, 45.0})
        for (const Angles& angles : randomViews(2, 5)) {
            look(angles, degrees);
            const Picture reference = referencePicture(scene);
            for (const int bricks : {1, 3})
                expectReference({.bricks = bricks}, reference);
        }
}

TEST_F(FillPolygons, aDeformedVolumeEqualsTheReference)
{
    for (const double degrees : {0.0, 45.0}) {
        look({20, 130}, degrees);
        FillOptions options{.deformation = twisted(field.size)};
        const Picture reference = FillScene(scene, options).reference();
        for (const int bricks : {1, 2}) {
            options.bricks = bricks;
            expectReference(options, reference);
        }
    }
}

TEST_F(FillPolygons, verticesGiveColours)
{
    scene.classification = Classification::none;
    for (const int channels : {3, 4})
        for (const bool deformed : {false, true}) {
            look({20, 130}, deformed ? 40.0 : 0.0);
            FillOptions options{.bricks = 2, .colorChannels = channels};
            if (deformed) options.deformation = twisted(field.size);
            FillScene fill(scene, options);
            expectPicture(fill.drawn(), fill.reference());
        }
}

TEST_F(FillPolygons, theCurrentColourCountsWithoutColoursOfVertices)
{
    scene.classification = Classification::none;
    scene.color = {0.9, 0.5, 0.7, 0.15};
    FillScene fill(scene, {});
    expectPicture(fill.drawn(), referencePicture(scene));
    fill.request().shading.replace = true;
    scene.color = {1, 1, 1, 1};
    expectPicture(fill.drawn(), referencePicture(scene));
}

TEST_F(FillPolygons, replaceKeepsTheCurrentOpacityOfTexturesWithoutOne)
{
    scene.classification = Classification::none;
    scene.opaqueTexture = true;
    scene.color = {1, 1, 1, 0.15};
    FillOptions options;
    options.texel = TexelFormat::luminance;
    FillScene fill(scene, options);
    const Picture reference = referencePicture(scene);
    fill.request().shading.replace = true;
    fill.request().shading.color = {0.3f, 0.2f, 0.1f, 0.15f};
    expectPicture(fill.drawn(), reference);
}

TEST_F(FillPolygons, everyBlendingJoinsFragmentsAsItSays)
{
    const std::pair<CastBlending, Compositing> pairs[] = {{CastBlending::max, Compositing::max},
                                                          {CastBlending::min, Compositing::min},
                                                          {CastBlending::sum, Compositing::sum}};
    for (float& value : field.values)
        value = (51.0f + std::round(204.0f * value)) / 255.0f;
    for (const auto& [blending, compositing] : pairs) {
        scene.compositing = compositing;
        scene.background =
            compositing == Compositing::min ? std::array{0.5, 0.6, 0.7} : std::array{0.2, 0.0, 0.1};
        expectReference({.bricks = 2, .blending = blending}, referencePicture(scene));
    }
    scene.compositing = Compositing::sum;
    FillScene fill(scene, {.blending = CastBlending::alphaSum});
    expectPicture(fill.drawn(), fill.reference([](const glm::dvec3&, const std::array<double, 4>& f) {
        return std::array{f[3] * f[0], f[3] * f[1], f[3] * f[2], f[3] * f[3]};
    }));
}

/// Colours are dark where the volume ends: an edge would count whole.
TEST_F(FillPolygons, premultipliedColoursAreNotWeightedWithAlpha)
{
    scene.compositing = Compositing::premultiplied;
    scene.background = {0.2, 0.0, 0.1};
    for (std::size_t i = 0; i < scene.table.size(); ++i)
        if (i % 4 < 3) scene.table[i] *= 4.0f * scene.table[i | 3];
    for (const Classification kind :
         {Classification::none, Classification::preInterpolation, Classification::postInterpolation}) {
        scene.classification = kind;
        scene.color = {0.2, 0.1, 0.15, 0.4};
        look({20, 130}, 40.0);
        expectReference({.bricks = 2, .blending = CastBlending::premultiplied}, referencePicture(scene));
    }
    FillOptions options{.deformation = twisted(field.size), .blending = CastBlending::premultiplied};
    for (const int channels : {0, 4}) {
        scene.color = channels > 0 ? std::array{1.0, 1.0, 1.0, 1.0} : scene.color;
        options.colorChannels = channels;
        FillScene fill(scene, options);
        expectPicture(fill.drawn(), fill.reference());
    }
}

/// Where little shows through, colours without an alpha of their own may still add up.
TEST_F(FillPolygons, whatShinesThroughOpaqueVoxelsIsNotLeftOut)
{
    field = constantField({4, 4, 200}, 1.0);
    for (int z = 194; z < 200; ++z) // the nearest six let 1/4096 through
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                field.at(x, y, z) = 0.0f;
    scene.compositing = Compositing::premultiplied;
    scene.overlap = 0;
    scene.table = {0, 0, 0, 0.75f, 1, 1, 1, 0};
    scene.view.model = translation(-2, -2, -100);
    scene.view.projection = ortho(-2, 2, -2, 2, -101, 101);
    FillScene fill(scene, {.blending = CastBlending::premultiplied});
    const CastPicture picture = fill.fill();
    ASSERT_EQ(picture.width * picture.height, scene.width * scene.height);
    for (std::size_t i = 0; i < picture.rgbt.size(); i += 4) {
        EXPECT_NEAR(picture.rgbt[i], 194.0 / 4096.0, 1e-5);
        EXPECT_NEAR(picture.rgbt[i + 3], 1.0 / 4096.0, 1e-7);
    }
}

/// Over an opacity of 0: the sum of what GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA makes of alphas.
TEST_F(FillPolygons, theAlphaOfOverIsThatOfBlending)
{
    field = constantField(field.size, 1.0);
    scene.classification = Classification::none;
    scene.color = {0.5, 0.25, 1.0, 0.2};
    scene.overlap = 0;
    scene.view.model = multiply(scaling(2.0 / 20, 2.0 / 16, 0.01), translation(-12, -9, -10));
    scene.view.projection = identity();
    for (const CastBlending blending : {CastBlending::over, CastBlending::premultiplied}) {
        const double weight = blending == CastBlending::over ? 0.2 : 1.0;
        FillScene fill(scene, {.bricks = 2, .blending = blending});
        const CastPicture picture = fill.fill();
        ASSERT_EQ(picture.width * picture.height, scene.width * scene.height);
        double color = 0.0, alpha = 0.0;
        for (int k = 0; k < 21; ++k) {
            color = 0.8 * color + weight * 0.5;
            alpha = 0.8 * alpha + 0.2 * 0.2;
        }
        ASSERT_FALSE(picture.alpha.empty());
        for (std::size_t i = 0; i < picture.alpha.size(); ++i) {
            EXPECT_NEAR(picture.rgbt[4 * i], color, 1e-5);
            EXPECT_NEAR(picture.rgbt[4 * i + 3], std::pow(0.8, 21), 1e-5);
            EXPECT_NEAR(picture.alpha[i], alpha, 1e-5);
        }
    }
}

TEST_F(FillPolygons, pixelsOutsideOfAllPolygonsHoldWhatChangesNothing)
{
    scene.classification = Classification::none;
    const std::pair<CastBlending, float> nothings[] = {{CastBlending::over, 0.0f},
                                                       {CastBlending::premultiplied, 0.0f},
                                                       {CastBlending::sum, 0.0f},
                                                       {CastBlending::max, -HUGE_VALF},
                                                       {CastBlending::min, HUGE_VALF}};
    for (const auto& [blending, nothing] : nothings) {
        const CastPicture picture = FillScene(scene, {.blending = blending}).fill();
        ASSERT_GT(picture.width, 10);
        EXPECT_EQ(picture.rgbt[0], nothing); // the corner of the box around a turned cube
        EXPECT_EQ(picture.rgbt[3], hidesBehind(blending) ? 1.0f : nothing);
        EXPECT_EQ(picture.alpha.empty(), !hidesBehind(blending));
    }
}

TEST_F(FillPolygons, everyFormatOfVoxelsIsSampled)
{
    struct Case
    {
        int channels, levels;
        VoxelFormat format;
        TexelFormat texel;
        bool opaque = false;
    };
    const Case cases[] = {
        {1, 255, {Channels::luminance, VoxelType::uint8}, TexelFormat::intensity},
        {1, 255, {Channels::luminance, VoxelType::uint8}, TexelFormat::luminance, true},
        {1, 127, {Channels::luminance, VoxelType::int8}, TexelFormat::intensity},
        {1, 65535, {Channels::luminance, VoxelType::uint16}, TexelFormat::intensity},
        {1, 65535, {Channels::intensity, VoxelType::float32}, TexelFormat::intensity},
        {1, 65535, {Channels::luminance, VoxelType::uint32}, TexelFormat::intensity},
        {2, 255, {Channels::luminanceAlpha, VoxelType::uint8}, TexelFormat::luminanceAlpha},
        {2, 65535, {Channels::luminanceAlpha, VoxelType::uint16}, TexelFormat::luminanceAlpha},
        {4, 255, {Channels::rgba, VoxelType::uint8}, TexelFormat::rgba},
        {4, 255, {Channels::abgr, VoxelType::uint32_8888}, TexelFormat::rgba},
        {4, 255, {Channels::rgba, VoxelType::uint8}, TexelFormat::rgb, true},
        {4, 65535, {Channels::rgba, VoxelType::float32}, TexelFormat::rgba},
    };
    scene.classification = Classification::none;
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message()
                     << "channels " << c.channels << ", type " << static_cast<int>(c.format.type));
        std::vector<Field> channels;
        for (int i = 0; i < c.channels; ++i)
            channels.push_back(quantised(noiseField({18, 15, 16}, unsigned(i) + 1), c.levels));
        field = c.channels == 1 ? channels[0] : combined(channels);
        scene.color = {1, 1, 1, 0.1};
        scene.opaqueTexture = c.opaque;
        look({20, 70});
        expectReference({.bricks = 2, .format = c.format, .texel = c.texel}, referencePicture(scene));
    }
}

TEST_F(FillPolygons, tablesOfEveryKindAreApplied)
{
    for (const int channels : {1, 2, 4})
        for (const Classification kind :
             {Classification::preInterpolation, Classification::postInterpolation}) {
            std::vector<Field> fields;
            for (int i = 0; i < channels; ++i)
                fields.push_back(quantised(noiseField({18, 15, 16}, unsigned(i) + 1)));
            field = channels == 1 ? fields[0] : combined(fields);
            scene.classification = kind;
            scene.table = colorTable(channels == 2 ? 2 : channels == 4 ? 1000 : 64);
            look({20, 70});
            const TexelFormat texels[] = {TexelFormat::intensity, TexelFormat::luminanceAlpha,
                                          TexelFormat::rgba};
            const Channels formats[] = {Channels::luminance, Channels::luminanceAlpha, Channels::rgba};
            const auto which = static_cast<std::size_t>(channels / 2);
            expectReference({.format = {formats[which], VoxelType::uint8}, .texel = texels[which]},
                            referencePicture(scene));
        }
}

TEST_F(FillPolygons, smallAndFlatBricksAreSampledWithinTheirVoxels)
{
    for (const VoxelSize size :
         {VoxelSize{3, 9, 8}, VoxelSize{1, 7, 6}, VoxelSize{8, 1, 9}, VoxelSize{5, 6, 1}}) {
        field = quantised(noiseField(size, 5));
        look({40, 30});
        for (const VoxelType type : {VoxelType::uint8, VoxelType::uint16, VoxelType::float32})
            expectReference({.format = {Channels::luminance, type}}, referencePicture(scene));
    }
}

TEST_F(FillPolygons, stacksAreNotInterpolatedAcross)
{
    scene.planes = SamplingPlanes::axisAligned;
    for (int axis = 0; axis < 3; ++axis) {
        look(axis == 2   ? Angles{70, 20}
             : axis == 1 ? Angles{10, 15}
                         : Angles{12, 80},
             axis == 1 ? 30.0 : 0.0);
        scene.stackAxis = axis;
        expectReference({.bricks = 2}, referencePicture(scene));
    }
}

TEST_F(FillPolygons, planesAcrossAnAxisAndShellsAreFilled)
{
    field = withEmptyBorder(testField({24, 19, 21}), 2);
    scene.planes = SamplingPlanes::axisAligned;
    look({30, 40}, 40);
    expectReference({.bricks = 2}, referencePicture(scene));
    scene.planes = SamplingPlanes::spherical;
    expectReference({.bricks = 2}, referencePicture(scene));
}

TEST_F(FillPolygons, theEyeMayBeInsideTheVolume)
{
    scene.view.model =
        multiply(translation(0, 0, -3), multiply(rotation(50, 1, 2, 3), translation(-12, -10, -10)));
    scene.view.projection = perspective(80, double(scene.width) / scene.height, 0.3, 60);
    FillOptions options;
    for (const bool deformed : {false, true}) {
        if (deformed) options.deformation = twisted(field.size);
        FillScene fill(scene, options);
        expectPicture(fill.drawn(), fill.reference());
    }
}

/// Every sample counts once, whichever tetrahedra and bricks meet at its pixel: head-on, all rays cross all
/// planes.
TEST_F(FillPolygons, seamsHaveNoDoubleAndNoMissingPixels)
{
    field = constantField({16, 16, 16}, 1.0);
    scene.classification = Classification::none;
    scene.color = {1, 1, 1, 1};
    scene.overlap = 1;
    scene.width = scene.height = 99;
    // Seams of bricks and faces of tetrahedra through the centres of pixels, then anywhere.
    for (const double turn : {0.0, 90.0, 17.0}) {
        scene.view.model = multiply(rotation(turn, 0, 0, 1), translation(-8, -8, -8));
        scene.view.projection = ortho(-49.5 / 9, 49.5 / 9, -49.5 / 9, 49.5 / 9, -20, 20);
        for (const bool moved : {false, true}) {
            FillOptions options{.bricks = 4, .blending = CastBlending::sum};
            options.deformation =
                Deformation{5, [moved](const glm::dvec3& p) {
                                const bool inside = p.x > 0 && p.x < 16 && p.y > 0 && p.y < 16;
                                if (!moved || !inside) return p;
                                return p + 0.6 * glm::dvec3(std::sin(5 * p.y), std::cos(7 * p.x + p.z), 0);
                            }};
            const CastPicture picture = FillScene(scene, options).fill();
            ASSERT_EQ(picture.width, 99);
            ASSERT_EQ(picture.height, 99);
            std::size_t off = 0;
            for (const float value : picture.rgbt)
                off += std::abs(value - 16.0f) > 1e-4f ? 1 : 0; // planes at 1/2 to 15 1/2
            EXPECT_EQ(off, 0u) << "turned " << turn << ", moved " << moved;
        }
    }
}

TEST_F(FillPolygons, opaqueThingsHideWhatIsBehindThem)
{
    scene.overlap = 0; // the reference masks edges of geometry, not of boxes
    for (const double degrees : {0.0, 50.0}) {
        look({30, 40}, degrees);
        FillScene fill(scene, {});
        const glm::dmat4 toClip = fill.request().projection * fill.request().model;
        const auto windowOf = [&](const glm::dvec3& point) {
            const glm::dvec4 clip = toClip * glm::dvec4(point, 1.0);
            const glm::dvec3 device = glm::dvec3(clip) / clip.w;
            return glm::dvec3((0.5 + 0.5 * device.x) * scene.width, (0.5 + 0.5 * device.y) * scene.height,
                              0.8 -
                                  0.6 * (0.5 + 0.5 * device.z)); // a depth range of 0.8 to 0.2, near is large
        };
        const double middle = windowOf({12, 10, 10}).z;
        const auto depthAt = [&](int x, int y) { return middle + 0.002 * ((x * 7 + y * 3) % 11 - 5.03); };
        std::vector<float> depths;
        for (int y = 0; y < scene.height; ++y)
            for (int x = 0; x < scene.width; ++x)
                depths.push_back(static_cast<float>(depthAt(x, y)));
        for (const bool orEqual : {false, true}) {
            fill.request().depth = {depths, orEqual, 0.8, 0.2};
            expectPicture(fill.drawn(),
                          fill.reference([&](const glm::dvec3& point, const std::array<double, 4>& f) {
                              const glm::dvec3 window = windowOf(point);
                              const bool seen = window.z < depthAt(int(window.x), int(window.y));
                              return seen ? std::optional(f) : std::nullopt;
                          }));
        }
    }
}

TEST_F(FillPolygons, anEqualDepthIsSeenIfSoWanted)
{
    field = constantField({8, 8, 8}, 1.0);
    scene.classification = Classification::none;
    scene.color = {1, 1, 1, 0.5};
    scene.view.model = translation(-4, -4, -4);
    scene.view.projection = ortho(-2, 2, -2, 2, -4, 4); // depth 1/2 + (1/2 - plane) / 8 in the middle
    FillScene fill(scene, {.blending = CastBlending::sum});
    const std::vector<float> depths(static_cast<std::size_t>(scene.width * scene.height), 0.5625f);
    fill.request().depth = {depths, false, 0.0, 1.0};
    const CastPicture less = fill.fill();
    fill.request().depth.orEqual = true;
    const CastPicture lessOrEqual = fill.fill();
    EXPECT_FLOAT_EQ(less.rgbt[0], 4.0f);
    EXPECT_FLOAT_EQ(lessOrEqual.rgbt[0], 5.0f);
}

/// Samples closer to a clip plane than 1/100 pixel may be on either side of it.
TEST_F(FillPolygons, clipPlanesCutTheVolume)
{
    scene.overlap = 0;
    for (const double degrees : {0.0, 50.0}) {
        look({30, 40}, degrees);
        FillOptions options;
        options.deformation = twisted(field.size);
        FillScene fill(scene, options);
        const glm::dmat4 model = fill.request().model;
        const glm::dvec3 middle = glm::dvec3(model * glm::dvec4(12, 9.5, 10.5, 1.0));
        const auto planeThrough = [&](const glm::dvec3& normal, const glm::dvec3& point) {
            return glm::vec4(glm::vec3(normal), static_cast<float>(-glm::dot(normal, point)));
        };
        const glm::vec4 planes[] = {planeThrough({0.8, 0.1, 0.6}, middle - glm::dvec3(0.2, 0, 0)),
                                    planeThrough({-0.3, 0.9, 0.2}, middle - glm::dvec3(0, 0.1, 0))};
        fill.request().clipPlanes = planes;
        const auto cut = [&](double shift) {
            return fill.reference([&, shift](const glm::dvec3& point, const std::array<double, 4>& f) {
                const glm::dvec4 eye = model * glm::dvec4(point, 1.0);
                const bool kept = glm::dot(glm::dvec4(planes[0]), eye) >= shift &&
                                  glm::dot(glm::dvec4(planes[1]), eye) >= shift;
                return kept ? std::optional(f) : std::nullopt;
            });
        };
        const double pixel = glm::length(glm::dvec3(model[0])) * 40.0 / scene.width;
        Picture reference = cut(0.0);
        const Picture more = cut(-pixel / 100), less = cut(pixel / 100);
        for (std::size_t i = 0; i < reference.unmasked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                if (more.rgba[4 * i + c] != less.rgba[4 * i + c]) reference.unmasked[i] = 0;
        expectPicture(fill.drawn(), reference);
    }
}

TEST_F(FillPolygons, opacitiesPerLengthFollowTheLineOfSight)
{
    scene.overlap = 0;
    scene.period = glm::dvec3(0.8, 1.0, 1.3);
    for (const double degrees : {0.0, 60.0}) {
        look({30, 40}, degrees);
        FillScene fill(scene, {});
        CastRequest& request = fill.request();
        const auto camera = findCamera(request.model, request.projection);
        const glm::dmat3 gauge(0.5, 0.1, 0.0, 0.0, 0.9, 0.2, 0.0, 0.0, 1.4);
        request.opacityGauge = gauge;
        expectPicture(fill.drawn(),
                      fill.reference([&](const glm::dvec3& point, const std::array<double, 4>& f) {
                          const glm::dvec3 sight = camera->towards(point);
                          const double units = glm::length(sight) / glm::length(gauge * sight);
                          return std::array{f[0], f[1], f[2], 1.0 - std::pow(1.0 - f[3], units)};
                      }));
    }
}

TEST_F(FillPolygons, opaqueVoxelsEndALineOfSight)
{
    scene.table = colorTable();
    for (std::size_t i = 3; i < scene.table.size(); i += 4)
        scene.table[i] = i < 100 ? 0.0f : 0.9f;
    expectReference({.bricks = 2}, referencePicture(scene));
}

TEST_F(FillPolygons, flatPolygonsHaveTheColourOfTheirFirstVertex)
{
    field = constantField({4, 4, 4}, 1.0);
    scene.classification = Classification::none;
    FillScene fill(scene, {.colorChannels = 3, .blending = CastBlending::sum});
    CastRequest& request = fill.request();
    request.model = request.projection = glm::dmat4(1.0);
    request.shading.flat = true;
    const std::vector<float> records{0.1f, 0.2f, 0.3f, -1, -1, 0, 0.9f, 0.8f, 0.7f, 1,  -1, 0,
                                     0.9f, 0.8f, 0.7f, 1,  1,  0, 0.5f, 0.8f, 0.7f, -1, 1,  0};
    const std::vector<std::uint32_t> indices{1, 2, 0, 2, 3, 0};
    const std::vector<PolygonRun> runs{{0, 0, 6}};
    CastPicture picture;
    PolygonFiller().fill(request, {records, indices, runs}, picture);
    ASSERT_EQ(picture.width, scene.width);
    for (std::size_t i = 0; i < picture.rgbt.size(); ++i)
        EXPECT_FLOAT_EQ(picture.rgbt[i], i % 4 < 3 ? 0.1f * static_cast<float>(i % 4 + 1) : 1.0f);
}

TEST_F(FillPolygons, thePictureDoesNotDependOnThreadsNorOnTheWidthOfVectors)
{
    FillOptions options{.bricks = 2, .deformation = twisted(field.size), .colorChannels = 4};
    look({30, 40}, 40);
    FillScene fill(scene, options);
    const std::vector<float> drawn = fill.drawn();
    fill.request().threads = 1;
    EXPECT_EQ(fill.drawn(), drawn);
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
        hwy::SetSupportedTargetsForTest(targets & -targets);
        const std::vector<float> other = fill.drawn();
        for (std::size_t i = 0; i < drawn.size(); ++i)
            ASSERT_NEAR(other[i], drawn[i], 1e-4) << hwy::TargetName(targets & -targets);
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST_F(FillPolygons, whatIsNotSeenMakesAnEmptyPicture)
{
    scene.view.model = multiply(translation(0, 0, 500), scene.view.model);
    const CastPicture picture = FillScene(scene, {}).fill();
    EXPECT_EQ(picture.width, 0);
    EXPECT_TRUE(picture.rgbt.empty());
}

TEST_F(FillPolygons, polygonsThatAreNotFiniteAreLeftOut)
{
    FillScene fill(scene, {});
    fill.request().model = fill.request().projection = glm::dmat4(1.0);
    const float nan = std::nanf("");
    const std::vector<float> records{0, 0, 0, 1, 0, 0, 0, nan, 0, HUGE_VALF, 0, 0};
    const std::vector<std::uint32_t> indices{0, 1, 2, 3, 1, 0};
    const std::vector<PolygonRun> runs{{0, 0, 6}};
    CastPicture picture;
    PolygonFiller().fill(fill.request(), {records, indices, runs}, picture);
    EXPECT_EQ(picture.width, 0);
}

TEST_F(FillPolygons, requestsThatCannotBeFilledAreRefusedWithAReason)
{
    FillScene fill(scene, {});
    CastRequest request = fill.request();
    EXPECT_EQ(fillRefusal(request), "");
    request.width = 40000;
    EXPECT_NE(fillRefusal(request).find("40000"), std::string::npos);
    request = fill.request();
    request.projection = glm::dmat4(0.0);
    EXPECT_NE(fillRefusal(request).find("singular"), std::string::npos);
    request = fill.request();
    fill.bricks().front().texels.voxels = {};
    EXPECT_NE(fillRefusal(request).find("no voxels"), std::string::npos);
    request.bricks = {};
    EXPECT_NE(fillRefusal(request), "");
}

/// What is kept of voxels, and its end.
TEST_F(FillPolygons, changedVoxelsAndTablesShow)
{
    for (const int bricks : {1, 2}) {
        FillScene fill(scene, {.bricks = bricks});
        expectPicture(fill.drawn(), referencePicture(scene));
        const Table other{colorTable(32)};
        fill.request().shading.table = &other;
        Scene changed = scene;
        changed.table = other.rgba;
        expectPicture(fill.drawn(), referencePicture(changed));

        const Field noise = quantised(noiseField(field.size, 9));
        changed.volume = &noise;
        FillScene noisy(changed, {.bricks = bricks});
        for (std::size_t i = 0; i < fill.bricks().size(); ++i) {
            fill.bricks()[i].texels.voxels = noisy.bricks()[i].texels.voxels;
            ++fill.bricks()[i].version;
        }
        expectPicture(fill.drawn(), referencePicture(changed));
    }
}

TEST_F(FillPolygons, forgottenBricksTakeNoMemory)
{
    FillScene fill(scene, {.bricks = 2});
    static_cast<void>(fill.fill());
    const std::size_t kept = fill.filler().bytes();
    EXPECT_GT(kept, field.values.size());
    fill.filler().forget(1);
    EXPECT_LT(fill.filler().bytes(), kept / 2);
    EXPECT_GT(fill.fill().width, 0);
}

TEST_F(FillPolygons, bricksThatDisagreeAreSampledEachOnItsOwn)
{
    // Without overlap every brick ends at its own outermost voxels: here all its voxels are the same.
    field = constantField({16, 16, 16}, 0.0);
    for (int z = 0; z < 16; ++z)
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                field.at(x, y, z) = static_cast<float>(1 + (x / 8) + 2 * (y / 8) + 4 * (z / 8)) / 8.0f;
    field = quantised(field);
    scene.overlap = 0;
    scene.classification = Classification::none;
    scene.color = {1, 1, 1, 0.2};
    look({20, 30});
    FillScene fill(scene, {.bricks = 2});
    expectPicture(fill.drawn(), fill.reference([&](const glm::dvec3& p, const std::array<double, 4>&) {
        const glm::ivec3 voxel(glm::clamp(p, 0.0, 15.9));
        const double value = double(field.at(voxel.x, voxel.y, voxel.z));
        return std::array{value, value, value, value};
    }),
                  40.0);
}

} // namespace
