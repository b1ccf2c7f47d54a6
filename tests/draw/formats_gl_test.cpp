// Every data type and format that OpenGL can hold shows the colour that its voxels mean, in both profiles.

#include "draw/draw_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using Type = voDataTypeScope;
using External = voExternalFormatTypeScope;
using Internal = voInternalFormatTypeScope;

using Color = std::array<double, 4>;

template <typename T>
void append(std::vector<unsigned char>& bytes, T value)
{
    const auto* p = reinterpret_cast<const unsigned char*>(&value);
    bytes.insert(bytes.end(), p, p + sizeof value);
}

/// One voxel of the given type, and what its numbers mean in the order in which they lie.
struct Voxel
{
    std::vector<unsigned char> bytes;
    std::vector<double> means;
};

template <typename T>
Voxel numbers(std::array<T, 4> values, double one, int channels)
{
    Voxel voxel;
    for (int c = 0; c < channels; ++c) {
        append(voxel.bytes, values[static_cast<std::size_t>(c)]);
        voxel.means.push_back(static_cast<double>(values[static_cast<std::size_t>(c)]) / one);
    }
    return voxel;
}

template <typename T>
Voxel packed(T value, std::vector<double> means)
{
    Voxel voxel;
    append(voxel.bytes, value);
    voxel.means = std::move(means);
    return voxel;
}

Voxel voxelOf(voDataType type, int channels)
{
    switch (type) {
    case Type::DEFAULT:
    case Type::UNSIGNED_BYTE: return numbers<std::uint8_t>({200, 100, 50, 150}, 255, channels);
    case Type::BYTE: return numbers<std::int8_t>({100, 50, 25, 75}, 127, channels);
    case Type::UNSIGNED_SHORT: return numbers<std::uint16_t>({51234, 25000, 12345, 40000}, 65535, channels);
    case Type::SHORT: return numbers<std::int16_t>({25000, 12000, 6000, 20000}, 32767, channels);
    case Type::UNSIGNED_INT:
        return numbers<std::uint32_t>({3000000000u, 1500000000u, 700000000u, 2000000000u}, 4294967295.0,
                                      channels);
    case Type::INT:
        return numbers<std::int32_t>({1500000000, 700000000, 350000000, 1000000000}, 2147483647.0, channels);
    case Type::FLOAT: return numbers<float>({0.75f, 0.5f, 0.25f, 0.625f}, 1.0, channels);
    case Type::UNSIGNED_BYTE_3_3_2_EXT:
        return packed<std::uint8_t>(5 << 5 | 3 << 2 | 1, {5 / 7.0, 3 / 7.0, 1 / 3.0, 1.0});
    case Type::UNSIGNED_SHORT_4_4_4_4_EXT:
        return packed<std::uint16_t>(12 << 12 | 7 << 8 | 3 << 4 | 9,
                                     {12 / 15.0, 7 / 15.0, 3 / 15.0, 9 / 15.0});
    case Type::UNSIGNED_SHORT_5_5_5_1_EXT:
        return packed<std::uint16_t>(20 << 11 | 10 << 6 | 5 << 1 | 1, {20 / 31.0, 10 / 31.0, 5 / 31.0, 1.0});
    case Type::UNSIGNED_INT_8_8_8_8_EXT:
        return packed<std::uint32_t>(200u << 24 | 100u << 16 | 50u << 8 | 150u,
                                     {200 / 255.0, 100 / 255.0, 50 / 255.0, 150 / 255.0});
    case Type::UNSIGNED_INT_10_10_10_2_EXT:
        return packed<std::uint32_t>(800u << 22 | 400u << 12 | 200u << 2 | 2u,
                                     {800 / 1023.0, 400 / 1023.0, 200 / 1023.0, 2 / 3.0});
    }
    return {};
}

bool isPacked(voDataType type)
{
    return type == Type::UNSIGNED_BYTE_3_3_2_EXT || type == Type::UNSIGNED_SHORT_4_4_4_4_EXT ||
           type == Type::UNSIGNED_SHORT_5_5_5_1_EXT || type == Type::UNSIGNED_INT_8_8_8_8_EXT ||
           type == Type::UNSIGNED_INT_10_10_10_2_EXT;
}

int channelsOf(voExternalFormatType format)
{
    return format == External::LUMINANCE_ALPHA                        ? 2
           : format == External::RGBA || format == External::ABGR_EXT ? 4
                                                                      : 1;
}

Color colorOf(const std::vector<double>& means, voExternalFormatType format)
{
    switch (channelsOf(format)) {
    case 1: return {means[0], means[0], means[0], means[0]};
    case 2: return {means[0], means[0], means[0], means[1]};
    default: break;
    }
    if (format == External::ABGR_EXT) return {means[3], means[2], means[1], means[0]};
    return {means[0], means[1], means[2], means[3]};
}

Color sampledAs(const Color& c, voInternalFormatType format)
{
    switch (format) {
    case Internal::INTENSITY8_EXT: return {c[0], c[0], c[0], c[0]};
    case Internal::LUMINANCE8_EXT: return {c[0], c[0], c[0], 1};
    case Internal::LUMINANCE8_ALPHA8_EXT: return {c[0], c[0], c[0], c[3]};
    case Internal::RGB8_EXT:
    case Internal::RGB4_EXT: return {c[0], c[1], c[2], 1};
    default: return c;
    }
}

/// The colour of the middle pixel when a square in the middle of a volume of 4 x 4 x 4 such voxels is drawn.
std::array<float, 4> drawnColor(const vo::OffscreenContext& context, voInternalFormatType internal,
                                voExternalFormatType external, voDataType type, const Voxel& voxel)
{
    voBrickSetCollection volume(4, 4, 4, 4, 4, 4, voPartialBrickTypeScope::TRUNCATE, 1, internal, external,
                                type, voInterpolationTypeScope::_3D);
    voBrick* brick = volume.getCurrentBrickSet()->getBrick(0);
    auto* bytes = static_cast<unsigned char*>(voAppearanceActions::dataAlloc(brick));
    for (int i = 0; i < 64; ++i)
        std::memcpy(bytes + static_cast<std::size_t>(i) * voxel.bytes.size(), voxel.bytes.data(),
                    voxel.bytes.size());
    const GladGLContext& gl = context.gl();
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    voAppearanceActions::textureEnable(voInterpolationTypeScope::_3D);
    voAppearanceActions::texgenEnable();
    voAppearanceActions::texgenSetEquation(brick);
    EXPECT_EQ(voAppearanceActions::textureBind(brick), 0) << voError::getErrorString();
    voIndexedFaceSet square(4, 3, 5);
    float corners[12] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    square.appendPoly(corners, 4);
    voGeometryActions::draw(&square, voInterleavedArrayTypeScope::V3F);
    const std::vector<float> picture = context.readFloats();
    const std::size_t middle = 4 * (4 * 8 + 4);
    return {picture[middle], picture[middle + 1], picture[middle + 2], picture[middle + 3]};
}

class Formats : public testing::TestWithParam<OffscreenProfile>
{
protected:
    void SetUp() override
    {
        vo::OffscreenRequest request;
        request.profile = GetParam();
        request.width = request.height = 8;
        request.floatColor = true;
        context_ = vo::openOffscreen(request);
        ASSERT_TRUE(context_);
    }
    std::unique_ptr<vo::OffscreenContext> context_;
};

INSTANTIATE_TEST_SUITE_P(Both, Formats,
                         testing::Values(OffscreenProfile::Core, OffscreenProfile::Compatibility),
                         [](const auto& test) {
                             return test.param == OffscreenProfile::Core ? "core" : "compatibility";
                         });

TEST_P(Formats, showTheColourThatTheirVoxelsMean)
{
    int drawn = 0;
    for (int type = Type::UNSIGNED_BYTE; type <= Type::FLOAT; ++type)
        for (int external = External::INTENSITY; external <= External::ABGR_EXT; ++external)
            for (const voInternalFormatType internal :
                 {Internal::INTENSITY8_EXT, Internal::LUMINANCE8_EXT, Internal::LUMINANCE8_ALPHA8_EXT,
                  Internal::RGBA8_EXT, Internal::RGB8_EXT, Internal::RGBA4_EXT, Internal::RGB4_EXT}) {
                const auto t = static_cast<voDataType>(type);
                const auto e = static_cast<voExternalFormatType>(external);
                if (isPacked(t) && channelsOf(e) != 4) continue;
                // Three channels have no alpha to come first.
                if (t == Type::UNSIGNED_BYTE_3_3_2_EXT && e == External::ABGR_EXT) continue;
                const Voxel voxel = voxelOf(t, channelsOf(e));
                const Color expected = sampledAs(colorOf(voxel.means, e), internal);
                const std::array<float, 4> found = drawnColor(*context_, internal, e, t, voxel);
                // The library keeps 8 bits at least; fixed-point filters and conversions may lose the last.
                for (std::size_t c = 0; c < 4; ++c)
                    EXPECT_NEAR(found[c], expected[c], 0.51 / 255)
                        << "type " << type << ", external " << external << ", internal " << internal
                        << ", component " << c;
                ++drawn;
            }
    EXPECT_EQ(drawn, 7 * 5 * 7 + 4 * 2 * 7 + 7);
}

TEST_P(Formats, negativeVoxelsAreBlack)
{
    Voxel voxel;
    append<std::int16_t>(voxel.bytes, -1000);
    EXPECT_EQ(drawnColor(*context_, Internal::INTENSITY8_EXT, External::LUMINANCE, Type::SHORT, voxel)[0],
              0.0f);
}

TEST_P(Formats, sixteenBitsAreKept)
{
    // Of 8 bits the two would be one.
    for (const std::uint16_t value : {std::uint16_t{25700}, std::uint16_t{25760}}) {
        Voxel voxel;
        append(voxel.bytes, value);
        const auto found =
            drawnColor(*context_, Internal::INTENSITY8_EXT, External::LUMINANCE, Type::UNSIGNED_SHORT, voxel);
        EXPECT_NEAR(found[0], value / 65535.0, 1.0 / 65535);
    }
}

TEST_P(Formats, packedSgisFormatsAnswerUnsupported)
{
    for (const voInternalFormatType internal :
         {Internal::QUAD_LUMINANCE8_SGIS, Internal::DUAL_LUMINANCE_ALPHA8_SGIS,
          Internal::DUAL_INTENSITY8_SGIS}) {
        voBrickSetCollection volume(4, 4, 4, 4, 4, 4, voPartialBrickTypeScope::TRUNCATE, 1, internal,
                                    External::LUMINANCE, Type::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
        EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::UNSUPPORTED);
    }
}

TEST(CoreState, clipPlanesTextureMatrixAndColourComeFromVoState)
{
    const Field field = quantised(rampField({16, 16, 16}, {0.02, 0.03, 0.01}, 0.05));
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = 64;
    scene.view.projection = ortho(0, 16, 0, 16, -17, 1);
    const auto context = openFor(scene, OffscreenProfile::Core);
    const GLdouble plane[4] = {-1, 0, 0, 8};
    voState::setClipPlane(1, plane);
    SceneDrawing drawing(*context, scene, {.bricks = 2, .utility = true});
    drawing.draw();
    const auto at = [](int x, int y) { return static_cast<std::size_t>(4 * (y * 64 + x)); };
    EXPECT_GT(context->readFloats()[at(50, 32)], 0.1f) << "not enabled yet";
    context->gl().Enable(GL_CLIP_DISTANCE0 + 1);
    drawing.draw();
    EXPECT_EQ(context->readFloats()[at(50, 32)], 0.0f);
    EXPECT_GT(context->readFloats()[at(10, 32)], 0.1f);
    context->gl().Disable(GL_CLIP_DISTANCE0 + 1);

    const Matrix oneVoxel = translation(1.0 / 16, 0, 0);
    scene.compositing = Compositing::max;
    SceneDrawing shifted(*context, scene, {.bricks = 1, .utility = true});
    shifted.draw();
    const float before = context->readFloats()[at(32, 32)];
    voState::setTextureMatrix(oneVoxel.data());
    shifted.draw();
    EXPECT_NEAR(context->readFloats()[at(32, 32)] - before, 0.02, 1.0 / 255);
}

} // namespace
