// Parts drawn together, against float64 samples and integrals along each pixel's ray.
#include "draw/draw_scene.h"

#include "../legacy/expect_error.h"
#include "support/compare.h"

#include <vo/State.h>
#include <vo/utParts.h>
#include <vo/utSolidActions.h>
#include <vo/utSolids.h>

#include <gtest/gtest.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <functional>

namespace {

using namespace vo;
using namespace vo::test;
using glm::dvec3;
using Set = std::unique_ptr<voIndexedTetraSet>;
using Format = voInterleavedArrayTypeScope;

constexpr int kWidth = 64, kHeight = 56;
const VoxelSize kSize{20, 18, 16};
const dvec3 kExtent(20, 18, 16);

Field blobs()
{
    return quantised(withEmptyBorder(fieldOf(kSize, [](const dvec3& p) {
        const double ball = 1.2 - glm::length(p - dvec3(10, 9, 8)) / 7;
        return ball * (0.7 + 0.3 * std::sin(p.x) * std::cos(0.8 * p.y + 0.5 * p.z));
    })));
}

Set wholeBox()
{
    return Set(voutBox(0, 0, 0, 20, 18, 16, 2, 2, 2).tessellate());
}

std::vector<float> tableOf(const std::array<double, 3>& color, double opacity)
{
    std::vector<float> table;
    for (int i = 0; i < 64; ++i) {
        for (const double channel : color)
            table.push_back(float(channel * (0.4 + 0.6 * i / 63)));
        table.push_back(float(opacity * i / 63));
    }
    return table;
}

std::unique_ptr<voLookupTable> lookupOf(std::vector<float>& table)
{
    auto lookup = std::make_unique<voLookupTablePost>(
        GLenum{voInternalFormatTypeScope::RGBA8_EXT}, int(table.size() / 4),
        GLenum{voExternalFormatTypeScope::RGBA}, GLenum{voDataTypeScope::FLOAT}, table.data());
    lookup->load();
    return lookup;
}

View viewFrom(double latitude, double longitude, double degrees)
{
    return degrees == 0 ? orthographicView({latitude, longitude}, kSize, kWidth, kHeight)
                        : perspectiveView({latitude, longitude}, kSize, kWidth, kHeight, degrees);
}

/// A context, and a volume in it.
struct Stage
{
    View view;
    Field field = blobs();
    Scene scene;
    std::unique_ptr<OffscreenContext> context;
    std::unique_ptr<SceneDrawing> drawing;
    bool core;

    explicit Stage(const View& v, OffscreenProfile profile = OffscreenProfile::Compatibility, int bricks = 1,
                   int stackAxis = -1)
        : view(v), core(profile == OffscreenProfile::Core)
    {
        scene.volume = &field;
        scene.view = view;
        scene.width = kWidth;
        scene.height = kHeight;
        scene.stackAxis = stackAxis;
        if (stackAxis >= 0) scene.planes = SamplingPlanes::axisAligned;
        if (bricks > 1) scene.overlap = 1;
        context = openFor(scene, profile);
        if (!context) throw std::runtime_error("no context");
        DrawOptions options;
        options.bricks = bricks;
        drawing = std::make_unique<SceneDrawing>(*context, scene, options);
    }
    voBrickSetCollection* volume() { return &drawing->volume(); }

    void setState(const std::array<float, 4>& color = {1, 1, 1, 1})
    {
        const GladGLContext& gl = context->gl();
        if (core) {
            voState::setModelMatrix(view.model.data());
            voState::setProjectionMatrix(view.projection.data());
            voState::setColor(color[0], color[1], color[2], color[3]);
        } else {
            gl.MatrixMode(GL_PROJECTION);
            gl.LoadMatrixd(view.projection.data());
            gl.MatrixMode(GL_MODELVIEW);
            gl.LoadMatrixd(view.model.data());
            gl.Color4f(color[0], color[1], color[2], color[3]);
        }
        gl.Enable(GL_BLEND);
        gl.BlendEquation(GL_FUNC_ADD);
        gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        gl.ClearColor(0, 0, 0, 0);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    std::vector<float> draw(voutParts& parts, float step = 1,
                            voSamplingMode mode = voSamplingModeScope::VIEWPORT_ALIGNED)
    {
        setState();
        float period[3] = {step, step, step};
        EXPECT_EQ(parts.draw(view.model.data(), view.projection.data(), mode, voSamplingSpaceScope::OBJECT,
                             period, 1024),
                  0);
        expectNoError();
        return context->readFloats();
    }
};

/// What a part shows at a point of the space of all.
struct ReferencePart
{
    std::function<bool(const dvec3&)> contains; ///< a place in its volume
    std::vector<float> table;
    glm::dmat4 matrix{1};
    std::array<double, 4> color{1, 1, 1, 1};
};

/// The samples of parts on planes, from the farthest.
class ReferenceParts
{
public:
    ReferenceParts(const Stage& stage, std::vector<ReferencePart> parts)
        : stage_(stage), parts_(std::move(parts))
    {
        for (const ReferencePart& part : parts_) {
            Scene& scene = scenes_.emplace_back(stage.scene);
            scene.classification =
                part.table.empty() ? Classification::none : Classification::postInterpolation;
            scene.table = part.table;
            toVoxels_.push_back(glm::inverse(part.matrix));
        }
    }

    /// Red, green, blue and opacity of each part at a point.
    void add(const dvec3& point, double length, glm::dvec4& pixel) const
    {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const ReferencePart& part = parts_[i];
            const dvec3 voxel(toVoxels_[i] * glm::dvec4(point, 1));
            const double margin = 0.5 * stage_.scene.overlap;
            bool inside = part.contains(voxel);
            for (int axis = 0; axis < 3; ++axis)
                inside = inside && voxel[axis] >= margin && voxel[axis] <= kExtent[axis] - margin;
            if (!inside) continue;
            const std::array<double, 4> sample = referenceSample(scenes_[i], voxel);
            const double alpha = 1 - std::pow(1 - sample[3] * part.color[3], length);
            for (int c = 0; c < 3; ++c)
                pixel[c] += alpha * (sample[std::size_t(c)] * part.color[std::size_t(c)] - pixel[c]);
            pixel.a += alpha * (1 - pixel.a);
        }
    }

    /// On planes of a geometry that has these corners: one opacity a plane.
    Picture onPlanes(const std::vector<dvec3>& corners) const
    {
        Scene scene = stage_.scene;
        for (const dvec3& corner : corners)
            scene.geometry.push_back({corner, corner, corner, corner});
        const ReferencePlanes planes = referencePlanes(scene);
        return picture([&](const dvec3& start, const dvec3& along, glm::dvec4& pixel) {
            for (const double offset : planes.offsets) {
                dvec3 point = start + (offset - glm::dot(planes.normal, start)) /
                                          glm::dot(planes.normal, along) * along;
                // Or rounding decides between slices.
                if (scene.stackAxis >= 0) point[scene.stackAxis] = std::floor(point[scene.stackAxis]) + 0.5;
                add(point, 1, pixel);
            }
        });
    }

    /// Along the whole ray, opacity counting for a length of 1.
    Picture integral() const
    {
        constexpr double kStep = 0.04;
        return picture([&](const dvec3& start, const dvec3& along, glm::dvec4& pixel) {
            const double length = glm::length(along);
            const dvec3 direction = along / length;
            const double middle = glm::dot(0.5 * kExtent - start, direction);
            for (double t = middle + 30; t > middle - 30; t -= kStep)
                if (t > 0 && t < length) add(start + t * direction, kStep, pixel);
        });
    }

private:
    template <typename Ray>
    Picture picture(Ray ray) const
    {
        const glm::dmat4 fromDevice = glm::inverse(glm::make_mat4(stage_.view.projection.data()) *
                                                   glm::make_mat4(stage_.view.model.data()));
        Picture result{kWidth, kHeight, {}, {}};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const glm::dvec2 device((2 * x + 1.0) / kWidth - 1, (2 * y + 1.0) / kHeight - 1);
                const glm::dvec4 near = fromDevice * glm::dvec4(device, -1, 1),
                                 far = fromDevice * glm::dvec4(device, 1, 1);
                const dvec3 start = dvec3(near) / near.w;
                glm::dvec4 pixel(0);
                ray(start, dvec3(far) / far.w - start, pixel);
                result.rgba.insert(result.rgba.end(), {pixel.r, pixel.g, pixel.b, pixel.a});
            }
        result.unmasked.assign(std::size_t(kWidth * kHeight), 1);
        return result;
    }

    const Stage& stage_;
    std::vector<ReferencePart> parts_;
    std::vector<Scene> scenes_;
    std::vector<glm::dmat4> toVoxels_;
};

std::vector<dvec3> boxCorners(const dvec3& lower, const dvec3& upper)
{
    std::vector<dvec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z);
    return corners;
}

/// The corners of what a plane leaves of the volume's box.
std::vector<dvec3> cutCorners(const glm::dvec4& plane)
{
    const std::vector<dvec3> box = boxCorners(dvec3(0), kExtent);
    std::vector<dvec3> corners;
    const auto distance = [&](const dvec3& p) { return glm::dot(plane, glm::dvec4(p, 1)); };
    for (std::size_t i = 0; i < 8; ++i) {
        if (distance(box[i]) >= 0) corners.push_back(box[i]);
        for (const std::size_t bit : {1u, 2u, 4u}) {
            const dvec3 &a = box[i], &b = box[i ^ bit];
            if (distance(a) * distance(b) < 0)
                corners.push_back(a + distance(a) / (distance(a) - distance(b)) * (b - a));
        }
    }
    return corners;
}

void expectAlike(const std::vector<float>& drawn, const Picture& reference, double decibels)
{
    const Comparison comparison = compare(drawn, reference);
    EXPECT_GE(comparison.psnrAll, decibels) << comparison.summary();
    EXPECT_GT(comparison.opaquePixels, 300u);
}

class VoutParts : public testing::TestWithParam<OffscreenProfile>
{
};

INSTANTIATE_TEST_SUITE_P(, VoutParts,
                         testing::Values(OffscreenProfile::Compatibility, OffscreenProfile::Core),
                         [](const auto& profile) {
                             return profile.param == OffscreenProfile::Core ? "core" : "compatibility";
                         });

const float kPlane[4] = {0.6f, -0.5f, 0.62f, -8.2f};

bool isInFront(const dvec3& p)
{
    return double(kPlane[0]) * p.x + double(kPlane[1]) * p.y + double(kPlane[2]) * p.z + double(kPlane[3]) >=
           0;
}

TEST_P(VoutParts, oneOfThemIsWhatDrawUtilityDraws)
{
    Stage stage(viewFrom(20, 30, 40), GetParam(), 2);
    const Set box = wholeBox();
    std::vector<float> table = tableOf({1, 0.7, 0.4}, 0.3);
    const auto lookup = lookupOf(table);
    voutParts parts;
    parts.setLookupTable(parts.add(box.get(), Format::V3F, stage.volume()), lookup.get());
    const std::vector<float> drawn = stage.draw(parts);

    lookup->enable();
    stage.setState();
    float period[3] = {1, 1, 1};
    voState::setEngine(voEngineScope::SLICES);
    voGeometryActions::drawUtility(box.get(), Format::V3F, stage.volume(), nullptr,
                                   voSamplingSpaceScope::OBJECT, period, voDecorationFlagsScope::NONE);
    lookup->disable();
    EXPECT_GE(compareDrawn(drawn, stage.context->readFloats()).psnrAll, 60);
}

TEST_P(VoutParts, volumesOfInterestAreTheSamplesInside)
{
    for (const double degrees : {0.0, 50.0}) {
        Stage stage(viewFrom(25, -40, degrees), GetParam(), 2);
        const Set box = wholeBox();
        const Set half(voutSolidActions::inside(box.get(), kPlane, 1));
        const float lower[3] = {4, 3.5f, 2}, upper[3] = {15, 13, 12.5f};
        const Set inner(voutSolidActions::inside(box.get(), lower, upper)),
            outer(voutSolidActions::outside(box.get(), lower, upper));
        std::vector<float> table = tableOf({1, 0.7, 0.4}, 0.4);
        const auto lookup = lookupOf(table);
        const auto isInBox = [&](const dvec3& p) {
            return p.x >= 4 && p.x <= 15 && p.y >= 3.5 && p.y <= 13 && p.z >= 2 && p.z <= 12.5;
        };
        const auto isOutside = [&](const dvec3& p) { return !isInBox(p); };
        const glm::dvec4 plane(kPlane[0], kPlane[1], kPlane[2], kPlane[3]);
        struct Case
        {
            voIndexedTetraSet* set;
            std::function<bool(const dvec3&)> contains;
            std::vector<dvec3> corners;
        };
        for (const Case& c : {Case{half.get(), isInFront, cutCorners(plane)},
                              {inner.get(), isInBox, boxCorners({4, 3.5, 2}, {15, 13, 12.5})},
                              {outer.get(), isOutside, boxCorners(dvec3(0), kExtent)}}) {
            voutParts parts;
            parts.setLookupTable(parts.add(c.set, Format::V3F, stage.volume()), lookup.get());
            const ReferenceParts reference(stage, {{c.contains, table}});
            expectAlike(stage.draw(parts), reference.onPlanes(c.corners), 42);
            voState::setUnitLength(1);
            expectAlike(stage.draw(parts, 0.2f), reference.integral(), 42);
            voState::setUnitLength(0);
        }
    }
}

TEST_P(VoutParts, insideAndOutsideAreTheWhole)
{
    for (const auto mode : {voSamplingModeScope::VIEWPORT_ALIGNED, voSamplingModeScope::SPHERICAL}) {
        Stage stage(viewFrom(-15, 70, 60), GetParam(), 2);
        const Set box = wholeBox();
        const Set ball(voutGeoSphere(10, 9, 8, 6, 0).tessellate());
        const Set half(voutSolidActions::inside(box.get(), kPlane, 1)),
            rest(voutSolidActions::outside(box.get(), kPlane, 1));
        const Set core(voutSolidActions::inside(half.get(), ball.get())),
            hull(voutSolidActions::outside(half.get(), ball.get()));
        std::vector<float> table = tableOf({0.6, 0.9, 1}, 0.4);
        const auto lookup = lookupOf(table);
        voutParts whole, parts;
        whole.setLookupTable(whole.add(box.get(), Format::V3F, stage.volume()), lookup.get());
        for (voIndexedTetraSet* set : {rest.get(), core.get(), hull.get()})
            parts.setLookupTable(parts.add(set, Format::V3F, stage.volume()), lookup.get());
        const std::vector<float> expected = stage.draw(whole, 1, mode);
        EXPECT_GE(compareDrawn(stage.draw(parts, 1, mode), expected).psnrAll, 45);
        parts.setVisible(1, VO_FALSE);
        EXPECT_LE(compareDrawn(stage.draw(parts, 1, mode), expected).psnrAll, 35);
    }
}

TEST_P(VoutParts, eachHasItsMatrixColourAndTable)
{
    for (const double degrees : {0.0, 45.0}) {
        Stage stage(viewFrom(30, 20, degrees), GetParam(), 2);
        const Set box = wholeBox();
        const Set half(voutSolidActions::inside(box.get(), kPlane, 1)),
            rest(voutSolidActions::outside(box.get(), kPlane, 1));
        std::vector<float> warm = tableOf({1, 0.5, 0.2}, 0.35), cold = tableOf({0.2, 0.6, 1}, 0.5);
        const auto warmLookup = lookupOf(warm), coldLookup = lookupOf(cold);
        // Turned, scaled, and moved into the other half: they overlap.
        glm::dmat4 matrix = glm::make_mat4(multiply(translation(1, 3, -2), rotation(20, 1, 2, 3)).data());
        matrix = matrix * glm::make_mat4(scaling(1.1, 0.9, 0.8).data());
        voutParts parts;
        for (const auto& set : {rest.get(), half.get(), half.get()})
            parts.add(set, Format::V3F, stage.volume());
        parts.setLookupTable(0, coldLookup.get());
        parts.setLookupTable(1, warmLookup.get());
        parts.setMatrix(1, glm::value_ptr(matrix));
        parts.setColor(1, 0.8f, 1, 0.9f, 0.7f);
        parts.setVisible(2, VO_FALSE);

        std::vector<dvec3> corners = cutCorners(-glm::dvec4(kPlane[0], kPlane[1], kPlane[2], kPlane[3]));
        for (const dvec3& corner : cutCorners({kPlane[0], kPlane[1], kPlane[2], kPlane[3]}))
            corners.emplace_back(matrix * glm::dvec4(corner, 1));
        const auto isBehind = [](const dvec3& p) { return !isInFront(p); };
        const ReferencePart still{isBehind, cold}, moved{isInFront, warm, matrix, {0.8f, 1, 0.9f, 0.7f}};
        expectAlike(stage.draw(parts), ReferenceParts(stage, {still, moved}).onPlanes(corners), 42);
        voState::setUnitLength(1);
        expectAlike(stage.draw(parts, 0.2f), ReferenceParts(stage, {still, moved}).integral(), 42);
        voState::setUnitLength(0);

        // A part without a table between others, and without its colour and matrix.
        parts.setVisible(2, VO_TRUE);
        parts.resetColor(1);
        parts.setMatrix(1, nullptr);
        parts.setColor(2, 0.3f, 0.2f, 0.1f, 0.15f);
        const ReferencePart plain{isInFront, {}, glm::dmat4(1), {0.3f, 0.2f, 0.1f, 0.15f}};
        expectAlike(
            stage.draw(parts),
            ReferenceParts(stage, {still, {isInFront, warm}, plain}).onPlanes(boxCorners(dvec3(0), kExtent)),
            42);
    }
}

TEST_P(VoutParts, stacksOfSlicesGoAlongTheirAxis)
{
    // From above: XY slices.
    Stage stage(viewFrom(70, 20, 0), GetParam(), 1, 2);
    const Set box = wholeBox();
    std::vector<float> warm = tableOf({1, 0.5, 0.2}, 0.35), cold = tableOf({0.2, 0.6, 1}, 0.5);
    const auto warmLookup = lookupOf(warm), coldLookup = lookupOf(cold);
    glm::dmat4 matrix = glm::make_mat4(multiply(translation(5, -3, 2), rotation(30, 0, 0, 1)).data());
    voutParts parts;
    for (int i = 0; i < 2; ++i)
        parts.add(box.get(), Format::V3F, stage.volume());
    parts.setLookupTable(0, warmLookup.get());
    parts.setLookupTable(1, coldLookup.get());
    parts.setMatrix(1, glm::value_ptr(matrix));
    std::vector<dvec3> corners = boxCorners(dvec3(0), kExtent);
    for (const dvec3& corner : boxCorners(dvec3(0), kExtent))
        corners.emplace_back(matrix * glm::dvec4(corner, 1));
    const auto all = [](const dvec3&) { return true; };
    expectAlike(stage.draw(parts),
                ReferenceParts(stage, {{all, warm}, {all, cold, matrix}}).onPlanes(corners), 42);

    matrix = glm::make_mat4(rotation(30, 1, 0, 0).data());
    parts.setMatrix(1, glm::value_ptr(matrix));
    float period[3] = {1, 1, 1};
    EXPECT_NE(parts.draw(stage.view.model.data(), stage.view.projection.data(), voSamplingModeScope::DEFAULT,
                         voSamplingSpaceScope::OBJECT, period, 100),
              0);
    expectUnsupported("tilts the slices");
}

TEST_P(VoutParts, recordsWithColoursAndCoordinatesKeepThem)
{
    Stage stage(viewFrom(20, 30, 0), GetParam());
    const Set box = wholeBox();
    const int count = box->getVertexData()->getCount(), indices = box->getIndices()->getCount();
    voIndexedTetraSet colored(count, 9, indices); // T3F_C3F_V3F: the volume, drawn 3 voxels further along x
    for (int vertex = 0; vertex < count; ++vertex) {
        const float* p = (*box->getVertexData())[vertex];
        const float record[9] = {p[0], p[1], p[2], 0.2f, 0.6f, 0.9f, p[0] + 3, p[1], p[2]};
        std::copy_n(record, 9, (*colored.getVertexData())[vertex]);
    }
    std::copy_n(box->getIndices()->getDataPtr(), indices, colored.getIndices()->getDataPtr());
    colored.getVertexData()->setCount(count);
    colored.getIndices()->setCount(indices);
    std::vector<float> table = tableOf({1, 1, 1}, 0.4);
    const auto lookup = lookupOf(table);
    voutParts parts;
    parts.setLookupTable(parts.add(&colored, Format::T3F_C3F_V3F, stage.volume()), lookup.get());
    const glm::dmat4 shift = glm::make_mat4(translation(3, 0, 0).data());
    const auto all = [](const dvec3&) { return true; };
    const std::vector<dvec3> corners = boxCorners(dvec3(3, 0, 0), kExtent + dvec3(3, 0, 0));
    expectAlike(stage.draw(parts),
                ReferenceParts(stage, {{all, table, shift, {0.2f, 0.6f, 0.9f, 1}}}).onPlanes(corners), 42);
    parts.setColor(0, 0.5f, 1, 0.5f, 0.6f);
    expectAlike(stage.draw(parts),
                ReferenceParts(stage, {{all, table, shift, {0.1, 0.6f, 0.45, 0.6f}}}).onPlanes(corners), 42);
}

TEST_P(VoutParts, leaveTablesTexturingAndTheCurrentColourAsTold)
{
    Stage stage(viewFrom(20, 30, 0), GetParam());
    const Set box = wholeBox();
    const auto drawPlainly = [&] {
        stage.setState({0.5f, 0.6f, 0.7f, 0.4f});
        float period[3] = {1, 1, 1};
        voState::setEngine(voEngineScope::SLICES);
        voGeometryActions::drawUtility(box.get(), Format::V3F, stage.volume(), nullptr,
                                       voSamplingSpaceScope::OBJECT, period, voDecorationFlagsScope::NONE);
        return stage.context->readFloats();
    };
    const std::vector<float> before = drawPlainly();
    std::vector<float> table = tableOf({1, 0.5, 0.2}, 0.35);
    const auto lookup = lookupOf(table);
    voutParts parts;
    for (int i = 0; i < 2; ++i)
        parts.add(box.get(), Format::V3F, stage.volume());
    parts.setLookupTable(1, lookup.get());
    parts.setColor(1, 1, 0, 0, 1);
    stage.draw(parts);
    EXPECT_EQ(drawPlainly(), before);
    EXPECT_FALSE(!stage.core && stage.context->gl().IsEnabled(GL_TEXTURE_3D));
}

TEST_P(VoutParts, wrongArgumentsAreRefused)
{
    Stage stage(viewFrom(20, 30, 0), GetParam());
    const Set box = wholeBox();
    voutParts parts;
    float period[3] = {1, 1, 1};
    const auto draw = [&](GLdouble* model, int mode, int space, int most) {
        return parts.draw(model, stage.view.projection.data(), voSamplingMode(mode), voSamplingSpace(space),
                          period, most);
    };
    EXPECT_EQ(draw(stage.view.model.data(), 0, 0, 10), 0); // nothing to draw
    expectNoError();
    EXPECT_EQ(parts.add(nullptr, Format::V3F, stage.volume()), -1);
    expectBadValue("tetraSet is NULL");
    EXPECT_EQ(parts.add(box.get(), Format::V3F, nullptr), -1);
    expectBadValue("volume is NULL");
    EXPECT_EQ(parts.add(box.get(), Format::T3F_V3F, stage.volume()), -1);
    expectBadValue("6 values");
    EXPECT_EQ(parts.add(box.get(), Format::V3F, stage.volume()), 0);
    EXPECT_EQ(parts.getCount(), 1);
    parts.setColor(1, 0, 0, 0, 0);
    expectBadValue("part 1 of 1");
    parts.setLookupTable(-1, nullptr);
    expectBadValue("part -1 of 1");
    const GLdouble flat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    parts.setMatrix(0, flat);
    expectBadValue("singular");
    Matrix zero{};
    EXPECT_NE(draw(zero.data(), 0, 0, 10), 0);
    expectBadValue("modelMatrix is singular");
    EXPECT_NE(draw(nullptr, 0, 0, 10), 0);
    expectBadValue("modelMatrix is NULL");
    EXPECT_NE(draw(stage.view.model.data(), 9, 0, 10), 0);
    expectBadEnum();
    EXPECT_NE(draw(stage.view.model.data(), 0, 9, 10), 0);
    expectBadEnum();
    EXPECT_NE(draw(stage.view.model.data(), 0, voSamplingSpaceScope::PRIMITIVE, 10), 0);
    expectUnsupported("PRIMITIVE");
    EXPECT_NE(draw(stage.view.model.data(), 0, 0, 0), 0);
    expectBadValue("at most 0 samples");
    period[1] = 0;
    EXPECT_NE(draw(stage.view.model.data(), 0, 0, 10), 0);
    expectBadValue("period");
}

} // namespace
