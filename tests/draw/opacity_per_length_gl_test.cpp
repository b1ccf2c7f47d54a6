// voState::setUnitLength: opacity per length along each pixel's own line of sight.

#include "draw/draw_scene.h"

#include "support/compare.h"

#include <vo/State.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;

constexpr int kPixels = 96;
constexpr double kUnit = 2.5;
const VoxelSize kSize{24, 20, 22};

std::vector<float> denseTable()
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        for (const double value : {0.5 + 0.5 * std::sin(6.0 * v), v * v, 1.0 - v, 0.6 * v})
            table.push_back(static_cast<float>(value));
    }
    return table;
}

/// Smooth, so that pictures of two sampling periods can agree.
Field smoothField()
{
    return fieldOf(kSize, [](const glm::dvec3& p) {
        return 0.5 + 0.2 * std::sin(0.5 * p.x) + 0.2 * std::cos(0.4 * p.y + 0.3 * p.z);
    });
}

struct LengthCase
{
    const char* name;
    SamplingPlanes planes = SamplingPlanes::viewportAligned;
    double degrees = 0.0; ///< perspective
    bool stacks = false;
    bool ownLoops = false;
    OffscreenProfile profile = OffscreenProfile::Compatibility;
    double bar = 70.0;
};

std::ostream& operator<<(std::ostream& stream, const LengthCase& c)
{
    return stream << c.name;
}

Scene sceneOf(const LengthCase& c, const Field& field, const Angles& angles, double period)
{
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = kPixels;
    scene.view = c.degrees > 0 ? perspectiveView(angles, kSize, kPixels, kPixels, c.degrees)
                               : orthographicView(angles, kSize, kPixels, kPixels);
    scene.overlap = 1;
    scene.planes = c.planes;
    scene.period = glm::dvec3(period);
    scene.classification = Classification::postInterpolation;
    scene.table = denseTable();
    if (!c.stacks) return scene;
    scene.planes = SamplingPlanes::axisAligned;
    View v = scene.view;
    scene.stackAxis = 3 - static_cast<int>(voGeometryActions::findClosestAxisIndex(
                              v.model.data(), v.projection.data(), voSamplingModeScope::AXIS_ALIGNED));
    return scene;
}

/// A sample of one ray: where, and how far from the next.
struct RaySample
{
    double distance;
    glm::dvec3 point;
    double step;
};

std::vector<RaySample> samplesOf(const Scene& scene, const glm::dvec3& start, const glm::dvec3& way)
{
    const glm::dvec3 ray = glm::normalize(way);
    std::vector<RaySample> samples;
    if (scene.planes == SamplingPlanes::spherical) {
        const ReferenceShells shells = referenceShells(scene);
        const double stretch = glm::length(ray / shells.scale);
        for (const double radius : shells.radii)
            samples.push_back(
                {radius / stretch, shells.eye + radius / stretch * ray, shells.spacing / stretch});
        return samples;
    }
    const ReferencePlanes planes = referencePlanes(scene);
    const double slope = glm::dot(planes.normal, ray);
    const double spacing = planes.offsets[0] - planes.offsets[1];
    for (const double offset : planes.offsets) {
        const double distance = (offset - glm::dot(planes.normal, start)) / slope;
        RaySample sample{distance, start + distance * ray, spacing / std::abs(slope)};
        for (int axis = 0; scene.planes == SamplingPlanes::axisAligned && axis < 3; ++axis)
            if (planes.normal[axis] != 0.0) sample.point[axis] = offset / planes.normal[axis];
        if (distance > 0 && distance < glm::length(way)) samples.push_back(sample);
    }
    return samples;
}

/// The scene with opacity per length, in double precision.
Picture expectedPicture(const Scene& scene)
{
    Picture picture = referencePicture(scene); // for its mask
    const glm::dmat4 fromClip =
        glm::inverse(glm::make_mat4(scene.view.projection.data()) * glm::make_mat4(scene.view.model.data()));
    const auto corner = [&](double x, double y, double z) {
        const glm::dvec4 p = fromClip * glm::dvec4(x, y, z, 1);
        return glm::dvec3(p) / p.w;
    };
    glm::dvec3 lower(0.5), upper(kSize.x - 0.5, kSize.y - 0.5, kSize.z - 0.5);
    if (scene.stackAxis >= 0) {
        lower[scene.stackAxis] -= 0.5;
        upper[scene.stackAxis] += 0.5;
    }
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const double u = 2 * (x + 0.5) / kPixels - 1, v = 2 * (y + 0.5) / kPixels - 1;
            const glm::dvec3 start = corner(u, v, -1);
            double* pixel = picture.rgba.data() + 4 * (y * kPixels + x);
            std::fill_n(pixel, 4, 0.0);
            for (const RaySample& s : samplesOf(scene, start, corner(u, v, 1) - start)) {
                if (glm::any(glm::lessThan(s.point, lower - 1e-9)) ||
                    glm::any(glm::greaterThan(s.point, upper + 1e-9)))
                    continue;
                const std::array<double, 4> rgba = referenceSample(scene, s.point);
                const double alpha = 1 - std::pow(1 - rgba[3], s.step / kUnit);
                for (std::size_t i = 0; i < 3; ++i)
                    pixel[i] += (rgba[i] - pixel[i]) * alpha;
                pixel[3] = 1 - (1 - pixel[3]) * (1 - alpha);
            }
        }
    return picture;
}

voSamplingMode modeOf(const LengthCase& c)
{
    return c.stacks || c.planes == SamplingPlanes::axisAligned ? voSamplingModeScope::AXIS_ALIGNED
           : c.planes == SamplingPlanes::spherical             ? voSamplingModeScope::SPHERICAL
                                                               : voSamplingModeScope::VIEWPORT_ALIGNED;
}

std::vector<float> drawnPerLength(const vo::OffscreenContext& context, const LengthCase& c,
                                  const Scene& scene)
{
    SceneDrawing drawing(context, scene,
                         {.bricks = 2, .utility = !c.ownLoops, .dataType = voDataTypeScope::FLOAT});
    voState::setUnitLength(kUnit);
    View view = scene.view;
    float period[3];
    for (int axis = 0; axis < 3; ++axis)
        period[axis] = static_cast<float>((*scene.period)[axis]);
    if (c.stacks) drawing.volume().setCurrentBrickSet(static_cast<voPlaneOrientation>(3 - scene.stackAxis));
    if (c.ownLoops)
        voState::setSampling(&drawing.tetras(), drawing.volume().getCurrentBrickSet(), view.model.data(),
                             view.projection.data(), modeOf(c), voSamplingSpaceScope::OBJECT, period, 4096);
    drawing.draw();
    voState::setUnitLength(0);
    voState::resetSampling();
    return context.readFloats();
}

class LengthGL : public testing::TestWithParam<LengthCase>
{
};

TEST_P(LengthGL, agreesWithTheReference)
{
    const LengthCase& c = GetParam();
    const Field field = smoothField();
    std::unique_ptr<vo::OffscreenContext> context;
    for (const Angles& angles : {Angles{0, 0}, Angles{25, 35}, Angles{-50, 110}}) {
        const Scene scene = sceneOf(c, field, angles, c.stacks ? 1.0 : 0.8);
        if (!context) context = openFor(scene, c.profile);
        const bool software = context->description().find("llvmpipe") != std::string::npos;
        const Comparison comparison = compare(drawnPerLength(*context, c, scene), expectedPicture(scene));
        SCOPED_TRACE(comparison.summary());
        EXPECT_GT(comparison.opaquePixels, 1000u);
        EXPECT_GE(comparison.psnrMasked, software ? c.bar : std::min(c.bar, 45.0));
    }
}

/// Twice as many samples leave the picture nearly as it is; per slice it changes much.
TEST_P(LengthGL, picturesOfTwoPeriodsNearlyAgree)
{
    const LengthCase& c = GetParam();
    const Field field = smoothField();
    const Angles angles{25, 35};
    const Scene fine = sceneOf(c, field, angles, 0.5), coarse = sceneOf(c, field, angles, 1.0);
    const auto context = openFor(fine, c.profile);
    const std::vector<float> first = drawnPerLength(*context, c, coarse);
    const std::vector<float> second = drawnPerLength(*context, c, fine);
    const double perLength = compareDrawn(first, second).psnrAll;
    const DrawOptions options{.bricks = 2, .utility = !c.ownLoops, .dataType = voDataTypeScope::FLOAT};
    const std::vector<float> third = drawnPicture(*context, coarse, options);
    const double perSlice = compareDrawn(third, drawnPicture(*context, fine, options)).psnrAll;
    RecordProperty("perLength", std::to_string(perLength));
    RecordProperty("perSlice", std::to_string(perSlice));
    EXPECT_GE(perLength, 28.0);
    EXPECT_GE(perLength, perSlice + 9.0) << perSlice;
}

INSTANTIATE_TEST_SUITE_P(
    All, LengthGL,
    testing::Values(
        LengthCase{.name = "orthographic"}, LengthCase{.name = "perspective", .degrees = 70},
        LengthCase{.name = "core", .degrees = 70, .profile = OffscreenProfile::Core},
        LengthCase{
            .name = "axisAligned", .planes = SamplingPlanes::axisAligned, .degrees = 40, .ownLoops = true},
        LengthCase{.name = "stacks", .degrees = 40, .stacks = true},
        LengthCase{.name = "spherical", .planes = SamplingPlanes::spherical, .degrees = 100, .bar = 45.0},
        LengthCase{.name = "ownLoops", .degrees = 70, .ownLoops = true},
        LengthCase{.name = "ownLoopsOfStacks", .stacks = true, .ownLoops = true}),
    [](const auto& test) { return std::string(test.param.name); });

/// A constant volume seen along z fills the picture.
struct SlabGL : testing::Test
{
    SlabGL()
    {
        scene.volume = &field;
        scene.width = scene.height = 8;
        scene.view.projection = ortho(0, 16, 0, 16, -17, 1);
        scene.color = {1, 1, 1, 0.125};
        context = openFor(scene, OffscreenProfile::Compatibility);
    }
    ~SlabGL() override
    {
        EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::NO_ERROR);
        voError::getErrorString();
    }
    std::vector<float> drawn(double period, bool utility = true)
    {
        scene.period = glm::dvec3(period);
        return drawnPicture(*context, scene, {.bricks = 1, .utility = utility});
    }
    /// Of voxels that are 1, with a current colour of opacity 1/8.
    float middle(double period) { return drawn(period)[4 * (4 * 8 + 4)]; }

    Field field = constantField({16, 16, 16}, 1.0);
    Scene scene;
    std::unique_ptr<vo::OffscreenContext> context;
};

TEST_F(SlabGL, opacityIsThatOfTheLength)
{
    for (const double unit : {0.5, 1.0, 3.0, 16.0, 100.0}) {
        voState::setUnitLength(unit);
        for (const double period : {0.25, 1.0, 2.0, 5.0, 16.0})
            EXPECT_NEAR(middle(period), 1 - std::pow(1 - 0.125, 16 / unit), 2e-5) << unit << " " << period;
    }
    voState::setUnitLength(0);
    EXPECT_NEAR(middle(2.0), 1 - std::pow(1 - 0.125, 8), 1e-5);
}

TEST_F(SlabGL, opaqueStaysOpaqueAndEmptyStaysEmpty)
{
    voState::setUnitLength(3);
    scene.color = {1, 1, 1, 1};
    EXPECT_EQ(middle(1), 1.0f);
    scene.color = {1, 1, 1, 0};
    EXPECT_EQ(middle(1), 0.0f);
    voState::setUnitLength(0);
}

TEST_F(SlabGL, zeroIsAsIfItHadNeverBeenSet)
{
    const std::vector<float> before = drawn(0.7);
    voState::setUnitLength(3);
    EXPECT_NE(drawn(0.7), before);
    voState::setUnitLength(0);
    EXPECT_EQ(drawn(0.7), before);
}

TEST_F(SlabGL, ownLoopsCountPerSliceUntilTheyTellTheirSampling)
{
    const std::vector<float> perSlice = drawn(0.7, false);
    voState::setUnitLength(3);
    EXPECT_EQ(drawn(0.7, false), perSlice);
    const std::vector<float> perLength = drawn(0.7, true);
    SceneDrawing drawing(*context, scene, {.bricks = 1});
    float period[3] = {0.7f, 0.7f, 0.7f};
    View view = scene.view;
    voState::setSampling(&drawing.tetras(), drawing.volume().getCurrentBrickSet(), view.model.data(),
                         view.projection.data(), voSamplingModeScope::DEFAULT, voSamplingSpaceScope::DEFAULT,
                         period, 4096);
    const std::vector<float> told = drawn(0.7, false);
    for (std::size_t i = 0; i < told.size(); ++i)
        ASSERT_NEAR(told[i], perLength[i], 1e-5);
    EXPECT_NE(told, perSlice);
    voState::resetSampling();
    EXPECT_EQ(drawn(0.7, false), perSlice);
    voState::setUnitLength(0);
}

/// What is no sample keeps its alpha.
TEST_F(SlabGL, outlinesAndFacesOfTetrahedraKeepTheirOpacity)
{
    SceneDrawing drawing(*context, scene, {.bricks = 1, .utility = true});
    const auto picture = [&] {
        const GladGLContext& gl = context->gl();
        gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Color4f(1, 0.5f, 0.25f, 0.5f);
        voGeometryActions::draw(drawing.volume().getCurrentBrickSet());
        voGeometryActions::draw(&drawing.tetras(), voInterleavedArrayTypeScope::V3F);
        return context->readFloats();
    };
    drawing.draw();
    const std::vector<float> before = picture();
    voState::setUnitLength(7);
    float period[3] = {1, 1, 1};
    View view = scene.view;
    voState::setSampling(&drawing.tetras(), drawing.volume().getCurrentBrickSet(), view.model.data(),
                         view.projection.data(), voSamplingModeScope::DEFAULT, voSamplingSpaceScope::DEFAULT,
                         period, 4096);
    EXPECT_EQ(picture(), before);
    voState::resetSampling();
    voState::setUnitLength(0);
}

/// Polygons that a cache kept while the view turned lie as far apart as they were made.
TEST_F(SlabGL, keptPolygonsCountTheirOwnDistance)
{
    scene.color = {1, 1, 1, 1};
    scene.period = glm::dvec3(1);
    SceneDrawing drawing(*context, scene, {.bricks = 1, .utility = true});
    voDrawActionCache cache(&drawing.tetras(), &drawing.volume(), 100, voSamplingModeScope::DEFAULT, 3, 0);
    cache.setThreshold(40);
    voState::setUnitLength(2);
    float period[3] = {1, 1, 1};
    for (const double turn : {0.0, 30.0}) {
        View view;
        view.model = multiply(rotation(turn, 0, 1, 0), translation(-8, -8, -8));
        view.projection = ortho(-2, 2, -2, 2, -20, 20);
        drawing.draw(view);
        context->gl().Clear(GL_COLOR_BUFFER_BIT);
        context->gl().Color4f(1, 1, 1, 0.125);
        EXPECT_EQ(voGeometryActions::drawUtility(&drawing.tetras(), voInterleavedArrayTypeScope::V3F,
                                                 &drawing.volume(), &cache, voSamplingSpaceScope::OBJECT,
                                                 period, voDecorationFlagsScope::NONE),
                  0);
        // 16 planes across z all the same, met aslant by the ray, whose way through the cube is as much
        // longer.
        const double length = 16 / std::cos(turn * M_PI / 180);
        EXPECT_NEAR(context->readFloats()[4 * (4 * 8 + 4)], 1 - std::pow(1 - 0.125, length / 2), 2e-5)
            << turn;
    }
    voState::setUnitLength(0);
}

TEST_F(SlabGL, badArgumentsAreRefused)
{
    const auto refused = [](voErrorType expected) {
        EXPECT_EQ(voError::getErrorNumber(), expected);
        voError::getErrorString();
    };
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
        voState::setUnitLength(bad);
        refused(voErrorTypeScope::BAD_VALUE);
    }
    SceneDrawing drawing(*context, scene, {.bricks = 1, .utility = true});
    drawing.draw();
    float period[3] = {1, 1, 1};
    View view = scene.view;
    const auto tell = [&](voIndexedTetraSet* tetras, voBrickSet* set, GLdouble* model,
                          voSamplingSpace space) {
        voState::setSampling(tetras, set, model, view.projection.data(), voSamplingModeScope::DEFAULT, space,
                             period, 10);
    };
    voBrickSet* set = drawing.volume().getCurrentBrickSet();
    tell(NULL, set, view.model.data(), voSamplingSpaceScope::OBJECT);
    refused(voErrorTypeScope::BAD_VALUE);
    tell(&drawing.tetras(), NULL, view.model.data(), voSamplingSpaceScope::OBJECT);
    refused(voErrorTypeScope::BAD_VALUE);
    tell(&drawing.tetras(), set, NULL, voSamplingSpaceScope::OBJECT);
    refused(voErrorTypeScope::BAD_VALUE);
    tell(&drawing.tetras(), set, view.model.data(), voSamplingSpaceScope::PRIMITIVE);
    refused(voErrorTypeScope::UNSUPPORTED);
    const auto primitive = [&] {
        return voGeometryActions::drawUtility(&drawing.tetras(), voInterleavedArrayTypeScope::V3F,
                                              &drawing.volume(), NULL, voSamplingSpaceScope::PRIMITIVE,
                                              period, voDecorationFlagsScope::NONE);
    };
    EXPECT_EQ(primitive(), 0);
    voState::setUnitLength(1);
    EXPECT_NE(primitive(), 0);
    refused(voErrorTypeScope::UNSUPPORTED);
    voState::setUnitLength(0);
}

} // namespace
