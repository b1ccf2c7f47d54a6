// Several contexts, tables that wait for one, and what is sent to each.

#include "draw/draw_scene.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstring>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;

Scene sceneOf(const Field& field)
{
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = 48;
    scene.view = orthographicView({20, 30}, field.size, 48, 48);
    scene.color = {1, 1, 1, 0.2};
    return scene;
}

DrawOptions utility(int bricks = 1)
{
    DrawOptions options;
    options.utility = true;
    options.bricks = bricks;
    return options;
}

TEST(Contexts, twoInOneThreadDoNotMix)
{
    const Field ball = quantised(ballField({20, 20, 20})), cubes = quantised(cubesField({20, 20, 20}, 10));
    auto first = openFor(sceneOf(ball), OffscreenProfile::Compatibility);
    const std::vector<float> ballAlone = drawnPicture(*first, sceneOf(ball), utility());
    auto second = openFor(sceneOf(cubes), OffscreenProfile::Core);
    const std::vector<float> cubesAlone = drawnPicture(*second, sceneOf(cubes), utility());
    ASSERT_NE(ballAlone, cubesAlone);

    first->makeCurrent();
    SceneDrawing one(*first, sceneOf(ball), utility());
    second->makeCurrent();
    SceneDrawing two(*second, sceneOf(cubes), utility());
    for (int frame = 0; frame < 3; ++frame) {
        first->makeCurrent();
        one.draw();
        EXPECT_EQ(first->readFloats(), ballAlone);
        second->makeCurrent();
        two.draw();
        EXPECT_EQ(second->readFloats(), cubesAlone);
    }
}

TEST(Contexts, oneVolumeIsDrawnInTwo)
{
    const Field ball = quantised(ballField({20, 20, 20}));
    const Scene scene = sceneOf(ball);
    auto first = openFor(scene, OffscreenProfile::Core);
    SceneDrawing drawing(*first, scene, utility(2));
    drawing.draw();
    const std::vector<float> picture = first->readFloats();
    auto second = openFor(scene, OffscreenProfile::Core);
    drawing.drawIn(*second);
    EXPECT_EQ(second->readFloats(), picture);
    first->makeCurrent();
    drawing.draw();
    EXPECT_EQ(first->readFloats(), picture);
}

TEST(Contexts, volumeDeletedElsewhereLeavesNoTexture)
{
    const Field ball = quantised(ballField({20, 20, 20}));
    auto first = openFor(sceneOf(ball), OffscreenProfile::Core);
    auto drawing = std::make_unique<SceneDrawing>(*first, sceneOf(ball), utility());
    drawing->draw();
    GLint name = 0;
    voAppearanceActions::textureBind(drawing->volume().getCurrentBrickSet()->getBrick(0));
    first->gl().GetIntegerv(GL_TEXTURE_BINDING_3D, &name);
    first->gl().BindTexture(GL_TEXTURE_3D, 0);
    ASSERT_TRUE(first->gl().IsTexture(static_cast<GLuint>(name)));
    auto second = openFor(sceneOf(ball), OffscreenProfile::Core);
    drawing.reset();
    first->makeCurrent();
    EXPECT_TRUE(first->gl().IsTexture(static_cast<GLuint>(name))) << "not touched from the other context";
    voAppearanceActions::textureDisable(voInterpolationTypeScope::_3D);
    EXPECT_FALSE(first->gl().IsTexture(static_cast<GLuint>(name))) << "gone with the next call in its own";
    EXPECT_EQ(first->gl().GetError(), GLenum{GL_NO_ERROR});
}

TEST(Contexts, deadContextIsForgottenWithItsTextures)
{
    const Field ball = quantised(ballField({20, 20, 20}));
    std::vector<float> first;
    for (int i = 0; i < 4; ++i) {
        auto context = openFor(sceneOf(ball), OffscreenProfile::Compatibility);
        const std::vector<float> picture = drawnPicture(*context, sceneOf(ball), utility());
        if (first.empty()) first = picture;
        EXPECT_EQ(picture, first) << "context " << i;
    }
}

TEST(Contexts, withoutOneTexturesAnswerUnsupported)
{
    voTexture3D texture(voInternalFormatTypeScope::DEFAULT, voExternalFormatTypeScope::DEFAULT,
                        voDataTypeScope::DEFAULT);
    voAppearanceActions::dataAlloc(&texture);
    EXPECT_NE(voAppearanceActions::textureBind(&texture), 0);
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::UNSUPPORTED);
    EXPECT_NE(std::strstr(voError::getErrorString(), "no OpenGL context"), nullptr);
}

/// The guide's turns by OpenGL itself, which keeps them in single precision.
Matrix turnedByOpenGl(const GladGLContext& gl, const Angles& angles, const Field& field)
{
    const auto [x, y, z] =
        std::array<double, 3>{double(field.size.x), double(field.size.y), double(field.size.z)};
    Matrix model;
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Rotated(-angles.latitude - 90, 1, 0, 0);
    gl.Rotated(-angles.longitude, 0, 0, 1);
    gl.Translated(-x / 2, -y / 2, -z / 2);
    gl.GetDoublev(GL_MODELVIEW_MATRIX, model.data());
    return model;
}

TEST(Contexts, headOnViewsAddUpOneSampleAVoxelInBothProfiles)
{
    const Field field = constantField({40, 24, 64}, 1.0);
    Scene scene = sceneOf(field);
    scene.compositing = Compositing::sum;
    scene.color = {0.01, 0.01, 0.01, 0.01};
    for (const auto engine : {voEngineScope::SLICES, voEngineScope::CAST})
        for (const OffscreenProfile profile : {OffscreenProfile::Compatibility, OffscreenProfile::Core}) {
            auto context = openFor(scene, profile);
            DrawOptions options = utility(2);
            options.engine = engine;
            SceneDrawing drawing(*context, scene, options);
            for (const auto& [angles, voxels] : {std::pair(Angles{0, 0}, 24),
                                                 {Angles{0, 90}, 40},
                                                 {Angles{0, 180}, 24},
                                                 {Angles{0, 270}, 40},
                                                 {Angles{90, 0}, 64},
                                                 {Angles{-90, 90}, 64},
                                                 {Angles{180, 90}, 40}}) {
                View view = orthographicView(angles, field.size, 48, 48);
                if (profile == OffscreenProfile::Compatibility)
                    view.model = turnedByOpenGl(context->gl(), angles, field);
                drawing.draw(view);
                const std::vector<float> picture = context->readFloats();
                EXPECT_GT(picture[4 * (24 * 48 + 24)], 0.0f);
                for (std::size_t i = 0; i < picture.size(); i += 4) {
                    if (picture[i] == 0.0f) continue;
                    ASSERT_NEAR(double(picture[i]), 0.01 * voxels, 1e-5)
                        << angles.latitude << " " << angles.longitude;
                }
            }
        }
}

// ---- Tables

std::vector<float> flatTable(float red, float alpha)
{
    return {red, 0, 0, alpha, red, 0, 0, alpha};
}

TEST(Tables, enabledWithoutContextWorkAtTheNextDraw)
{
    const Field field = constantField({8, 8, 8}, 0.5);
    std::vector<float> entries = flatTable(1, 1);
    voLookupTablePost table(voInternalFormatTypeScope::RGBA8_EXT, 2, voExternalFormatTypeScope::RGBA,
                            voDataTypeScope::FLOAT, entries.data());
    table.load();
    table.enable();
    auto context = openFor(sceneOf(field), OffscreenProfile::Core);
    const std::vector<float> picture = drawnPicture(*context, sceneOf(field), utility());
    const float* centre = picture.data() + 4 * (24 * 48 + 24);
    EXPECT_GT(centre[0], 0.5f);
    EXPECT_EQ(centre[1], 0.0f);
    table.disable();
    const std::vector<float> plain = drawnPicture(*context, sceneOf(field), utility());
    EXPECT_GT(plain[4 * (24 * 48 + 24) + 1], 0.1f);
}

TEST(Tables, anotherOneReplacesAndTheLastOneDeletedSwitchesOff)
{
    const Field field = constantField({8, 8, 8}, 0.5);
    auto context = openFor(sceneOf(field), OffscreenProfile::Compatibility);
    SceneDrawing drawing(*context, sceneOf(field), utility());
    const auto centreRed = [&] {
        drawing.draw();
        return context->readFloats()[4 * (24 * 48 + 24)];
    };
    const float plain = centreRed();
    std::vector<float> none = flatTable(0, 1), full = flatTable(1, 1);
    voLookupTablePost black(GL_RGBA8, 2, GL_RGBA, GL_FLOAT, none.data());
    black.load();
    black.enable();
    EXPECT_EQ(centreRed(), 0.0f);
    {
        voLookupTablePost red(GL_RGBA8, 2, GL_RGBA, GL_FLOAT, full.data());
        red.load();
        red.enable();
        EXPECT_GT(centreRed(), 0.5f);
    }
    EXPECT_EQ(centreRed(), plain);
}

TEST(Tables, loadTakesNewEntriesForTheNextFrame)
{
    const Field field = constantField({8, 8, 8}, 0.5);
    auto context = openFor(sceneOf(field), OffscreenProfile::Core);
    SceneDrawing drawing(*context, sceneOf(field), utility());
    for (const bool pre : {false, true}) {
        std::vector<float> entries = flatTable(0, 1);
        std::unique_ptr<voLookupTable> table;
        if (pre)
            table = std::make_unique<voLookupTablePre>(GL_RGBA8, 2, GL_RGBA, GL_FLOAT, entries.data());
        else
            table = std::make_unique<voLookupTablePost>(GL_RGBA8, 2, GL_RGBA, GL_FLOAT, entries.data());
        table->load();
        table->enable();
        drawing.draw();
        EXPECT_EQ(context->readFloats()[4 * (24 * 48 + 24)], 0.0f);
        entries[0] = entries[4] = 1;
        drawing.draw();
        EXPECT_EQ(context->readFloats()[4 * (24 * 48 + 24)], 0.0f) << "not loaded yet";
        table->load();
        drawing.draw();
        EXPECT_GT(context->readFloats()[4 * (24 * 48 + 24)], 0.5f);
    }
}

// ---- What is sent

std::atomic<int> textureImages{0};
std::atomic<int> textureParts{0};
vo::OffscreenContext* countedContext = nullptr;
PFNGLTEXIMAGE3DPROC realTexImage3D = nullptr;
PFNGLTEXSUBIMAGE3DPROC realTexSubImage3D = nullptr;

void countTexImage3D(GLenum target, GLint level, GLint internalFormat, GLsizei w, GLsizei h, GLsizei d,
                     GLint border, GLenum format, GLenum type, const void* pixels)
{
    ++textureImages;
    realTexImage3D(target, level, internalFormat, w, h, d, border, format, type, pixels);
}

void countTexSubImage3D(GLenum target, GLint level, GLint x, GLint y, GLint z, GLsizei w, GLsizei h,
                        GLsizei d, GLenum format, GLenum type, const void* pixels)
{
    ++textureParts;
    realTexSubImage3D(target, level, x, y, z, w, h, d, format, type, pixels);
}

voState::Function countingGetProcAddress(const char* name)
{
    const GLADapiproc function = countedContext->getProcAddress(name);
    if (!std::strcmp(name, "glTexImage3D")) {
        realTexImage3D = reinterpret_cast<PFNGLTEXIMAGE3DPROC>(function);
        return reinterpret_cast<voState::Function>(&countTexImage3D);
    }
    if (!std::strcmp(name, "glTexSubImage3D")) {
        realTexSubImage3D = reinterpret_cast<PFNGLTEXSUBIMAGE3DPROC>(function);
        return reinterpret_cast<voState::Function>(&countTexSubImage3D);
    }
    return reinterpret_cast<voState::Function>(function);
}

TEST(Downloads, eachBrickIsSentOnceAndNothingInLaterFrames)
{
    const Field field = quantised(ballField({24, 24, 24}));
    auto context = openFor(sceneOf(field), OffscreenProfile::Compatibility);
    countedContext = context.get();
    voState::setGetProcAddress(countingGetProcAddress);
    for (const bool useUtility : {true, false}) {
        textureImages = textureParts = 0;
        SceneDrawing drawing(*context, sceneOf(field), {.bricks = 3, .utility = useUtility});
        drawing.draw();
        EXPECT_EQ(textureImages, 27);
        EXPECT_EQ(textureParts, 27);
        for (const Angles& angles : fixedViews())
            drawing.draw(orthographicView(angles, field.size, 48, 48));
        EXPECT_EQ(textureImages, 27) << "36 more views send nothing";
        drawing.volume().setDirtyFlag(VO_TRUE);
        drawing.draw();
        EXPECT_EQ(textureImages, 54) << "the dirty flag sends all again";
    }
    voState::setGetProcAddress(nullptr);
}

// ---- 8 bits

TEST(EightBits, constantOpacityDrawnStraightIntoBytesKeepsItsDecibels)
{
    for (const auto& [opacity, decibels] : {std::pair{0.05, 28.0}, {0.2, 40.0}}) {
        const Field field = quantised(axisRampField({64, 64, 64}, 0));
        Scene scene = sceneOf(field);
        scene.classification = Classification::postInterpolation;
        scene.color = {1, 1, 1, 1};
        const auto alpha = static_cast<float>(opacity);
        scene.table = {0, 0, 0, alpha, 1, 1, 1, alpha};
        auto context = openFor(scene, OffscreenProfile::Compatibility, false);
        SceneDrawing drawing(*context, scene, utility());
        drawing.draw();
        const Comparison comparison = compare(fromBytes(context->readBytes()), referencePicture(scene));
        EXPECT_GE(comparison.psnrMasked, decibels) << comparison.summary();
    }
}

TEST(Bricks, manyGiveThePictureOfOne)
{
    Field field = quantised(noiseField({40, 36, 44}, 5));
    for (const Angles& angles : {Angles{0, 0}, Angles{33, 70}, Angles{-50, 200}}) {
        Scene scene = sceneOf(field);
        scene.width = scene.height = 200;
        scene.overlap = 1;
        scene.view = orthographicView(angles, field.size, 200, 200);
        auto context = openFor(scene, OffscreenProfile::Core);
        const std::vector<float> one = drawnPicture(*context, scene, utility(1));
        for (const int bricks : {2, 3, 5}) {
            const std::vector<float> many = drawnPicture(*context, scene, utility(bricks));
            const Comparison comparison = compareDrawn(many, one);
            EXPECT_LE(comparison.fractionOff, 0.0005) << bricks << " a side: " << comparison.summary();
        }
    }
}

} // namespace
