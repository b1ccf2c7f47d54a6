// Scenes with styles through OpenGL, beside the reference and closed forms.

#include "cast/cast_scene.h"
#include "draw/draw_scene.h"
#include "draw/volume_programs.h"
#include "style/shadow_textures.h"
#include "support/float_screen.h"
#include "support/styled_reference.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <stdexcept>

namespace {

using namespace vo;
using vo::test::psnr;
using vo::test::styledReference;
using vo::test::styleWithReference;

constexpr int kPixels = 64;
/// Decibels of all four channels, peak 1.
constexpr double kAlike = 45.0;
/// Where no edge lies near the middle of a pixel.
constexpr double kEqual = 75.0;

TexturePointer bytes(VoxelSize size, int components, const std::function<double(glm::dvec3, int)>& value)
{
    auto texture = std::make_shared<VoxelTexture>();
    texture->size = size;
    texture->components = components;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int c = 0; c < components; ++c) {
                    const glm::dvec3 place = (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(size.x, size.y, size.z);
                    texture->texels.push_back(static_cast<std::byte>(std::lround(255.0 * value(place, c))));
                }
    return texture;
}

TexturePointer constant(double value)
{
    return bytes({16, 16, 16}, 1, [=](glm::dvec3, int) { return value; });
}

double ballAt(const glm::dvec3& place)
{
    const double distance = glm::length((place - glm::dvec3(0.45, 0.5, 0.55)) * glm::dvec3(2.2, 2.0, 2.0));
    return 0.6 * glm::clamp(1.4 - 1.5 * distance, 0.0, 1.0) +
           0.1 * (1.0 + std::sin(9.0 * place.x + 5.0 * place.y)) / 2.0;
}

/// A soft ball and a wave.
TexturePointer ball(int components = 1)
{
    return bytes({24, 20, 16}, components, [](glm::dvec3 place, int c) {
        return glm::clamp(ballAt(place) * (1.0 - 0.25 * c) + 0.1 * c * place.z, 0.0, 1.0);
    });
}

/// A volume two wide round the origin, seen along -z from 4 in front of it.
StyledScene sceneOf(TexturePointer voxels, bool perspective)
{
    StyledScene scene;
    scene.width = scene.height = kPixels;
    scene.background.opacity = 0.0f;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -4.0));
    scene.clipFromEye =
        perspective ? glm::perspective(0.5, 1.0, 1.0, 10.0) : glm::ortho(-1.5, 1.5, -1.5, 1.5, 1.0, 10.0);
    StyledVolume volume;
    volume.dimensions = glm::vec3(2.0f);
    const VoxelSize& size = voxels->size;
    volume.unitLength = 2.0 / std::max({size.x, size.y, size.z});
    volume.spacing = volume.unitLength;
    volume.voxels = std::move(voxels);
    scene.volumes.push_back(volume);
    return scene;
}

StyleLight light(StyleLight::Kind kind)
{
    StyleLight made;
    made.kind = kind;
    made.color = {1.0f, 0.9f, 0.7f};
    made.ambientIntensity = 0.3f;
    made.position = {1.0f, 2.0f, 3.0f};
    made.direction = glm::normalize(glm::vec3(-1.0f, -2.0f, -3.0f));
    made.attenuation = {0.7f, 0.1f, 0.05f};
    made.beamWidth = 0.2f;
    made.cutOffAngle = 0.5f;
    return made;
}

/// The ball, turned, stretched and lit from two sides, with a chain of styles.
StyledScene turnedScene(const StyleChain& chain, bool perspective = true, int components = 1)
{
    StyledScene scene = sceneOf(ball(components), perspective);
    StyledVolume& volume = scene.volumes[0];
    volume.worldFromLocal = glm::rotate(glm::dmat4(1.0), 0.6, glm::normalize(glm::dvec3(1.0, 2.0, 0.5)));
    volume.worldFromLocal = glm::scale(volume.worldFromLocal, glm::dvec3(1.0, 0.8, 1.3));
    volume.spacing = 0.07;
    volume.chains = {chain};
    volume.surroundings.lights = {light(StyleLight::Kind::directional), light(StyleLight::Kind::point),
                                  light(StyleLight::Kind::spot)};
    return scene;
}

class SceneDrawing : public vo::test::FloatScreen<kPixels>
{
protected:
    std::vector<float> picture(const StyledScene& scene)
    {
        gl().ClearColor(0, 0, 0, 0);
        gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawer_.draw(scene);
        return context_->readFloats();
    }
    /// Is like the reference, and not empty. `what` is the scene's own name.
    void compare(const StyledScene& scene, const std::string& what, double alike = kAlike)
    {
        static std::map<std::string, std::vector<double>> references;
        std::vector<double>& reference = references[what];
        if (reference.empty()) reference = styledReference(scene);
        const std::vector<float> drawn = picture(scene);
        EXPECT_GT(psnr(drawn, reference), alike) << what;
        double most = 0.0;
        for (std::size_t i = 3; i < reference.size(); i += 4)
            most = std::max(most, reference[i]);
        EXPECT_GT(most, 0.1) << what << " shows nothing";
    }

    SceneDrawer drawer_;
};

INSTANTIATE_TEST_SUITE_P(Profiles, SceneDrawing, vo::test::kBothProfiles, vo::test::profileName);

TEST_P(SceneDrawing, constantVolumeHasTheOpacityOfItsLength)
{
    const double value = 51 / 255.0;
    const std::vector<float> drawn = picture(sceneOf(constant(value), false));
    // 16 voxels deep; colour and opacity are the value.
    const double alpha = 1.0 - std::pow(1.0 - value, 16.0);
    EXPECT_NEAR(pixelAt(drawn, 32, 32)[3], alpha, 1e-4);
    EXPECT_NEAR(pixelAt(drawn, 32, 32)[0], value * alpha, 1e-4);
    EXPECT_EQ(pixelAt(drawn, 2, 32)[3], 0.0f);
}

TEST_P(SceneDrawing, slantedRaysOfAPerspectiveAreLonger)
{
    const double value = 10 / 255.0;
    const std::vector<float> drawn = picture(sceneOf(constant(value), true));
    const auto expected = [&](double pixel) {
        const double slope = (2.0 * (pixel + 0.5) / kPixels - 1.0) * std::tan(0.25);
        const double middle = std::tan(0.25) / kPixels;
        const double length = std::sqrt(1.0 + slope * slope + middle * middle);
        return 1.0 - std::pow(1.0 - value, 16.0 * length);
    };
    EXPECT_NEAR(pixelAt(drawn, 32, 32)[3], expected(32), 1e-4);
    EXPECT_NEAR(pixelAt(drawn, 50, 32)[3], expected(50), 1e-4);
}

TEST_P(SceneDrawing, voxelsOfAnyNumberOfComponentsAreThoseOfTheReference)
{
    for (const int components : {1, 2, 3, 4})
        for (const bool perspective : {false, true})
            compare(turnedScene({}, perspective, components),
                    std::to_string(components) + (perspective ? " components, perspective" : " components"));
}

// ---- Surfaces and the sky

/// A ball of triangles.
StyledSurface sphere(const glm::dvec3& middle, double radius)
{
    constexpr int kRings = 12, kSectors = 24;
    StyledSurface surface;
    surface.worldFromLocal = glm::scale(glm::translate(glm::dmat4(1.0), middle), glm::dvec3(radius));
    for (int ring = 0; ring <= kRings; ++ring)
        for (int sector = 0; sector < kSectors; ++sector) {
            const double latitude = M_PI * ring / kRings, longitude = 2.0 * M_PI * sector / kSectors;
            surface.positions.emplace_back(std::sin(latitude) * std::cos(longitude), std::cos(latitude),
                                           -std::sin(latitude) * std::sin(longitude));
        }
    surface.normals = surface.positions;
    for (int ring = 0; ring < kRings; ++ring)
        for (int sector = 0; sector < kSectors; ++sector) {
            const int right = (sector + 1) % kSectors, here = ring * kSectors, below = here + kSectors;
            for (const int corner : {here + sector, below + sector, below + right})
                surface.triangles.push_back(corner);
            for (const int corner : {here + sector, below + right, here + right})
                surface.triangles.push_back(corner);
        }
    surface.diffuse = {0.9f, 0.4f, 0.2f};
    surface.specular = glm::vec3(0.4f);
    surface.lights = {light(StyleLight::Kind::directional), light(StyleLight::Kind::spot)};
    return surface;
}

/// A square three wide, turned by an angle round y.
StyledSurface pane(const glm::dvec3& middle, double angle, const glm::vec3& color, float transparency)
{
    StyledSurface surface;
    surface.worldFromLocal =
        glm::rotate(glm::translate(glm::dmat4(1.0), middle), angle, glm::dvec3(0.1, 1.0, 0.05));
    surface.positions = {{-1.5f, -1.5f, 0.0f}, {1.5f, -1.5f, 0.0f}, {1.5f, 1.5f, 0.0f}, {-1.5f, 1.5f, 0.0f}};
    surface.normals.assign(4, {0.0f, 0.0f, 1.0f});
    surface.triangles = {0, 1, 2, 0, 2, 3};
    surface.lit = surface.solid = false;
    surface.emissive = color;
    surface.transparency = transparency;
    return surface;
}

/// The angle of a pane whose edges come to no pixel's middle, where rounding would decide.
constexpr double kClearOfPixels = 1.21;

TEST_P(SceneDrawing, opaqueSurfacesAreInsideAVolume)
{
    StyledScene scene = turnedScene({});
    scene.surfaces = {sphere({0.2, 0.1, 0.1}, 0.5)};
    scene.surfaces[0].clipPlanes = {{0.0, 1.0, 0.3, 0.1}};
    scene.surfaces[0].solid = false;
    compare(scene, "sphere in a volume");
    scene.surfaces[0].worldFromLocal =
        glm::scale(scene.surfaces[0].worldFromLocal, glm::dvec3(-1.0, 1.0, 1.0));
    scene.surfaces[0].solid = true;
    compare(scene, "mirrored sphere in a volume");
}

TEST_P(SceneDrawing, skyIsBehind)
{
    StyledScene scene = turnedScene({});
    scene.clipFromEye = glm::perspective(1.5, 1.0, 0.1, 10.0);
    scene.eyeFromWorld = glm::rotate(scene.eyeFromWorld, 0.8, glm::dvec3(1.0, 0.3, 0.2));
    scene.background.opacity = 0.75f;
    scene.background.skyAngles = {0.8f, 1.2f};
    scene.background.sky = {{0, 0, 1}, {0.5f, 0.5f, 1}, {1, 0.5f, 0}};
    scene.background.groundAngles = {0.9f, 1.3f};
    scene.background.ground = {{0.1f, 0.1f, 0}, {0.3f, 0.4f, 0}, {0, 0.3f, 0.1f}};
    compare(scene, "sky and ground");
}

TEST_P(SceneDrawing, translucentSurfacesAreInOrderWithSlices)
{
    for (const bool perspective : {false, true}) {
        StyledScene scene = turnedScene({}, perspective);
        scene.surfaces = {pane({0, 0, 0}, 1.2, {1, 0, 0}, 0.4f), pane({0, 0, 0.3}, -0.9, {0, 0, 1}, 0.5f),
                          pane({0.3, 0, -0.3}, 0.02, {0, 1, 0}, 0.3f)};
        compare(scene, perspective ? "panes, perspective" : "panes");
        scene.surfaces = {sphere({0.2, 0.1, 0.1}, 0.7), sphere({-0.3, -0.2, 0.1}, 0.6)};
        for (StyledSurface& surface : scene.surfaces) {
            surface.transparency = 0.5f;
            surface.solid = false;
        }
        compare(scene, perspective ? "translucent spheres, perspective" : "translucent spheres");
        scene.volumes.clear();
        compare(scene, perspective ? "spheres alone, perspective" : "spheres alone");
    }
}

TEST_P(SceneDrawing, panesAcrossTheViewAreDrawnAtAnyDepth)
{
    StyledScene scene = turnedScene({});
    scene.volumes.clear();
    for (const double z : {0.05, 0.15, 0.25, 0.35, 0.55}) {
        scene.surfaces = {pane({0, 0, z}, 0.0, {1, 0, 0}, 0.4f), pane({0, 0, z - 0.1}, 0.0, {0, 0, 1}, 0.5f)};
        const std::vector<float> drawn = picture(scene);
        const float* const middle = pixelAt(drawn, kPixels / 2, kPixels / 2);
        EXPECT_NEAR(middle[0], 0.6f, 1e-5f) << z;
        EXPECT_NEAR(middle[2], 0.4f * 0.5f, 1e-5f) << z;
    }
}

TEST_P(SceneDrawing, nearerOfTwoNeighbouringTrianglesIsInFront)
{
    StyledScene scene = turnedScene({});
    for (const double step : {1e-4, -1e-4}) {
        scene.surfaces = {pane({0, 0, 0.1}, 0.0, {1, 0, 0}, 0.4f),
                          pane({0, 0, 0.1 + step}, 0.0, {0, 0, 1}, 0.5f),
                          pane({0, 0, -2.0}, 0.0, {0, 1, 0}, 0.5f)};
        compare(scene, step > 0.0 ? "blue pane in front" : "red pane in front");
    }
}

TEST_P(SceneDrawing, colorsOfVerticesAreMixed)
{
    StyledScene scene = turnedScene({});
    scene.surfaces = {sphere({0, 0, 0}, 0.8)};
    for (const glm::vec3& position : scene.surfaces[0].positions)
        scene.surfaces[0].colors.emplace_back(0.5f + 0.5f * position, 0.6f + 0.4f * position.x);
    compare(scene, "colours of vertices");
}

TEST_P(SceneDrawing, volumesThatOverlapAreOneBehindTheOther)
{
    StyledScene scene = turnedScene({});
    scene.volumes.push_back(
        turnedScene({styleWithReference(SilhouetteEnhancement{0.3f, 0.7f, 1.5f, nullptr})}).volumes[0]);
    scene.volumes[1].worldFromLocal = glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, 0.2, 0.1));
    scene.volumes[1].voxels = ball(4);
    scene.volumes[1].spacing = 0.113;
    compare(scene, "two volumes");
    scene.volumes[1].spacing = scene.volumes[0].spacing;
    compare(scene, "two volumes of one spacing");
}

TEST_P(SceneDrawing, volumesBesideAndBehindEachOtherAreInOrder)
{
    StyledScene scene = turnedScene({});
    StyledVolume& volume = scene.volumes[0];
    volume.worldFromLocal = glm::scale(volume.worldFromLocal, glm::dvec3(0.4));
    volume.spacing = 0.03;
    for (const glm::dvec3& place : {glm::dvec3(0.6, 0.0, 0.0), glm::dvec3(0.1, 0.2, -1.5)}) {
        scene.volumes.push_back(scene.volumes[0]);
        scene.volumes.back().worldFromLocal[3] = glm::dvec4(place, 1.0);
    }
    scene.volumes[0].worldFromLocal[3] = glm::dvec4(-0.5, 0.0, 0.0, 1.0);
    compare(scene, "beside and behind");
    std::ranges::reverse(scene.volumes);
    compare(scene, "beside and behind");
}

TEST_P(SceneDrawing, eyesMayBeInAVolume)
{
    StyledScene scene = turnedScene({});
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.2, -0.3));
    scene.clipFromEye = glm::perspective(1.0, 1.0, 0.1, 10.0);
    compare(scene, "from within");
    scene.surfaces = {pane({0, 0, 0}, 1.2, {1, 0, 0}, 1.0f)};
    compare(scene, "from within");
}

TEST_P(SceneDrawing, clipPlanesCutVolumes)
{
    StyledScene scene = turnedScene({});
    scene.volumes[0].clipPlanes = {{1.0, 0.2, 0.1, 0.2}, {-0.3, 1.0, 0.0, 0.4}};
    compare(scene, "clip planes");
    scene.surfaces = {pane({0, 0, 0}, 1.2, {1, 0, 0}, 1.0f)};
    compare(scene, "clip planes");
}

// ---- Styles

/// Every style alone, and some in a row.
std::map<std::string, StyleChain> chains()
{
    std::map<std::string, StyleChain> all;
    OpacityMap map;
    map.transferFunction = bytes({32, 1, 1}, 4, [](glm::dvec3 place, int c) {
        return c == 3 ? 0.4 * place.x : 0.5 + 0.5 * std::sin(6.0 * place.x + c);
    });
    const auto opacityMap = styleWithReference(map);
    const auto edge = styleWithReference(EdgeEnhancement{{1, 0, 0, 1}, 0.6f, nullptr});
    const auto silhouette = styleWithReference(SilhouetteEnhancement{0.3f, 0.7f, 1.5f, nullptr});
    const auto toned = styleWithReference(ToneMapped{});
    const auto cartoon = styleWithReference(Cartoon{{0, 0, 0.4f, 1}, {1, 0.8f, 0.2f, 0.8f}, 5, nullptr});
    Shaded shading;
    shading.lighting = true;
    shading.specular = glm::vec3(0.5f);
    const auto shaded = styleWithReference(shading);
    shading.hasMaterial = true;
    shading.surfaceNormals = bytes(
        {8, 8, 8}, 3, [](glm::dvec3 place, int c) { return 0.5 + 0.5 * glm::normalize(place - 0.48)[c]; });
    Blended blended;
    blended.voxels = ball(4);
    blended.dimensions = glm::vec3(2.0f);
    blended.chain = {silhouette};
    blended.weightFunction1 = Blended::Weight::alpha0;
    return {{"opacity map", {opacityMap}},
            {"opacity map without a function", {styleWithReference(OpacityMap{})}},
            {"boundary", {styleWithReference(BoundaryEnhancement{})}},
            {"cartoon", {cartoon}},
            {"edge", {edge}},
            {"silhouette", {silhouette}},
            {"tone", {toned}},
            {"shaded", {shaded}},
            {"given normals", {styleWithReference(shading)}},
            {"blended", {styleWithReference(blended)}},
            {"map, silhouette, shaded, edge", {opacityMap, silhouette, shaded, edge}},
            {"edge, then tone", {edge, toned}}};
}

/// The same picture, drawn by slices: samples of volumes that are not seen lie between those of the others.
StyledScene sliced(StyledScene scene)
{
    for (const double spacing : {0.8, 0.9}) {
        StyledVolume& clear = scene.volumes.emplace_back(sceneOf(constant(0.0), true).volumes[0]);
        clear.chains = {{}};
        clear.spacing = spacing;
    }
    return scene;
}

/// The same picture, drawn from hit to hit, of a surface that is not seen.
StyledScene fromHitToHit(StyledScene scene)
{
    scene.surfaces.push_back(pane({0, 0, 0}, 1.2, {1, 0, 0}, 1.0f));
    return scene;
}

TEST_P(SceneDrawing, everyStyleIsThatOfTheReference)
{
    for (const auto& [name, chain] : chains())
        for (const bool perspective : {false, true}) {
            const std::string what = name + (perspective ? ", perspective" : "");
            compare(turnedScene(chain, perspective), what);
            compare(sliced(turnedScene(chain, perspective)), what);
            compare(fromHitToHit(turnedScene(chain, perspective)), what);
        }
}

/// Seen in a corner of a volume alone, so that most blocks of voxels are clear.
TexturePointer cornerBall(bool nearest)
{
    auto texture = bytes({45, 40, 50}, 1, [](glm::dvec3 place, int) {
        return glm::clamp(1.0 - 3.0 * glm::length(place - glm::dvec3(0.7, 0.65, 0.3)), 0.05, 1.0);
    });
    auto made = std::make_shared<VoxelTexture>(*texture);
    made->nearest = nearest;
    return made;
}

TEST_P(SceneDrawing, clearBlocksAreLeaptOverAndNothingElse)
{
    OpacityMap map;
    map.transferFunction = bytes({64, 1, 1}, 4, [](glm::dvec3 place, int c) {
        return c == 3 ? glm::clamp(place.x - 0.1, 0.0, 0.5) : place.x;
    });
    for (const bool turned : {false, true})
        for (const bool nearest : {false, true}) {
            StyledScene scene = turnedScene({styleWithReference(map)}, turned);
            scene.volumes[0].voxels = cornerBall(nearest);
            scene.volumes[0].spacing = 0.041;
            if (!turned) scene.volumes[0].worldFromLocal = glm::dmat4(1.0);
            const std::string what = std::to_string(turned) + std::to_string(nearest);
            for (const StyledScene& drawn : {scene, sliced(scene), fromHitToHit(scene)})
                compare(drawn, "clear blocks " + what);
            IsoSurfaces& surfaces = scene.volumes[0].surfaces.emplace();
            surfaces.values = {0.3f, 0.6f};
            surfaces.chains = {{styleWithReference(OpacityMap{})}};
            for (const StyledScene& drawn : {scene, sliced(scene), fromHitToHit(scene)})
                compare(drawn, "surfaces and clear blocks " + what, nearest ? 40.0 : kAlike);
        }
}

// ---- Volumes that are more than samples with a chain

/// Numbers 0 to 3 in the quarters of the box, in the second component.
TexturePointer quarters()
{
    return bytes({6, 6, 4}, 2, [](glm::dvec3 place, int c) {
        return c == 0 ? 0.5 : ((place.x > 0.5) + 2 * (place.y > 0.5)) / 255.0;
    });
}

TEST_P(SceneDrawing, segmentsHaveTheirChains)
{
    StyledScene scene = turnedScene({});
    StyledVolume& volume = scene.volumes[0];
    volume.chains.push_back({styleWithReference(ToneMapped{})});
    volume.chains.push_back({styleWithReference(SilhouetteEnhancement{0.3f, 0.7f, 1.5f, nullptr})});
    volume.segments = Segments{quarters(), 1, 255.0f, {1, -1, 0}, 2};
    compare(scene, "segments");
    compare(sliced(scene), "segments");
}

/// Chains that take turns: of two kinds, which differ in numbers alone, without styles, and with one that
/// does nothing.
std::vector<StyleChain> chainsThatTakeTurns()
{
    const auto silhouette = [](float retained, float boundary) {
        return StyleChain{styleWithReference(SilhouetteEnhancement{retained, boundary, 1.5f, nullptr})};
    };
    const auto tone = [](const glm::vec4& cool, const glm::vec4& warm) {
        return StyleChain{styleWithReference(ToneMapped{cool, warm, nullptr})};
    };
    const StyleChain nothing{styleWithReference(Blended{})}; // it has no voxels
    return {silhouette(0.3f, 0.7f),
            {},
            tone({0, 0, 1, 0}, {1, 1, 0, 0}),
            nothing,
            silhouette(0.5f, 0.2f),
            tone({0, 1, 0, 0}, {1, 0, 1, 0}),
            {}};
}

/// Numbers 0 to 6.
TexturePointer sevenSegments()
{
    return bytes({7, 6, 4}, 1, [](glm::dvec3 place, int) {
        return std::fmod(std::floor(7.0 * place.x) + 3.0 * std::floor(6.0 * place.y), 7.0) / 255.0;
    });
}

TEST_P(SceneDrawing, chainsOfOneKindHaveTheirOwnNumbers)
{
    StyledScene scene = turnedScene({});
    StyledVolume& volume = scene.volumes[0];
    volume.chains = chainsThatTakeTurns();
    volume.segments = Segments{sevenSegments(), 0, 255.0f, {4, 0, 1, 5, 3, 2}, 6};
    compare(scene, "kinds of chains");
    compare(sliced(scene), "kinds of chains");
    volume.projection = RayProjection{RayProjection::Type::average};
    compare(scene, "kinds of chains, projected");
    IsoSurfaces& surfaces = volume.surfaces.emplace();
    surfaces.values = {0.15f, 0.25f, 0.35f, 0.4f, 0.45f, 0.5f, 0.55f};
    surfaces.chains = chainsThatTakeTurns();
    compare(scene, "kinds of chains of surfaces");
    compare(sliced(scene), "kinds of chains of surfaces");
}

// ---- Many segments, each with a table of its own

/// Squares of a grid, seen head-on, each of its own number.
constexpr int kAcross = 27;

glm::vec3 colorOfSegment(int id)
{
    return glm::vec3(8 * (id % 30) + 10, 8 * (id / 30) + 10, (97 * id) % 256) / 255.0f;
}

/// Opaque, and of the segment's colour times the value. Segments that follow each other have tables of other
/// sizes and numbers of components; each fifth has one of 16 bits.
TexturePointer tableOfSegment(int id)
{
    const glm::vec3 color = colorOfSegment(id);
    auto table = std::make_shared<VoxelTexture>();
    table->size.x = 2 + id % 300;
    table->components = 3 + id % 2;
    table->kind = TexelKind::float32;
    std::vector<float> texels;
    for (int texel = 0; texel < table->size.x; ++texel) {
        const float value = (static_cast<float>(texel) + 0.5f) / static_cast<float>(table->size.x);
        texels.insert(texels.end(), {color.r * value, color.g * value, color.b * value});
        if (table->components == 4) texels.push_back(1.0f);
    }
    const auto store = [&table](const auto& numbers) {
        table->texels.resize(numbers.size() * sizeof numbers[0]);
        std::memcpy(table->texels.data(), numbers.data(), table->texels.size());
    };
    if (id % 5 != 0) {
        store(texels);
        return table;
    }
    table->kind = TexelKind::uint16;
    std::vector<std::uint16_t> whole(texels.size());
    std::ranges::transform(texels, whole.begin(),
                           [](float number) { return static_cast<std::uint16_t>(number * 65535.0f + 0.5f); });
    store(whole);
    return table;
}

/// A box with the same value everywhere, and a style for each of so many segments; other squares of the grid
/// have numbers beyond them.
StyledScene segmentsScene(int segments, double value)
{
    StyledScene scene = sceneOf(constant(value), false);
    scene.clipFromEye = glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0);
    StyledVolume& volume = scene.volumes[0];
    auto numbers = std::make_shared<VoxelTexture>();
    numbers->size = {kAcross, kAcross, 1};
    numbers->kind = TexelKind::uint16;
    numbers->texels.resize(2 * numbers->size.count());
    for (std::uint16_t id = 0; id < kAcross * kAcross; ++id)
        std::memcpy(numbers->texels.data() + 2 * id, &id, 2);
    volume.segments = Segments{numbers, 0, 65535.0f, {}, -1};
    volume.chains.clear();
    for (int id = 0; id < segments; ++id) {
        OpacityMap map;
        map.transferFunction = tableOfSegment(id);
        volume.chains.push_back({makeStyle(map)});
        volume.segments->chainOf.push_back(segments - 1 - id);
    }
    std::ranges::reverse(volume.chains);
    return scene;
}

/// Each pixel has the colour of the segment that its middle is in, at the value of all voxels.
void expectSegments(const std::vector<float>& drawn, int segments, double value, const std::string& what)
{
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const auto square = [](int pixel) { return kAcross * (2 * pixel + 1) / (2 * kPixels); };
            const int id = kAcross * square(y) + square(x);
            const double half = 0.5 / (2 + id % 300);
            const glm::vec3 expected =
                colorOfSegment(id) * static_cast<float>(glm::clamp(value, half, 1.0 - half));
            const float* const pixel = drawn.data() + 4 * (y * kPixels + x);
            ASSERT_EQ(pixel[3], id < segments ? 1.0f : 0.0f) << what << ", segment " << id;
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(pixel[channel], id < segments ? expected[channel] : 0.0f, 1e-5f)
                    << what << ", segment " << id;
        }
}

TEST_P(SceneDrawing, eachOfManySegmentsHasATableOfItsOwn)
{
    for (const int segments : {3, 255, 725})
        for (const double value : {0.0, 0.4, 1.0}) {
            const StyledScene scene = segmentsScene(segments, value);
            const std::string what = std::to_string(segments) + " at " + std::to_string(value);
            expectSegments(picture(scene), segments, value, what + " by rays");
            expectSegments(picture(sliced(scene)), segments, value, what + " by slices");
            ScenePicture cast;
            castScene(scene, 1, cast);
            expectSegments(cast.rgba, segments, value, what + " without OpenGL");
        }
}

/// All are clear but two, which share their bit in the masks of blocks with clear ones.
TEST_P(SceneDrawing, segmentsAmongClearOnesAreSeen)
{
    OpacityMap clear;
    clear.transferFunction = bytes({1, 1, 1}, 4, [](glm::dvec3, int) { return 0.0; });
    for (const int first : {30, 2}) {
        StyledScene scene = segmentsScene(725, 0.4);
        StyledVolume& volume = scene.volumes[0];
        volume.voxels = bytes({50, 50, 50}, 1, [](glm::dvec3, int) { return 0.4; });
        for (int id = 0; id < 725; ++id)
            if (id != first && id != 700)
                volume.chains[static_cast<std::size_t>(724 - id)] = {makeStyle(clear)};
        ScenePicture cast;
        castScene(scene, 1, cast);
        for (const std::vector<float>& drawn : {picture(scene), picture(sliced(scene)), cast.rgba}) {
            double sum = 0.0;
            for (std::size_t i = 3; i < drawn.size(); i += 4)
                sum += static_cast<double>(drawn[i]);
            const auto middle = [](int square) { return (2 * square + 1) * kPixels / (2 * kAcross); };
            for (const int id : {first, 700})
                EXPECT_EQ(pixelAt(drawn, middle(id % kAcross), middle(id / kAcross))[3], 1.0f) << id;
            EXPECT_LE(sum, 2 * 9.0);
        }
    }
}

/// One of the tables is another one in the next picture.
TEST_P(SceneDrawing, aTableThatIsReplacedIsDrawn)
{
    StyledScene scene = segmentsScene(725, 0.4);
    expectSegments(picture(scene), 725, 0.4, "before");
    OpacityMap map;
    map.transferFunction = bytes({1, 1, 1}, 3, [](glm::dvec3, int c) { return c == 1 ? 1.0 : 0.0; });
    scene.volumes[0].chains[724] = {makeStyle(map)};
    const std::vector<float> drawn = picture(scene);
    EXPECT_EQ(glm::make_vec4(pixelAt(drawn, 0, 0)), glm::vec4(0, 1, 0, 1));
    const std::vector<float> before = picture(segmentsScene(725, 0.4));
    EXPECT_TRUE(std::equal(drawn.begin() + 4 * 3, drawn.begin() + 4 * kPixels, before.begin() + 4 * 3));
}

TEST_P(SceneDrawing, programsAreNoLongerForMoreSegments)
{
    const auto program = [](int segments) {
        return volumeProgram(segmentsScene(segments, 0.5).volumes[0], {VolumeWay::rays, false});
    };
    const VolumeProgram few = program(20), many = program(725);
    EXPECT_NEAR(static_cast<double>(many.fragmentText.size()), static_cast<double>(few.fragmentText.size()),
                10.0);
    EXPECT_TRUE(many.chains.textures().empty());
}

TEST_P(SceneDrawing, surfacesLieWhereValuesCross)
{
    Shaded shading;
    shading.lighting = true;
    shading.hasMaterial = true;
    shading.diffuse = {0.2f, 0.7f, 0.9f};
    Shaded other = shading;
    other.diffuse = {0.9f, 0.7f, 0.1f};
    other.transparency = 0.3f;
    OpacityMap map;
    map.transferFunction = bytes({2, 1, 1}, 4, [](glm::dvec3, int c) { return c == 3 ? 0.6 : 0.8; });
    const auto clear = styleWithReference(map);
    for (const bool perspective : {false, true}) {
        StyledScene scene = turnedScene({}, perspective);
        IsoSurfaces& surfaces = scene.volumes[0].surfaces.emplace();
        surfaces.values = {0.2f, 0.3f, 0.55f};
        surfaces.chains = {{clear, styleWithReference(shading)}, {clear, styleWithReference(other)}};
        surfaces.surfaceTolerance = 0.01f;
        scene.volumes[0].clipPlanes = {{1.0, 0.2, 0.1, 0.4}};
        for (const StyledScene& drawn : {scene, sliced(scene), fromHitToHit(scene)})
            compare(drawn, perspective ? "surfaces of values, perspective" : "surfaces of values", kEqual);
        scene.surfaces = {sphere({0.2, 0.1, 0.1}, 0.5)};
        for (const StyledScene& drawn : {scene, sliced(scene), fromHitToHit(scene)})
            compare(drawn, perspective ? "surfaces and sphere, perspective" : "surfaces and sphere");
    }
    StyledScene scene = turnedScene({});
    IsoSurfaces& surfaces = scene.volumes[0].surfaces.emplace();
    surfaces.values = {0.3f};
    surfaces.chains = {{clear, styleWithReference(shading)}};
    surfaces.gradients = bytes(
        {8, 8, 8}, 3, [](glm::dvec3 place, int c) { return 0.5 + 0.5 * glm::normalize(place - 0.48)[c]; });
    compare(scene, "surfaces with given normals", kEqual);
}

TEST_P(SceneDrawing, projectionsJoinWholeRays)
{
    const auto silhouette = styleWithReference(SilhouetteEnhancement{0.3f, 0.7f, 1.5f, nullptr});
    using Type = RayProjection::Type;
    for (const auto& [type, name] :
         {std::pair(Type::max, "max"), std::pair(Type::min, "min"), std::pair(Type::average, "average")})
        for (const float threshold : {0.0f, 0.35f})
            for (const int components : {1, 4}) {
                StyledScene scene = turnedScene({}, threshold > 0.0f, components);
                if (components == 4) scene.volumes[0].chains = {{silhouette}};
                scene.volumes[0].projection = RayProjection{type, threshold};
                compare(scene, name + std::to_string(components) + std::to_string(threshold));
            }
}

TEST_P(SceneDrawing, projectionsEndAtOpaqueSurfaces)
{
    StyledScene scene = turnedScene({}, true, 4);
    scene.volumes[0].projection = RayProjection{};
    scene.volumes[0].clipPlanes = {{0.3, 1.0, 0.1, 0.4}};
    scene.surfaces = {sphere({0.3, 0.1, 0.3}, 0.5), pane({0, 0, 0.2}, kClearOfPixels, {1, 0, 0}, 0.4f)};
    compare(scene, "projection, sphere and pane");
}

/// Surfaces of values in the turned ball, in another place and with planes of their own.
StyledVolume otherSurfaces(const std::vector<float>& values, float transparency)
{
    Shaded shading;
    shading.lighting = true;
    shading.hasMaterial = true;
    shading.diffuse = {0.2f, 0.7f, 0.9f};
    shading.transparency = transparency;
    OpacityMap solid;
    solid.transferFunction = bytes({2, 1, 1}, 4, [](glm::dvec3, int) { return 1.0; });
    StyledVolume volume = turnedScene({}).volumes[0];
    volume.worldFromLocal = glm::translate(glm::dmat4(1.0), glm::dvec3(0.2, 0.1, 0.1));
    volume.worldFromLocal = glm::rotate(volume.worldFromLocal, -0.4, glm::dvec3(0.0, 0.8, 0.6));
    volume.spacing = 0.09;
    volume.surfaces =
        IsoSurfaces{values, {{styleWithReference(solid), styleWithReference(shading)}}, 0.0f, {}};
    return volume;
}

TEST_P(SceneDrawing, surfacesOfValuesStandAmongTheSamplesOfOtherVolumes)
{
    for (const bool perspective : {false, true})
        for (const float transparency : {0.0f, 0.5f})
            for (const double spacing : {0.07, 0.09}) {
                StyledScene scene = turnedScene({}, perspective);
                scene.volumes[0].spacing = spacing;
                scene.volumes.push_back(otherSurfaces({0.25f, 0.4f}, transparency));
                const std::string what = "surfaces among samples " + std::to_string(transparency) +
                                         std::to_string(spacing) + (perspective ? ", perspective" : "");
                compare(scene, what, 60.0);
                std::ranges::reverse(scene.volumes);
                compare(scene, what + ", first", 60.0);
            }
}

TEST_P(SceneDrawing, surfacesOfValuesCrossEachOtherAndPanes)
{
    StyledScene scene = turnedScene({});
    scene.volumes = {otherSurfaces({0.25f}, 0.5f), otherSurfaces({0.3f}, 0.3f)};
    scene.volumes[1].worldFromLocal = glm::translate(glm::dmat4(1.0), glm::dvec3(-0.3, 0.2, 0.2));
    scene.volumes[1].spacing = 0.13;
    compare(scene, "surfaces that cross", 60.0);
    compare(sliced(scene), "surfaces that cross", 50.0);
    scene.surfaces = {pane({0, 0, 0.3}, 0.7, {1, 0, 0}, 0.4f)};
    compare(scene, "surfaces that cross, and a pane");
    compare(sliced(scene), "surfaces that cross, and a pane");
    scene.volumes.pop_back();
    compare(scene, "a surface and a pane");
}

TEST_P(SceneDrawing, surfacesOfValuesCrossPanesAsTheyDoBesideProjections)
{
    for (const bool perspective : {false, true}) {
        StyledScene scene = turnedScene({}, perspective);
        scene.volumes.push_back(otherSurfaces({0.25f}, 0.5f));
        StyledVolume& projection = scene.volumes[0];
        projection.projection = RayProjection{};
        projection.worldFromLocal = glm::translate(glm::dmat4(1.0), glm::dvec3(0.8, 0.8, 0.0));
        projection.dimensions = glm::vec3(0.2f);
        scene.surfaces = {pane({0, 0, 0.1}, 20.0, {1, 0, 0}, 0.4f)};
        scene.surfaces[0].worldFromLocal =
            glm::rotate(scene.surfaces[0].worldFromLocal, 0.9, glm::dvec3(0.0, 1.0, 0.0));
        compare(scene, perspective ? "pane and projection, perspective" : "pane and projection", kEqual);
    }
}

/// Two volumes in one place, of one colour each.
TEST_P(SceneDrawing, surfacesOfOneValueInOnePlaceAreInTheirOrder)
{
    for (const bool perspective : {false, true}) {
        StyledScene scene = turnedScene({}, perspective);
        IsoSurfaces& surfaces = scene.volumes[0].surfaces.emplace();
        surfaces.values = {0.2f, 0.3f};
        scene.volumes.push_back(scene.volumes[0]);
        for (int i : {0, 1}) {
            OpacityMap map;
            map.transferFunction = bytes({2, 1, 1}, 4, [i](glm::dvec3, int c) {
                return c == 3 ? 0.6 : c == 2 * i ? 1.0 : 0.0;
            });
            scene.volumes[static_cast<std::size_t>(i)].surfaces->chains = {{styleWithReference(map)}};
        }
        ScenePicture cast;
        castScene(scene, 0, cast);
        for (const std::vector<float>& drawn : {picture(scene), cast.rgba}) {
            int seen = 0;
            for (int y = 0; y < kPixels; ++y)
                for (int x = 0; x < kPixels; ++x) {
                    const auto pixel = pixelAt(drawn, x, y);
                    ASSERT_NEAR(pixel[2], 0.4f * pixel[0], 1e-4f) << x << ", " << y;
                    seen += pixel[3] > 0.5f ? 1 : 0;
                }
            EXPECT_GT(seen, 100);
        }
    }
}

/// Waves of triangles as small as pixels.
TEST_P(SceneDrawing, fineMeshesHaveNoHoles)
{
    constexpr int kEdge = 150;
    StyledScene scene = turnedScene({}, false);
    scene.volumes.clear();
    StyledSurface mesh = pane({0, 0, 0}, 1.0, {1, 0, 0}, 0.5f);
    mesh.worldFromLocal = glm::dmat4(1.0);
    mesh.positions.clear();
    mesh.triangles.clear();
    for (int y = 0; y <= kEdge; ++y)
        for (int x = 0; x <= kEdge; ++x) {
            const float u = static_cast<float>(x) / kEdge, v = static_cast<float>(y) / kEdge;
            mesh.positions.emplace_back(2.0f * u - 1.0f, 2.0f * v - 1.0f,
                                        0.2f * std::sin(9.0f * u) * std::cos(7.0f * v));
            if (x == kEdge || y == kEdge) continue;
            const int corner = y * (kEdge + 1) + x, above = corner + kEdge + 1;
            for (const int i : {corner, corner + 1, above + 1, corner, above + 1, above})
                mesh.triangles.push_back(i);
        }
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    for (int moved = 0; moved < 8; ++moved) {
        mesh.worldFromLocal[3] = {0.0037 * moved, 0.0053 * moved, 0.0, 1.0};
        scene.surfaces = {mesh};
        const std::vector<float> drawn = picture(scene);
        for (int y = 14; y < kPixels - 14; ++y)
            for (int x = 14; x < kPixels - 14; ++x)
                ASSERT_NEAR(pixelAt(drawn, x, y)[3], 0.5f, 1e-5f) << x << ", " << y;
    }
}

TEST_P(SceneDrawing, facesOfOneDepthAreAllSeenAndInTheirOrder)
{
    StyledScene scene = turnedScene({});
    scene.volumes.clear();
    const StyledSurface red = pane({0, 0, 0.1}, 0.4, {1, 0, 0}, 0.4f);
    StyledSurface blue = red;
    blue.emissive = {0, 0, 1};
    scene.surfaces = {red, blue, pane({0, 0, 1.2}, 0.4, {0, 1, 0}, 0.5f)};
    const std::vector<float> alone = picture(scene);
    StyledScene among = sliced(scene);
    among.volumes.pop_back();
    EXPECT_GT(psnr(picture(among), std::vector<double>(alone.begin(), alone.end())), kEqual);
    // Behind green, which lets 0.5 through, red comes first and lets 0.4 through.
    ScenePicture cast;
    castScene(scene, 0, cast);
    for (const std::vector<float>& drawn : {alone, cast.rgba}) {
        const auto middle = pixelAt(drawn, kPixels / 2, kPixels / 2);
        EXPECT_NEAR(middle[0], 0.5f * 0.6f, 1e-4f);
        EXPECT_NEAR(middle[2], 0.5f * 0.4f * 0.6f, 1e-4f);
    }
}

/// Two boxes of one value each whose fronts cross in the plane x = 0.
TEST_P(SceneDrawing, projectionsStandWhereRaysEnter)
{
    StyledScene scene = sceneOf(constant(0.2), false);
    scene.volumes.push_back(sceneOf(constant(0.8), false).volumes[0]);
    for (std::size_t i = 0; i < 2; ++i) {
        StyledVolume& volume = scene.volumes[i];
        volume.worldFromLocal = glm::rotate(glm::dmat4(1.0), 0.3, glm::dvec3(1, 0, 0));
        volume.worldFromLocal = glm::rotate(volume.worldFromLocal, i == 0 ? 0.5 : -0.5, glm::dvec3(0, 1, 0));
        volume.projection = RayProjection{};
        volume.spacing = 0.3;
    }
    ScenePicture cast;
    castScene(scene, 0, cast);
    for (const std::vector<float>& drawn : {picture(scene), picture(sliced(scene)), cast.rgba})
        for (int y = 24; y < 40; ++y)
            for (int x = 21; x < 43; ++x) {
                const float value = x < kPixels / 2 ? 51.0f / 255.0f : 204.0f / 255.0f;
                ASSERT_NEAR(pixelAt(drawn, x, y)[0], value, 1e-4f) << x << ", " << y;
            }
}

TEST_P(SceneDrawing, projectionsStandAmongOtherThings)
{
    for (const bool perspective : {false, true}) {
        const std::string way = perspective ? ", perspective" : "";
        StyledScene scene = turnedScene({}, perspective, 4);
        scene.volumes[0].projection = RayProjection{};
        scene.volumes[0].clipPlanes = {{0.3, 1.0, 0.1, 0.4}};
        scene.volumes.push_back(otherSurfaces({0.25f}, 0.5f));
        for (const StyledScene& drawn : {scene, sliced(scene)})
            compare(drawn, "projection and surfaces" + way, 55.0);
        scene.volumes[1].surfaces.reset();
        for (const StyledScene& drawn : {scene, sliced(scene)})
            compare(drawn, "projection and samples" + way, 60.0);
        scene.volumes[1].voxels = ball(2);
        scene.volumes[1].projection = RayProjection{RayProjection::Type::average, 0.0f};
        for (const StyledScene& drawn : {scene, sliced(scene)})
            compare(drawn, "two projections" + way, kEqual);
        scene.volumes.push_back(otherSurfaces({0.25f}, 0.5f));
        scene.volumes.back().surfaces.reset();
        scene.volumes.back().worldFromLocal[3] = {-0.2, -0.3, 0.0, 1.0};
        compare(scene, "two projections and samples" + way, 60.0);
        scene.surfaces = {pane({0, 0, 0.3}, 0.7, {1, 0, 0}, 0.4f)};
        compare(scene, "two projections, samples and a pane" + way);
    }
}

/// Two tetrahedra on a common face, the second with other places than a box would have.
std::shared_ptr<StyledTetras> tetras()
{
    StyledTetras made;
    made.positions = {
        {-1, -0.9f, -0.8f}, {1, -0.8f, -0.6f}, {0, 0.9f, -0.7f}, {0, 0, 0.9f}, {0.1f, -0.2f, -1.6f}};
    for (const glm::vec3& position : made.positions)
        made.places.push_back(0.5f * position + 0.5f);
    made.places[3] = {0.8f, 0.3f, 0.9f};
    made.places[4] = {0.7f, 0.3f, 0.2f};
    made.indices = {0, 1, 2, 3, 0, 2, 1, 4};
    return std::make_shared<StyledTetras>(made);
}

TEST_P(SceneDrawing, tetrahedraHavePlacesOfTheirOwn)
{
    Shaded shading;
    shading.lighting = true;
    for (const bool perspective : {false, true}) {
        StyledScene scene = turnedScene({styleWithReference(shading)}, perspective);
        scene.volumes[0].tetras = tetras();
        compare(scene, perspective ? "tetrahedra, perspective" : "tetrahedra");
    }
}

TEST_P(SceneDrawing, projectionsOfTetrahedraJoinWholeRays)
{
    const auto silhouette = styleWithReference(SilhouetteEnhancement{0.3f, 0.7f, 1.5f, nullptr});
    using Type = RayProjection::Type;
    for (const Type type : {Type::max, Type::min, Type::average})
        for (const float threshold : {0.0f, 0.15f}) {
            StyledScene scene = turnedScene({silhouette}, threshold > 0.0f, threshold > 0.0f ? 4 : 1);
            scene.volumes[0].tetras = tetras();
            scene.volumes[0].projection = RayProjection{type, threshold};
            compare(scene,
                    "tetrahedra, " + std::to_string(static_cast<int>(type)) + std::to_string(threshold));
        }
}

/// Rays of one value, whose opacity falls from 0.8 to 0.2: they end above the threshold.
TEST_P(SceneDrawing, projectionsWithAThresholdShowTheEndOfWhatDoesNotFall)
{
    auto voxels = std::make_shared<VoxelTexture>(
        *bytes({8, 8, 8}, 2, [](glm::dvec3 place, int c) { return c == 0 ? 0.8 : 0.2 + 0.6 * place.z; }));
    voxels->nearest = true;
    for (const bool hasTetras : {false, true}) {
        StyledScene scene = sceneOf(voxels, false);
        scene.volumes[0].projection = RayProjection{RayProjection::Type::max, 0.35f};
        if (hasTetras) {
            auto box = std::make_shared<StyledTetras>();
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 place(corner & 1, corner >> 1 & 1, corner >> 2);
                box->places.push_back(place);
                box->positions.push_back(2.0f * place - 1.0f);
            }
            box->indices = {0, 3, 5, 6, 1, 3, 5, 0, 2, 3, 0, 6, 4, 5, 6, 0, 7, 3, 6, 5};
            scene.volumes[0].tetras = box;
        }
        ScenePicture cast;
        castScene(scene, 0, cast);
        for (const std::vector<float>& drawn : {picture(scene), cast.rgba}) {
            EXPECT_NEAR(pixelAt(drawn, 27, 40)[3], 61.0f / 255.0f, 1e-4f) << hasTetras;
            EXPECT_NEAR(pixelAt(drawn, 27, 40)[0], 0.8f * 61.0f / 255.0f, 1e-4f) << hasTetras;
        }
    }
}

TEST_P(SceneDrawing, projectionsOfTetrahedraStandBetweenOtherThings)
{
    StyledScene scene = turnedScene({}, true, 4);
    scene.volumes[0].tetras = tetras();
    scene.volumes[0].projection = RayProjection{};
    scene.volumes[0].clipPlanes = {{0.3, 1.0, 0.1, 0.4}};
    scene.surfaces = {sphere({0.3, 0.1, 0.3}, 0.5), pane({0, 0, 0.2}, kClearOfPixels, {1, 0, 0}, 0.4f)};
    compare(scene, "tetrahedra, sphere and pane");
    scene.volumes[0].segments = Segments{quarters(), 1, 255.0f, {1, -1, 0}, 0};
    scene.volumes[0].chains.push_back({styleWithReference(ToneMapped{})});
    compare(scene, "tetrahedra, segments, sphere and pane");
}

TEST_P(SceneDrawing, stipplesAreThePointsOfTheCpuEngine)
{
    StyledScene scene = turnedScene({});
    scene.volumes[0].stipple.emplace();
    scene.volumes[0].stipple->gradientThreshold = 0.0f;
    scene.surfaces = {sphere({0.5, 0.4, 0.4}, 0.5)};
    ScenePicture cast;
    castScene(scene, 0, cast);
    const std::vector<double> expected(cast.rgba.begin(), cast.rgba.end());
    EXPECT_GT(psnr(picture(scene), expected), kAlike);
    scene.volumes.push_back(turnedScene({}).volumes[0]);
    scene.volumes[1].projection = RayProjection{};
    castScene(scene, 0, cast);
    EXPECT_GT(psnr(picture(scene), {cast.rgba.begin(), cast.rgba.end()}), kAlike);
}

TEST_P(SceneDrawing, picturesAreThoseOfTheCpuEngine)
{
    for (const auto& [name, chain] : chains()) {
        const StyledScene scene = turnedScene(chain);
        ScenePicture cast;
        castScene(scene, 0, cast);
        EXPECT_GT(psnr(picture(scene), {cast.rgba.begin(), cast.rgba.end()}), kAlike) << name;
    }
}

TEST_P(SceneDrawing, shadowsAreThoseOfTheCpuEngine)
{
    Shaded shaded;
    shaded.lighting = true;
    shaded.shadows = true;
    shaded.specular = glm::vec3(0.5f);
    StyledScene scene = turnedScene({makeStyle(shaded)});
    StyledVolume& volume = scene.volumes[0];
    volume.dimensions = {2.0f, 0.8f, 0.5f}; // shadows of few texels
    volume.unitLength = 0.05;
    std::vector<StyleLight>& lights = volume.surroundings.lights;
    lights.insert(lights.end(), lights.begin(), lights.begin() + 2);
    lights[3].direction = -lights[3].direction;
    lights[4].position = -lights[4].position;
    const std::vector<float> bright = picture(scene);
    ShadowStore().add(volume, 0);
    ScenePicture cast;
    castScene(scene, 0, cast);
    const std::vector<double> expected(cast.rgba.begin(), cast.rgba.end());
    EXPECT_GT(psnr(picture(scene), expected), kAlike);
    EXPECT_LT(psnr(bright, expected), 35.0) << "shadows change next to nothing";
}

TEST_P(SceneDrawing, surfacesWithoutNormalsHaveThoseOfTheirTriangles)
{
    StyledScene scene = sceneOf(constant(0.0), true);
    scene.volumes.clear();
    scene.surfaces = {sphere({0.2, 0.1, 0.1}, 1.2)};
    scene.surfaces[0].normals.clear();
    ScenePicture cast;
    castScene(scene, 0, cast);
    EXPECT_GT(psnr(picture(scene), {cast.rgba.begin(), cast.rgba.end()}), kAlike);
}

// ---- The caller's state

/// A picture in which all that the drawer can do has a part.
StyledScene fullScene()
{
    StyledScene scene = turnedScene({styleWithReference(SilhouetteEnhancement{})});
    scene.background.opacity = 1.0f;
    scene.background.sky = {{0.1f, 0.2f, 0.3f}};
    scene.surfaces = {sphere({0.5, 0.4, 0.4}, 0.5), pane({0, 0, 0.3}, -0.9, {0, 0, 1}, 0.5f)};
    scene.volumes.push_back(turnedScene({}).volumes[0]);
    scene.volumes[1].projection = RayProjection{};
    scene.volumes[1].worldFromLocal = glm::translate(glm::dmat4(1.0), glm::dvec3(0.8, 0.0, 0.0));
    scene.volumes.push_back(turnedScene({}).volumes[0]);
    scene.volumes[2].stipple.emplace();
    scene.volumes.push_back(scene.volumes[1]);
    scene.volumes[3].tetras = tetras();
    return scene;
}

/// What a program may have set before it has a scene drawn.
void disturb(const GladGLContext& gl, bool core)
{
    GLuint names[8];
    gl.GenTextures(4, names);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_3D, names[0]);
    gl.BindTexture(GL_TEXTURE_2D, names[1]);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, names[2]);
    gl.GenSamplers(1, names);
    gl.SamplerParameteri(names[0], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.SamplerParameteri(names[0], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindSampler(0, names[0]);
    gl.ActiveTexture(GL_TEXTURE2);
    gl.GenVertexArrays(1, names);
    gl.BindVertexArray(names[0]);
    gl.GenBuffers(2, names);
    gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, names[1]);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 17);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    for (const GLenum name :
         {GL_CULL_FACE, GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL, GL_DEPTH_CLAMP, GL_PRIMITIVE_RESTART,
          GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE3, GL_PROGRAM_POINT_SIZE})
        gl.Enable(name);
    if (!core) {
        gl.Enable(GL_ALPHA_TEST);
        gl.AlphaFunc(GL_GREATER, 0.9f);
        gl.Enable(GL_POLYGON_STIPPLE);
        const GLubyte holes[128] = {};
        gl.PolygonStipple(holes);
    }
    gl.GenFramebuffers(1, names);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, names[0]);
    gl.CullFace(GL_FRONT_AND_BACK);
    gl.LogicOp(GL_CLEAR);
    gl.PolygonOffset(1.0f, 1e6f);
    gl.PrimitiveRestartIndex(0);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.FrontFace(GL_CW);
    gl.BlendFuncSeparate(GL_ZERO, GL_ONE, GL_DST_COLOR, GL_DST_ALPHA);
    gl.BlendEquationSeparate(GL_MAX, GL_FUNC_SUBTRACT);
    gl.DepthFunc(GL_NEVER);
    gl.PointSize(5.0f);
    gl.Viewport(3, 4, 20, 10);
}

/// All integers of OpenGL's state that a scene touches, by their names.
std::map<GLenum, std::vector<GLint>> stateOf(const GladGLContext& gl)
{
    std::map<GLenum, std::vector<GLint>> state;
    for (const GLenum name : {GL_CURRENT_PROGRAM,
                              GL_VERTEX_ARRAY_BINDING,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_ELEMENT_ARRAY_BUFFER_BINDING,
                              GL_PIXEL_UNPACK_BUFFER_BINDING,
                              GL_UNPACK_ROW_LENGTH,
                              GL_UNPACK_SKIP_ROWS,
                              GL_UNPACK_ALIGNMENT,
                              GL_ACTIVE_TEXTURE,
                              GL_BLEND,
                              GL_BLEND_SRC_RGB,
                              GL_BLEND_DST_RGB,
                              GL_BLEND_SRC_ALPHA,
                              GL_BLEND_DST_ALPHA,
                              GL_BLEND_EQUATION_RGB,
                              GL_BLEND_EQUATION_ALPHA,
                              GL_DEPTH_TEST,
                              GL_DEPTH_FUNC,
                              GL_DEPTH_WRITEMASK,
                              GL_CULL_FACE,
                              GL_COLOR_LOGIC_OP,
                              GL_POLYGON_OFFSET_FILL,
                              GL_DEPTH_CLAMP,
                              GL_PRIMITIVE_RESTART,
                              GL_CLIP_DISTANCE0,
                              GL_CLIP_DISTANCE1,
                              GL_CLIP_DISTANCE3,
                              GL_PROGRAM_POINT_SIZE,
                              GL_FRONT_FACE,
                              GL_POLYGON_MODE,
                              GL_VIEWPORT,
                              GL_POINT_SIZE,
                              GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_RENDERBUFFER_BINDING,
                              GL_SCISSOR_TEST,
                              GL_STENCIL_TEST,
                              GL_COLOR_WRITEMASK}) {
        std::vector<GLint>& values = state[name];
        values.resize(4);
        gl.GetIntegerv(name, values.data());
    }
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLenum unit = GL_TEXTURE0; unit < GL_TEXTURE0 + 8; ++unit) {
        gl.ActiveTexture(unit);
        for (const GLenum name : {GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY,
                                  GL_SAMPLER_BINDING}) {
            GLint value = 0;
            gl.GetIntegerv(name, &value);
            state[unit].push_back(value);
        }
    }
    gl.ActiveTexture(static_cast<GLenum>(active));
    return state;
}

TEST_P(SceneDrawing, stateOfTheCallerIsGivenBackAndDoesNotDisturb)
{
    const StyledScene scene = fullScene();
    const std::vector<float> expected = picture(scene);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    disturb(gl(), GetParam() == OffscreenProfile::Core);
    const auto before = stateOf(gl());
    SceneDrawer fresh; // sends its textures in this state
    fresh.draw(scene);
    EXPECT_EQ(stateOf(gl()), before);
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
    gl().BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    EXPECT_EQ(context_->readFloats(), expected);
}

TEST_P(SceneDrawing, scissorAndColorMaskOfTheCallerCount)
{
    const StyledScene scene = fullScene();
    const std::vector<float> expected = picture(scene);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl().Enable(GL_SCISSOR_TEST);
    gl().Scissor(10, 12, 30, 31);
    gl().ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    drawer_.draw(scene);
    const std::vector<float> drawn = context_->readFloats();
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const bool inside = x >= 10 && x < 40 && y >= 12 && y < 43;
            ASSERT_EQ(pixelAt(drawn, x, y)[0], inside ? pixelAt(expected, x, y)[0] : 0.0f) << x << " " << y;
            ASSERT_EQ(pixelAt(drawn, x, y)[1], 0.0f);
        }
}

// ---- Framebuffers of the caller

/// What a program has of colours and depths; depths may be missing (0).
struct Format
{
    GLenum depth;
    int samples;
    const char* name;
};

/// A framebuffer of 8-bit colours, and one without depths to read it.
class ByteFramebuffer
{
public:
    ByteFramebuffer(const GladGLContext& gl, const Format& format) : gl_(gl)
    {
        make(0, 0, framebuffers_[1], buffers_ + 2);
        make(format.samples, format.depth, framebuffers_[0], buffers_);
    }
    ~ByteFramebuffer()
    {
        gl_.DeleteFramebuffers(2, framebuffers_);
        gl_.DeleteRenderbuffers(3, buffers_);
    }
    ByteFramebuffer(const ByteFramebuffer&) = delete;
    ByteFramebuffer& operator=(const ByteFramebuffer&) = delete;

    std::vector<unsigned char> read() const
    {
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[1]);
        gl_.BlitFramebuffer(0, 0, kPixels, kPixels, 0, 0, kPixels, kPixels, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
        std::vector<unsigned char> pixels(4 * kPixels * kPixels);
        gl_.ReadPixels(0, 0, kPixels, kPixels, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }

private:
    void make(int samples, GLenum depth, GLuint& framebuffer, GLuint* buffers) const
    {
        gl_.GenFramebuffers(1, &framebuffer);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        const auto attach = [&](GLenum point, GLenum format, GLuint& buffer) {
            gl_.GenRenderbuffers(1, &buffer);
            gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
            gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kPixels, kPixels);
            gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer);
        };
        attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, buffers[0]);
        const bool both = depth == GL_DEPTH24_STENCIL8 || depth == GL_DEPTH32F_STENCIL8;
        if (depth != 0) attach(both ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depth, buffers[1]);
        EXPECT_EQ(gl_.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    }

    const GladGLContext& gl_;
    GLuint framebuffers_[2]{}, buffers_[3]{};
};

constexpr double kFaint = 0.002;
constexpr int kFaintSlices = 512;

/// Slices that are each less than what 8 bits can tell from nothing.
StyledScene faintScene()
{
    auto function = std::make_shared<VoxelTexture>();
    function->kind = TexelKind::float32;
    function->components = 4;
    const float texel[4] = {0.75f, 0.5f, 0.25f, static_cast<float>(kFaint)};
    function->texels.resize(sizeof texel);
    std::memcpy(function->texels.data(), texel, sizeof texel);
    OpacityMap map;
    map.transferFunction = function;
    StyledScene scene = sceneOf(constant(0.5), false);
    scene.volumes[0].chains = {{makeStyle(map)}};
    scene.volumes[0].unitLength = scene.volumes[0].spacing = 2.0 / kFaintSlices;
    return scene;
}

TEST_P(SceneDrawing, faintSlicesAddUpInFramebuffersOfEightBits)
{
    for (const Format& format :
         {Format{GL_DEPTH24_STENCIL8, 0, "24 bits"}, Format{GL_DEPTH_COMPONENT16, 0, "16 bits"},
          Format{GL_DEPTH_COMPONENT32F, 0, "floats"}, Format{0, 0, "no depths"},
          Format{GL_DEPTH24_STENCIL8, 4, "24 bits, samples"}, Format{GL_DEPTH_COMPONENT24, 4, "24, samples"},
          Format{GL_DEPTH32F_STENCIL8, 4, "floats, samples"}, Format{0, 4, "no depths, samples"}})
        for (const StyledScene& scene : {faintScene(), sliced(faintScene())}) {
            const ByteFramebuffer target(gl(), format);
            gl().ClearColor(0, 0, 0, 1);
            gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            // Something opaque in the left half, in the middle of the volume, at the depth 4 of 1 to 10.
            gl().Enable(GL_SCISSOR_TEST);
            gl().Scissor(0, 0, kPixels / 2, kPixels);
            gl().ClearDepth((4.0 - 1.0) / 9.0);
            gl().ClearColor(1, 1, 1, 1);
            gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            gl().Disable(GL_SCISSOR_TEST);
            gl().ClearDepth(1.0);
            drawer_.draw(scene);
            const std::vector<unsigned char> drawn = target.read();
            for (const bool left : {true, false}) {
                const bool hidden = left && format.depth != 0;
                const double alpha = 1.0 - std::pow(1.0 - kFaint, kFaintSlices / (hidden ? 2.0 : 1.0));
                for (std::size_t c = 0; c < 3; ++c) {
                    const double color = 0.75 - 0.25 * static_cast<double>(c);
                    const double expected = 255.0 * (alpha * color + (1.0 - alpha) * (left ? 1.0 : 0.0));
                    EXPECT_NEAR(drawn[4 * (32 * kPixels + (left ? 20 : 44)) + c], expected, 1.0)
                        << format.name << (scene.surfaces.empty() ? "" : ", slices") << (left ? " left" : "");
                }
            }
        }
}

TEST_P(SceneDrawing, opaqueSurfacesHideVolumesWhereThereAreNoDepths)
{
    StyledScene scene = faintScene();
    scene.surfaces = {pane({0, 0, 0}, 0.0, {1, 0, 0}, 0.0f)};
    const ByteFramebuffer target(gl(), {0, 0, "no depths"});
    drawer_.draw(scene);
    const double alpha = 1.0 - std::pow(1.0 - kFaint, kFaintSlices / 2.0);
    EXPECT_NEAR(target.read()[4 * (32 * kPixels + 32)], 255.0 * (alpha * 0.75 + 1.0 - alpha), 1.0);
}

TEST_P(SceneDrawing, opaqueSurfacesLeaveTheirDepths)
{
    StyledScene scene = faintScene();
    scene.surfaces = {pane({0, 0, 0.5}, 0.0, {1, 0, 0}, 0.0f)};
    scene.surfaces[0].worldFromLocal = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, 0.5));
    picture(scene);
    float depth = 0.0f;
    gl().ReadPixels(32, 32, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_NEAR(depth, 2.5 / 9.0, 1e-6);
}

// ---- What cannot be drawn

std::string failureOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

TEST_P(SceneDrawing, texturesThatTheDriverCannotHoldAreNamed)
{
    auto wide = std::make_shared<VoxelTexture>();
    wide->size = {1 << 20, 1, 1};
    wide->texels.resize(1 << 20);
    StyledScene scene = sceneOf(constant(0.2), true);
    scene.volumes[0].voxels = wide;
    EXPECT_NE(failureOf([&] { picture(scene); }).find("1048576 x 1 x 1"), std::string::npos);
    wide->size = {16, 16, 16};
    wide->texels.resize(100);
    EXPECT_NE(failureOf([&] { picture(scene); }).find("100 bytes"), std::string::npos);
    scene.volumes[0].voxels = constant(0.2);
    EXPECT_EQ(failureOf([&] { picture(scene); }), "");
}

TEST_P(SceneDrawing, spacingsThatAreTooFineAreNamed)
{
    StyledScene scene = sceneOf(constant(0.2), true);
    scene.volumes[0].spacing = 1e-9;
    EXPECT_NE(failureOf([&] { picture(scene); }).find("sampling planes"), std::string::npos);
}

TEST_P(SceneDrawing, contextsAreNeeded)
{
    const StyledScene scene = sceneOf(constant(0.2), true);
    context_->release();
    SceneDrawer drawer;
    EXPECT_NE(failureOf([&] { drawer.draw(scene); }).find("no OpenGL context"), std::string::npos);
    ASSERT_TRUE(context_->makeCurrent());
    picture(scene);
    context_->release();
    EXPECT_NE(failureOf([&] { drawer_.draw(scene); }).find("not current"), std::string::npos);
    ASSERT_TRUE(context_->makeCurrent());
}

TEST_P(SceneDrawing, volumesAndSurfacesWithoutSenseAreLeftOut)
{
    const StyledScene scene = sceneOf(constant(0.2), true);
    const auto isClear = [this](const StyledScene& changed) {
        const std::vector<float> drawn = picture(changed);
        return std::ranges::all_of(drawn, [](float value) { return value == 0.0f; });
    };
    EXPECT_FALSE(isClear(scene));
    const auto changed = [&](const std::function<void(StyledVolume&)>& change) {
        StyledScene copy = scene;
        change(copy.volumes[0]);
        return copy;
    };
    EXPECT_TRUE(isClear(changed([](StyledVolume& volume) { volume.voxels = nullptr; })));
    EXPECT_TRUE(isClear(changed([](StyledVolume& volume) { volume.dimensions.y = 0.0f; })));
    EXPECT_TRUE(isClear(changed([](StyledVolume& volume) { volume.spacing = 0.0; })));
    EXPECT_TRUE(isClear(changed([](StyledVolume& volume) { volume.unitLength = NAN; })));
    EXPECT_TRUE(isClear(changed([](StyledVolume& volume) { volume.chains.clear(); })));
    EXPECT_TRUE(isClear(changed([](StyledVolume& volume) { volume.worldFromLocal = glm::dmat4(0.0); })));
    EXPECT_TRUE(isClear(changed([](StyledVolume& volume) { volume.segments.emplace(); })));
    StyledScene surface = scene;
    surface.volumes.clear();
    surface.surfaces = {pane({0, 0, 0}, 0.0, {1, 0, 0}, 0.0f), pane({0, 0, 0}, 0.0, {1, 0, 0}, 0.5f)};
    EXPECT_FALSE(isClear(surface));
    for (StyledSurface& changedSurface : surface.surfaces)
        changedSurface.triangles[3] = 4;
    EXPECT_TRUE(isClear(surface));
}

TEST_P(SceneDrawing, texturesThatAreForgottenComeBack)
{
    const StyledScene scene = turnedScene({}), other = sceneOf(constant(0.2), true);
    const std::vector<float> expected = picture(scene);
    for (int i = 0; i < 40; ++i)
        picture(other);
    EXPECT_EQ(picture(scene), expected);
}

} // namespace
