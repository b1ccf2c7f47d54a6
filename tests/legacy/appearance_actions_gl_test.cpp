#include "square_screen.h"

#include <vo/utPerfMeter.h>

#include <gtest/gtest.h>

namespace {

using namespace vo::test;
using Interpolation = voInterpolationTypeScope;

struct AppearanceActionsGL : testing::Test
{
    GLuint bound(GLenum binding = GL_TEXTURE_BINDING_3D)
    {
        GLint name = 0;
        screen.gl().GetIntegerv(binding, &name);
        return static_cast<GLuint>(name);
    }
    /// A texel of the two-dimensional texture that is bound.
    float texelOfBound()
    {
        float texels[16] = {};
        screen.gl().GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, texels);
        return texels[5];
    }
    SquareScreen screen;
};

TEST_F(AppearanceActionsGL, textureEnableIsOpenGlsOwnState)
{
    for (const auto& [type, target] : {std::pair(Interpolation::_2D, GL_TEXTURE_2D),
                                       {Interpolation::_3D, GL_TEXTURE_3D},
                                       {Interpolation::DEFAULT, GL_TEXTURE_3D}}) {
        voAppearanceActions::textureEnable(type);
        EXPECT_TRUE(screen.gl().IsEnabled(static_cast<GLenum>(target)));
        voAppearanceActions::textureDisable(type);
        EXPECT_FALSE(screen.gl().IsEnabled(static_cast<GLenum>(target)));
    }
    expectNoError();
}

TEST_F(AppearanceActionsGL, texgenIsOpenGlsOwnState)
{
    voAppearanceActions::texgenEnable();
    for (const GLenum coordinate : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R})
        EXPECT_TRUE(screen.gl().IsEnabled(coordinate));
    voBrick brick(voInternalFormatTypeScope::DEFAULT, voExternalFormatTypeScope::DEFAULT,
                  voDataTypeScope::DEFAULT);
    brick.setBrickSizes(10, 20, 30, 5, 8, 4);
    voAppearanceActions::texgenSetEquation(&brick);
    float plane[4];
    screen.gl().GetTexGenfv(GL_T, GL_OBJECT_PLANE, plane);
    EXPECT_FLOAT_EQ(plane[1] * 24 + plane[3], 0.5f);
    screen.gl().GetTexGenfv(GL_R, GL_OBJECT_PLANE, plane);
    EXPECT_FLOAT_EQ(plane[2] * 34 + plane[3], 1.0f);
    voAppearanceActions::texgenDisable();
    EXPECT_FALSE(screen.gl().IsEnabled(GL_TEXTURE_GEN_S));
    expectNoError();
}

TEST_F(AppearanceActionsGL, bindMakesTheTextureCurrent)
{
    const auto volume = SquareScreen::constantVolume(255);
    EXPECT_EQ(voAppearanceActions::textureBind(SquareScreen::brickOf(*volume)), 0);
    const GLuint name = bound();
    EXPECT_TRUE(screen.gl().IsTexture(name));
    GLint width = 0;
    screen.gl().GetTexLevelParameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 4);
    screen.gl().BindTexture(GL_TEXTURE_3D, 0);
    EXPECT_EQ(voAppearanceActions::textureBind(SquareScreen::brickOf(*volume)), 0);
    EXPECT_EQ(bound(), name);
    expectNoError();
}

TEST_F(AppearanceActionsGL, bindDownloadsOnceLoadAndDirtyFlagAgain)
{
    const auto volume = SquareScreen::constantVolume(255);
    voBrick* brick = SquareScreen::brickOf(*volume);
    EXPECT_NEAR(screen.drawSquare(*volume).first, 1.0f, 1e-4f);
    std::memset(brick->getDataPtr(), 0, 64);
    EXPECT_NEAR(screen.drawSquare(*volume).first, 1.0f, 1e-4f);
    EXPECT_EQ(voAppearanceActions::textureLoad(brick), 0);
    EXPECT_EQ(screen.drawSquare(*volume).first, 0.0f);
    std::memset(brick->getDataPtr(), 255, 64);
    volume->setDirtyFlag(VO_FALSE);
    EXPECT_EQ(screen.drawSquare(*volume).first, 0.0f);
    volume->setDirtyFlag(VO_TRUE);
    EXPECT_NEAR(screen.drawSquare(*volume).first, 1.0f, 1e-4f);
    double low = 0, high = 510;
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick, low, high), 0);
    EXPECT_NEAR(screen.drawSquare(*volume).first, 0.5f, 3e-3f);
    expectNoError();
}

TEST_F(AppearanceActionsGL, optimizeMakesResidentAndUnoptimizeReleases)
{
    const auto volume = SquareScreen::constantVolume(255);
    EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), voOptimizeVolumeTypeScope::BEST_PERFORMANCE),
              0);
    EXPECT_EQ(bound(), 0u); // the caller's binding is given back
    std::memset(SquareScreen::brickOf(*volume)->getDataPtr(), 0, 64);
    EXPECT_NEAR(screen.drawSquare(*volume).first, 1.0f, 1e-4f); // resident since then
    const GLuint name = bound();
    EXPECT_EQ(voAppearanceActions::volumeUnoptimize(volume.get()), 0);
    EXPECT_FALSE(screen.gl().IsTexture(name));
    EXPECT_EQ(screen.drawSquare(*volume).first, 0.0f);
    expectNoError();
}

TEST_F(AppearanceActionsGL, deletingTheVolumeDeletesItsTextures)
{
    auto volume = SquareScreen::constantVolume(255);
    screen.drawSquare(*volume);
    const GLuint name = bound();
    volume.reset();
    EXPECT_FALSE(screen.gl().IsTexture(name));
    const auto next = SquareScreen::constantVolume(255);
    EXPECT_NEAR(screen.drawSquare(*next).first, 1.0f, 1e-4f);
    expectNoError();
}

TEST_F(AppearanceActionsGL, bindRefusesWhatHasNoVoxelsOrIsTooLarge)
{
    voBrick brick(voInternalFormatTypeScope::DEFAULT, voExternalFormatTypeScope::DEFAULT,
                  voDataTypeScope::DEFAULT);
    EXPECT_NE(voAppearanceActions::textureBind(&brick), 0);
    expectBadValue("no voxels");
    EXPECT_NE(voAppearanceActions::textureLoad(&brick), 0);
    expectBadValue("no voxels");
    voAppearanceActions::dataAlloc(&brick);
    brick.setBrickSizes(0, 0, 0, 100, 100, 100);
    EXPECT_NE(voAppearanceActions::textureBind(&brick), 0);
    expectBadValue("bytes of voxels");
    std::vector<unsigned char> voxels(4000000);
    brick.setBrickSizes(0, 0, 0, 1000000, 2, 2);
    brick.setDataPtr(voxels.data());
    EXPECT_NE(voAppearanceActions::textureBind(&brick), 0);
    expectBadValue("larger than OpenGL takes");
    brick.setBrickSizes(0, 0, 0, 2, 2, 2);
    EXPECT_EQ(voAppearanceActions::textureBind(&brick), 0);
    EXPECT_EQ(screen.gl().GetError(), GLenum{GL_NO_ERROR});
}

TEST_F(AppearanceActionsGL, bestParametersKnowTheLimitOfTheContext)
{
    GLint limit = 0;
    screen.gl().GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
    voInternalFormatType internal;
    voExternalFormatType external;
    int x = 1 << 30, y = 7, z = limit;
    EXPECT_EQ(voAppearanceActions::getBestParameters(Interpolation::_3D, voRenderingModeScope::COLOR,
                                                     voDataTypeScope::FLOAT, voExternalFormatTypeScope::RGBA,
                                                     internal, external, x, y, z),
              0);
    EXPECT_EQ(x, limit);
    EXPECT_EQ(y, 7);
    EXPECT_EQ(z, limit);
}

TEST_F(AppearanceActionsGL, dirtyFlagMakesEveryStackStale)
{
    auto volume = byteVolume(4, 4, Interpolation::_2D, 0);
    for (int s = 0; s < 3; ++s)
        voAppearanceActions::dataAlloc(volume->getBrickSet(s));
    const auto texel = [&](voBrick* brick) {
        screen.gl().BindTexture(GL_TEXTURE_2D, 0);
        EXPECT_EQ(voAppearanceActions::textureBind(brick), 0);
        return texelOfBound();
    };
    for (const bool dirty : {false, true}) {
        for (int s = 0; s < 3; ++s)
            std::memset(volume->getBrickSet(s)->getBrick(1)->getDataPtr(), dirty ? 255 : 0, 16);
        volume->setDirtyFlag(dirty ? VO_TRUE : VO_FALSE);
        for (int s = 0; s < 3; ++s)
            EXPECT_EQ(texel(volume->getBrickSet(s)->getBrick(1)), dirty ? 1.0f : 0.0f) << s;
    }
    // Without the flag the old voxels stay.
    for (int s = 0; s < 3; ++s) {
        std::memset(volume->getBrickSet(s)->getBrick(1)->getDataPtr(), 0, 16);
        EXPECT_EQ(texel(volume->getBrickSet(s)->getBrick(1)), 1.0f) << s;
    }
    expectNoError();
}

TEST_F(AppearanceActionsGL, optimizeSendsADirtyVolumeAgain)
{
    const auto volume = SquareScreen::constantVolume(255);
    voBrick* brick = SquareScreen::brickOf(*volume);
    const int best = voOptimizeVolumeTypeScope::BEST_PERFORMANCE;
    EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), best), 0);
    std::memset(brick->getDataPtr(), 0, 64);
    volume->setDirtyFlag(VO_TRUE);
    EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), best), 0);
    std::memset(brick->getDataPtr(), 255, 64); // after it was sent
    EXPECT_EQ(screen.drawSquare(*volume).first, 0.0f);
    expectNoError();
}

TEST_F(AppearanceActionsGL, interleavingLeavesThePictureAsItIs)
{
    const auto volume = byteVolume(4, 2, Interpolation::_3D, 0);
    voBrickSet& set = *volume->getCurrentBrickSet();
    voAppearanceActions::dataAlloc(&set);
    for (int b = 0; b < set.getBrickCount(); ++b)
        std::memset(set.getBrick(b)->getDataPtr(), 20 + 30 * b, 8);
    CubeArrays cube(4);
    voIndexedTetraSet tetras(&cube.vertices[0][0], 8, 3, cube.indices, 20);
    std::vector<std::vector<float>> pictures;
    using O = voOptimizeVolumeTypeScope;
    for (const int flags :
         {int{O::NONE}, int{O::TEXTURE_OBJECTS}, int{O::BEST_PERFORMANCE}, int{O::INTERLEAVE}}) {
        EXPECT_EQ(voAppearanceActions::volumeUnoptimize(volume.get()), 0);
        EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), flags), 0);
        EXPECT_EQ(voAppearanceActions::cliqueTest(set.getBrick(0), set.getBrick(1)),
                  flags & O::INTERLEAVE ? VO_TRUE : VO_FALSE);
        screen.gl().Clear(GL_COLOR_BUFFER_BIT);
        float period[3] = {1, 1, 1};
        EXPECT_EQ(voGeometryActions::drawUtility(&tetras, voInterleavedArrayTypeScope::V3F, volume.get(),
                                                 NULL, voSamplingSpaceScope::OBJECT, period,
                                                 voDecorationFlagsScope::NONE),
                  0);
        pictures.push_back(screen.context->readFloats());
        EXPECT_EQ(pictures.back(), pictures.front());
    }
    EXPECT_NEAR(pictures.front()[0], (20 + 30 * 4) / 255.0, 1e-4); // brick 4 is the nearest at the lower left
    expectNoError();
}

/// Polygons with voxel coordinates of their own, as a texture matrix takes them to a brick.
TEST_F(AppearanceActionsGL, textureMatrixStandsForTransformedCoordinates)
{
    const auto volume = byteVolume(8, 4, Interpolation::_3D, 0);
    voBrick* brick = volume->getCurrentBrickSet()->getBrick(6); // at (0, 4, 4)
    auto* voxels = static_cast<unsigned char*>(voAppearanceActions::dataAlloc(brick));
    for (int i = 0; i < 64; ++i)
        voxels[i] = static_cast<unsigned char>(4 * i);
    const auto drawn = [&](bool byMatrix) {
        const GladGLContext& gl = screen.gl();
        gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Color4f(1, 1, 1, 1);
        voIndexedFaceSet square(0, 6, 0);
        float corners[] = {0, 4, 5, 0, 0, 2, 4, 4, 6, 4, 0, 2, 4, 8, 7, 4, 4, 2, 0, 8, 6, 0, 4, 2};
        square.appendPoly(corners, 4);
        float matrix[16];
        voAppearanceActions::textureMakeMatrix(brick, matrix);
        gl.MatrixMode(GL_TEXTURE);
        gl.LoadIdentity();
        if (byMatrix)
            gl.MultMatrixf(matrix);
        else
            voAppearanceActions::xfmVox2TexCoords(brick, &square, voInterleavedArrayTypeScope::T3F_V3F,
                                                  voPlaneOrientationScope::UNSPECIFIED);
        gl.MatrixMode(GL_MODELVIEW);
        voAppearanceActions::textureEnable(Interpolation::_3D);
        EXPECT_EQ(voAppearanceActions::textureBind(brick), 0);
        voGeometryActions::draw(&square, voInterleavedArrayTypeScope::T3F_V3F);
        voAppearanceActions::textureDisable(Interpolation::_3D);
        return screen.context->readFloats();
    };
    const std::vector<float> expected = drawn(false), found = drawn(true);
    EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.3f);
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-5) << i;
    expectNoError();
}

TEST_F(AppearanceActionsGL, enabledMeterCountsTheFramesOfDrawUtility)
{
    const auto volume = SquareScreen::constantVolume(255);
    CubeArrays cube(4);
    voIndexedTetraSet tetras(&cube.vertices[0][0], 8, 3, cube.indices, 20);
    const auto frame = [&] {
        float period[3] = {1, 1, 1};
        EXPECT_EQ(voGeometryActions::drawUtility(&tetras, voInterleavedArrayTypeScope::V3F, volume.get(),
                                                 NULL, voSamplingSpaceScope::OBJECT, period,
                                                 voDecorationFlagsScope::NONE),
                  0);
        return screen.context->readFloats();
    };
    const auto total = [](const voutPerfMeter& meter) {
        double sum = 0;
        for (int phase = 0; phase < voutPerfMeter::PHASE_COUNT; ++phase)
            sum += meter.getTimer(static_cast<voutPerfMeter::Phase>(phase)).getSeconds();
        return sum;
    };
    const std::vector<float> plain = frame();
    voAppearanceActions::volumeUnoptimize(volume.get());
    voutPerfMeter meter;
    {
        voutPerfMeter replaced;
        replaced.enable();
        meter.enable();
        EXPECT_EQ(frame(), plain);
        EXPECT_EQ(replaced.getFrameCount(), 0);
        replaced.disable(); // is not the one
        frame();
    }
    frame();
    EXPECT_EQ(meter.getFrameCount(), 3);
    for (int phase = 0; phase < voutPerfMeter::PHASE_COUNT; ++phase)
        EXPECT_GT(meter.getTimer(static_cast<voutPerfMeter::Phase>(phase)).getSeconds(), 0.0) << phase;
    meter.disable();
    const double before = total(meter);
    frame();
    EXPECT_EQ(meter.getFrameCount(), 3);
    EXPECT_EQ(total(meter), before);
    {
        voutPerfMeter gone;
        gone.enable();
    }
    frame();
    expectNoError();
}

} // namespace
