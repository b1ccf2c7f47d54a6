// What pick says of the current graphics state, against what is drawn.

#include "draw/draw_scene.h"

#include "expect_error.h"

#include <vo/State.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;
using Type = voDataTypeScope;
using External = voExternalFormatTypeScope;
using Internal = voInternalFormatTypeScope;
using Format = voInterleavedArrayTypeScope;

constexpr int kPixels = 40;
const VoxelSize kSize{18, 15, 20};

std::vector<float> colorTable()
{
    std::vector<float> table;
    for (int i = 0; i < 64; ++i) {
        const double v = i / 63.0;
        for (const double value : {0.5 + 0.5 * std::sin(6.0 * v), v * v, 1.0 - v, 0.2 * v})
            table.push_back(static_cast<float>(value));
    }
    return table;
}

struct PickCase
{
    const char* name;
    Classification classification = Classification::none;
    int channels = 4;
    voDataType type = Type::FLOAT;
    int bricks = 1;
    bool stacks = false;
    double degrees = 0.0;
    bool texCoords = false;
    OffscreenProfile profile = OffscreenProfile::Compatibility;
    double unitLength = 0.0;
};

std::ostream& operator<<(std::ostream& stream, const PickCase& c)
{
    return stream << c.name;
}

Field fieldOf(const PickCase& c)
{
    std::vector<Field> channels;
    for (int i = 0; i < c.channels; ++i)
        channels.push_back(noiseField(kSize, unsigned(i) + 1));
    Field field = c.channels == 1 ? channels[0] : combined(channels);
    return c.type == Type::UNSIGNED_BYTE ? quantised(field) : field;
}

Scene sceneOf(const PickCase& c, const Field& field, const Angles& angles, std::vector<float> table)
{
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = kPixels;
    scene.view = c.degrees > 0 ? perspectiveView(angles, kSize, kPixels, kPixels, c.degrees)
                               : orthographicView(angles, kSize, kPixels, kPixels);
    scene.overlap = 1;
    scene.period = glm::dvec3(1.2, 0.9, 1.1);
    if (c.stacks) scene.period = glm::dvec3(1.0);
    scene.classification = c.classification;
    scene.table = std::move(table);
    // One channel comes back as its luminance alone: then fragments are added up.
    scene.compositing = c.channels == 4 ? Compositing::over : Compositing::sum;
    scene.color = c.channels == 4 ? std::array{0.9, 0.7, 0.8, 0.3} : std::array{0.75, 0.75, 0.75, 0.5};
    return scene;
}

/// Red, green and blue that the picked samples of a pixel make.
struct PickedPixel
{
    glm::dvec3 color{0.0};
    int samples = 0;
};

PickedPixel pickPixel(const PickCase& c, const Scene& scene, SceneDrawing& drawing, int x, int y)
{
    View view = scene.view;
    int pixel[2] = {x, y}, viewport[4] = {0, 0, kPixels, kPixels};
    float period[3];
    for (int axis = 0; axis < 3; ++axis)
        period[axis] = static_cast<float>((*scene.period)[axis]);
    voVertexData coordinates(200, c.texCoords ? 6 : 3);
    std::vector<float> floats(4 * 200);
    std::vector<unsigned char> bytes(4 * 200);
    void* voxels = c.type == Type::FLOAT ? static_cast<void*>(floats.data()) : bytes.data();
    voGeometryActions::pick(pixel, viewport, &drawing.tetras(), drawing.volume().getCurrentBrickSet(),
                            c.texCoords ? Format::T3F_V3F : Format::V3F, view.model.data(),
                            view.projection.data(), period, VO_TRUE, &coordinates, voxels);
    PickedPixel result;
    result.samples = coordinates.getCount();
    const auto value = [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        return c.type == Type::FLOAT ? double(floats[at]) : bytes[at] / 255.0;
    };
    for (int i = coordinates.getCount() - 1; i >= 0; --i) {
        if (c.channels == 4) {
            const glm::dvec3 rgb(value(4 * i), value(4 * i + 1), value(4 * i + 2));
            result.color += (rgb - result.color) * value(4 * i + 3);
        } else {
            result.color += glm::dvec3(value(c.channels * i));
        }
    }
    return result;
}

class PickGL : public testing::TestWithParam<PickCase>
{
};

TEST_P(PickGL, picksWhatIsDrawn)
{
    const PickCase& c = GetParam();
    const Field field = fieldOf(c);
    std::unique_ptr<vo::OffscreenContext> context;
    int compared = 0;
    for (const Angles& angles : randomViews(3, 29)) {
        std::vector<float> table = colorTable();
        if (c.channels < 4) // grey
            for (std::size_t i = 0; i < table.size(); i += 4)
                table[i + 1] = table[i + 2] = table[i];
        Scene scene = sceneOf(c, field, angles, table);
        if (!context) context = openFor(scene, c.profile);
        if (c.stacks) {
            scene.planes = SamplingPlanes::axisAligned;
            View v = scene.view;
            scene.stackAxis =
                3 - static_cast<int>(voGeometryActions::findClosestAxisIndex(
                        v.model.data(), v.projection.data(), voSamplingModeScope::AXIS_ALIGNED));
        }
        DrawOptions options;
        options.utility = true;
        options.bricks = c.bricks;
        options.explicitTexCoords = c.texCoords;
        options.dataType = c.type;
        SceneDrawing drawing(*context, scene, options);
        voState::setUnitLength(c.unitLength);
        drawing.draw();
        const std::vector<float> picture = context->readFloats();
        const Picture reference = referencePicture(scene);
        const bool software = context->description().find("llvmpipe") != std::string::npos;
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x) {
                if (!reference.isUnmasked(x, y)) continue;
                const PickedPixel picked = pickPixel(c, scene, drawing, x, y);
                const double rounding = c.type == Type::FLOAT ? 0.0 : 0.51 / 255 * picked.samples;
                const double bar =
                    (software ? 3e-4 : 1e-2) * (c.channels == 4 ? 1 : picked.samples) + rounding;
                for (int i = 0; i < 3; ++i)
                    ASSERT_NEAR(picked.color[i], picture[std::size_t(4 * (y * kPixels + x) + i)], bar)
                        << "pixel " << x << " " << y << ", " << picked.samples << " samples";
                if (picked.samples > 4) ++compared;
            }
    }
    EXPECT_GT(compared, 500);
    expectNoError();
}

const Classification kPre = Classification::preInterpolation;
const Classification kPost = Classification::postInterpolation;

INSTANTIATE_TEST_SUITE_P(
    All, PickGL,
    testing::Values(
        PickCase{.name = "colours"}, PickCase{.name = "coloursPre", .classification = kPre},
        PickCase{.name = "coloursPost", .classification = kPost},
        PickCase{.name = "coreProfile", .classification = kPost, .profile = OffscreenProfile::Core},
        PickCase{.name = "bricks", .classification = kPost, .bricks = 3},
        PickCase{.name = "perspective", .classification = kPre, .bricks = 2, .degrees = 50},
        PickCase{.name = "texCoords", .bricks = 2, .degrees = 30, .texCoords = true},
        PickCase{.name = "stacks", .classification = kPost, .bricks = 2, .stacks = true},
        PickCase{.name = "grey", .channels = 1, .bricks = 2},
        PickCase{.name = "greyPost", .classification = kPost, .channels = 1},
        PickCase{.name = "greyPre", .classification = kPre, .channels = 1},
        PickCase{.name = "greyAlpha", .classification = kPost, .channels = 2},
        PickCase{.name = "perLength", .classification = kPost, .degrees = 60, .unitLength = 3},
        PickCase{.name = "bytes", .channels = 1, .type = Type::UNSIGNED_BYTE},
        PickCase{.name = "bytesPost", .classification = kPost, .channels = 1, .type = Type::UNSIGNED_BYTE}),
    [](const auto& test) { return std::string(test.param.name); });

/// A volume of 4^3 equal voxels seen along -z, and one pixel.
struct PickStateGL : testing::Test
{
    PickStateGL()
    {
        vo::OffscreenRequest request;
        request.width = request.height = 4;
        request.floatColor = true;
        context = vo::openOffscreen(request);
        view.projection = ortho(0, 4, 0, 4, -5, 1);
    }

    template <class T>
    std::unique_ptr<voBrickSetCollection> volume(voDataType type, voExternalFormatType format,
                                                 std::vector<T> voxel,
                                                 voInternalFormatType internal = Internal::DEFAULT)
    {
        auto result =
            std::make_unique<voBrickSetCollection>(4, 4, 4, 4, 4, 4, voPartialBrickTypeScope::TRUNCATE, 0,
                                                   internal, format, type, voInterpolationTypeScope::_3D);
        T* target = static_cast<T*>(voAppearanceActions::dataAlloc(result->getCurrentBrickSet()));
        for (int i = 0; i < 64; ++i)
            target = std::copy(voxel.begin(), voxel.end(), target);
        return result;
    }

    /// The nearest sample of the pixel (1, 2).
    template <class T, std::size_t N>
    std::array<T, N> picked(voBrickSetCollection& bricks, voInterleavedArrayType format = Format::V3F,
                            std::vector<float> front = {})
    {
        std::vector<float> records;
        for (int i = 0; i < 8; ++i) {
            records.insert(records.end(), front.begin(), front.end());
            for (const bool far : {i % 4 == 1 || i % 4 == 2, i % 4 >= 2, i >= 4})
                records.push_back(far ? 4.0f : 0.0f);
        }
        int indices[20] = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
        const int values = 3 + static_cast<int>(front.size());
        voIndexedTetraSet tetras(records.data(), 8, values, indices, 20);
        int pixel[2] = {1, 2}, viewport[4] = {0, 0, 4, 4};
        float period[3] = {1, 1, 1};
        voVertexData coordinates(1, values);
        std::array<T, N> found{};
        EXPECT_EQ(voGeometryActions::pick(pixel, viewport, &tetras, bricks.getCurrentBrickSet(), format,
                                          view.model.data(), view.projection.data(), period, VO_TRUE,
                                          &coordinates, found.data()),
                  VO_TRUE);
        expectNoError();
        return found;
    }

    std::unique_ptr<vo::OffscreenContext> context;
    View view;
};

TEST_F(PickStateGL, currentColourIsAFactor)
{
    context->gl().Color4f(0.5f, 0.25f, 1.0f, 0.75f);
    const auto rgba = volume<float>(Type::FLOAT, External::RGBA, {0.5f, 0.5f, 0.25f, 1.0f});
    EXPECT_EQ((picked<float, 4>(*rgba)), (std::array{0.25f, 0.125f, 0.25f, 0.75f}));
    const auto abgr = volume<float>(Type::FLOAT, External::ABGR_EXT, {1.0f, 0.25f, 0.5f, 0.5f});
    EXPECT_EQ((picked<float, 4>(*abgr)), (std::array{0.75f, 0.25f, 0.125f, 0.25f}));
}

TEST_F(PickStateGL, coloursBecomeOneChannelByLuminance)
{
    context->gl().Color4f(0.5f, 0.25f, 1.0f, 0.75f);
    const auto grey = volume<float>(Type::FLOAT, External::LUMINANCE, {0.5f});
    EXPECT_NEAR((picked<float, 1>(*grey)[0]), 0.5 * (0.30 * 0.5 + 0.59 * 0.25 + 0.11), 1e-6);
    const auto two = volume<float>(Type::FLOAT, External::LUMINANCE_ALPHA, {0.5f, 0.25f});
    const auto found = picked<float, 2>(*two);
    EXPECT_NEAR(found[0], 0.5 * (0.30 * 0.5 + 0.59 * 0.25 + 0.11), 1e-6);
    EXPECT_NEAR(found[1], 0.25 * 0.75, 1e-6);
}

TEST_F(PickStateGL, packedVoxelsArePackedAgain)
{
    context->gl().Color4f(1, 1, 1, 1);
    const auto nibbles = volume<std::uint16_t>(Type::UNSIGNED_SHORT_4_4_4_4_EXT, External::RGBA, {0xC739});
    EXPECT_EQ((picked<std::uint16_t, 1>(*nibbles)[0]), 0xC739);
    context->gl().Color4f(0, 1, 1, 1);
    EXPECT_EQ((picked<std::uint16_t, 1>(*nibbles)[0]), 0x0739);
    const auto small = volume<std::uint8_t>(Type::UNSIGNED_BYTE_3_3_2_EXT, External::RGBA, {0xAD});
    EXPECT_EQ((picked<std::uint8_t, 1>(*small)[0]), 0x0D);
}

TEST_F(PickStateGL, coloursOfVerticesReplaceTheCurrentOne)
{
    context->gl().Color4f(0.1f, 0.1f, 0.1f, 0.1f);
    const auto rgba = volume<float>(Type::FLOAT, External::RGBA, {1, 1, 1, 0.5f});
    EXPECT_EQ((picked<float, 4>(*rgba, Format::C4F_V3F, {0.5f, 0.25f, 0.75f, 0.5f})),
              (std::array{0.5f, 0.25f, 0.75f, 0.25f}));
    EXPECT_EQ((picked<float, 4>(*rgba, Format::C3F_V3F, {0.5f, 0.25f, 0.75f})),
              (std::array{0.5f, 0.25f, 0.75f, 0.5f}));
}

TEST_F(PickStateGL, replaceLeavesTheColourOut)
{
    context->gl().Color4f(0.1f, 0.1f, 0.1f, 0.25f);
    context->gl().TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const auto rgba = volume<float>(Type::FLOAT, External::RGBA, {1, 0.5f, 1, 0.5f});
    EXPECT_EQ((picked<float, 4>(*rgba)), (std::array{1.0f, 0.5f, 1.0f, 0.5f}));
    const auto opaque = volume<float>(Type::FLOAT, External::RGBA, {1, 0.5f, 1, 0.5f}, Internal::RGB8_EXT);
    EXPECT_EQ((picked<float, 4>(*opaque)), (std::array{1.0f, 0.5f, 1.0f, 0.25f}));
}

TEST_F(PickStateGL, negativeVoxelsAreBlackAsTexturesHaveThem)
{
    context->gl().Color4f(1, 1, 1, 1);
    const auto shorts = volume<std::int16_t>(Type::SHORT, External::LUMINANCE, {-1234});
    EXPECT_EQ((picked<std::int16_t, 1>(*shorts)[0]), 0);
    const auto floats = volume<float>(Type::FLOAT, External::LUMINANCE, {-2.5f});
    EXPECT_FLOAT_EQ((picked<float, 1>(*floats)[0]), -2.5f);
}

TEST_F(PickStateGL, textureMatrixMovesTheVoxels)
{
    context->gl().Color4f(1, 1, 1, 1);
    const auto ramp = volume<float>(Type::FLOAT, External::LUMINANCE, {0.0f});
    float* voxels = static_cast<float*>(ramp->getCurrentBrickSet()->getBrick(0)->getDataPtr());
    for (int i = 0; i < 64; ++i)
        voxels[i] = static_cast<float>(i % 4); // x
    EXPECT_FLOAT_EQ((picked<float, 1>(*ramp)[0]), 1.0f);
    context->gl().MatrixMode(GL_TEXTURE);
    context->gl().Translatef(0.25f, 0, 0);
    EXPECT_FLOAT_EQ((picked<float, 1>(*ramp)[0]), 2.0f);
    context->gl().LoadIdentity();
    context->gl().Scalef(1.5f, 1, 1);
    EXPECT_FLOAT_EQ((picked<float, 1>(*ramp)[0]), 1.75f);
}

TEST_F(PickStateGL, textureMatrixOfAStackHasTheTwoCoordinatesThatItsTexturesHave)
{
    context->gl().Color4f(1, 1, 1, 1);
    voBrickSetCollection stacks(4, 4, 4, 4, 4, 4, voPartialBrickTypeScope::TRUNCATE, 0, Internal::DEFAULT,
                                External::LUMINANCE, Type::FLOAT, voInterpolationTypeScope::_2D);
    stacks.setCurrentBrickSet(voPlaneOrientationScope::XZ);
    for (int y = 0; y < 4; ++y) {
        float* voxels =
            static_cast<float*>(voAppearanceActions::dataAlloc(stacks.getCurrentBrickSet()->getBrick(y)));
        for (int i = 0; i < 16; ++i)
            voxels[i] = static_cast<float>(i % 4 + 10 * y + i / 4 * 100); // x, y, z
    }
    view.model = multiply(translation(0, 4, 0), rotation(90, 1, 0, 0)); // along -y, z points down
    view.projection = ortho(0, 4, 0, 4, -10, 10);
    const float before = picked<float, 1>(stacks)[0];
    context->gl().MatrixMode(GL_TEXTURE);
    context->gl().Translatef(0.25f, -0.25f, 0.25f); // one voxel more in x, one less in z
    EXPECT_FLOAT_EQ((picked<float, 1>(stacks)[0]), before + 1 - 100);
}

TEST_F(PickStateGL, oneChannelLooksAllComponentsUp)
{
    context->gl().Color4f(1, 1, 1, 1);
    std::vector<float> entries = {0, 0, 0, 0, 0.5f, 0.25f, 0.125f, 0.75f};
    voLookupTablePost table(Internal::RGBA8_EXT, 2, External::RGBA, Type::FLOAT, entries.data());
    table.load();
    table.enable();
    const auto rgba =
        volume<float>(Type::FLOAT, External::RGBA, {0.5f, 1.0f, 0.25f, 1.0f}, Internal::LUMINANCE8_EXT);
    EXPECT_EQ((picked<float, 4>(*rgba)), (std::array{0.25f, 0.125f, 0.0625f, 0.375f}));
    const auto two = volume<float>(Type::FLOAT, External::RGBA, {0.5f, 1.0f, 0.25f, 1.0f},
                                   Internal::LUMINANCE8_ALPHA8_EXT);
    EXPECT_EQ((picked<float, 4>(*two)), (std::array{0.25f, 0.125f, 0.0625f, 0.75f}));
}

TEST_F(PickStateGL, valuesBetweenVoxelsAreInterpolated)
{
    context->gl().Color4f(1, 1, 1, 1);
    const auto ramp = volume<float>(Type::FLOAT, External::LUMINANCE, {0.0f});
    float* voxels = static_cast<float*>(ramp->getCurrentBrickSet()->getBrick(0)->getDataPtr());
    for (int i = 0; i < 64; ++i)
        voxels[i] = static_cast<float>(i % 4 + i / 4 % 4 * 10 + i / 16 * 100);
    view.projection = ortho(-0.25, 3.75, 0.125, 4.125, -5, 1); // pixel (1, 2) shows (1.25, 2.625)
    EXPECT_NEAR((picked<float, 1>(*ramp)[0]), 0.75f + 21.25f + 300.0f, 1e-4);
}

TEST_F(PickStateGL, nothingOfTheCallersIsChanged)
{
    const GladGLContext& gl = context->gl();
    const auto rgba = volume<float>(Type::FLOAT, External::RGBA, {0.5f, 0.5f, 0.25f, 1.0f});
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_3D, texture);
    gl.Color4f(0.5f, 0.5f, 0.5f, 0.5f);
    picked<float, 4>(*rgba);
    GLint unit = 0, bound = 0, program = -1;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    gl.GetIntegerv(GL_TEXTURE_BINDING_3D, &bound);
    gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
    EXPECT_EQ(unit, GL_TEXTURE1);
    EXPECT_EQ(bound, static_cast<GLint>(texture));
    EXPECT_EQ(program, 0);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    gl.DeleteTextures(1, &texture);
}

} // namespace
