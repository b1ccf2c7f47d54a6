// Where OpenGL runs on the processor, the samples of a sparse volume's slices are taken a pixel at once.

#include "draw/sparse_slices.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;

constexpr int kPixels = 144;
/// A sample too many or too few would be a thousandth at least.
constexpr double kRounding = 1e-4;

class MarchedSlicesGL : public SparseSlices
{
protected:
    /// The ball lies across the seams of two bricks a side.
    MarchedSlicesGL() : SparseSlices({22, 18, 20}, kPixels) {}

    bool isSoftware() const { return context->description().find("llvmpipe") != std::string::npos; }

    /// Whether a frame's samples were taken a pixel at once.
    bool marches(const std::function<void()>& draw)
    {
        const std::string messages = messagesOf(draw);
        EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
        return messages.find("all of a pixel at once") != std::string::npos;
    }
    bool marches()
    {
        return marches([&] { drawing->draw(scene.view); });
    }

    /// drawUtility alone, in the state that is set, over a background.
    void drawOver() const
    {
        gl().ClearColor(0.1f, 0.3f, 0.2f, 0.4f);
        gl().Clear(GL_COLOR_BUFFER_BIT);
        float period[3] = {1, 1, 1};
        voGeometryActions::drawUtility(&drawing->tetras(), voInterleavedArrayTypeScope::V3F,
                                       &drawing->volume(), nullptr, voSamplingSpaceScope::OBJECT, period,
                                       voDecorationFlagsScope::NONE);
    }

    /// Slice by slice, as where fragments are counted.
    void slice(const std::function<void()>& draw)
    {
        GLuint query = 0;
        gl().GenQueries(1, &query);
        gl().BeginQuery(GL_SAMPLES_PASSED, query);
        EXPECT_FALSE(marches(draw));
        gl().EndQuery(GL_SAMPLES_PASSED);
        gl().DeleteQueries(1, &query);
    }

    /// The largest difference of any channel between slices at once and one by one.
    double differenceFromSlices(const std::function<void()>& draw)
    {
        EXPECT_EQ(marches(draw), isSoftware());
        const std::vector<float> marched = context->readFloats();
        slice(draw);
        const std::vector<float> sliced = context->readFloats();
        EXPECT_GT(*std::ranges::max_element(sliced), 0.1f) << "the picture shows something";
        return largestDifference(marched, sliced);
    }
    double differenceFromSlices()
    {
        return differenceFromSlices([&] { drawing->draw(scene.view); });
    }

    void expectTruth()
    {
        EXPECT_EQ(marches(), isSoftware());
        const Comparison comparison = compare(context->readFloats(), referencePicture(scene));
        EXPECT_LE(comparison.largestMasked, 5e-4) << comparison.summary();
        EXPECT_LE(comparison.fractionOff, 0.001) << comparison.summary();
        EXPECT_GT(comparison.opaquePixels, 500u);
    }

    /// Head-on planes lie where voxels are centred.
    void expectTruthHeadOn()
    {
        for (const Angles& angles :
             {Angles{0, 0}, Angles{0, 90}, Angles{0, 180}, Angles{90, 0}, Angles{-90, 0}}) {
            SCOPED_TRACE(testing::Message() << angles.latitude << " " << angles.longitude);
            scene.view = orthographicView(angles, field.size, kPixels, kPixels);
            expectTruth();
        }
    }
};

TEST_F(MarchedSlicesGL, areTheSamplesOfTheSlicesInDoublePrecision)
{
    for (const int bricks : {1, 2})
        for (const OffscreenProfile profile : {OffscreenProfile::Compatibility, OffscreenProfile::Core}) {
            options.bricks = bricks;
            open(profile);
            for (const Angles& angles : {Angles{20, 30}, Angles{0, 0}, Angles{90, 0}, Angles{-70, 200}}) {
                SCOPED_TRACE(testing::Message() << bricks << " bricks a side, from " << angles.latitude << " "
                                                << angles.longitude);
                scene.view = orthographicView(angles, field.size, kPixels, kPixels);
                expectTruth();
                scene.view = perspectiveView(angles, field.size, kPixels, kPixels, 50);
                expectTruth();
            }
        }
}

TEST_F(MarchedSlicesGL, planesInSeamsShowOnce)
{
    // Seams lie where voxels are centred, too.
    options.bricks = 2;
    open();
    expectTruthHeadOn();
}

TEST_F(MarchedSlicesGL, planesInOuterFacesShow)
{
    for (int z = 0; z < 15; ++z)
        for (int y = 0; y < 15; ++y)
            for (int x = 0; x < 15; ++x) {
                field.at(x, y, z) = 0.6f;
                field.at(field.size.x - 1 - x, field.size.y - 1 - y, field.size.z - 1 - z) = 0.8f;
            }
    field = quantised(field);
    open();
    expectTruthHeadOn();
}

TEST_F(MarchedSlicesGL, classifyAsSlicesDo)
{
    scene.classification = Classification::preInterpolation;
    open();
    expectTruth();
    scene.classification = Classification::none;
    scene.color = {1, 0.5, 0.25, 0.2};
    open();
    expectTruth();
    const Field colors = combined({field, field, constantField(field.size, 0.5), field});
    scene.volume = &colors;
    open();
    expectTruth();
    scene.classification = Classification::postInterpolation;
    open();
    expectTruth();
}

TEST_F(MarchedSlicesGL, oneMayLookFromInsideAndBeyondTheNearPlane)
{
    open();
    const glm::dvec3 middle = 0.5 * glm::dvec3(field.size.x, field.size.y, field.size.z);
    scene.view.projection = perspective(70, 1.0, 4.0, 70.0);
    for (const double away : {0.0, 10.0, 30.0, 60.0}) {
        SCOPED_TRACE(away);
        scene.view.model = multiply(multiply(translation(0, 0, -away), rotation(40, 1, 2, 0)),
                                    translation(-middle.x, -middle.y, -middle.z));
        EXPECT_LE(differenceFromSlices(), kRounding);
    }
    scene.view = orthographicView({30, 20}, field.size, kPixels, kPixels);
    scene.view.model = multiply(translation(0, 0, 60), scene.view.model);
    EXPECT_LE(differenceFromSlices(), kRounding);
}

TEST_F(MarchedSlicesGL, opacitiesPerLengthAreThoseOfSlices)
{
    open();
    voState::setUnitLength(0.7);
    EXPECT_LE(differenceFromSlices(), kRounding);
    scene.view = perspectiveView({20, 30}, field.size, kPixels, kPixels, 70);
    EXPECT_LE(differenceFromSlices(), kRounding);
    voState::setUnitLength(0.0);
}

TEST_F(MarchedSlicesGL, joinWhatIsThereAsSlicesDo)
{
    open();
    drawing->draw(scene.view);
    const auto draw = [&] { drawOver(); };
    gl().BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    EXPECT_LE(differenceFromSlices(draw), kRounding);
    gl().BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    EXPECT_LE(differenceFromSlices(draw), kRounding);
    gl().BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    EXPECT_LE(differenceFromSlices(draw), kRounding);
    gl().BlendFunc(GL_SRC_ALPHA, GL_ONE);
    EXPECT_LE(differenceFromSlices(draw), 4 * kRounding) << "sums are larger";
}

TEST_F(MarchedSlicesGL, clipPlanesScissorsAndMasksCount)
{
    open();
    drawing->draw(scene.view);
    const auto draw = [&] { drawOver(); };
    const GLdouble left[4] = {-1, 0.2, 0, 3}, below[4] = {0.1, -1, 0.3, 55};
    gl().ClipPlane(GL_CLIP_PLANE0, left);
    gl().ClipPlane(GL_CLIP_PLANE2, below);
    gl().Enable(GL_CLIP_PLANE0);
    gl().Enable(GL_CLIP_PLANE2);
    EXPECT_LE(differenceFromSlices(draw), kRounding);
    EXPECT_TRUE(gl().IsEnabled(GL_CLIP_PLANE0) && !gl().IsEnabled(GL_CLIP_PLANE1));
    gl().Disable(GL_CLIP_PLANE0);
    gl().Disable(GL_CLIP_PLANE2);
    gl().Viewport(17, 9, kPixels - 30, kPixels - 11);
    EXPECT_LE(differenceFromSlices(draw), kRounding);
    gl().Enable(GL_SCISSOR_TEST);
    gl().Scissor(50, 60, 41, 33);
    gl().ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    EXPECT_LE(differenceFromSlices(draw), kRounding);
}

TEST_F(MarchedSlicesGL, newTablesAndVoxelsShow)
{
    open();
    EXPECT_LE(differenceFromSlices(), kRounding);
    std::vector<float> entries = tableFrom(120);
    voLookupTablePost table(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, 256,
                            GLenum{voExternalFormatTypeScope::RGBA}, GLenum{voDataTypeScope::FLOAT},
                            entries.data());
    table.load();
    table.enable();
    EXPECT_LE(differenceFromSlices(), kRounding);
    std::ranges::copy(tableFrom(1), entries.begin());
    table.load();
    EXPECT_LE(differenceFromSlices(), kRounding);
    voBrick* brick = drawing->volume().getCurrentBrickSet()->getBrick(0);
    auto* voxels = static_cast<unsigned char*>(brick->getDataPtr());
    for (int z = 44; z < 54; ++z)
        for (int y = 4; y < 14; ++y)
            std::fill_n(voxels + (z * field.size.y + y) * field.size.x + 4, 10,
                        static_cast<unsigned char>(255));
    const std::vector<float> before = context->readFloats();
    voAppearanceActions::dataScaleRange(brick, 0.0f, 255.0f);
    EXPECT_LE(differenceFromSlices(), kRounding);
    EXPECT_NE(context->readFloats(), before);
}

TEST_F(MarchedSlicesGL, volumesMayAlternate)
{
    open();
    const Field otherField = quantised(withEmptyBorder(ballField({70, 70, 70}), 22));
    Scene otherScene = scene;
    otherScene.volume = &otherField;
    SceneDrawing other(*context, otherScene, options);
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_LE(differenceFromSlices(), kRounding);
        EXPECT_LE(differenceFromSlices([&] { other.draw(scene.view); }), kRounding);
    }
}

TEST_F(MarchedSlicesGL, happenOnlyWhereNothingElseWouldSee)
{
    open();
    drawing->draw(scene.view);
    const auto draw = [&] { drawOver(); };
    EXPECT_EQ(marches(draw), isSoftware());
    gl().Enable(GL_DEPTH_TEST);
    gl().DepthMask(GL_FALSE);
    EXPECT_FALSE(marches(draw));
    gl().Disable(GL_DEPTH_TEST);
    gl().BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    EXPECT_FALSE(marches(draw)) << "a clear fragment has a colour";
    gl().BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl().PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    EXPECT_FALSE(marches(draw));
    gl().PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    EXPECT_EQ(marches(draw), isSoftware());

    options.explicitTexCoords = true;
    open();
    EXPECT_FALSE(marches());
    options.explicitTexCoords = false;
    scene.compositing = Compositing::max;
    open();
    EXPECT_FALSE(marches());
    scene.compositing = Compositing::over;
    scene.table = tableFrom(0);
    open();
    EXPECT_FALSE(marches()) << "every voxel shows";
    scene.table = tableFrom(1);
    options.bricks = 8;
    open();
    EXPECT_FALSE(marches()) << "bricks so small cost more than they save";
}

TEST_F(MarchedSlicesGL, giveEveryTextureUnitBack)
{
    open();
    drawing->draw(scene.view);
    GLuint textures[4] = {}, samplers[4] = {};
    gl().GenTextures(4, textures);
    gl().GenSamplers(4, samplers);
    for (GLuint unit = 0; unit < 4; ++unit) {
        gl().ActiveTexture(GL_TEXTURE0 + unit);
        gl().BindTexture(GL_TEXTURE_3D, textures[unit]);
        gl().BindSampler(unit, samplers[unit]);
    }
    gl().ActiveTexture(GL_TEXTURE0);
    EXPECT_EQ(marches([&] { drawOver(); }), isSoftware());
    GLint active = 0, source = 0, destination = 0;
    gl().GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    EXPECT_EQ(active, GL_TEXTURE0);
    gl().GetIntegerv(GL_BLEND_SRC_RGB, &source);
    gl().GetIntegerv(GL_BLEND_DST_RGB, &destination);
    EXPECT_EQ(source, GL_SRC_ALPHA);
    EXPECT_EQ(destination, GL_ONE_MINUS_SRC_ALPHA);
    for (GLuint unit = 0; unit < 4; ++unit) {
        GLint texture = 0, sampler = 0;
        gl().ActiveTexture(GL_TEXTURE0 + unit);
        gl().GetIntegerv(GL_TEXTURE_BINDING_3D, &texture);
        gl().GetIntegerv(GL_SAMPLER_BINDING, &sampler);
        EXPECT_EQ(texture, static_cast<GLint>(textures[unit])) << unit;
        EXPECT_EQ(sampler, static_cast<GLint>(samplers[unit])) << unit;
    }
}

} // namespace
