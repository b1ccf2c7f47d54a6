// A program's own volume in OpenGL: both engines beside the reference in double precision, and behind what
// the program has drawn before, by closed forms.

#include "program_volume.h" // before headers that name OpenGL's own

#include "support/styled_reference.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <string>

#include <vo/Error.h>
#include <vo/x3d/StyledVolume.h>

#include "x3d/plane_spacing.h"

namespace {

using namespace vo;
using namespace program_volume;
using vo::test::psnr;
using vo::test::styledReference;
using vo::test::styleWithReference;

/// Decibels of all four channels, peak 1.
constexpr double kAlike = 45.0;

/// What voX3DStyledVolume says that it draws: opacities are those of a voxel, lit from the eye.
StyledScene sceneOf(const Voxels& voxels, const glm::dmat4& model, const glm::dmat4& projection)
{
    auto texture = std::make_shared<VoxelTexture>();
    texture->size = {kVoxels, kVoxels, kVoxels};
    for (const unsigned char value : voxels.values)
        texture->texels.push_back(std::byte{value});
    StyledScene scene;
    scene.width = scene.height = kPixels;
    scene.clipFromEye = projection;
    scene.background.opacity = 0.0f;
    StyledVolume volume;
    volume.voxels = texture;
    volume.dimensions = glm::vec3(kVoxels);
    volume.worldFromLocal = glm::translate(model, glm::dvec3(0.5 * kVoxels));
    StyleLight headlight;
    headlight.direction = glm::vec3(glm::inverse(glm::dmat3(model)) * glm::dvec3(0, 0, -1));
    volume.surroundings.lights = {headlight};
    scene.volumes = {volume};
    return scene;
}

/// Of planes as far apart as the library has them where nobody chooses (plane_spacing_test).
std::vector<double> referenceOf(StyledScene scene)
{
    StyledVolume& volume = scene.volumes[0];
    volume.spacing = planeSpacing(scene, volume, usualSampling(volume)).distance;
    return styledReference(scene);
}

class StyledVolumeGl : public ProgramScreen
{
protected:
    /// By a light along -x, with those that the style throws, and not without.
    void expectShadows(voX3DStyledVolume& volume, voX3DNode& style, const glm::dmat4& projection,
                       const std::vector<double>& reference)
    {
        volume.setHeadlight(VO_FALSE);
        volume.addLight(-1, 0, 0, 1);
        for (const voEngine engine : kEngines) {
            style.setInt("shadows", 0);
            context_->clear();
            EXPECT_LT(psnr(drawn(volume, turned(), projection, engine), reference), 35.0)
                << "shadows change next to nothing";
            style.setInt("shadows", 1);
            context_->clear();
            EXPECT_GT(psnr(drawn(volume, turned(), projection, engine), reference), kAlike) << engine;
        }
    }

    /// An opaque rectangle as a program would have drawn it: its colour, and its depth in the window.
    void fill(int x, int y, int width, int height, const glm::vec4& color, double depth)
    {
        gl().Enable(GL_SCISSOR_TEST);
        gl().Scissor(x, y, width, height);
        gl().ClearColor(color.r, color.g, color.b, color.a);
        gl().ClearDepth(depth);
        gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl().Disable(GL_SCISSOR_TEST);
        gl().ClearDepth(1.0);
    }
};

INSTANTIATE_TEST_SUITE_P(Profiles, StyledVolumeGl, vo::test::kBothProfiles, vo::test::profileName);

TEST_P(StyledVolumeGl, bothEnginesDrawTheReference)
{
    const Voxels voxels;
    voX3DScene scene;
    const auto node = [&](const char* type) { return scene.createNode(type); };
    voX3DNode shaded = node("ShadedVolumeStyle");
    shaded.setInt("lighting", 1);
    Shaded lit;
    lit.lighting = true;
    struct Case
    {
        const char* name;
        voX3DNode node;
        vo::test::ReferenceStyle style;
    };
    const Case cases[] = {{"map", voX3DNode(), OpacityMap{}},
                          {"cartoon", node("CartoonVolumeStyle"), Cartoon{}},
                          {"boundary", node("BoundaryEnhancementVolumeStyle"), BoundaryEnhancement{}},
                          {"shaded", shaded, lit}};
    const glm::dmat4 projections[] = {glm::ortho(-8.0, 8.0, -8.0, 8.0, 1.0, 30.0),
                                      glm::perspective(1.0, 1.0, 1.0, 30.0)};
    for (const Case& each : cases)
        for (const glm::dmat4& projection : projections) {
            StyledScene expected = sceneOf(voxels, turned(), projection);
            expected.volumes[0].chains = {{styleWithReference(each.style)}};
            const std::vector<double> reference = referenceOf(expected);
            voX3DStyledVolume volume(scene, each.node, const_cast<voBrickSetCollection*>(&voxels.bricks));
            for (const voEngine engine : kEngines) {
                context_->clear();
                EXPECT_GT(psnr(drawn(volume, turned(), projection, engine), reference), kAlike)
                    << each.name << ", engine " << engine;
            }
            EXPECT_GT(reference[4 * (kPixels / 2 * kPixels + kPixels / 2) + 3], 0.3) << each.name;
        }
}

/// Two soft balls, one of which keeps the light of -x in eye space from the other.
void setTwoBalls(Voxels& voxels)
{
    const glm::dvec3 middle(0.5 * (kVoxels - 1));
    const glm::dvec3 way = glm::inverse(glm::dmat3(turned())) * glm::dvec3(2.2, 0, 0);
    for (int i = 0; i < kVoxels * kVoxels * kVoxels; ++i) {
        const glm::dvec3 place(i % kVoxels, i / kVoxels % kVoxels, i / kVoxels / kVoxels);
        const double distance =
            std::min(glm::length(place - middle - way), glm::length(place - middle + way));
        voxels.values[static_cast<std::size_t>(i)] =
            static_cast<unsigned char>(std::clamp(380.0 - 120.0 * distance, 0.0, 255.0));
    }
}

TEST_P(StyledVolumeGl, shadowsFallAsInTheReference)
{
    Voxels voxels;
    setTwoBalls(voxels);
    voX3DScene scene;
    voX3DNode shaded = scene.createNode("ShadedVolumeStyle");
    shaded.setInt("lighting", 1);
    const glm::dmat4 projection = glm::ortho(-8.0, 8.0, -8.0, 8.0, 1.0, 30.0);
    Shaded fields;
    fields.lighting = fields.shadows = true;
    StyledScene expected = sceneOf(voxels, turned(), projection);
    expected.volumes[0].chains = {{styleWithReference(fields)}};
    StyleLight side = expected.volumes[0].surroundings.lights[0];
    side.direction = glm::vec3(glm::inverse(glm::dmat3(turned())) * glm::dvec3(-1, 0, 0));
    expected.volumes[0].surroundings.lights = {side};
    const std::vector<double> reference = referenceOf(expected);
    voX3DStyledVolume volume(scene, shaded, const_cast<voBrickSetCollection*>(&voxels.bricks));
    expectShadows(volume, shaded, projection, reference);
}

/// The volume as five tetrahedra, bent: records of voxel coordinates and positions, in voxels.
struct Bent
{
    Bent()
    {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 place(corner & 1, corner >> 1 & 1, corner >> 2);
            const glm::vec3 moved(0.5f + place.x * (1.0f - 0.3f * place.z),
                                  place.y + 0.25f * place.z * place.x, 1.2f * place.z - 0.2f * place.y);
            for (const glm::vec3& each : {place, moved})
                for (int axis = 0; axis < 3; ++axis)
                    records.push_back(kVoxels * each[axis]);
            tetras->places.push_back(place);
            tetras->positions.push_back(float(kVoxels) * moved);
        }
        tetras->indices.assign(std::begin(indices), std::end(indices));
    }

    std::vector<float> records;
    int indices[20] = {0, 3, 5, 6, 1, 3, 5, 0, 2, 3, 0, 6, 4, 5, 6, 0, 7, 3, 6, 5};
    std::shared_ptr<StyledTetras> tetras = std::make_shared<StyledTetras>();
};

/// The edges of the tetrahedra beside the same in voxels, on average.
double unitOf(const StyledTetras& tetras)
{
    double space = 0.0, voxels = 0.0;
    for (std::size_t i = 0; i < tetras.indices.size(); ++i) {
        const auto a = std::size_t(tetras.indices[i - i % 4]), b = std::size_t(tetras.indices[i]);
        space += glm::distance(glm::dvec3(tetras.positions[a]), glm::dvec3(tetras.positions[b]));
        voxels += kVoxels * glm::distance(glm::dvec3(tetras.places[a]), glm::dvec3(tetras.places[b]));
    }
    return space / voxels;
}

TEST_P(StyledVolumeGl, shadowsInBentTetrahedraFallAsInTheReference)
{
    Voxels voxels;
    setTwoBalls(voxels);
    Bent bent;
    voIndexedTetraSet tetras(bent.records.data(), 8, 6, bent.indices, 20);
    voX3DScene scene;
    voX3DNode shaded = scene.createNode("ShadedVolumeStyle");
    shaded.setInt("lighting", 1);
    const glm::dmat4 projection = glm::ortho(-6.0, 6.0, -6.0, 6.0, 1.0, 30.0);
    Shaded fields;
    fields.lighting = fields.shadows = true;
    StyledScene expected = sceneOf(voxels, turned(), projection);
    StyledVolume& shown = expected.volumes[0];
    shown.chains = {{styleWithReference(fields)}};
    shown.worldFromLocal = turned();
    shown.tetras = bent.tetras;
    shown.unitLength = unitOf(*bent.tetras);
    shown.dimensions *= static_cast<float>(shown.unitLength);
    StyleLight side;
    side.direction = glm::vec3(glm::inverse(glm::dmat3(turned())) * glm::dvec3(-1, 0, 0));
    shown.surroundings.lights = {side};
    const std::vector<double> reference = referenceOf(expected);
    voX3DStyledVolume volume(scene, shaded, const_cast<voBrickSetCollection*>(&voxels.bricks), &tetras,
                             voInterleavedArrayTypeScope::T3F_V3F);
    expectShadows(volume, shaded, projection, reference);
}

// ---- What the program has drawn before

constexpr int kValue = 51;
constexpr double kOpacity = kValue / 255.0;

/// A volume that fills the picture, from z = -12 to -4 before the eye.
glm::dmat4 ahead()
{
    return glm::translate(glm::dmat4(1.0), glm::dvec3(-0.5 * kVoxels, -0.5 * kVoxels, -12.0));
}

glm::dmat4 ahead(bool perspective)
{
    return perspective ? glm::frustum(-0.02, 0.02, -0.02, 0.02, 1.0, 33.0)
                       : glm::ortho(-3.0, 3.0, -3.0, 3.0, 1.0, 33.0);
}

/// Where something `distance` before the eye lies in the window.
double windowDepth(const glm::dmat4& projection, double distance)
{
    const glm::dvec4 clip = projection * glm::dvec4(0.0, 0.0, -distance, 1.0);
    return 0.5 + 0.5 * clip.z / clip.w;
}

/// The grey of so many voxels over a colour.
glm::dvec4 over(double voxels, const glm::dvec4& behind)
{
    const double alpha = 1.0 - std::pow(1.0 - kOpacity, voxels);
    return alpha * glm::dvec4(glm::dvec3(kOpacity), 1.0) + (1.0 - alpha) * behind;
}

void expectColor(const float* pixel, const glm::dvec4& expected, const std::string& what)
{
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(pixel[c], expected[c], 2e-4) << what << ", channel " << c;
}

TEST_P(StyledVolumeGl, opaqueThingsInTheMiddleHideTheVoxelsBehindThem)
{
    const Voxels voxels(kValue);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, voX3DNode(), const_cast<voBrickSetCollection*>(&voxels.bricks));
    const glm::vec4 red(0.5f, 0.25f, 0.125f, 1.0f);
    for (const voEngine engine : kEngines)
        for (const bool perspective : {false, true}) {
            const std::string what =
                std::string(perspective ? "perspective" : "parallel") + ", engine " + std::to_string(engine);
            const glm::dmat4 projection = ahead(perspective);
            context_->clear();
            fill(0, 0, 16, kPixels, red, windowDepth(projection, 9.0));
            fill(16, 0, 8, kPixels, red, windowDepth(projection, 2.0));
            fill(24, 0, 8, kPixels, red, windowDepth(projection, 20.0));
            const auto seen = drawn(volume, ahead(), projection, engine);
            expectColor(pixelAt(seen, 8, 24), over(5.0, red), what + ", in the middle");
            expectColor(pixelAt(seen, 20, 24), red, what + ", in front");
            expectColor(pixelAt(seen, 28, 24), over(8.0, red), what + ", behind");
            expectColor(pixelAt(seen, 40, 24), over(8.0, glm::dvec4(0.0)), what + ", nowhere");
        }
}

TEST_P(StyledVolumeGl, rangesOfDepthsAreTheCallers)
{
    const Voxels voxels(kValue);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, voX3DNode(), const_cast<voBrickSetCollection*>(&voxels.bricks));
    const glm::dmat4 projection = ahead(true);
    for (const voEngine engine : kEngines) {
        context_->clear();
        gl().DepthRange(0.25, 0.5);
        fill(0, 0, kPixels, kPixels, glm::vec4(1.0f), 0.25 + 0.25 * windowDepth(projection, 9.0));
        const auto seen = drawn(volume, ahead(), projection, engine);
        gl().DepthRange(0.0, 1.0);
        expectColor(pixelAt(seen, 24, 24), over(5.0, glm::dvec4(1.0)), "engine " + std::to_string(engine));
    }
}

TEST_P(StyledVolumeGl, projectionsEndAtOpaqueThings)
{
    Voxels voxels(0);
    for (int z = 0; z < kVoxels; ++z)
        std::fill_n(voxels.values.begin() + z * kVoxels * kVoxels, kVoxels * kVoxels, z < 4 ? 200 : 50);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, scene.createNode("ProjectionVolumeStyle"),
                             const_cast<voBrickSetCollection*>(&voxels.bricks));
    const glm::dmat4 projection = ahead(false);
    for (const voEngine engine : kEngines) {
        context_->clear();
        fill(0, 0, 16, kPixels, glm::vec4(1.0f), windowDepth(projection, 7.0));
        const auto seen = drawn(volume, ahead(), projection, engine);
        EXPECT_NEAR(pixelAt(seen, 8, 24)[0], 50 / 255.0, 1e-3) << engine << ": the front half alone";
        EXPECT_NEAR(pixelAt(seen, 40, 24)[0], 200 / 255.0, 1e-3) << engine;
    }
}

TEST_P(StyledVolumeGl, framebuffersWithSeveralSamplesHaveDepthsToo)
{
    const Voxels voxels(kValue);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, voX3DNode(), const_cast<voBrickSetCollection*>(&voxels.bricks));
    const glm::dmat4 projection = ahead(false);
    GLuint framebuffer = 0, buffers[2];
    gl().GenFramebuffers(1, &framebuffer);
    gl().GenRenderbuffers(2, buffers);
    gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const std::pair<GLenum, GLenum> parts[] = {{GL_COLOR_ATTACHMENT0, GL_RGBA32F},
                                               {GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24}};
    for (int i = 0; i < 2; ++i) {
        gl().BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        gl().RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, parts[i].second, kPixels, kPixels);
        gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, parts[i].first, GL_RENDERBUFFER, buffers[i]);
    }
    ASSERT_EQ(gl().CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
    gl().Viewport(0, 0, kPixels, kPixels);
    for (const voEngine engine : kEngines) {
        gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        fill(0, 0, kPixels, kPixels, glm::vec4(1.0f), windowDepth(projection, 9.0));
        gl().Enable(GL_SCISSOR_TEST);
        gl().Scissor(0, 0, kPixels, kPixels - 4);
        ASSERT_TRUE(
            volume.draw(glm::value_ptr(ahead()), glm::value_ptr(projection), kPixels, kPixels, engine))
            << voError::getErrorString();
        EXPECT_TRUE(gl().IsEnabled(GL_SCISSOR_TEST));
        gl().Disable(GL_SCISSOR_TEST);
        GLint bound = 0;
        gl().GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
        EXPECT_EQ(GLuint(bound), framebuffer);
        gl().GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
        EXPECT_EQ(GLuint(bound), framebuffer);
        gl().GetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
        EXPECT_EQ(GLuint(bound), buffers[1]);
        EXPECT_EQ(gl().GetError(), GLenum(GL_NO_ERROR));
        gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, context_->framebuffer());
        gl().BlitFramebuffer(0, 0, kPixels, kPixels, 0, 0, kPixels, kPixels, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        const auto seen = context_->readFloats();
        expectColor(pixelAt(seen, 24, 24), over(5.0, glm::dvec4(1.0)), "engine " + std::to_string(engine));
        expectColor(pixelAt(seen, 24, kPixels - 2), glm::dvec4(1.0), "beyond the scissor");
    }
    volume.releaseDrawing();
    gl().DeleteFramebuffers(1, &framebuffer);
    gl().DeleteRenderbuffers(2, buffers);
}

TEST_P(StyledVolumeGl, withoutDepthsNothingIsHidden)
{
    OffscreenRequest request;
    request.withDepth = request.withStencil = false;
    context_ = opened(request);
    ASSERT_TRUE(context_);
    const Voxels voxels(kValue);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, voX3DNode(), const_cast<voBrickSetCollection*>(&voxels.bricks));
    context_->clear();
    const auto seen = drawn(volume, ahead(), ahead(false), voEngineScope::CAST);
    expectColor(pixelAt(seen, 24, 24), over(8.0, glm::dvec4(0.0)), "without depths");
}

} // namespace
