// Pictures of a volume's occupied boxes are those of the whole volume.
#include "draw/draw_scene.h"

#include "support/compare.h"

#include <vo/utOccupied.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;

/// What rounding of coordinates in small polygons makes of a picture with steep edges, for fragments of at
/// most a tenth. A sample too many or too few would be a thousandth at least.
constexpr double kRounding = 5e-5;

std::vector<float> tableFrom(int first)
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const float v = static_cast<float>(i) / 255.0f;
        table.insert(table.end(), {v, 0.5f * v, 1.0f - v, i < first ? 0.0f : 0.02f + 0.1f * v});
    }
    return table;
}

/// A ball in a corner, a letter in another, and a faint cloud that tables from entry 40 on do not show.
Field sparseField()
{
    const VoxelSize size{45, 38, 51};
    Field field = constantField(size, 0.1);
    const Field letter = letterFField({20, 20, 20}), ball = ballField({18, 18, 18});
    for (int z = 0; z < 20; ++z)
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                field.at(2 + x, 3 + y, 4 + z) = std::max(0.1f, letter.at(x, y, z));
    for (int z = 0; z < 18; ++z)
        for (int y = 0; y < 18; ++y)
            for (int x = 0; x < 18; ++x)
                field.at(25 + x, 18 + y, 31 + z) = std::max(0.1f, ball.at(x, y, z));
    return quantised(field);
}

std::vector<Tetrahedron> copied(std::unique_ptr<voIndexedTetraSet> set)
{
    std::vector<Tetrahedron> tetras;
    const voIndices& indices = *set->getIndices();
    for (int i = 0; i < indices.getCount(); ++i) {
        if (i % 4 == 0) tetras.emplace_back();
        const float* p = (*set->getVertexData())[indices.getDataPtr()[i]];
        tetras.back()[std::size_t(i % 4)] = {p[0], p[1], p[2]};
    }
    return tetras;
}

class OccupiedGL : public testing::Test
{
protected:
    OccupiedGL()
    {
        scene.volume = &field;
        scene.width = scene.height = 120;
        scene.overlap = 1;
        scene.view = orthographicView({20, 30}, field.size, 120, 120);
        scene.classification = Classification::postInterpolation;
        scene.table = tableFrom(40);
        options.utility = true;
    }

    struct Pictures
    {
        std::vector<float> whole, boxes;
        std::string messages; ///< about the boxes

        double largestDifference() const
        {
            double largest = 0.0;
            for (std::size_t i = 0; i < whole.size(); ++i)
                largest = std::max(largest, std::abs(double(whole[i]) - double(boxes[i])));
            return largest;
        }
        bool toldOfGaps() const
        {
            return messages.find("nothing shows between the boxes") != std::string::npos;
        }
    };

    /// The set of what `shown` makes visible; `scene` is drawn.
    std::vector<Tetrahedron> boxesOf(std::vector<float> shown, int side)
    {
        voutOccupied occupied(&whole->volume(), loaded(shown).get(), side);
        EXPECT_GT(occupied.getBoxCount(), 2);
        EXPECT_LT(occupied.getCoveredFraction(), 0.7);
        return copied(std::unique_ptr<voIndexedTetraSet>(occupied.tessellate()));
    }

    std::unique_ptr<voLookupTable> loaded(std::vector<float>& entries) const
    {
        if (scene.classification == Classification::none) return nullptr;
        auto table = std::make_unique<voLookupTablePost>(
            GLenum{voInternalFormatTypeScope::RGBA8_EXT}, int(entries.size() / 4),
            GLenum{voExternalFormatTypeScope::RGBA}, GLenum{voDataTypeScope::FLOAT}, entries.data());
        table->load();
        return table;
    }

    Pictures draw(OffscreenProfile profile, const std::vector<float>& shown, int side = 8)
    {
        context = openFor(scene, profile);
        whole = std::make_unique<SceneDrawing>(*context, scene, options);
        whole->draw();
        Pictures pictures{context->readFloats(), {}, {}};
        Scene inBoxes = scene;
        inBoxes.geometry = boxesOf(shown, side);
        SceneDrawing boxes(*context, inBoxes, options);
        std::ostringstream messages;
        voError::setDebugLevel(2);
        voError::setDebugStream(messages);
        boxes.draw();
        voError::setDebugLevel(0);
        voError::setDebugStream(stderr);
        pictures.boxes = context->readFloats();
        pictures.messages = messages.str();
        EXPECT_GT(*std::ranges::max_element(pictures.whole), 0.1f) << "the picture shows something";
        whole.reset();
        return pictures;
    }

    Field field = sparseField();
    Scene scene;
    DrawOptions options;
    std::unique_ptr<vo::OffscreenContext> context;
    std::unique_ptr<SceneDrawing> whole;
};

TEST_F(OccupiedGL, isDrawnAsTheWholeToTheBit)
{
    for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST})
        for (const OffscreenProfile profile : {OffscreenProfile::Compatibility, OffscreenProfile::Core})
            for (const int bricks : {1, 2})
                for (const bool perspective : {false, true}) {
                    SCOPED_TRACE(testing::Message() << "engine " << int(engine) << ", bricks " << bricks
                                                    << (perspective ? ", perspective" : ""));
                    options.engine = engine;
                    options.bricks = bricks;
                    scene.view = perspective ? perspectiveView({-35, 140}, field.size, 120, 120, 50)
                                             : orthographicView({20, 30}, field.size, 120, 120);
                    for (const int side : {4, 8, 12}) {
                        const Pictures pictures = draw(profile, scene.table, side);
                        EXPECT_TRUE(pictures.whole == pictures.boxes) << pictures.largestDifference();
                        EXPECT_TRUE(pictures.toldOfGaps());
                    }
                }
}

TEST_F(OccupiedGL, isDrawnAsTheWholeWithAndWithoutATable)
{
    for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST}) {
        options.engine = engine;
        scene.classification = Classification::preInterpolation;
        Pictures pictures = draw(OffscreenProfile::Compatibility, scene.table);
        EXPECT_TRUE(pictures.whole == pictures.boxes) << pictures.largestDifference();
        EXPECT_TRUE(pictures.toldOfGaps());

        scene.classification = Classification::none;
        scene.color = {1, 1, 1, 0.2};
        for (float& value : field.values)
            value = value < 0.11f ? 0.0f : value;
        pictures = draw(OffscreenProfile::Compatibility, scene.table);
        EXPECT_TRUE(pictures.whole == pictures.boxes) << pictures.largestDifference();
        EXPECT_TRUE(pictures.toldOfGaps());
        scene.color = {1, 1, 1, 1};
        field = sparseField();
    }
}

TEST_F(OccupiedGL, leavesOutWhatATableShowsLater)
{
    const std::vector<float> shown = scene.table;
    scene.table = tableFrom(1); // the cloud too
    options.utility = false;
    const Pictures loops = draw(OffscreenProfile::Compatibility, shown);
    EXPECT_GT(loops.largestDifference(), 0.1);
    options.utility = true;
    for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST}) {
        options.engine = engine;
        Pictures pictures = draw(OffscreenProfile::Compatibility, shown);
        EXPECT_FALSE(pictures.toldOfGaps());
        pictures.whole = loops.boxes;
        EXPECT_LE(pictures.largestDifference(), 2e-3) << "the boxes alone, polygon by polygon";
    }
}

TEST_F(OccupiedGL, whereClearFragmentsLeaveATraceIsDrawnAsItIs)
{
    for (const Compositing compositing : {Compositing::max, Compositing::sum}) {
        scene.compositing = compositing;
        EXPECT_FALSE(draw(OffscreenProfile::Compatibility, scene.table).toldOfGaps());
    }
}

TEST_F(OccupiedGL, polygonByPolygonHasNoSeams)
{
    options.utility = false;
    for (const int bricks : {1, 2})
        for (const Angles& angles : {Angles{20, 30}, Angles{0, 0}, Angles{-70, 200}})
            for (const int side : {3, 5, 8}) {
                SCOPED_TRACE(testing::Message() << bricks << " bricks, side " << side);
                options.bricks = bricks;
                scene.view = orthographicView(angles, field.size, 120, 120);
                EXPECT_LE(draw(OffscreenProfile::Compatibility, scene.table, side).largestDifference(),
                          kRounding);
            }
}

TEST_F(OccupiedGL, nothingIsDrawnWithoutAnError)
{
    context = openFor(scene, OffscreenProfile::Compatibility);
    std::vector<float> clear = tableFrom(256);
    whole = std::make_unique<SceneDrawing>(*context, scene, options);
    const std::unique_ptr<voLookupTable> table = loaded(clear);
    voutOccupied occupied(&whole->volume(), table.get());
    EXPECT_EQ(occupied.getBoxCount(), 0);
    const std::unique_ptr<voIndexedTetraSet> none(occupied.tessellate());
    const GladGLContext& gl = context->gl();
    for (const voEngine engine : {voEngineScope::SLICES, voEngineScope::CAST}) {
        gl.ClearColor(0, 0, 0, 0);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        voState::setEngine(engine);
        EXPECT_EQ(voGeometryActions::drawUtility(none.get(), voInterleavedArrayTypeScope::V3F,
                                                 &whole->volume(), NULL, voSamplingSpaceScope::OBJECT, NULL,
                                                 voDecorationFlagsScope::NONE),
                  0);
        EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::NO_ERROR);
        const std::vector<float> picture = context->readFloats();
        EXPECT_EQ(*std::ranges::max_element(picture), 0.0f);
    }
}

} // namespace
