// drawUtility leaves out what cannot be seen; the picture stays.

#include "draw/sparse_slices.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;

/// What rounding of coordinates in small triangles makes of a picture with steep edges. A sample too many or
/// too few would be a thousandth at least.
constexpr double kRounding = 5e-5;

/// A frame, and how many fragments it took.
struct Frame
{
    std::vector<float> picture;
    GLuint fragments = 0;
};

constexpr int kPixels = 160;
constexpr Place kBall{36, 29, 33};

class SpaceLeapingGL : public SparseSlices
{
protected:
    /// The ball lies in the corner opposite the letter's.
    SpaceLeapingGL() : SparseSlices(kBall, kPixels) {}

    static double largestDifference(const Frame& a, const Frame& b)
    {
        return SparseSlices::largestDifference(a.picture, b.picture);
    }

    Frame frame()
    {
        GLuint query = 0;
        Frame result;
        gl().GenQueries(1, &query);
        gl().BeginQuery(GL_SAMPLES_PASSED, query);
        drawing->draw(scene.view);
        gl().EndQuery(GL_SAMPLES_PASSED);
        gl().GetQueryObjectuiv(query, GL_QUERY_RESULT, &result.fragments);
        gl().DeleteQueries(1, &query);
        result.picture = context->readFloats();
        return result;
    }

    /// Every fragment leaves a depth: none can be left out.
    Frame wholeFrame()
    {
        gl().Enable(GL_DEPTH_TEST);
        gl().DepthFunc(GL_ALWAYS);
        Frame result = frame();
        gl().Disable(GL_DEPTH_TEST);
        return result;
    }

    void expectLeaped(double part = 0.75)
    {
        const Frame leaped = frame(), whole = wholeFrame();
        EXPECT_LT(leaped.fragments, part * whole.fragments);
        EXPECT_GT(leaped.fragments, 0u);
        EXPECT_LE(largestDifference(leaped, whole), kRounding);
        EXPECT_GT(*std::ranges::max_element(whole.picture), 0.1f) << "the picture shows something";
    }

    void expectWhole()
    {
        const Frame first = frame(), whole = wholeFrame();
        EXPECT_EQ(first.fragments, whole.fragments);
    }
};

TEST_F(SpaceLeapingGL, leavesThePictureAsItIs)
{
    for (const int bricks : {1, 2, 3}) {
        options.bricks = bricks;
        for (const OffscreenProfile profile : {OffscreenProfile::Compatibility, OffscreenProfile::Core}) {
            open(profile);
            for (const Angles& angles : {Angles{20, 30}, Angles{0, 0}, Angles{-70, 200}}) {
                SCOPED_TRACE(testing::Message() << bricks << " bricks a side, from " << angles.latitude << " "
                                                << angles.longitude);
                scene.view = orthographicView(angles, field.size, kPixels, kPixels);
                expectLeaped();
                scene.view = perspectiveView(angles, field.size, kPixels, kPixels, 50);
                expectLeaped();
            }
        }
    }
}

TEST_F(SpaceLeapingGL, goesByTheTableThatIsActive)
{
    scene.classification = Classification::none;
    scene.color = {1, 1, 1, 0.2};
    open();
    expectLeaped();
    scene.color = {1, 1, 1, 1};
    scene.classification = Classification::preInterpolation;
    open();
    expectLeaped();
    scene.classification = Classification::postInterpolation;
    scene.table = tableFrom(200);
    open();
    const Frame little = frame();
    expectLeaped(0.6);
    scene.table = tableFrom(0);
    open();
    expectWhole();
    scene.table = tableFrom(1);
    open();
    EXPECT_GT(frame().fragments, little.fragments);
}

TEST_F(SpaceLeapingGL, aTableLoadedBetweenFramesCounts)
{
    open();
    const Frame before = frame();
    std::vector<float> opaque = tableFrom(0);
    voLookupTablePost other(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, 256,
                            GLenum{voExternalFormatTypeScope::RGBA}, GLenum{voDataTypeScope::FLOAT},
                            opaque.data());
    other.load();
    other.enable();
    const Frame full = frame();
    EXPECT_GT(full.fragments, before.fragments);
    EXPECT_EQ(full.fragments, wholeFrame().fragments);
}

TEST_F(SpaceLeapingGL, newVoxelsShow)
{
    open();
    const Frame before = frame();
    voBrick* brick = drawing->volume().getCurrentBrickSet()->getBrick(0);
    auto* voxels = static_cast<unsigned char*>(brick->getDataPtr());
    for (int z = 40; z < 50; ++z)
        for (int y = 4; y < 14; ++y)
            std::fill_n(voxels + (z * field.size.y + y) * field.size.x + 4, 10,
                        static_cast<unsigned char>(255));
    voAppearanceActions::dataScaleRange(brick, 0.0f, 255.0f);
    const Frame after = frame();
    EXPECT_GT(after.fragments, before.fragments);
    EXPECT_LE(largestDifference(after, wholeFrame()), kRounding);
    EXPECT_GT(largestDifference(after, before), 0.1);
}

TEST_F(SpaceLeapingGL, happensOnlyWhereAClearFragmentLeavesNoTrace)
{
    scene.compositing = Compositing::max;
    open();
    expectWhole();
    scene.compositing = Compositing::sum;
    open();
    expectWhole();
}

TEST_F(SpaceLeapingGL, keptSlicesAreThereAfterOtherDraws)
{
    open();
    const Frame first = frame();
    EXPECT_EQ(frame().picture, first.picture) << "kept";
    Field other = ballField({50, 50, 50});
    Scene otherScene = scene;
    otherScene.volume = &other;
    SceneDrawing otherDrawing(*context, otherScene, options);
    otherDrawing.draw(scene.view);
    EXPECT_EQ(frame().picture, first.picture) << "after another volume";
    voGeometryActions::draw(drawing->volume().getCurrentBrickSet());
    EXPECT_EQ(frame().picture, first.picture) << "after outlines";
}

TEST_F(SpaceLeapingGL, volumesThatAlternateKeepTheirRanges)
{
    options.bricks = 2;
    open();
    const Field otherField = sparseField(kBall);
    Scene otherScene = scene;
    otherScene.volume = &otherField;
    otherScene.table = tableFrom(100);
    auto other = std::make_unique<SceneDrawing>(*context, otherScene, options);
    const auto rangesFound = [&](SceneDrawing& volume) {
        std::istringstream lines(messagesOf([&] { volume.draw(scene.view); }));
        int count = 0;
        for (std::string line; std::getline(lines, line);)
            count += line.find("ranges of a brick's voxels found") != std::string::npos;
        return count;
    };
    EXPECT_EQ(rangesFound(*drawing), 8);
    EXPECT_EQ(rangesFound(*other), 8);
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(rangesFound(*drawing), 0);
        EXPECT_EQ(rangesFound(*other), 0);
    }
    voAppearanceActions::dataScaleRange(other->volume().getCurrentBrickSet()->getBrick(3), 0.0f, 255.0f);
    EXPECT_EQ(rangesFound(*drawing), 0);
    EXPECT_EQ(rangesFound(*other), 1) << "new voxels";
    EXPECT_EQ(rangesFound(*drawing), 0);
    voAppearanceActions::volumeUnoptimize(&other->volume());
    EXPECT_EQ(rangesFound(*drawing), 0) << "its own were not forgotten";
    EXPECT_EQ(rangesFound(*other), 8) << "forgotten with the textures";
    expectLeaped();
}

TEST_F(SpaceLeapingGL, doesNotHappenToVolumesOutOfPlace)
{
    options.explicitTexCoords = true;
    open();
    expectWhole();
}

} // namespace
