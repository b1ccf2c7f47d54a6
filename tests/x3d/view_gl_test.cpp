// Views of scenes in OpenGL: both engines draw the picture that is there without it.

#include "offscreen/offscreen.h" // before headers that name OpenGL's own

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include <vo/Error.h>
#include <vo/x3d/View.h>

namespace {

constexpr const char* kScene =
    "<X3D profile='Full' version='4.0'><Scene><Background skyColor='0 0 0.25' transparency='0'/>"
    "<Viewpoint position='0 0 6'/><Transform rotation='1 1 0 0.6'><VolumeData dimensions='2 2 2'>"
    "<PixelTexture3D containerField='voxels' image='1 2 2 2 10 60 120 180 240 30 90 150'/>"
    "</VolumeData></Transform></Scene></X3D>";

constexpr const char* kGradientScene =
    "<X3D profile='Full' version='3.0'><Scene><NavigationInfo headlight='false'/>"
    "<Viewpoint position='0 0 6'/><Transform rotation='1 1 0 0.6'><VolumeData dimensions='2 2 2'>"
    "<PixelTexture3D containerField='voxels' image='1 2 2 2 10 60 120 180 240 30 90 150'/>"
    "<BoundaryEnhancementVolumeStyle gradientColor='1 0.3 0 0.8'/>"
    "</VolumeData></Transform></Scene></X3D>";

/// With planes `sampling` apart, 0 for the usual distance.
void expectOnePicture(const char* text, double sampling)
{
    constexpr int kWidth = 60, kHeight = 50;
    std::string whyNot;
    const auto context = vo::openOffscreen({.width = kWidth, .height = kHeight, .floatColor = true}, &whyNot);
    ASSERT_TRUE(context) << whyNot;
    voX3DScene scene;
    ASSERT_TRUE(scene.readText(text, std::char_traits<char>::length(text), "test"));
    voX3DView view(scene);
    view.setSize(kWidth, kHeight);
    view.setSampling(sampling);
    std::vector<float> expected(4 * kWidth * kHeight);
    ASSERT_TRUE(view.picture(expected.data()));
    for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST, voEngineScope::AUTOMATIC}) {
        context->clear();
        const GladGLContext& gl = context->gl();
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(0, 0, kWidth, kHeight);
        gl.Viewport(1, 2, 3, 4);
        ASSERT_TRUE(view.draw(engine)) << voError::getErrorString();
        GLint viewport[4];
        gl.GetIntegerv(GL_VIEWPORT, viewport);
        EXPECT_EQ(viewport[3], 4) << "state is given back";
        EXPECT_EQ(gl.GetError(), GLenum(GL_NO_ERROR));
        const auto found = context->readFloats();
        // Few planes lie apart at the box's outline. Of many, edges at 1/256 of a pixel move all at a time,
        // in at most 2 pixels of 1000.
        const double alike = engine == voEngineScope::CAST ? 1e-6 : 0.01;
        int others = 0;
        for (std::size_t i = 0; i < found.size(); ++i)
            others += double(std::abs(found[i] - expected[i])) >= alike;
        EXPECT_LE(others, sampling > 0 || engine == voEngineScope::CAST ? 0 : 4 * kWidth * kHeight / 500)
            << engine;
    }
    view.releaseDrawing();
    EXPECT_GT(expected[4 * (25 * kWidth + 30)], 0.1f) << "the volume is seen";
}

TEST(ViewGl, bothEnginesDrawThePictureThatIsThereWithoutOpenGl)
{
    for (const double sampling : {0.0, 16.0})
        expectOnePicture(kScene, sampling);
}

TEST(ViewGl, bothEnginesMixInGradientColors)
{
    for (const double sampling : {0.0, 16.0})
        expectOnePicture(kGradientScene, sampling);
}

/// Opaque things of the program stand before the sky, and hide what is behind them.
TEST(ViewGl, theSkyIsBehindWhatTheProgramHasDrawn)
{
    const auto context = vo::openOffscreen({.width = 8, .height = 8, .floatColor = true});
    ASSERT_TRUE(context);
    const GladGLContext& gl = context->gl();
    voX3DScene scene;
    ASSERT_TRUE(scene.readText(kScene, std::char_traits<char>::length(kScene), "test"));
    voX3DView view(scene);
    view.setSize(8, 8);
    for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST}) {
        context->clear();
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(0, 0, 4, 8);
        gl.ClearColor(1, 0.5, 0, 1);
        gl.ClearDepth(0.0);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.Disable(GL_SCISSOR_TEST);
        gl.ClearDepth(1.0);
        ASSERT_TRUE(view.draw(engine)) << voError::getErrorString();
        const auto found = context->readFloats();
        EXPECT_FLOAT_EQ(found[0], 1.0f) << engine;
        EXPECT_FLOAT_EQ(found[1], 0.5f) << engine;
        EXPECT_FLOAT_EQ(found[4 * 7 + 1], 0.0f) << engine;
        EXPECT_FLOAT_EQ(found[4 * 7 + 2], 0.25f) << engine << ": the sky";
        EXPECT_GT(found[4 * (4 * 8 + 4)], 0.1f) << engine << ": the volume";
        EXPECT_FLOAT_EQ(found[4 * (4 * 8 + 3)], 1.0f) << engine << ": the volume is hidden";
    }
    view.releaseDrawing();
}

TEST(ViewGl, thinSheetsAreAsOpaqueAsTheirThickness)
{
    constexpr int kSize = 9;
    constexpr double kThick = 1e-4, kOpacity = 20.0 / 255.0;
    const auto context = vo::openOffscreen({.width = kSize, .height = kSize, .floatColor = true});
    ASSERT_TRUE(context);
    for (const double degrees : {0.0, 45.0, 85.0}) {
        const std::string text = "<X3D profile='Full' version='4.0'><Scene><Viewpoint position='0 0 1'/>"
                                 "<Transform rotation='1 0 0 " +
                                 std::to_string(degrees * std::acos(-1.0) / 180) +
                                 "'><VolumeData dimensions='1 1 0.0001'><PixelTexture3D image='1 1 1 1 20'/>"
                                 "</VolumeData></Transform></Scene></X3D>";
        voX3DScene scene;
        ASSERT_TRUE(scene.readText(text.data(), text.size(), "test"));
        voX3DView view(scene);
        view.setSize(kSize, kSize);
        context->clear();
        ASSERT_TRUE(view.draw(voEngineScope::SLICES)) << voError::getErrorString();
        EXPECT_EQ(scene.getMessageCount(), 0);
        const double length = kThick / std::cos(degrees * std::acos(-1.0) / 180);
        const double expected = kOpacity * (1 - std::pow(1 - kOpacity, length / kThick));
        // A plane more or less of at least 25, and edges of polygons at steps of 1/256 of a pixel.
        const auto found = context->readFloats();
        EXPECT_NEAR(double(found[4 * (4 * kSize + 4)]), expected, expected / 12) << degrees;
    }
}

TEST(ViewGl, projectionsOfThinSheetsFarAwayAreThere)
{
    constexpr int kSize = 16;
    const auto context = vo::openOffscreen({.width = kSize, .height = kSize, .floatColor = true});
    ASSERT_TRUE(context);
    const std::string text = "<X3D profile='Full' version='4.0'><Scene><Viewpoint position='0 0 3000' "
                             "fieldOfView='0.0002'/><Transform rotation='1 1 0 0.8'>"
                             "<VolumeData dimensions='1 1 0.001'><PixelTexture3D image='1 1 1 1 128'/>"
                             "<ProjectionVolumeStyle/></VolumeData></Transform></Scene></X3D>";
    voX3DScene scene;
    ASSERT_TRUE(scene.readText(text.data(), text.size(), "test"));
    voX3DView view(scene);
    view.setSize(kSize, kSize);
    std::vector<float> cast(4 * kSize * kSize);
    ASSERT_TRUE(view.picture(cast.data()));
    context->clear();
    ASSERT_TRUE(view.draw(voEngineScope::SLICES)) << voError::getErrorString();
    const auto found = context->readFloats();
    for (std::size_t i = 0; i < cast.size(); i += 4) {
        EXPECT_NEAR(cast[i], 128.0 / 255, 1e-5) << i;
        EXPECT_NEAR(found[i], 128.0 / 255, 1e-5) << i;
    }
}

/// Its depths differ by less than numbers tell apart in 1 of 512 of them.
TEST(ViewGl, translucentShapesMayBeSmallForTheirDistance)
{
    const auto context = vo::openOffscreen({.width = 8, .height = 8, .floatColor = true});
    ASSERT_TRUE(context);
    const std::string text = "<X3D profile='Full' version='4.0'><Scene><Viewpoint position='0 0 5'/>"
                             "<Transform translation='0 0 -1e14'><Shape><Appearance>"
                             "<Material transparency='0.5'/></Appearance><Sphere/></Shape></Transform>"
                             "</Scene></X3D>";
    voX3DScene scene;
    ASSERT_TRUE(scene.readText(text.data(), text.size(), "test"));
    voX3DView view(scene);
    view.setSize(8, 8);
    context->clear();
    EXPECT_TRUE(view.draw(voEngineScope::SLICES)) << voError::getErrorString();
}

TEST(ViewGl, anotherContextIsRefusedUntilDrawingIsReleased)
{
    const auto first = vo::openOffscreen({.width = 8, .height = 8}),
               second = vo::openOffscreen({.width = 8, .height = 8});
    ASSERT_TRUE(first && second);
    voX3DScene scene;
    ASSERT_TRUE(scene.readText(kScene, std::char_traits<char>::length(kScene), "test"));
    voX3DView view(scene);
    view.setSize(8, 8);
    ASSERT_TRUE(first->makeCurrent());
    EXPECT_TRUE(view.draw());
    ASSERT_TRUE(second->makeCurrent());
    EXPECT_FALSE(view.draw());
    EXPECT_EQ(voError::getErrorNumber(), voError::UNSUPPORTED);
    ASSERT_TRUE(first->makeCurrent());
    view.releaseDrawing();
    ASSERT_TRUE(second->makeCurrent());
    EXPECT_TRUE(view.draw());
    view.releaseDrawing();
}

} // namespace
