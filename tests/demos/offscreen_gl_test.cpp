#include "offscreen/offscreen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace {

using vo::OffscreenBackEnd;
using vo::OffscreenContext;
using vo::OffscreenProfile;
using vo::OffscreenRequest;
using vo::openOffscreen;

std::unique_ptr<OffscreenContext> open(const OffscreenRequest& request)
{
    std::string whyNot;
    auto context = openOffscreen(request, &whyNot);
    EXPECT_TRUE(context) << whyNot;
    return context;
}

void clearTo(const OffscreenContext& context, float red, float green, float blue)
{
    context.gl().ClearColor(red, green, blue, 1);
    context.gl().Clear(GL_COLOR_BUFFER_BIT);
}

TEST(Offscreen, environmentChoosesTheBackEnd)
{
    const char* wanted = std::getenv("VO_OFFSCREEN");
    if (!wanted) GTEST_SKIP() << "VO_OFFSCREEN is not set";
    const auto context = open({});
    ASSERT_TRUE(context);
    EXPECT_EQ(context->backEnd(),
              std::string(wanted) == "egl" ? OffscreenBackEnd::Egl : OffscreenBackEnd::Osmesa);
}

TEST(Offscreen, clearedFramebufferHoldsTheColour)
{
    const auto context = open({.width = 7, .height = 5});
    ASSERT_TRUE(context);
    clearTo(*context, 1, 0.2f, 0);
    const auto pixels = context->readBytes();
    ASSERT_EQ(pixels.size(), 7u * 5 * 4);
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        ASSERT_EQ(pixels[i], 255);
        ASSERT_EQ(pixels[i + 1], 51);
        ASSERT_EQ(pixels[i + 2], 0);
    }
}

TEST(Offscreen, floatFramebufferKeepsFloats)
{
    const auto context = open({.width = 3, .height = 2, .floatColor = true});
    ASSERT_TRUE(context);
    clearTo(*context, 0.1234567f, -2, 3e10f);
    const auto pixels = context->readFloats();
    EXPECT_EQ(pixels[0], 0.1234567f);
    EXPECT_EQ(pixels[1], -2);
    EXPECT_EQ(pixels[2], 3e10f);
}

TEST(Offscreen, compatibilityContextDrawsLegacyTriangles)
{
    const auto context = open({.width = 8, .height = 8});
    ASSERT_TRUE(context);
    const GladGLContext& gl = context->gl();
    clearTo(*context, 0, 0, 0);
    gl.Color3d(0, 1, 0);
    gl.Begin(GL_QUADS);
    gl.Vertex2d(-1, -1);
    gl.Vertex2d(0, -1);
    gl.Vertex2d(0, 1);
    gl.Vertex2d(-1, 1);
    gl.End();
    EXPECT_EQ(gl.GetError(), GLenum(GL_NO_ERROR));
    const auto pixels = context->readBytes();
    EXPECT_EQ(pixels[1], 255) << "left half drawn";
    EXPECT_EQ(pixels[4 * 7 + 1], 0) << "right half left alone";
}

TEST(Offscreen, coreContextHasNoFixedFunctions)
{
    const auto context = open({.profile = OffscreenProfile::Core});
    ASSERT_TRUE(context);
    GLint mask = 0;
    context->gl().GetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    EXPECT_TRUE(mask & GL_CONTEXT_CORE_PROFILE_BIT);
    context->gl().Enable(GL_LIGHTING);
    EXPECT_EQ(context->gl().GetError(), GLenum(GL_INVALID_ENUM));
}

TEST(Offscreen, stencilAndDepthAreThere)
{
    const auto context = open({});
    ASSERT_TRUE(context);
    GLint bits = 0;
    context->gl().GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT,
                                                      GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, &bits);
    EXPECT_EQ(bits, 8);
    context->gl().GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                                      GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
    EXPECT_EQ(bits, 24);
}

TEST(Offscreen, contextsOfOneThreadDoNotMix)
{
    const auto red = open({.width = 4, .height = 4});
    const auto green = open({.width = 4, .height = 4});
    const auto blue = open({.profile = OffscreenProfile::Core, .width = 4, .height = 4});
    ASSERT_TRUE(red && green && blue);
    const std::pair<OffscreenContext*, int> all[] = {{red.get(), 0}, {green.get(), 1}, {blue.get(), 2}};
    for (const auto& [context, channel] : all) {
        ASSERT_TRUE(context->makeCurrent());
        clearTo(*context, channel == 0, channel == 1, channel == 2);
    }
    for (const auto& [context, channel] : all) {
        ASSERT_TRUE(context->makeCurrent());
        const auto pixels = context->readBytes();
        for (int i = 0; i < 3; ++i)
            EXPECT_EQ(pixels[std::size_t(i)], i == channel ? 255 : 0);
    }
}

TEST(Offscreen, bothBackEndsInOneThread)
{
    const auto egl = openOffscreen({.backEnd = OffscreenBackEnd::Egl, .width = 4, .height = 4});
    if (!egl) GTEST_SKIP() << "no EGL on this machine";
    clearTo(*egl, 1, 0, 0);
    const auto osmesa = openOffscreen({.backEnd = OffscreenBackEnd::Osmesa, .width = 4, .height = 4});
    if (!osmesa) GTEST_SKIP() << "no OSMesa on this machine";
    clearTo(*osmesa, 0, 1, 0);
    ASSERT_TRUE(egl->makeCurrent());
    EXPECT_EQ(egl->readBytes()[0], 255);
    ASSERT_TRUE(osmesa->makeCurrent());
    EXPECT_EQ(osmesa->readBytes()[0], 0);
    EXPECT_EQ(osmesa->readBytes()[1], 255);
}

TEST(Offscreen, impossibleSizesAreRefusedWithAText)
{
    for (const int side : {0, -1, 1 << 20}) {
        std::string whyNot;
        EXPECT_FALSE(openOffscreen({.width = side, .height = 4}, &whyNot));
        EXPECT_NE(whyNot.find(std::to_string(side) + " x 4"), std::string::npos) << whyNot;
    }
}

TEST(Offscreen, impossibleVersionIsRefusedWithAText)
{
    std::string whyNot;
    EXPECT_FALSE(openOffscreen({.majorVersion = 9, .minorVersion = 9}, &whyNot));
    EXPECT_NE(whyNot, "");
}

TEST(Offscreen, unknownWordInTheEnvironmentIsRefusedWithAText)
{
    const char* value = std::getenv("VO_OFFSCREEN");
    const std::string before = value ? value : "";
    setenv("VO_OFFSCREEN", "glut", 1);
    std::string whyNot;
    EXPECT_FALSE(openOffscreen({}, &whyNot));
    EXPECT_NE(whyNot.find("'glut'"), std::string::npos) << whyNot;
    value ? setenv("VO_OFFSCREEN", before.c_str(), 1) : unsetenv("VO_OFFSCREEN");
}

} // namespace
