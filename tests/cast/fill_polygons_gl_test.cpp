// Filled polygons against the same polygons drawn by OpenGL.

#include "cast/fill_scene.h"
#include "draw/draw_scene.h"
#include "support/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using Format = voInterleavedArrayTypeScope;

std::vector<float> rampTable()
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i)
        for (const double entry : {i / 255.0, 0.5, 1.0 - i / 255.0, 0.002 + 0.1 * i / 255.0})
            table.push_back(static_cast<float>(entry));
    return table;
}

class FillPolygonsGL : public testing::Test
{
protected:
    FillPolygonsGL()
    {
        setenv("VO_ENGINE", "slices", 1); // what is compared with
        scene.volume = &field;
        scene.width = 150;
        scene.height = 131;
        scene.overlap = 1;
        scene.classification = Classification::postInterpolation;
        scene.table = rampTable();
        look({35, 50});
    }

    void look(const Angles& angles, double degrees = 0.0)
    {
        scene.view = degrees > 0.0 ? perspectiveView(angles, field.size, scene.width, scene.height, degrees)
                                   : orthographicView(angles, field.size, scene.width, scene.height);
    }

    std::vector<float> drawnByOpenGl(FillScene& fill, int bricks, voInterleavedArrayType format)
    {
        if (!context) context = openFor(scene, OffscreenProfile::Compatibility);
        DrawOptions options;
        options.utility = true;
        options.bricks = bricks;
        SceneDrawing drawing(*context, scene, options);
        drawing.draw(); // leaves the scene's state behind
        context->gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const vo::TetraView& view = fill.request().tetras;
        std::vector<float> records(view.records.begin(), view.records.end());
        std::vector<int> indices(view.indices.begin(), view.indices.end());
        voIndexedTetraSet tetras(records.data(), static_cast<int>(records.size()) / view.valuesPerVertex,
                                 view.valuesPerVertex, indices.data(), static_cast<int>(indices.size()));
        float period[3] = {1, 1, 1};
        voGeometryActions::drawUtility(&tetras, format, &drawing.volume(), nullptr,
                                       voSamplingSpaceScope::OBJECT, period, voDecorationFlagsScope::NONE);
        EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::NO_ERROR);
        return context->readFloats();
    }

    void expectSame(const FillOptions& options, voInterleavedArrayType format)
    {
        FillScene fill(scene, options);
        const Comparison apart = compareDrawn(fill.drawn(), drawnByOpenGl(fill, options.bricks, format));
        SCOPED_TRACE(apart.summary());
        EXPECT_GT(apart.opaquePixels, 3000u);
        EXPECT_GE(apart.psnrAll, 50.0);
        EXPECT_LE(apart.fractionOff, 0.002);
        worst = std::min(worst, apart.psnrAll);
        RecordProperty("worst_dB", std::to_string(worst));
    }

    Field field = quantised(noiseField({22, 25, 19}, 8));
    Deformation bent{3, [](const glm::dvec3& p) {
                         return glm::dvec3(p.x + 0.02 * p.y * p.z, p.y + 2.0 * std::sin(0.2 * p.x),
                                           0.9 * p.z + 0.1 * p.x);
                     }};
    Scene scene;
    std::unique_ptr<vo::OffscreenContext> context;
    double worst = 1e9;
};

TEST_F(FillPolygonsGL, everyRecordFormatLooksTheSame)
{
    for (const double degrees : {0.0, 50.0})
        for (const int bricks : {1, 2}) {
            look({35, 50 + 10 * degrees}, degrees);
            expectSame({.bricks = bricks}, Format::V3F);
            expectSame({.bricks = bricks, .deformation = bent}, Format::T3F_V3F);
            expectSame({.bricks = bricks, .colorChannels = 3}, Format::C3F_V3F);
            expectSame({.bricks = bricks, .deformation = bent, .colorChannels = 4}, Format::T3F_C4F_V3F);
        }
}

/// Every edge of the volume and of its bricks runs through the middles of pixels: who has them is the rule of
/// the rasteriser.
TEST_F(FillPolygonsGL, pixelsOnEdgesBelongToTheSameSide)
{
    for (const double side : {1.0, -1.0}) {
        scene.view.model = multiply(scaling(side, 1, 1), translation(-11, -12.5, -9.5));
        scene.view.projection = ortho(-25, 25, -131 / 6.0, 131 / 6.0, -30, 30);
        for (const int bricks : {1, 3})
            expectSame({.bricks = bricks}, Format::V3F);
    }
}

} // namespace
