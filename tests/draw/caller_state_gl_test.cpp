// What the caller set in OpenGL is honoured, and given back.

#include "draw/draw_scene.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;

constexpr int kPixels = 64;

/// A cube of 16 voxels a side that fills the picture, seen along z with x to the right and y up.
Scene cubeScene(const Field& field)
{
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = kPixels;
    scene.view.projection = ortho(0, field.size.x, 0, field.size.y, -field.size.z - 1.0, 1.0);
    scene.color = {1, 1, 1, 0.2};
    return scene;
}

class CallerState : public testing::TestWithParam<bool>
{
protected:
    void SetUp() override
    {
        scene_ = cubeScene(field_);
        context_ = openFor(scene_, OffscreenProfile::Compatibility);
    }

    DrawOptions options() const
    {
        DrawOptions o;
        o.utility = GetParam();
        o.bricks = 2;
        return o;
    }

    const GladGLContext& gl() const { return context_->gl(); }
    std::vector<float> draw() { return drawnPicture(*context_, scene_, options()); }
    static const float* pixel(const std::vector<float>& picture, int x, int y)
    {
        return picture.data() + 4 * (static_cast<std::size_t>(y) * kPixels + static_cast<std::size_t>(x));
    }

    Field field_ = quantised(rampField({16, 16, 16}, {0.02, 0.03, 0.01}, 0.05));
    Scene scene_;
    std::unique_ptr<vo::OffscreenContext> context_;
};

INSTANTIATE_TEST_SUITE_P(Both, CallerState, testing::Values(false, true),
                         [](const auto& test) { return test.param ? "drawUtility" : "ownLoops"; });

TEST_P(CallerState, clipPlaneCutsTheVolume)
{
    const std::vector<float> whole = draw();
    gl().MatrixMode(GL_MODELVIEW);
    gl().LoadIdentity();
    const GLdouble plane[4] = {-1, 0, 0, 8};
    gl().ClipPlane(GL_CLIP_PLANE2, plane);
    gl().Enable(GL_CLIP_PLANE2);
    const std::vector<float> cut = draw();
    for (int y = 8; y < kPixels - 8; y += 7)
        for (int x = 4; x < kPixels - 4; x += 3) {
            const float expected = x < kPixels / 2 ? pixel(whole, x, y)[0] : 0.0f;
            EXPECT_NEAR(pixel(cut, x, y)[0], expected, 1e-6) << x << " " << y;
        }
    EXPECT_GT(pixel(whole, 50, 50)[0], 0.1f);
}

TEST_P(CallerState, alphaTestDropsFragments)
{
    gl().Enable(GL_ALPHA_TEST);
    gl().AlphaFunc(GL_GREATER, 0.9f);
    const std::vector<float> none = draw();
    gl().Disable(GL_ALPHA_TEST);
    const std::vector<float> all = draw();
    EXPECT_EQ(pixel(none, 32, 32)[0], 0.0f);
    EXPECT_GT(pixel(all, 32, 32)[0], 0.1f);
}

TEST_P(CallerState, opaqueSurfaceInFrontHidesTheVolume)
{
    SceneDrawing drawing(*context_, scene_, options());
    gl().Enable(GL_DEPTH_TEST);
    drawing.draw();
    const std::vector<float> open = context_->readFloats();
    // The draw clears; so the surface is a depth value that the clear leaves behind.
    gl().ClearDepth(0.01);
    drawing.draw();
    const std::vector<float> hidden = context_->readFloats();
    EXPECT_GT(pixel(open, 32, 32)[0], 0.1f);
    EXPECT_EQ(pixel(hidden, 32, 32)[0], 0.0f);
}

TEST_P(CallerState, stencilMasksTheVolume)
{
    gl().ClearStencil(1);
    gl().Clear(GL_STENCIL_BUFFER_BIT);
    gl().Enable(GL_STENCIL_TEST);
    gl().StencilFunc(GL_EQUAL, 0, 255);
    EXPECT_EQ(pixel(draw(), 32, 32)[0], 0.0f);
    gl().StencilFunc(GL_EQUAL, 1, 255);
    EXPECT_GT(pixel(draw(), 32, 32)[0], 0.1f);
}

TEST_P(CallerState, textureMatrixShiftsTheVoxels)
{
    // One voxel to the right of the ramp: every sample inside grows by the slope.
    DrawOptions o = options();
    o.bricks = 1;
    scene_.color = {1, 1, 1, 1};
    scene_.compositing = Compositing::max;
    SceneDrawing drawing(*context_, scene_, o);
    drawing.draw();
    const float before = pixel(context_->readFloats(), 32, 32)[0];
    gl().MatrixMode(GL_TEXTURE);
    gl().LoadIdentity();
    gl().Translatef(1.0f / 16, 0, 0);
    drawing.draw();
    const float after = pixel(context_->readFloats(), 32, 32)[0];
    EXPECT_NEAR(after - before, field_.at(9, 8, 8) - field_.at(8, 8, 8), 0.5 / 255);
    EXPECT_GT(after, before);
}

TEST_P(CallerState, pixelStoreOfTheCallerDoesNotDisturbDownloads)
{
    const std::vector<float> plain = draw();
    GLuint buffer = 0;
    gl().GenBuffers(1, &buffer);
    gl().BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    gl().BufferData(GL_PIXEL_UNPACK_BUFFER, 64, nullptr, GL_STATIC_DRAW);
    gl().PixelStorei(GL_UNPACK_ROW_LENGTH, 77);
    gl().PixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
    gl().PixelTransferf(GL_RED_SCALE, 0.5f);
    const std::vector<float> disturbed = draw();
    voFloatTarget target(8, 8);
    float pixels[4 * 8 * 8] = {};
    target.begin();
    gl().ClearColor(0.5f, 0.5f, 0.5f, 0.5f);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    target.readPixels(pixels);
    target.end();
    EXPECT_EQ(pixels[0], 0.5f) << "nor reading back";
    // What the off-screen context read went through the scale.
    for (std::size_t i = 0; i < plain.size(); i += 4) {
        ASSERT_EQ(disturbed[i], 0.5f * plain[i]);
        ASSERT_EQ(disturbed[i + 1], plain[i + 1]);
    }
    GLint kept = 0;
    gl().GetIntegerv(GL_UNPACK_ROW_LENGTH, &kept);
    EXPECT_EQ(kept, 77);
    gl().GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &kept);
    EXPECT_EQ(static_cast<GLuint>(kept), buffer);
    float scale = 0;
    gl().GetFloatv(GL_RED_SCALE, &scale);
    EXPECT_EQ(scale, 0.5f);
}

/// What the library could disturb, by name.
std::map<std::string, GLint> stateOf(const GladGLContext& gl)
{
    const std::pair<const char*, GLenum> names[] = {
        {"program", GL_CURRENT_PROGRAM},
        {"vertex array", GL_VERTEX_ARRAY_BINDING},
        {"array buffer", GL_ARRAY_BUFFER_BINDING},
        {"element buffer", GL_ELEMENT_ARRAY_BUFFER_BINDING},
        {"copy read buffer", GL_COPY_READ_BUFFER_BINDING},
        {"active texture", GL_ACTIVE_TEXTURE},
        {"matrix mode", GL_MATRIX_MODE},
        {"blend", GL_BLEND},
        {"blend equation", GL_BLEND_EQUATION_RGB},
        {"depth test", GL_DEPTH_TEST},
        {"depth mask", GL_DEPTH_WRITEMASK},
        {"polygon mode", GL_POLYGON_MODE},
        {"draw framebuffer", GL_DRAW_FRAMEBUFFER_BINDING},
        {"read framebuffer", GL_READ_FRAMEBUFFER_BINDING},
        {"renderbuffer", GL_RENDERBUFFER_BINDING},
        {"unpack alignment", GL_UNPACK_ALIGNMENT},
        {"texture 3D", GL_TEXTURE_3D},
        {"texture 2D", GL_TEXTURE_2D},
        {"texgen", GL_TEXTURE_GEN_S},
        {"attributes", GL_ATTRIB_STACK_DEPTH},
        {"viewport", GL_VIEWPORT},
    };
    std::map<std::string, GLint> state;
    for (const auto& [text, name] : names) {
        GLint values[4] = {};
        gl.GetIntegerv(name, values);
        state[text] = values[0];
    }
    for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
        GLint active = 0, value = 0;
        gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
        gl.ActiveTexture(unit);
        for (const GLenum name :
             {GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D, GL_SAMPLER_BINDING}) {
            gl.GetIntegerv(name, &value);
            state[std::to_string(unit) + " " + std::to_string(name)] = value;
        }
        gl.ActiveTexture(static_cast<GLenum>(active));
    }
    float color[4];
    gl.GetFloatv(GL_CURRENT_COLOR, color);
    state["colour"] = static_cast<GLint>(1000 * color[3]);
    return state;
}

/// A caller's own program, arrays, textures and sampler, none of them 0.
void setObjectsOfTheCaller(const GladGLContext& gl)
{
    const char* text = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }";
    const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER), program = gl.CreateProgram();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    gl.LinkProgram(program);
    gl.UseProgram(program);
    GLuint buffer = 0, array = 0, sampler = 0, textures[3];
    gl.GenVertexArrays(1, &array);
    gl.BindVertexArray(array);
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.GenSamplers(1, &sampler);
    gl.BindSampler(0, sampler);
    gl.GenTextures(3, textures);
    gl.BindTexture(GL_TEXTURE_2D, textures[0]);
    gl.BindTexture(GL_TEXTURE_3D, textures[1]);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_2D, textures[2]);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.MatrixMode(GL_TEXTURE);
}

TEST_P(CallerState, isGivenBackAfterAWholeFrame)
{
    scene_.classification = Classification::postInterpolation;
    scene_.table = {0, 0, 0, 0, 1, 1, 1, 1};
    SceneDrawing drawing(*context_, scene_, options());
    drawing.draw();
    setObjectsOfTheCaller(gl());
    const auto before = stateOf(gl());
    float period[3] = {1, 1, 1};
    voGeometryActions::drawUtility(&drawing.tetras(), voInterleavedArrayTypeScope::V3F, &drawing.volume(),
                                   nullptr, voSamplingSpaceScope::OBJECT, period,
                                   voDecorationFlagsScope::ALL);
    voAppearanceActions::volumeOptimize(&drawing.volume(), voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
    drawing.volume().setDirtyFlag(VO_TRUE);
    voAppearanceActions::volumeOptimize(&drawing.volume(), voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
    voFloatTarget target(8, 8);
    target.begin();
    target.end();
    target.show(0, 0);
    EXPECT_EQ(before, stateOf(gl()));
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
}

// ---- Single polygons

class PolygonState : public testing::Test
{
protected:
    void SetUp() override
    {
        context_ = openFor(cubeScene(field_), OffscreenProfile::Compatibility);
        gl().MatrixMode(GL_PROJECTION);
        gl().LoadMatrixd(ortho(0, 16, 0, 16, -17, 1).data());
        gl().MatrixMode(GL_MODELVIEW);
        gl().LoadIdentity();
        clear();
    }

    const GladGLContext& gl() const { return context_->gl(); }
    void clear()
    {
        gl().ClearColor(0, 0, 0, 0);
        gl().Clear(GL_COLOR_BUFFER_BIT);
    }
    std::vector<float> pixel(int x, int y) const
    {
        const std::vector<float> all = context_->readFloats();
        const auto at = all.begin() + 4 * (y * kPixels + x);
        return {at, at + 4};
    }
    int litPixels() const
    {
        const std::vector<float> all = context_->readFloats();
        int lit = 0;
        for (std::size_t i = 0; i < all.size(); i += 4)
            lit += all[i] > 0.5f;
        return lit;
    }

    Field field_ = quantised(rampField({16, 16, 16}, {0.02, 0.03, 0.01}, 0.05));
    std::unique_ptr<vo::OffscreenContext> context_;
};

float square[12] = {4, 4, 8, 12, 4, 8, 12, 12, 8, 4, 12, 8};

TEST_F(PolygonState, lineModeOfTheCallerDrawsOutlinesAlone)
{
    voIndexedFaceSet faces(8, 3, 16);
    faces.appendPoly(square, 4);
    gl().Color4f(1, 1, 1, 1);
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::V3F);
    EXPECT_EQ(litPixels(), 32 * 32);
    clear();
    gl().PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::V3F);
    EXPECT_GE(litPixels(), 4 * 31);
    EXPECT_LE(litPixels(), 4 * 34);
    EXPECT_EQ(pixel(32, 32)[0], 0.0f) << "no diagonal";
}

TEST_F(PolygonState, modeArgumentHoldsForTheCall)
{
    voIndexedFaceSet faces(8, 3, 16);
    faces.appendPoly(square, 4);
    gl().Color4f(1, 1, 1, 1);
    voGeometryActions::draw(&faces, GL_LINE, voInterleavedArrayTypeScope::V3F);
    EXPECT_LE(litPixels(), 4 * 34);
    gl().PolygonMode(GL_FRONT, GL_LINE);
    gl().PolygonMode(GL_BACK, GL_POINT);
    voGeometryActions::draw(&faces, GL_FILL, voInterleavedArrayTypeScope::V3F);
    EXPECT_GE(litPixels(), 32 * 32);
    GLint modes[2];
    gl().GetIntegerv(GL_POLYGON_MODE, modes);
    EXPECT_EQ(modes[0], GL_LINE);
    EXPECT_EQ(modes[1], GL_POINT);
}

TEST_F(PolygonState, vertexColoursAreInterpolatedOrFlat)
{
    float colored[4 * 7] = {1, 0, 0, 1, 4,  4,  8, 0, 1, 0, 1, 12, 4,  8,
                            0, 1, 0, 1, 12, 12, 8, 1, 0, 0, 1, 4,  12, 8};
    voIndexedFaceSet faces(8, 7, 16);
    faces.appendPoly(colored, 4);
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::C4F_V3F);
    // The pixel's centre is at x = 32.5 / 4 of [4, 12].
    EXPECT_NEAR(pixel(32, 32)[1], (32.5 / 4 - 4) / 8, 1e-5);
    gl().ShadeModel(GL_FLAT);
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::C4F_V3F);
    EXPECT_EQ(pixel(46, 32), (std::vector<float>{1, 0, 0, 1})) << "the first vertex's colour";
}

TEST_F(PolygonState, colourOfThreeFloatsIsOpaque)
{
    float colored[4 * 6] = {0.25f, 0.5f, 1, 4,  4,  8, 0.25f, 0.5f, 1, 12, 4,  8,
                            0.25f, 0.5f, 1, 12, 12, 8, 0.25f, 0.5f, 1, 4,  12, 8};
    voIndexedFaceSet faces(8, 6, 16);
    faces.appendPoly(colored, 4);
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::C3F_V3F);
    EXPECT_EQ(pixel(32, 32), (std::vector<float>{0.25f, 0.5f, 1, 1}));
}

TEST_F(PolygonState, selectionModeNamesWhatIsHit)
{
    float vertices[12] = {4, 4, 2, 12, 4, 2, 8, 12, 2, 8, 8, 9};
    int indices[4] = {0, 1, 2, 3};
    voIndexedTetraSet tetra(vertices, 4, 3, indices, 4);
    GLuint hits[64] = {};
    gl().SelectBuffer(64, hits);
    gl().RenderMode(GL_SELECT);
    gl().InitNames();
    gl().PushName(42);
    voGeometryActions::draw(&tetra, voInterleavedArrayTypeScope::V3F);
    gl().LoadName(43);
    gl().MatrixMode(GL_MODELVIEW);
    gl().LoadMatrixd(translation(100, 0, 0).data());
    voGeometryActions::draw(&tetra, voInterleavedArrayTypeScope::V3F);
    const GLint count = gl().RenderMode(GL_RENDER);
    ASSERT_EQ(count, 1);
    EXPECT_EQ(hits[0], 1u);
    EXPECT_EQ(hits[3], 42u);
}

TEST_F(PolygonState, polygonsOfTheApplicationAreTextured)
{
    SceneDrawing drawing(*context_, cubeScene(field_), {});
    voBrick* brick = drawing.volume().getCurrentBrickSet()->getBrick(0);
    voAppearanceActions::textureEnable(voInterpolationTypeScope::_3D);
    voAppearanceActions::texgenEnable();
    voAppearanceActions::texgenSetEquation(brick);
    voAppearanceActions::textureBind(brick);
    gl().Disable(GL_BLEND);
    gl().Color4f(1, 1, 1, 1);
    clear();
    gl().Begin(GL_QUADS);
    for (int corner = 0; corner < 4; ++corner)
        gl().Vertex3fv(square + 3 * corner);
    gl().End();
    const std::vector<float> theirs = context_->readFloats();
    clear();
    voIndexedFaceSet faces(8, 3, 16);
    faces.appendPoly(square, 4);
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::V3F);
    const std::vector<float> ours = context_->readFloats();
    const Comparison comparison = compareDrawn(theirs, ours);
    EXPECT_LE(comparison.largestAll, 1e-5) << comparison.summary();
    const auto at = static_cast<std::size_t>(4 * (32 * kPixels + 32));
    const double expected = 0.05 + 0.02 * (32.5 / 4) + 0.03 * (32.5 / 4) + 0.01 * 8;
    EXPECT_NEAR(theirs[at], expected, 1.0 / 255);
    EXPECT_NEAR(theirs[at + 3], expected, 1.0 / 255) << "intensity answers alpha, too";
}

TEST_F(PolygonState, replaceLeavesTheColourOut)
{
    SceneDrawing drawing(*context_, cubeScene(field_), {});
    voBrick* brick = drawing.volume().getCurrentBrickSet()->getBrick(0);
    voAppearanceActions::textureEnable(voInterpolationTypeScope::_3D);
    voAppearanceActions::texgenEnable();
    voAppearanceActions::texgenSetEquation(brick);
    voAppearanceActions::textureBind(brick);
    gl().Disable(GL_BLEND);
    gl().Color4f(0.5f, 0, 0, 1);
    voIndexedFaceSet faces(8, 3, 16);
    faces.appendPoly(square, 4);
    clear();
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::V3F);
    const std::vector<float> modulated = pixel(32, 32);
    gl().TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    clear();
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::V3F);
    const std::vector<float> replaced = pixel(32, 32);
    EXPECT_GT(replaced[1], 0.3f);
    EXPECT_EQ(modulated[1], 0.0f);
    EXPECT_NEAR(modulated[0], 0.5f * replaced[0], 1e-6);
}

} // namespace
