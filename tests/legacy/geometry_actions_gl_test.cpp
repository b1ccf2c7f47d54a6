#include "square_screen.h"

#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <limits>
#include <sstream>

namespace {

using namespace vo::test;
using Format = voInterleavedArrayTypeScope;
using Space = voSamplingSpaceScope;
using Decorations = voDecorationFlagsScope;

struct GeometryActionsGL : testing::Test
{
    GeometryActionsGL() : tetras(&cube.vertices[0][0], 8, 3, cube.indices, 20)
    {
        screen.gl().ClearColor(0, 0, 0, 0);
        screen.gl().Clear(GL_COLOR_BUFFER_BIT);
        screen.gl().Color4f(1, 1, 1, 1);
        square.appendPoly(corners, 4);
    }
    ~GeometryActionsGL() override { EXPECT_EQ(screen.gl().GetError(), GLenum{GL_NO_ERROR}); }

    int drawUtility(voBrickSetCollection& volume, voDrawActionCache* cache = NULL)
    {
        return voGeometryActions::drawUtility(&tetras, Format::V3F, &volume, cache, Space::OBJECT, period,
                                              Decorations::NONE);
    }

    SquareScreen screen;
    CubeArrays cube{4};
    voIndexedTetraSet tetras;
    float corners[12] = {0, 0, 2, 4, 0, 2, 4, 4, 2, 0, 4, 2};
    voIndexedFaceSet square{0, 3, 0};
    float period[3] = {1, 1, 1};
};

TEST_F(GeometryActionsGL, drawFillsAFaceSet)
{
    voGeometryActions::draw(&square, Format::V3F);
    EXPECT_EQ(screen.middle().first, 1.0f);
    expectNoError();
}

TEST_F(GeometryActionsGL, drawFillsTheFacesOfTetrahedra)
{
    voGeometryActions::draw(&tetras, GL_FILL, Format::V3F);
    EXPECT_EQ(screen.middle().first, 1.0f);
    expectNoError();
}

TEST_F(GeometryActionsGL, outlinesOfBricksLeaveTheMiddleFree)
{
    const auto volume = SquareScreen::constantVolume(255);
    voGeometryActions::draw(SquareScreen::brickOf(*volume));
    voGeometryActions::draw(volume->getCurrentBrickSet());
    EXPECT_EQ(screen.middle().first, 0.0f);
    const std::vector<float> pixels = screen.context->readFloats();
    EXPECT_GT(*std::max_element(pixels.begin(), pixels.end()), 0.0f);
    expectNoError();
}

TEST_F(GeometryActionsGL, drawRefusesIndicesThatPointNowhere)
{
    for (const int entry : {-1, 5, INT_MAX, INT_MIN}) {
        (*square.getIndices())[0] = entry;
        voGeometryActions::draw(&square, Format::V3F);
        expectBadValue("groups");
    }
    (*square.getIndices())[0] = 4;
    for (const int vertex : {-1, 4, INT_MAX}) {
        (*square.getIndices())[4] = vertex;
        voGeometryActions::draw(&square, Format::V3F);
        expectBadValue("vertex");
    }
    tetras.getIndices()->getDataPtr()[3] = 99;
    voGeometryActions::draw(&tetras, Format::V3F);
    expectBadValue("vertex 99");
    EXPECT_EQ(screen.middle().first, 0.0f);
}

TEST_F(GeometryActionsGL, drawUtilityDrawsTheVolume)
{
    const auto volume = SquareScreen::constantVolume(255);
    voDrawActionCache cache(&tetras, volume.get(), 64, voSamplingModeScope::VIEWPORT_ALIGNED, 3, 250000);
    cache.setThreshold(2);
    for (voDrawActionCache* each : {static_cast<voDrawActionCache*>(NULL), &cache, &cache}) {
        screen.gl().Clear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(drawUtility(*volume, each), 0);
        EXPECT_NEAR(screen.middle().first, 1.0f, 1e-4f);
    }
    expectNoError();
}

/// A volume turned inside out along the view: the bricks with the low voxels are nearest, whatever their
/// boxes say.
TEST_F(GeometryActionsGL, drawUtilityDrawsDeformedBricksInTheOrderOfTheirSamples)
{
    const auto volume = byteVolume(4, 2, voInterpolationTypeScope::_3D, 0);
    ASSERT_EQ(volume->getCurrentBrickSet()->getBrickCount(), 8);
    voBrickSetIterator next(volume->getCurrentBrickSet());
    for (voBrick* brick; (brick = next());) {
        float origin[3], size[3];
        brick->getBrickSizes(origin, size);
        std::memset(voAppearanceActions::dataAlloc(brick), origin[2] < 2 ? 51 : 204, 8);
    }
    float records[8][6];
    for (int i = 0; i < 8; ++i) {
        const float* p = &cube.vertices[i][0];
        const float record[6] = {p[0], p[1], 4 - p[2], p[0], p[1], p[2]};
        std::copy_n(record, 6, records[i]);
    }
    voIndexedTetraSet insideOut(records[0], 8, 6, cube.indices, 20);
    screen.gl().Enable(GL_BLEND);
    screen.gl().BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    EXPECT_EQ(voGeometryActions::drawUtility(&insideOut, Format::T3F_V3F, volume.get(), NULL, Space::OBJECT,
                                             period, Decorations::NONE),
              0);
    float expected = 0;
    for (const float value : {0.8f, 0.8f, 0.2f, 0.2f})
        expected = value * value + (1 - value) * expected;
    EXPECT_NEAR(screen.middle().first, expected, 1e-4f);
    screen.gl().Disable(GL_BLEND);
    expectNoError();
}

TEST_F(GeometryActionsGL, drawUtilityChoosesTheStackMostAcrossTheView)
{
    auto volume = byteVolume(4, 4, voInterpolationTypeScope::_2D, 0);
    voAppearanceActions::dataAlloc(volume->getCurrentBrickSet());
    std::memset(volume->getCurrentBrickSet()->getBrick(2)->getDataPtr(), 255, 16);
    EXPECT_EQ(voAppearanceActions::volumeMakeTransposed(volume.get()), 0);
    screen.gl().MatrixMode(GL_MODELVIEW);
    screen.gl().LoadMatrixd((translation(2, 2, 0) * rotation(90, 1, 0, 0) * translation(-2, -2, -2)).m);
    EXPECT_EQ(drawUtility(*volume), 0);
    EXPECT_EQ(volume->getCurrentBrickSet()->getOrientation(), voPlaneOrientationScope::XZ);
    screen.gl().LoadIdentity();
    EXPECT_EQ(drawUtility(*volume), 0);
    EXPECT_EQ(volume->getCurrentBrickSet()->getOrientation(), voPlaneOrientationScope::XY);
    expectNoError();
}

TEST_F(GeometryActionsGL, cacheWithoutABoundStaysWithinMemory)
{
    const auto volume = SquareScreen::constantVolume(255);
    voDrawActionCache cache(&tetras, volume.get(), INT_MAX, voSamplingModeScope::DEFAULT, 3, INT_MAX);
    EXPECT_EQ(drawUtility(*volume, &cache), 0);
    EXPECT_GT(screen.middle().first, 0.5f);
    period[2] = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(drawUtility(*volume, &cache), 0);
    expectNoError();
}

TEST_F(GeometryActionsGL, cacheFollowsRewrittenTetrahedra)
{
    const auto volume = SquareScreen::constantVolume(255);
    voDrawActionCache cache(&tetras, volume.get(), 64, voSamplingModeScope::DEFAULT, 3, 250000);
    EXPECT_EQ(drawUtility(*volume, &cache), 0);
    EXPECT_GT(screen.middle().first, 0.5f);
    for (int i = 0; i < 8; ++i)
        (*tetras.getVertexData())[i][0] += 100;
    screen.gl().Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(drawUtility(*volume, &cache), 0);
    EXPECT_EQ(screen.middle().first, 0.0f);
    expectNoError();
}

/// drawUtility says at level 2 whether polygons were made.
TEST_F(GeometryActionsGL, shellsAreMadeAnewWhereTheEyeMoves)
{
    const auto volume = SquareScreen::constantVolume(255);
    voDrawActionCache cache(&tetras, volume.get(), 64, voSamplingModeScope::SPHERICAL, 3, 0);
    std::ostringstream said;
    const auto isNew = [&](double x, double z, double degrees) {
        screen.gl().MatrixMode(GL_PROJECTION);
        screen.gl().LoadIdentity();
        screen.gl().Frustum(-1, 1, -1, 1, 1, 100);
        screen.gl().MatrixMode(GL_MODELVIEW);
        screen.gl().LoadIdentity();
        screen.gl().Rotated(degrees, 0, 1, 0);
        screen.gl().Translated(-2 - x, -2, -2 - z); // the eye z before the middle of the cube
        said.str("");
        voError::setDebugStream(said);
        voError::setDebugLevel(2);
        EXPECT_EQ(drawUtility(*volume, &cache), 0);
        voError::setDebugLevel(0);
        voError::setDebugStream(stderr);
        EXPECT_NE(said.str().find("polygons"), std::string::npos);
        return said.str().find("new polygons") != std::string::npos;
    };
    EXPECT_TRUE(isNew(0, 10, 0));
    EXPECT_FALSE(isNew(0, 10, 0));
    EXPECT_TRUE(isNew(0.1, 10, 0));
    cache.setThreshold(5); // tan(5 degrees) * 10 = 0.87
    EXPECT_FALSE(isNew(0, 10, 0));
    EXPECT_TRUE(isNew(1, 10, 0));
    EXPECT_FALSE(isNew(1, 10.8, 0));
    EXPECT_TRUE(isNew(1, 11.2, 0));
    EXPECT_FALSE(isNew(1, 11.2, 4));
    EXPECT_TRUE(isNew(1, 11.2, 6));
    EXPECT_TRUE(isNew(0, 0.5, 0)); // inside: no way to move
    EXPECT_TRUE(isNew(0, 0.6, 0));
    expectNoError();
}

TEST_F(GeometryActionsGL, cacheOutlivesWhatItWasMadeFor)
{
    auto volume = SquareScreen::constantVolume(255);
    auto mine = std::make_unique<voIndexedTetraSet>(&cube.vertices[0][0], 8, 3, cube.indices, 20);
    voDrawActionCache cache(mine.get(), volume.get(), 64, voSamplingModeScope::DEFAULT, 3, 250000);
    EXPECT_EQ(drawUtility(*volume, &cache), 0);
    mine.reset();
    volume = SquareScreen::constantVolume(255);
    screen.gl().Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(drawUtility(*volume, &cache), 0);
    EXPECT_NEAR(screen.middle().first, 1.0f, 1e-4f);
    expectNoError();
}

TEST_F(GeometryActionsGL, drawUtilityRefusesWhatCannotBeDrawn)
{
    const auto empty = byteVolume(4, 4);
    EXPECT_NE(drawUtility(*empty), 0);
    expectBadValue("no voxels");
    const auto volume = SquareScreen::constantVolume(255);
    for (const float bad : {0.0f, -1.0f, std::nanf(""), HUGE_VALF}) {
        period[2] = bad;
        EXPECT_NE(drawUtility(*volume), 0);
        expectBadValue("samplingPeriod[2]");
    }
    period[2] = 1;
    EXPECT_NE(voGeometryActions::drawUtility(&tetras, Format::USER_V3F, volume.get(), NULL, Space::OBJECT,
                                             period, Decorations::NONE),
              0);
    expectUnsupported("USER_V3F");
    EXPECT_NE(voGeometryActions::drawUtility(&tetras, Format::V3F, volume.get(), NULL,
                                             static_cast<voSamplingSpace>(12), period, Decorations::NONE),
              0);
    expectBadEnum();
    const GLdouble zero[16] = {};
    screen.gl().LoadMatrixd(zero);
    EXPECT_NE(drawUtility(*volume), 0);
    expectBadValue("singular");
    const auto stacks = byteVolume(4, 4, voInterpolationTypeScope::_2D);
    EXPECT_NE(drawUtility(*stacks), 0);
    expectBadValue("singular");
    EXPECT_EQ(screen.middle().first, 0.0f);
}

/// A framebuffer without images, then one whose image has no size.
TEST_F(GeometryActionsGL, drawUtilityRefusesAnIncompleteFramebuffer)
{
    const auto volume = SquareScreen::constantVolume(255);
    const GladGLContext& gl = screen.gl();
    GLint screenBuffer = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &screenBuffer);
    GLuint framebuffer = 0, image = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.GenRenderbuffers(1, &image);
    for (const bool attached : {false, true})
        for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST}) {
            voState::setEngine(engine);
            gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
            gl.BindRenderbuffer(GL_RENDERBUFFER, image);
            if (attached)
                gl.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, image);
            EXPECT_NE(voGeometryActions::drawUtility(&tetras, Format::V3F, volume.get(), NULL, Space::OBJECT,
                                                     period, Decorations::ALL),
                      0);
            expectBadValue("framebuffer");
            EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
            EXPECT_EQ(voState::getFramesDrawn(voEngineScope::AUTOMATIC), 0);
            gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(screenBuffer));
        }
    EXPECT_EQ(drawUtility(*volume), 0);
    EXPECT_EQ(voState::getFramesDrawn(voEngineScope::AUTOMATIC), 1);
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.DeleteRenderbuffers(1, &image);
}

TEST_F(GeometryActionsGL, verticesThatAreNoNumbersDoNoHarm)
{
    const auto volume = SquareScreen::constantVolume(255);
    for (const float value :
         {std::nanf(""), HUGE_VALF, -HUGE_VALF, std::numeric_limits<float>::max(), -1e30f}) {
        cube.vertices[5][1] = value;
        drawUtility(*volume);
        voGeometryActions::draw(&tetras, Format::V3F);
        voError::getErrorNumber();
        voError::getErrorString();
    }
}

TEST_F(GeometryActionsGL, decorationsAreDrawn)
{
    const auto volume = SquareScreen::constantVolume(0);
    screen.gl().Enable(GL_BLEND); // the empty volume leaves what is behind it
    screen.gl().BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const int decoration : {Decorations::BRICKS, Decorations::TETRAS, Decorations::ALL}) {
        screen.gl().Clear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(voGeometryActions::drawUtility(&tetras, Format::V3F, volume.get(), NULL, Space::OBJECT,
                                                 period, static_cast<voDecorationFlags>(decoration)),
                  0);
        const std::vector<float> pixels = screen.context->readFloats();
        EXPECT_GT(*std::max_element(pixels.begin(), pixels.end()), 0.0f) << decoration;
    }
    expectNoError();
}

} // namespace
