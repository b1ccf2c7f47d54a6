// The CPU engine draws what slices draw, in the states in which it can, and in no others.

#include "draw/draw_scene.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;

constexpr int kPixels = 128;

struct EngineCase
{
    const char* name;
    Classification classification = Classification::postInterpolation;
    Compositing compositing = Compositing::over;
    int bricks = 1;
    double degrees = 0.0; ///< perspective
    int stackAxis = -1;
    int channels = 1;
    bool ramp = false;      ///< a table that never falls
    bool texCoords = false; ///< records with voxel coordinates: polygons are filled
    SamplingPlanes planes = SamplingPlanes::viewportAligned;
};

std::ostream& operator<<(std::ostream& stream, const EngineCase& c)
{
    return stream << c.name;
}

/// A smooth ball with noise, so that a voxel out of place shows.
Field testField(int channels)
{
    const vo::VoxelSize size{36, 30, 33};
    Field field = ballField(size);
    const Field noise = noiseField(size, 5);
    for (std::size_t i = 0; i < field.values.size(); ++i)
        field.values[i] *= 0.8f + 0.2f * noise.values[i];
    field = quantised(withEmptyBorder(field, 1));
    if (channels == 1) return field;
    return combined({field, quantised(axisRampField(size, 0)), quantised(axisRampField(size, 2)), field});
}

std::vector<float> colorTable()
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        const double ground = std::min(1.0, 5.0 * v); // no edge where the volume ends
        for (const double c :
             {ground * (0.5 + 0.5 * std::sin(6.0 * v)), v * v, ground * (1.0 - v), v < 0.2 ? 0.0 : 0.1 * v})
            table.push_back(static_cast<float>(c));
    }
    return table;
}

std::vector<float> rampTable()
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i)
        for (const double slope : {1.0, 1.7, 0.6, 1.2})
            table.push_back(static_cast<float>(std::clamp(slope * (i / 255.0 - 0.2), 0.0, 1.0)));
    return table;
}

Scene sceneOf(const EngineCase& c, const Field& field, const Angles& angles)
{
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = kPixels;
    scene.view = c.degrees > 0 ? perspectiveView(angles, field.size, kPixels, kPixels, c.degrees)
                               : orthographicView(angles, field.size, kPixels, kPixels);
    scene.overlap = 1;
    scene.planes = c.planes;
    scene.stackAxis = c.stackAxis;
    scene.classification = c.classification;
    if (c.classification != Classification::none) scene.table = c.ramp ? rampTable() : colorTable();
    scene.compositing = c.compositing;
    if (c.compositing == Compositing::min) {
        scene.background = {1, 1, 1};
        return scene;
    }
    if (c.compositing == Compositing::premultiplied) scene.color = {0.1, 0.08, 0.12, 1};
    if (c.compositing == Compositing::sum || c.classification == Classification::none)
        scene.color = {0.02, 0.015, 0.01, 0.1};
    return scene;
}

DrawOptions optionsOf(const EngineCase& c, voEngine engine)
{
    DrawOptions options;
    options.utility = true;
    options.engine = engine;
    options.bricks = c.bricks;
    options.explicitTexCoords = c.texCoords;
    return options;
}

class EnginePictures : public testing::TestWithParam<EngineCase>
{
};

TEST_P(EnginePictures, agree)
{
    const EngineCase& c = GetParam();
    Field field = testField(c.channels);
    if (c.compositing == Compositing::min) // no edge where the volume ends
        for (float& value : field.values)
            value = 1.0f - value;
    for (const OffscreenProfile profile : {OffscreenProfile::Compatibility, OffscreenProfile::Core})
        for (const Angles& angles : {Angles{0, 0}, Angles{20, 30}, Angles{-65, 250}}) {
            const Scene scene = sceneOf(c, field, angles);
            const auto context = openFor(scene, profile);
            const auto slices = drawnPicture(*context, scene, optionsOf(c, voEngineScope::SLICES));
            ASSERT_EQ(voState::getFramesDrawn(voEngineScope::SLICES), 1);
            const auto cast = drawnPicture(*context, scene, optionsOf(c, voEngineScope::CAST));
            EXPECT_EQ(voState::getFramesDrawn(voEngineScope::CAST), 1) << "slices were drawn instead";
            const Comparison comparison = compareDrawn(cast, slices);
            EXPECT_GE(comparison.psnrAll, 50.0) << angles.latitude << " " << comparison.summary();
            EXPECT_LE(comparison.fractionOff, 0.002) << angles.latitude << " " << comparison.summary();
            EXPECT_GT(comparison.opaquePixels, 500u);
        }
}

const EngineCase kCases[] = {
    {.name = "table"},
    {.name = "noTable", .classification = Classification::none},
    {.name = "tableBefore", .classification = Classification::preInterpolation},
    {.name = "max", .compositing = Compositing::max},
    {.name = "min", .classification = Classification::none, .compositing = Compositing::min},
    {.name = "maxOfARamp", .compositing = Compositing::max, .ramp = true},
    {.name = "sum", .compositing = Compositing::sum},
    {.name = "premultiplied", .compositing = Compositing::premultiplied},
    {.name = "eightBricks", .bricks = 2},
    {.name = "perspective", .bricks = 2, .degrees = 60},
    {.name = "stacks", .stackAxis = 2},
    {.name = "fourChannels", .classification = Classification::none, .channels = 4},
    {.name = "fourChannelsTable", .channels = 4},
    {.name = "shells", .degrees = 90, .planes = SamplingPlanes::spherical},
    {.name = "voxelCoordinates", .texCoords = true},
    {.name = "voxelCoordinatesInBricks", .bricks = 2, .degrees = 50, .texCoords = true},
    {.name = "voxelCoordinatesPremultiplied",
     .compositing = Compositing::premultiplied,
     .bricks = 2,
     .texCoords = true},
    {.name = "voxelCoordinatesPremultipliedWithoutTable",
     .classification = Classification::none,
     .compositing = Compositing::premultiplied,
     .degrees = 50,
     .texCoords = true},
};

INSTANTIATE_TEST_SUITE_P(Cases, EnginePictures, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

// ---- The caller's state

class EngineState : public testing::Test
{
protected:
    void open(OffscreenProfile profile, bool floatColor = true)
    {
        scene_ = sceneOf({.name = ""}, field_, {20, 30});
        context_ = openFor(scene_, profile, floatColor);
        drawing_ =
            std::make_unique<SceneDrawing>(*context_, scene_, optionsOf({.name = ""}, voEngineScope::CAST));
    }
    void SetUp() override { open(OffscreenProfile::Compatibility); }

    const GladGLContext& gl() const { return context_->gl(); }

    /// What drew the frame that `draw` draws.
    voEngine drawnWith(const std::function<void()>& draw) const
    {
        const long before = voState::getFramesDrawn(voEngineScope::CAST);
        draw();
        EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
        return voState::getFramesDrawn(voEngineScope::CAST) > before ? voEngineScope::CAST
                                                                     : voEngineScope::SLICES;
    }
    voEngine drawnWith() const
    {
        return drawnWith([&] { drawing_->draw(); });
    }
    /// drawUtility alone, in the state that is set.
    void drawFrame(voEngine engine) const
    {
        voState::setEngine(engine);
        float period[3] = {1, 1, 1};
        voGeometryActions::drawUtility(&drawing_->tetras(), voInterleavedArrayTypeScope::V3F,
                                       &drawing_->volume(), nullptr, voSamplingSpaceScope::OBJECT, period,
                                       voDecorationFlagsScope::NONE);
    }
    /// Both engines draw over a background, in the state that is set.
    Comparison compareOver(float red, float alpha) const
    {
        std::vector<float> pictures[2];
        for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST}) {
            gl().ClearColor(red, 0.25f, 0.5f, alpha);
            gl().Clear(GL_COLOR_BUFFER_BIT);
            EXPECT_EQ(drawnWith([&] { drawFrame(engine); }), engine);
            pictures[engine == voEngineScope::CAST] = context_->readFloats();
        }
        for (std::size_t i = 3; i < pictures[0].size(); i += 4)
            if (std::abs(pictures[0][i] - pictures[1][i]) > 1.5f / 255) ++alphasOff_;
        return compareDrawn(pictures[1], pictures[0]);
    }

    Field field_ = testField(1);
    Scene scene_;
    std::unique_ptr<vo::OffscreenContext> context_;
    std::unique_ptr<SceneDrawing> drawing_;
    mutable int alphasOff_ = 0;
};

TEST_F(EngineState, automaticCastsWhereOpenGLRunsOnTheProcessor)
{
    drawing_ =
        std::make_unique<SceneDrawing>(*context_, scene_, optionsOf({.name = ""}, voEngineScope::AUTOMATIC));
    const bool software = context_->description().find("llvmpipe") != std::string::npos;
    EXPECT_EQ(drawnWith(), software ? voEngineScope::CAST : voEngineScope::SLICES);
}

TEST_F(EngineState, environmentChoosesWhereTheProgramDoesNot)
{
    drawing_->draw();
    const auto drawnAs = [&](voEngine engine) { return drawnWith([&] { drawFrame(engine); }); };
    for (const auto& [word, engine] :
         {std::pair("slices", voEngineScope::SLICES), std::pair("cast", voEngineScope::CAST)}) {
        setenv("VO_ENGINE", word, 1);
        EXPECT_EQ(drawnAs(voEngineScope::AUTOMATIC), engine);
        EXPECT_EQ(drawnAs(voEngineScope::SLICES), voEngineScope::SLICES) << word;
        EXPECT_EQ(drawnAs(voEngineScope::CAST), voEngineScope::CAST) << word;
    }
    unsetenv("VO_ENGINE");
}

TEST_F(EngineState, unknownEngineInTheEnvironmentIsToldOnce)
{
    const voEngine usual = drawnWith([&] { drawFrame(voEngineScope::AUTOMATIC); });
    testing::internal::CaptureStderr();
    for (const char* word : {"cast ", "CAST", "nonsense", ""}) {
        setenv("VO_ENGINE", word, 1);
        EXPECT_EQ(drawnWith([&] { drawFrame(voEngineScope::AUTOMATIC); }), usual) << word;
    }
    unsetenv("VO_ENGINE");
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "VO_ENGINE: expected slices or cast, found \"cast \", which has no effect\n");
}

TEST_F(EngineState, otherStatesAreDrawnAsSlices)
{
    const GladGLContext& g = gl();
    struct Obstacle
    {
        const char* name;
        std::function<void()> set, reset;
    };
    const auto enabled = [&](const char* name, GLenum what) {
        return Obstacle{name, [&g, what] { g.Enable(what); }, [&g, what] { g.Disable(what); }};
    };
    const Obstacle obstacles[] = {
        enabled("alpha test", GL_ALPHA_TEST),
        enabled("culling", GL_CULL_FACE),
        enabled("logic operation", GL_COLOR_LOGIC_OP),
        enabled("stipple", GL_POLYGON_STIPPLE),
        enabled("depth clamp", GL_DEPTH_CLAMP),
        enabled("depths written", GL_DEPTH_TEST),
        {"no blending", [&] { g.Disable(GL_BLEND); }, [&] { g.Enable(GL_BLEND); }},
        {"other factors", [&] { g.BlendFunc(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA); },
         [&] { g.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); }},
        {"other equation", [&] { g.BlendEquation(GL_FUNC_SUBTRACT); }, [&] { g.BlendEquation(GL_FUNC_ADD); }},
        {"lines", [&] { g.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); },
         [&] { g.PolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
        {"stencil written",
         [&] {
             g.Enable(GL_STENCIL_TEST);
             g.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
         },
         [&] {
             g.Disable(GL_STENCIL_TEST);
             g.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
         }},
        {"depth function",
         [&] {
             g.Enable(GL_DEPTH_TEST);
             g.DepthMask(GL_FALSE);
             g.DepthFunc(GL_GREATER);
         },
         [&] {
             g.Disable(GL_DEPTH_TEST);
             g.DepthMask(GL_TRUE);
             g.DepthFunc(GL_LESS);
         }},
        {"texture matrix",
         [&] {
             g.MatrixMode(GL_TEXTURE);
             g.Translatef(0.1f, 0, 0);
         },
         [&] { g.LoadIdentity(); }},
    };
    drawing_->draw();
    const auto cast = [&] { return drawnWith([&] { drawFrame(voEngineScope::CAST); }); };
    EXPECT_EQ(cast(), voEngineScope::CAST);
    for (const Obstacle& obstacle : obstacles) {
        obstacle.set();
        EXPECT_EQ(cast(), voEngineScope::SLICES) << obstacle.name;
        obstacle.reset();
        EXPECT_EQ(cast(), voEngineScope::CAST) << "without " << obstacle.name;
    }
}

TEST_F(EngineState, countedFragmentsAreThoseOfSlices)
{
    drawing_->draw();
    GLuint query = 0;
    gl().GenQueries(1, &query);
    gl().BeginQuery(GL_SAMPLES_PASSED, query);
    EXPECT_EQ(drawnWith([&] { drawFrame(voEngineScope::CAST); }), voEngineScope::SLICES);
    gl().EndQuery(GL_SAMPLES_PASSED);
    GLuint samples = 0;
    gl().GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
    EXPECT_GT(samples, static_cast<GLuint>(kPixels * kPixels)) << "more than one picture has";
}

TEST_F(EngineState, depthsOfTheCallerHideWhatLiesBehind)
{
    drawing_->draw();
    gl().Enable(GL_DEPTH_TEST);
    gl().Enable(GL_SCISSOR_TEST);
    gl().Scissor(kPixels / 3, kPixels / 4, kPixels / 3, kPixels / 2);
    gl().ClearDepth(0.4567); // between two planes
    gl().Clear(GL_DEPTH_BUFFER_BIT);
    gl().Disable(GL_SCISSOR_TEST);
    gl().DepthMask(GL_FALSE);
    for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
        gl().DepthFunc(function);
        const Comparison comparison = compareOver(0, 0);
        EXPECT_GE(comparison.psnrAll, 50.0) << comparison.summary();
        EXPECT_LE(comparison.fractionOff, 0.002);
    }
    const std::vector<float> hidden = context_->readFloats();
    gl().Disable(GL_DEPTH_TEST);
    compareOver(0, 0);
    EXPECT_GT(compareDrawn(context_->readFloats(), hidden).fractionOff, 0.05) << "something was hidden";
}

TEST_F(EngineState, clipPlanesCut)
{
    drawing_->draw();
    gl().MatrixMode(GL_MODELVIEW);
    const GLdouble plane[4] = {1, 0.4, 0.2, -16};
    gl().ClipPlane(GL_CLIP_PLANE3, plane);
    gl().Enable(GL_CLIP_PLANE3);
    const Comparison comparison = compareOver(0, 0);
    EXPECT_GE(comparison.psnrAll, 50.0) << comparison.summary();
    EXPECT_LE(comparison.fractionOff, 0.002);
    EXPECT_TRUE(gl().IsEnabled(GL_CLIP_PLANE3));
}

TEST_F(EngineState, backgroundAndItsAlphaAreBlended)
{
    drawing_->draw();
    const GLenum alphaFactors[][2] = {
        {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}, {GL_ONE, GL_ONE_MINUS_SRC_ALPHA}, {GL_ZERO, GL_ONE}};
    for (const GLenum colorSource : {GL_SRC_ALPHA, GL_ONE})
        for (const auto& [source, destination] : alphaFactors) {
            if (colorSource == GL_ONE) gl().Color4f(0.02f, 0.015f, 0.01f, 1);
            gl().BlendFuncSeparate(colorSource, GL_ONE_MINUS_SRC_ALPHA, source, destination);
            const Comparison comparison = compareOver(0.75f, 0.5f);
            EXPECT_GE(comparison.psnrAll, 50.0) << colorSource << " " << comparison.summary();
            EXPECT_LE(alphasOff_, kPixels * kPixels / 500) << source;
            GLint factor = 0;
            gl().GetIntegerv(GL_BLEND_SRC_ALPHA, &factor);
            EXPECT_EQ(static_cast<GLenum>(factor), source) << "given back";
        }
    gl().BlendFunc(GL_SRC_ALPHA, GL_ONE);
    EXPECT_GE(compareOver(0.75f, 0.5f).psnrAll, 50.0);
}

TEST_F(EngineState, maskScissorStencilAndViewportHold)
{
    drawing_->draw();
    gl().Viewport(10, -20, kPixels - 30, kPixels);
    gl().Enable(GL_SCISSOR_TEST);
    gl().Scissor(0, 0, kPixels / 2, kPixels);
    gl().ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    gl().Enable(GL_STENCIL_TEST);
    gl().StencilFunc(GL_EQUAL, 1, 255);
    gl().ClearStencil(1);
    gl().Clear(GL_STENCIL_BUFFER_BIT);
    gl().Scissor(0, 0, kPixels / 2, kPixels / 2);
    gl().ClearStencil(0);
    gl().Clear(GL_STENCIL_BUFFER_BIT);
    gl().Disable(GL_SCISSOR_TEST);
    const Comparison comparison = compareOver(0.25f, 1);
    EXPECT_GE(comparison.psnrAll, 50.0) << comparison.summary();
    EXPECT_LE(comparison.fractionOff, 0.002);
}

TEST_F(EngineState, colorsThatAFramebufferWouldClampAreDrawnAsSlices)
{
    open(OffscreenProfile::Compatibility, false);
    drawing_->draw();
    EXPECT_EQ(drawnWith([&] { drawFrame(voEngineScope::CAST); }), voEngineScope::CAST);
    gl().Color4f(2, 1, 1, 0.5f);
    EXPECT_EQ(drawnWith([&] { drawFrame(voEngineScope::CAST); }), voEngineScope::SLICES);
}

/// Each corner of the volume in turn is no number: the picture is the same as with flat tetrahedra in place
/// of those that use it.
TEST_F(EngineState, tetrahedraWithAVertexThatIsNotFiniteAreLeftOut)
{
    drawing_->draw();
    const voVertexData& vertices = *drawing_->tetras().getVertexData();
    const voIndices& indices = *drawing_->tetras().getIndices();
    const auto drawn = [&](std::vector<float> records, std::vector<int> corners, voEngine engine) {
        gl().Clear(GL_COLOR_BUFFER_BIT);
        voState::setEngine(engine);
        voIndexedTetraSet tetras(records.data(), static_cast<int>(records.size()) / 3, 3, corners.data(),
                                 static_cast<int>(corners.size()));
        float period[3] = {1, 1, 1};
        EXPECT_EQ(voGeometryActions::drawUtility(&tetras, voInterleavedArrayTypeScope::V3F,
                                                 &drawing_->volume(), nullptr, voSamplingSpaceScope::OBJECT,
                                                 period, voDecorationFlagsScope::NONE),
                  0);
        return context_->readFloats();
    };
    const std::vector<float> whole(vertices.getDataPtr(), vertices.getDataPtr() + 3 * vertices.getCount());
    const std::vector<int> all(indices.getDataPtr(), indices.getDataPtr() + indices.getCount());
    for (std::size_t vertex = 0; vertex < whole.size() / 3; ++vertex)
        for (const float value : {std::nanf(""), HUGE_VALF}) {
            std::vector<float> records = whole;
            records[3 * vertex + vertex % 3] = value;
            std::vector<int> left = all;
            for (std::size_t i = 0; i < all.size(); ++i)
                if (all[i] == static_cast<int>(vertex)) left[i] = all[i ^ 1];
            for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST})
                EXPECT_TRUE(drawn(records, all, engine) == drawn(whole, left, engine))
                    << "vertex " << vertex << ", engine " << engine;
        }
}

TEST_F(EngineState, opacityPerLengthHolds)
{
    drawing_->draw();
    voState::setUnitLength(2.5);
    const Comparison comparison = compareOver(0, 0);
    EXPECT_GE(comparison.psnrAll, 50.0) << comparison.summary();
    EXPECT_LE(comparison.fractionOff, 0.002);
    const std::vector<float> perLength = context_->readFloats();
    voState::setUnitLength(0);
    compareOver(0, 0);
    EXPECT_GT(compareDrawn(context_->readFloats(), perLength).fractionOff, 0.05);
}

TEST_F(EngineState, newVoxelsAndTablesShow)
{
    drawing_->draw();
    const Comparison first = compareOver(0, 0);
    EXPECT_GE(first.psnrAll, 50.0);
    const std::vector<float> before = context_->readFloats();
    voBrick* brick = drawing_->volume().getCurrentBrickSet()->getBrick(0);
    auto* voxels = static_cast<unsigned char*>(brick->getDataPtr());
    std::fill_n(voxels + 36 * 30 * 10, 36 * 30 * 8, static_cast<unsigned char>(200));
    voAppearanceActions::textureLoad(brick);
    const Comparison second = compareOver(0, 0);
    EXPECT_GE(second.psnrAll, 50.0) << second.summary();
    EXPECT_GT(compareDrawn(context_->readFloats(), before).fractionOff, 0.05) << "the new voxels show";
    std::vector<float> table = colorTable();
    for (std::size_t i = 0; i < table.size(); i += 4)
        std::swap(table[i], table[i + 2]);
    const std::vector<float> withOldTable = context_->readFloats();
    voLookupTablePost other(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, 256,
                            GLenum{voExternalFormatTypeScope::RGBA}, GLenum{voDataTypeScope::FLOAT},
                            table.data());
    other.load();
    other.enable();
    EXPECT_GE(compareOver(0, 0).psnrAll, 50.0);
    EXPECT_GT(compareDrawn(context_->readFloats(), withOldTable).fractionOff, 0.05) << "the new table shows";
}

} // namespace
