// Pictures of the library against the float64 reference on the same planes.

#include "draw/draw_scene.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;

constexpr int kPixels = 160;

std::vector<float> rampTable(double from, double to, double opacity)
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const double v = std::clamp((i / 255.0 - from) / (to - from), 0.0, 1.0);
        for (int c = 0; c < 3; ++c)
            table.push_back(static_cast<float>(v));
        table.push_back(static_cast<float>(opacity * v));
    }
    return table;
}

std::vector<float> colorTable()
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        table.push_back(static_cast<float>(0.5 + 0.5 * std::sin(6.0 * v)));
        table.push_back(static_cast<float>(v * v));
        table.push_back(static_cast<float>(1.0 - v));
        table.push_back(static_cast<float>(0.1 * v));
    }
    return table;
}

struct PictureCase
{
    const char* name;
    Classification classification;
    std::vector<float> table;
    Compositing compositing = Compositing::over;
    int bricks = 1;
    int overlap = 1;
    int stackAxis = -1;
    double degrees = 0.0; ///< perspective
    bool emptyBorder = false;
    bool utility = false;
    bool texCoords = false;
    voDataType type = voDataTypeScope::UNSIGNED_BYTE;
};

std::ostream& operator<<(std::ostream& stream, const PictureCase& c)
{
    return stream << c.name;
}

class PictureGL : public testing::TestWithParam<PictureCase>
{
};

Field testField(bool emptyBorder, int levels)
{
    const VoxelSize size{40, 33, 36};
    Field field = quantised(letterFField(size), levels);
    const Field ball = ballField(size);
    const Field noise = noiseField(size, 3);
    for (std::size_t i = 0; i < field.values.size(); ++i)
        field.values[i] = std::max(field.values[i], ball.values[i] * (0.7f + 0.3f * noise.values[i]));
    if (emptyBorder) field = withEmptyBorder(field, 2);
    return quantised(field, levels);
}

Scene sceneOf(const PictureCase& c, const Field& field, const Angles& angles)
{
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = kPixels;
    scene.view = c.degrees > 0 ? perspectiveView(angles, field.size, kPixels, kPixels, c.degrees)
                               : orthographicView(angles, field.size, kPixels, kPixels);
    scene.overlap = c.overlap;
    scene.classification = c.classification;
    scene.table = c.table;
    scene.compositing = c.compositing;
    if (c.classification == Classification::none) scene.color = {1, 1, 1, 0.1};
    return scene;
}

/// What a picture must reach. Graphics cards filter textures with 8 bits of weight; the software rasteriser
/// is held to what its floats can do.
struct Bars
{
    double masked;
    double unmasked; ///< of volumes with an empty border
};

Bars barsFor(const vo::OffscreenContext& context)
{
    const bool software = context.description().find("llvmpipe") != std::string::npos;
    return software ? Bars{80.0, 75.0} : Bars{50.0, 45.0};
}

TEST_P(PictureGL, agreesWithTheReference)
{
    const PictureCase& c = GetParam();
    const Field field = testField(c.emptyBorder, c.type == voDataTypeScope::UNSIGNED_BYTE ? 255 : 65535);
    std::vector<Angles> views = {{0, 0}, {30, 40}, {-90, 90}};
    for (const Angles& angles : randomViews(2, 17))
        views.push_back(angles);
    std::unique_ptr<vo::OffscreenContext> context;
    for (const Angles& angles : views) {
        Scene scene = sceneOf(c, field, angles);
        DrawOptions options;
        options.bricks = c.bricks;
        options.utility = c.utility;
        options.explicitTexCoords = c.texCoords;
        options.dataType = c.type;
        if (!context) context = openFor(scene, OffscreenProfile::Compatibility);
        if (c.stackAxis >= 0) {
            scene.planes = SamplingPlanes::axisAligned;
            View v = scene.view;
            scene.stackAxis =
                3 - static_cast<int>(voGeometryActions::findClosestAxisIndex(
                        v.model.data(), v.projection.data(), voSamplingModeScope::AXIS_ALIGNED));
        }
        const std::vector<float> picture = drawnPicture(*context, scene, options);
        const Comparison comparison = compare(picture, referencePicture(scene));
        SCOPED_TRACE(testing::Message() << "latitude " << angles.latitude << ", longitude "
                                        << angles.longitude << ": " << comparison.summary());
        EXPECT_GT(comparison.opaquePixels, 1000u);
        EXPECT_GE(comparison.psnrMasked, barsFor(*context).masked);
        EXPECT_LE(comparison.fractionOff, 0.01);
        if (c.emptyBorder) {
            EXPECT_GE(comparison.psnrAll, barsFor(*context).unmasked);
        }
    }
}

const Classification kNone = Classification::none;
const Classification kPre = Classification::preInterpolation;
const Classification kPost = Classification::postInterpolation;

INSTANTIATE_TEST_SUITE_P(
    All, PictureGL,
    testing::Values(
        PictureCase{.name = "grey", .classification = kNone, .table = {}},
        PictureCase{.name = "greyEmptyBorder", .classification = kNone, .table = {}, .emptyBorder = true},
        PictureCase{.name = "smoothRamp", .classification = kPost, .table = rampTable(0, 1, 0.1)},
        PictureCase{.name = "steepRamp", .classification = kPost, .table = rampTable(0.4, 0.45, 0.1)},
        PictureCase{.name = "colorPost", .classification = kPost, .table = colorTable()},
        PictureCase{.name = "colorPre", .classification = kPre, .table = colorTable()},
        PictureCase{.name = "colorPostEmptyBorder",
                    .classification = kPost,
                    .table = colorTable(),
                    .emptyBorder = true},
        PictureCase{.name = "maximum", .classification = kNone, .table = {}, .compositing = Compositing::max},
        PictureCase{.name = "sum", .classification = kNone, .table = {}, .compositing = Compositing::sum},
        PictureCase{.name = "eightBricks", .classification = kPost, .table = colorTable(), .bricks = 2},
        PictureCase{.name = "twentySevenBricks", .classification = kPost, .table = colorTable(), .bricks = 3},
        PictureCase{
            .name = "bricksBeforeInterpolation", .classification = kPre, .table = colorTable(), .bricks = 2},
        PictureCase{.name = "perspective", .classification = kPost, .table = colorTable(), .degrees = 40},
        PictureCase{.name = "perspectiveBricks",
                    .classification = kPost,
                    .table = colorTable(),
                    .bricks = 3,
                    .degrees = 40},
        PictureCase{.name = "stacks", .classification = kPost, .table = colorTable(), .stackAxis = 2},
        PictureCase{.name = "stacksOfBricks",
                    .classification = kPost,
                    .table = colorTable(),
                    .bricks = 2,
                    .stackAxis = 2},
        PictureCase{
            .name = "stacksPerspective", .classification = kNone, .table = {}, .stackAxis = 2, .degrees = 30},
        PictureCase{.name = "explicitTexCoords",
                    .classification = kPost,
                    .table = colorTable(),
                    .bricks = 2,
                    .texCoords = true},
        PictureCase{
            .name = "utility", .classification = kPost, .table = colorTable(), .bricks = 3, .utility = true},
        PictureCase{.name = "utilityTexCoords",
                    .classification = kPost,
                    .table = colorTable(),
                    .bricks = 2,
                    .utility = true,
                    .texCoords = true},
        PictureCase{.name = "utilityStacks",
                    .classification = kPost,
                    .table = colorTable(),
                    .bricks = 2,
                    .stackAxis = 2,
                    .utility = true},
        PictureCase{.name = "shorts",
                    .classification = kPost,
                    .table = colorTable(),
                    .bricks = 2,
                    .type = voDataTypeScope::UNSIGNED_SHORT},
        PictureCase{.name = "floats",
                    .classification = kPost,
                    .table = colorTable(),
                    .type = voDataTypeScope::FLOAT}),
    [](const auto& test) { return std::string(test.param.name); });

// SPHERICAL.

struct ShellsGL : testing::Test
{
    ShellsGL()
    {
        scene.volume = &field;
        scene.width = scene.height = 100;
        scene.overlap = 1;
        scene.planes = SamplingPlanes::spherical;
        scene.color = {1, 1, 1, 0.1};
        context = openFor(scene, OffscreenProfile::Compatibility);
    }

    /// 100 degrees high; the volume's middle straight ahead, at a distance.
    static View wideView(double turn, double distance)
    {
        View view;
        view.model = multiply(translation(0, 0, -distance),
                              multiply(rotation(turn + 10, 1, 0.2, 0),
                                       multiply(rotation(turn, 0, 0.3, 1), translation(-20, -16.5, -18))));
        view.projection = perspective(100, 1, 0.5, 200);
        return view;
    }

    void expectPicture(const DrawOptions& options)
    {
        const Comparison comparison =
            compare(drawnPicture(*context, scene, options), referencePicture(scene));
        SCOPED_TRACE(comparison.summary());
        EXPECT_GT(comparison.opaquePixels, 1500u);
        EXPECT_LT(comparison.maskedPixels, comparison.opaquePixels / 2);
        EXPECT_GE(comparison.psnrMasked, 60.0);
        // A facet is up to a fiftieth of a step away from its shell: so many samples are in or out by
        // mistake.
        EXPECT_GE(comparison.psnrAll, 45.0);
        worst = std::min(worst, comparison.psnrMasked);
        RecordProperty("worst_dB", std::to_string(worst));
    }

    Field field = testField(true, 255);
    Scene scene;
    std::unique_ptr<vo::OffscreenContext> context;
    double worst = 1e9;
};

TEST_F(ShellsGL, raysAreSampledAtEqualDistances)
{
    DrawOptions options;
    for (const double distance : {34.0, 25.0, 12.0, 0.0}) { // the last two inside the volume
        scene.view = wideView(5 * distance, distance);
        expectPicture(options);
    }
}

TEST_F(ShellsGL, bricksMakeTheSamePicture)
{
    DrawOptions options;
    options.bricks = 3;
    for (const bool texCoords : {false, true}) {
        options.explicitTexCoords = texCoords;
        scene.view = wideView(70, texCoords ? 10.0 : 27.0);
        expectPicture(options);
    }
}

TEST_F(ShellsGL, drawUtilityDrawsShells)
{
    DrawOptions options;
    options.utility = true;
    options.bricks = 2;
    scene.view = wideView(120, 25);
    expectPicture(options);
}

TEST_F(ShellsGL, everyRayHasTheStepOfItsOwnDirection)
{
    scene.period = glm::dvec3(1, 0.7, 2);
    scene.view = wideView(30, 25);
    expectPicture({});
}

TEST_F(ShellsGL, volumesAreDrawnToTheirEdge)
{
    field = noiseField({40, 33, 36}, 4);
    scene.view = wideView(40, 30);
    const Comparison comparison = compare(drawnPicture(*context, scene, {}), referencePicture(scene));
    SCOPED_TRACE(comparison.summary());
    EXPECT_GE(comparison.psnrMasked, 60.0);
    EXPECT_GE(comparison.psnrAll, 35.0);
}

/// How far a picture is from the integral along each ray, in steps of a sixth, of the same opacity per
/// length.
TEST_F(ShellsGL, shellsAreCloserToTheIntegralThanPlanes)
{
    constexpr double kFine = 6.0;
    scene.view = wideView(20, 26);
    Scene fine = scene;
    fine.period = glm::dvec3(1.0 / kFine);
    fine.color = {1, 1, 1, 1};
    fine.classification = Classification::postInterpolation;
    for (int i = 0; i < 4096; ++i) {
        const auto v = static_cast<float>(i / 4095.0);
        fine.table.insert(fine.table.end(),
                          {v, v, v, static_cast<float>(1.0 - std::pow(1.0 - 0.1 * i / 4095.0, 1.0 / kFine))});
    }
    const Picture integral = referencePicture(fine);
    const Comparison shells = compare(drawnPicture(*context, scene, {}), integral);
    scene.planes = SamplingPlanes::viewportAligned;
    const Comparison planes = compare(drawnPicture(*context, scene, {}), integral);
    RecordProperty("shells_dB", std::to_string(shells.psnrAll));
    RecordProperty("planes_dB", std::to_string(planes.psnrAll));
    EXPECT_GT(shells.psnrAll, planes.psnrAll + 3.0) << shells.summary() << "; planes " << planes.summary();
}

} // namespace
