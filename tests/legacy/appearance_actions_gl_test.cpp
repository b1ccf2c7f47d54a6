#include "square_screen.h"

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

} // namespace
