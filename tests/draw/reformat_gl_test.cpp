// Cross-sections as programs draw them, against trilinear samples in float64.

#include "draw/draw_scene.h"

#include "support/compare.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;
using Format = voInterleavedArrayTypeScope;

constexpr int kPixels = 160;

/// Graphics cards filter textures with 8 bits of weight, software with floats.
double barFor(const vo::OffscreenContext& context)
{
    return context.description().find("llvmpipe") != std::string::npos ? 70.0 : 45.0;
}

/// Where a section is drawn, and which part of it.
struct Section
{
    glm::dvec3 normal;
    double offset = 0.0;
    std::vector<glm::dvec3> polygon; ///< counterclockwise, convex; empty: the whole plane
};

/// A section of a scene's volume computed pixel by pixel.
class DirectSection
{
public:
    DirectSection(const Scene& scene, int stackAxis, const Section& section)
        : scene_(scene), section_(section),
          fromClip_(glm::inverse(glm::make_mat4(scene.view.projection.data()) *
                                 glm::make_mat4(scene.view.model.data())))
    {
        upper_ = glm::dvec3(scene.volume->size.x, scene.volume->size.y, scene.volume->size.z);
        for (int axis = 0; axis < 3; ++axis)
            if (axis != stackAxis) {
                lower_[axis] += 0.5 * scene.overlap;
                upper_[axis] -= 0.5 * scene.overlap;
            }
    }

    Picture picture() const
    {
        Picture result;
        result.width = scene_.width;
        result.height = scene_.height;
        for (int y = 0; y < scene_.height; ++y)
            for (int x = 0; x < scene_.width; ++x) {
                const std::optional<glm::dvec3> point = hit(x + 0.5, y + 0.5);
                std::array<double, 4> rgba{};
                if (point) rgba = referenceSample(scene_, *point);
                if (point) rgba[3] = 1.0;
                result.rgba.insert(result.rgba.end(), rgba.begin(), rgba.end());
                bool certain = true;
                for (const double dx : {-0.01, 0.01})
                    for (const double dy : {-0.01, 0.01})
                        certain = certain && hit(x + 0.5 + dx, y + 0.5 + dy).has_value() == point.has_value();
                result.unmasked.push_back(certain);
            }
        return result;
    }

private:
    glm::dvec3 unproject(double x, double y, double z) const
    {
        const glm::dvec4 p =
            fromClip_ * glm::dvec4(2 * x / scene_.width - 1, 2 * y / scene_.height - 1, z, 1);
        return glm::dvec3(p) / p.w;
    }

    std::optional<glm::dvec3> hit(double x, double y) const
    {
        const glm::dvec3 a = unproject(x, y, -1), b = unproject(x, y, 1);
        const double da = glm::dot(section_.normal, a) - section_.offset;
        const double db = glm::dot(section_.normal, b) - section_.offset;
        if ((da < 0) == (db < 0)) return std::nullopt;
        const glm::dvec3 p = a + (da / (da - db)) * (b - a);
        for (int axis = 0; axis < 3; ++axis)
            if (p[axis] < lower_[axis] || p[axis] > upper_[axis]) return std::nullopt;
        for (std::size_t i = 0; i < section_.polygon.size(); ++i) {
            const glm::dvec3 from = section_.polygon[i];
            const glm::dvec3 along = section_.polygon[(i + 1) % section_.polygon.size()] - from;
            if (glm::dot(section_.normal, glm::cross(along, p - from)) < 0) return std::nullopt;
        }
        return p;
    }

    const Scene& scene_;
    const Section& section_;
    glm::dmat4 fromClip_;
    glm::dvec3 lower_{0.0};
    glm::dvec3 upper_;
};

/// What a program does that shows a section.
std::vector<float> drawnSection(const vo::OffscreenContext& context, const Scene& scene,
                                const DrawOptions& options, voPlaneOrientation stack, const Section& section,
                                voInterleavedArrayType format)
{
    SceneDrawing drawing(context, scene, options);
    voBrickSetCollection& volume = drawing.volume();
    volume.setCurrentBrickSet(stack);
    voBrickSet* set = volume.getCurrentBrickSet();
    const int values = getValuesPerVertex(format);
    std::vector<std::unique_ptr<voIndexedFaceSet>> faces;
    std::vector<voIndexedFaceSetPtr> rows;
    for (int b = 0; b < set->getBrickCount(); ++b) {
        faces.push_back(std::make_unique<voIndexedFaceSet>(0, values, 0));
        rows.push_back(faces.back().get());
    }
    std::vector<voIndexedFaceSetPtrPtr> sets;
    for (voIndexedFaceSetPtr& row : rows)
        sets.push_back(&row);
    if (section.polygon.empty()) {
        float plane[4] = {float(section.normal.x), float(section.normal.y), float(section.normal.z),
                          float(-section.offset)};
        EXPECT_EQ(voGeometryActions::polygonizeMPR(plane, set, sets.data(), format), 0);
    } else {
        voVertexData polygon(int(section.polygon.size()), values);
        std::fill_n(polygon.getDataPtr(), section.polygon.size() * std::size_t(values), 1.0f);
        for (std::size_t i = 0; i < section.polygon.size(); ++i)
            for (int axis = 0; axis < 3; ++axis) {
                polygon[int(i)][values - 3 + axis] = float(section.polygon[i][axis]);
                if (hasTextureComponent(format)) polygon[int(i)][axis] = float(section.polygon[i][axis]);
            }
        polygon.setCount(int(section.polygon.size()));
        EXPECT_EQ(voGeometryActions::polygonizeMPR(&polygon, set, sets.data(), format), 0);
    }
    if (hasTextureComponent(format)) voAppearanceActions::xfmVox2TexCoords(set, 1, sets.data(), format);

    const GladGLContext& gl = context.gl();
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadMatrixd(scene.view.projection.data());
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadMatrixd(scene.view.model.data());
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    gl.Color4f(1, 1, 1, 1);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    voAppearanceActions::textureEnable(volume.getInterpolationType());
    if (!hasTextureComponent(format)) voAppearanceActions::texgenEnable();
    for (int b = 0; b < set->getBrickCount(); ++b) {
        voAppearanceActions::texgenSetEquation(set->getBrick(b));
        EXPECT_EQ(voAppearanceActions::textureBind(set->getBrick(b)), 0);
        voGeometryActions::draw(sets[std::size_t(b)][0], format);
    }
    voAppearanceActions::texgenDisable();
    voAppearanceActions::textureDisable(volume.getInterpolationType());
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::NO_ERROR);
    return context.readFloats();
}

struct ReformatGL : testing::Test
{
    ReformatGL()
    {
        const Field ball = ballField(field.size);
        for (std::size_t i = 0; i < field.values.size(); ++i)
            field.values[i] = std::max(field.values[i], ball.values[i]);
        field = quantised(field);
        scene.volume = &field;
        scene.width = scene.height = kPixels;
        scene.overlap = 1;
        scene.view = orthographicView({0, 0}, field.size, kPixels, kPixels);
        context = openFor(scene, OffscreenProfile::Compatibility);
    }

    /// A view whose middle does not pass along the plane, which would show nothing.
    View viewOnto(const Section& section, int number) const
    {
        for (const Angles& angles : randomViews(20, unsigned(number) + 1)) {
            const View view = number % 3 ? orthographicView(angles, field.size, kPixels, kPixels)
                                         : perspectiveView(angles, field.size, kPixels, kPixels, 40);
            const glm::dvec3 turned = glm::dmat3(glm::make_mat4(view.model.data())) * section.normal;
            if (std::abs(turned.z) > 0.5 * glm::length(turned)) return view;
        }
        throw std::runtime_error("no view onto the section");
    }

    void expectSections(voPlaneOrientation stack, voInterleavedArrayType format, int bricks)
    {
        const bool stacks = stack != voPlaneOrientationScope::UNSPECIFIED;
        const int stackAxis = stacks ? 3 - static_cast<int>(stack) : -1;
        std::mt19937 random(5 + unsigned(stack) + unsigned(format));
        std::normal_distribution<double> component;
        DrawOptions options;
        options.bricks = bricks;
        const glm::dvec3 centre(0.5 * field.size.x, 0.5 * field.size.y, 0.5 * field.size.z);
        for (int i = 0; i < 6; ++i) {
            Section section;
            section.normal =
                glm::normalize(glm::dvec3(component(random), component(random), component(random)));
            section.offset = glm::dot(section.normal, centre) + 3.0 * component(random);
            if (i == 0) section = {{0, 0, 1}, 0.75 * field.size.z, {}};
            if (i % 2) makeSquare(section, centre);
            scene.view = viewOnto(section, i);
            Scene drawn = scene;
            drawn.stackAxis = stackAxis;
            const Picture truth = DirectSection(scene, stackAxis, section).picture();
            const Comparison comparison =
                compare(drawnSection(*context, drawn, options, stack, section, format), truth);
            SCOPED_TRACE(testing::Message() << "section " << i << ": " << comparison.summary());
            EXPECT_GT(comparison.opaquePixels, 1000u);
            EXPECT_GE(comparison.psnrMasked, barFor(*context));
            EXPECT_LE(comparison.fractionOff, 0.003);
            worst = std::min(worst, comparison.psnrMasked);
        }
        RecordProperty("worst_dB", std::to_string(worst));
    }

    static void makeSquare(Section& section, const glm::dvec3& centre)
    {
        const glm::dvec3 middle =
            centre - section.normal * (glm::dot(section.normal, centre) - section.offset);
        const glm::dvec3 u = 12.0 * glm::normalize(glm::cross(section.normal, glm::dvec3(0.3, 0.5, 0.8)));
        const glm::dvec3 v = glm::cross(section.normal, u);
        for (const glm::dvec3& corner : {middle - u - v, middle + u - v, middle + u + v, middle - u + v})
            section.polygon.push_back(glm::dvec3(glm::vec3(corner)));
    }

    // Sizes differ: an exchanged axis shows.
    Field field = noiseField({40, 33, 36}, 3);
    Scene scene;
    std::unique_ptr<vo::OffscreenContext> context;
    double worst = 1e9;
};

using Stack = voPlaneOrientationScope;

TEST_F(ReformatGL, sectionsOfAVolumeAreTrilinear)
{
    expectSections(Stack::UNSPECIFIED, Format::V3F, 1);
    expectSections(Stack::UNSPECIFIED, Format::T3F_V3F, 3);
    expectSections(Stack::UNSPECIFIED, Format::C4F_V3F, 2);
}

TEST_F(ReformatGL, sectionsOfAStackAreTrilinear)
{
    expectSections(Stack::XY, Format::C4F_V3F, 1);
    expectSections(Stack::XZ, Format::C4F_V3F, 1);
    expectSections(Stack::YZ, Format::C4F_V3F, 1);
}

TEST_F(ReformatGL, sectionsOfAStackOfBricksAreTrilinear)
{
    expectSections(Stack::XY, Format::T3F_C4F_V3F, 2);
    expectSections(Stack::YZ, Format::C3F_V3F, 3);
}

} // namespace
