// Pictures of the CPU engine against the reference in double precision.

#include "cast/cast_scene.h"
#include "style/shadow_textures.h"
#include "styled_scenes.h"
#include "support/styled_reference.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <string>

namespace {

using namespace styled_scenes;
using vo::test::psnr;
using vo::test::ReferenceStyle;
using vo::test::styleWithReference;

constexpr double kLeastDecibels = 45.0;
/// A sample too few is seen.
constexpr double kSameSamples = 70.0;

void expectReference(const vo::StyledScene& scene, const std::string& what, double least = kLeastDecibels)
{
    const vo::ScenePicture picture = castOf(scene, 0);
    const std::vector<double> reference = vo::test::styledReference(scene);
    ASSERT_EQ(picture.rgba.size(), reference.size());
    double contrast = 0.0;
    for (std::size_t i = 4; i < reference.size(); ++i)
        contrast = std::max(contrast, std::abs(reference[i] - reference[i % 4]));
    EXPECT_GT(contrast, 0.05) << what << ": nothing is seen";
    EXPECT_GE(psnr(picture.rgba, reference), least) << what;
}

/// Bumps, different in each component.
float bumps(const glm::vec3& p, int component)
{
    const auto c = static_cast<float>(component);
    return 0.5f + 0.3f * std::sin(7.0f * p.x + c) * std::cos(6.0f * p.y - c) +
           0.2f * std::sin(8.0f * p.z + 2.0f * p.x + 2.0f * c);
}

vo::StyleLight lampOf(vo::StyleLight::Kind kind)
{
    vo::StyleLight light;
    light.kind = kind;
    light.color = {1.0f, 0.9f, 0.7f};
    light.intensity = 0.8f;
    light.ambientIntensity = 0.3f;
    light.direction = glm::normalize(glm::vec3(-0.5f, -0.3f, -1.0f));
    light.position = {3.0f, 4.0f, 9.0f};
    light.attenuation = {1.0f, 0.02f, 0.002f};
    light.radius = 14.0f;
    light.beamWidth = 0.3f;
    light.cutOffAngle = 0.7f;
    return light;
}

/// A volume of uneven voxels, turned and unevenly scaled.
vo::StyledVolume turnedVolume(int components = 1)
{
    vo::StyledVolume volume = boxOf(bytesOf({16, 12, 10}, components, bumps), {8.0f, 7.0f, 6.5f});
    volume.unitLength = 0.5;
    volume.spacing = 0.37;
    volume.worldFromLocal = glm::translate(glm::dmat4(1.0), {0.3, -0.2, 0.1});
    volume.worldFromLocal =
        glm::rotate(volume.worldFromLocal, 0.7, glm::normalize(glm::dvec3(1.0, 2.0, 0.5)));
    volume.worldFromLocal = glm::scale(volume.worldFromLocal, {1.0, 1.4, 0.8});
    volume.surroundings.lights = {lampOf(vo::StyleLight::Kind::directional),
                                  lampOf(vo::StyleLight::Kind::point), lampOf(vo::StyleLight::Kind::spot)};
    return volume;
}

vo::StyledScene sceneOf(bool perspective, const vo::StyledVolume& volume)
{
    vo::StyledScene scene = perspective ? perspectiveScene(36) : orthoScene(36, 7.0);
    if (perspective) scene.clipFromEye = glm::perspective(0.7, 1.0, 1.0, 100.0);
    scene.background.sky = {{0.1f, 0.2f, 0.3f}};
    scene.volumes.push_back(volume);
    return scene;
}

/// A function of luminance to a colour: clear below 0.4.
std::shared_ptr<vo::VoxelTexture> rampFunction()
{
    return bytesOf({64, 1, 1}, 4, [](const glm::vec3& p, int c) {
        if (c == 3) return std::max(0.0f, p.x - 0.4f);
        return c == 0 ? p.x : c == 1 ? 1.0f - p.x : 0.5f;
    });
}

std::shared_ptr<vo::VoxelTexture> normalTexture()
{
    return bytesOf({9, 8, 7}, 3, bumps);
}

std::vector<std::pair<std::string, ReferenceStyle>> allStyles()
{
    vo::OpacityMap map;
    map.transferFunction = rampFunction();
    vo::OpacityMap reversed;
    reversed.opaqueAtZero = true;
    vo::BoundaryEnhancement boundary;
    boundary.boundaryOpacity = 3.0f;
    boundary.opacityFactor = 0.7f;
    vo::EdgeEnhancement edge;
    edge.edgeColor = {1, 0, 0, 1};
    vo::SilhouetteEnhancement silhouette;
    silhouette.retainedOpacity = 0.1f;
    silhouette.boundaryOpacity = 0.7f;
    silhouette.sharpness = 2.0f;
    vo::Cartoon cartoon;
    cartoon.parallelColor = {0, 0, 0.5f, 1};
    cartoon.surfaceNormals = normalTexture();
    vo::Shaded shaded;
    shaded.lighting = true;
    shaded.hasMaterial = true;
    shaded.diffuse = {0.8f, 0.6f, 0.4f};
    shaded.specular = {0.5f, 0.5f, 0.5f};
    shaded.emissive = {0.05f, 0.0f, 0.0f};
    shaded.transparency = 0.2f;
    vo::Blended blended;
    blended.voxels = bytesOf({8, 8, 8}, 3, bumps);
    blended.dimensions = {8.0f, 7.0f, 6.5f};
    blended.weightFunction2 = vo::Blended::Weight::alpha0;
    return {{"OpacityMap", map},
            {"OpacityMap of 2005", reversed},
            {"Boundary", boundary},
            {"Edge", edge},
            {"Silhouette", silhouette},
            {"Cartoon", vo::Cartoon{}},
            {"Cartoon, normals", cartoon},
            {"ToneMapped", vo::ToneMapped{}},
            {"Shaded", shaded},
            {"Blended", blended}};
}

TEST(styledPictures, eachStyleIsThatOfTheReference)
{
    for (const auto& [name, fields] : allStyles())
        for (const bool perspective : {false, true}) {
            vo::StyledVolume volume = turnedVolume();
            volume.chains = {{styleWithReference(fields)}};
            expectReference(sceneOf(perspective, volume), name + (perspective ? ", perspective" : ""));
        }
}

TEST(styledPictures, eachNumberOfComponents)
{
    for (const int components : {1, 2, 3, 4}) {
        vo::StyledVolume volume = turnedVolume(components);
        expectReference(sceneOf(true, volume), std::to_string(components) + " components");
        volume.chains = {{styleWithReference(vo::SilhouetteEnhancement{0.2f, 0.8f, 1.0f, nullptr})}};
        expectReference(sceneOf(false, volume), std::to_string(components) + " components, silhouette");
    }
}

TEST(styledPictures, eachKindOfTexel)
{
    vo::StyledVolume volume = turnedVolume();
    volume.chains = {{styleWithReference(vo::EdgeEnhancement{})}};
    volume.voxels = textureOf({9, 8, 7}, 1, bumps);
    expectReference(sceneOf(true, volume), "float");
    auto nearest = bytesOf({9, 8, 7}, 1, bumps);
    nearest->nearest = true;
    volume.voxels = nearest;
    expectReference(sceneOf(true, volume), "nearest");
    auto repeated = bytesOf({9, 8, 7}, 1, bumps);
    repeated->repeats = {true, false, true};
    volume.voxels = repeated;
    expectReference(sceneOf(true, volume), "repeated");
}

vo::StyleChain composite()
{
    vo::OpacityMap map;
    map.transferFunction = rampFunction();
    vo::EdgeEnhancement edge;
    edge.edgeColor = {1, 0, 0, 1};
    return {styleWithReference(map), styleWithReference(edge), styleWithReference(vo::BoundaryEnhancement{}),
            styleWithReference(vo::SilhouetteEnhancement{0.3f, 0.7f, 0.5f, nullptr}),
            styleWithReference(vo::ToneMapped{})};
}

TEST(styledPictures, compositesInOrder)
{
    for (const bool perspective : {false, true}) {
        vo::StyledVolume volume = turnedVolume();
        volume.chains = {composite()};
        expectReference(sceneOf(perspective, volume), "in order");
        std::reverse(volume.chains[0].begin(), volume.chains[0].end());
        expectReference(sceneOf(perspective, volume), "in reverse");
    }
}

TEST(styledPictures, segmentsHaveTheirStyles)
{
    vo::Segments segments;
    segments.identifiers = bytesOf({5, 4, 3}, 2, [](const glm::vec3& p, int c) {
        return c == 0 ? 0.0f : std::floor(5.0f * p.x + 2.0f * p.y) / 255.0f;
    });
    segments.component = 1;
    segments.chainOf = {0, 1, -1, 2};
    segments.beyond = 1;
    vo::StyledVolume volume = turnedVolume();
    volume.segments = segments;
    volume.chains = {composite(), {}, {styleWithReference(vo::Cartoon{})}};
    expectReference(sceneOf(false, volume), "segments");
    expectReference(sceneOf(true, volume), "segments, perspective");
    volume.projection.emplace();
    expectReference(sceneOf(true, volume), "segments, projection");
}

TEST(styledPictures, projections)
{
    using Type = vo::RayProjection::Type;
    for (const Type type : {Type::max, Type::min, Type::average})
        for (const float threshold : {0.0f, 0.4f, 0.95f})
            for (const int components : {1, 2, 4}) {
                vo::StyledVolume volume = turnedVolume(components);
                volume.projection = vo::RayProjection{type, threshold};
                if (components == 2) volume.chains = {composite()};
                expectReference(sceneOf(components > 1, volume),
                                "type " + std::to_string(static_cast<int>(type)) + ", threshold " +
                                    std::to_string(threshold) + ", components " + std::to_string(components));
            }
}

TEST(styledPictures, surfacesOfValues)
{
    vo::Shaded shaded;
    shaded.lighting = true;
    shaded.hasMaterial = true;
    vo::Shaded clear = shaded;
    clear.transparency = 0.6f;
    for (const float tolerance : {0.0f, 0.06f}) {
        vo::StyledVolume volume = turnedVolume();
        vo::IsoSurfaces surfaces;
        surfaces.values = {0.3f, 0.55f, 0.7f};
        surfaces.chains = {{styleWithReference(clear)}, {styleWithReference(shaded)}};
        surfaces.surfaceTolerance = tolerance;
        volume.surfaces = surfaces;
        expectReference(sceneOf(false, volume), "surfaces");
        expectReference(sceneOf(true, volume), "surfaces, perspective");
        volume.surfaces->gradients = normalTexture();
        expectReference(sceneOf(true, volume), "surfaces, gradients");
    }
}

/// The box as five tetrahedra, one corner of it pulled out.
std::shared_ptr<vo::StyledTetras> fiveTetras(const glm::vec3& dimensions)
{
    auto tetras = std::make_shared<vo::StyledTetras>();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        tetras->places.push_back(place * 0.9f + 0.05f);
        tetras->positions.push_back((place - 0.5f) * dimensions * (corner == 7 ? 1.3f : 1.0f));
    }
    tetras->indices = {0, 3, 5, 6, 1, 0, 3, 5, 2, 0, 3, 6, 4, 0, 5, 6, 7, 3, 5, 6};
    return tetras;
}

TEST(styledPictures, tetrahedraCarryPlacesAndNormals)
{
    vo::StyledVolume volume = turnedVolume();
    volume.tetras = fiveTetras(volume.dimensions);
    expectReference(sceneOf(false, volume), "tetrahedra");
    volume.chains = {composite()};
    expectReference(sceneOf(true, volume), "tetrahedra, composite");
    volume.surfaces = vo::IsoSurfaces{{0.5f}, {{styleWithReference(vo::ToneMapped{})}}, 0.0f, nullptr};
    expectReference(sceneOf(true, volume), "tetrahedra, surface");
}

TEST(styledPictures, whatIsLeaptOverHasNothing)
{
    // Blobs far apart, and a lone voxel here and there.
    const auto blobs = [](const glm::vec3& p, int) {
        const glm::vec3 cell = glm::fract(p * 2.0f) - 0.5f;
        const bool lone = std::fmod(std::floor(p.x * 50.0f) * 7.0f + std::floor(p.y * 42.0f) * 13.0f +
                                        std::floor(p.z * 46.0f) * 29.0f,
                                    997.0f) < 1.0f;
        return lone ? 1.0f : std::max(0.0f, 0.9f - 4.0f * glm::length(cell));
    };
    vo::OpacityMap narrow;
    narrow.transferFunction = bytesOf({256, 1, 1}, 2, [](const glm::vec3& p, int c) {
        return c == 0 || std::abs(p.x - 0.4f) < 0.02f ? 1.0f : 0.0f;
    });
    vo::OpacityMap reversed;
    reversed.opaqueAtZero = true;
    for (const bool perspective : {false, true}) {
        vo::StyledVolume volume = turnedVolume();
        volume.voxels = bytesOf({50, 42, 46}, 1, blobs);
        volume.unitLength = volume.spacing = 0.14;
        expectReference(sceneOf(perspective, volume), "sparse", kSameSamples);
        volume.chains = {{styleWithReference(narrow), styleWithReference(vo::ToneMapped{})}};
        expectReference(sceneOf(perspective, volume), "narrow", kSameSamples);
        volume.chains = {{styleWithReference(reversed)}};
        volume.unitLength = 3.0;
        expectReference(sceneOf(perspective, volume), "opaque at zero", kSameSamples);
        volume.chains = {{styleWithReference(vo::ToneMapped{})}};
        volume.surfaces = vo::IsoSurfaces{{0.2f, 0.5f, 0.95f}, volume.chains, 0.0f, nullptr};
        expectReference(sceneOf(perspective, volume), "surfaces", kSameSamples);
    }
}

/// Blobs in the middle; nothing at the faces.
float inside(const glm::vec3& p, int component)
{
    const glm::vec3 cell = glm::fract(p * 2.0f) - 0.5f;
    return std::max(0.0f, 0.9f - (4.0f + static_cast<float>(component)) * glm::length(cell));
}

/// Voxels that repeat are not leapt over, and are the same where there is nothing at the faces.
void expectSameWithoutLeaps(vo::StyledScene scene, const std::string& what)
{
    const vo::ScenePicture leapt = castOf(scene, 0);
    auto repeated = std::make_shared<vo::VoxelTexture>(*scene.volumes[0].voxels);
    repeated->repeats = {true, true, true};
    repeated->serial = vo::newSerial();
    scene.volumes[0].voxels = repeated;
    const vo::ScenePicture whole = castOf(scene, 0);
    double most = 0.0;
    for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
        ASSERT_NEAR(leapt.rgba[i], whole.rgba[i], 1e-6f) << what << ", " << i;
        most = std::max(most, std::abs(double(whole.rgba[i]) - double(whole.rgba[i % 4])));
    }
    EXPECT_GT(most, 0.05) << what << ": nothing is seen";
    ASSERT_EQ(leapt.depth, whole.depth) << what;
}

vo::StyledVolume sparseVolume(int components)
{
    vo::StyledVolume volume = turnedVolume();
    volume.voxels = bytesOf({50, 42, 46}, components, inside);
    volume.unitLength = volume.spacing = 0.14;
    return volume;
}

TEST(styledPictures, projectionsAreTheSameWithoutLeaps)
{
    using Type = vo::RayProjection::Type;
    for (const bool perspective : {false, true})
        for (const Type type : {Type::max, Type::min, Type::average})
            for (const float threshold : {0.0f, 0.3f}) {
                vo::StyledVolume volume = sparseVolume(1);
                volume.projection = vo::RayProjection{type, threshold};
                vo::StyledScene scene = sceneOf(perspective, volume);
                scene.background.sky = {{0.7f, 0.6f, 0.5f}};
                const std::string what = "type " + std::to_string(static_cast<int>(type)) + ", threshold " +
                                         std::to_string(threshold);
                expectSameWithoutLeaps(scene, what);
                expectReference(scene, what, kSameSamples);
            }
}

TEST(styledPictures, colorsAreTheSameWithoutLeaps)
{
    vo::OpacityMap reversed;
    reversed.opaqueAtZero = true;
    for (const int components : {2, 3, 4}) {
        vo::StyledVolume volume = sparseVolume(components);
        const std::string what = std::to_string(components) + " components";
        expectSameWithoutLeaps(sceneOf(true, volume), what);
        expectReference(sceneOf(true, volume), what, kSameSamples);
        reversed.voxelComponents = components;
        volume.chains = {{styleWithReference(reversed)}};
        volume.unitLength = 3.0;
        expectSameWithoutLeaps(sceneOf(true, volume), what + ", opaque at zero");
    }
}

TEST(styledPictures, segmentsAreTheSameWithoutLeaps)
{
    vo::OpacityMap reversed;
    reversed.opaqueAtZero = true;
    vo::Segments segments;
    segments.identifiers = bytesOf({50, 42, 46}, 1, [](const glm::vec3& p, int) {
        return std::floor(3.0f * p.x + 2.0f * p.y) / 255.0f;
    });
    segments.chainOf = {-1, 0, 1, -1};
    segments.beyond = 0;
    for (const bool perspective : {false, true}) {
        vo::StyledVolume volume = sparseVolume(1);
        volume.segments = segments;
        volume.chains = {{}, {styleWithReference(reversed), styleWithReference(vo::ToneMapped{})}};
        volume.unitLength = 3.0;
        expectSameWithoutLeaps(sceneOf(perspective, volume), "segments");
        expectReference(sceneOf(perspective, volume), "segments", kSameSamples);
    }
}

vo::StyledSurface ball(const glm::dvec3& at, double radius)
{
    vo::StyledSurface surface;
    constexpr int kAcross = 24;
    for (int row = 0; row <= kAcross; ++row)
        for (int column = 0; column <= kAcross; ++column) {
            const double latitude = kPi * (row / double(kAcross) - 0.5),
                         longitude = 2.0 * kPi * column / kAcross;
            surface.normals.emplace_back(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                                         -std::cos(latitude) * std::sin(longitude));
            surface.positions.push_back(surface.normals.back() * static_cast<float>(radius));
        }
    for (int row = 0; row < kAcross; ++row)
        for (int column = 0; column < kAcross; ++column) {
            const int a = row * (kAcross + 1) + column, b = a + 1, c = a + kAcross + 1, d = c + 1;
            surface.triangles.insert(surface.triangles.end(), {a, b, d, a, d, c});
        }
    surface.worldFromLocal = glm::scale(glm::translate(glm::dmat4(1.0), at), {1.0, 1.5, 1.0});
    surface.diffuse = {0.3f, 0.8f, 0.5f};
    surface.specular = {0.6f, 0.6f, 0.6f};
    surface.lights = {lampOf(vo::StyleLight::Kind::directional), lampOf(vo::StyleLight::Kind::spot)};
    return surface;
}

TEST(styledPictures, volumesAndSurfacesTogether)
{
    for (const bool perspective : {false, true}) {
        vo::StyledVolume volume = turnedVolume();
        volume.chains = {composite()};
        vo::StyledScene scene = sceneOf(perspective, volume);
        volume = turnedVolume(4);
        volume.worldFromLocal = glm::translate(glm::dmat4(1.0), {2.0, 1.0, 1.5});
        volume.spacing = 0.5;
        volume.clipPlanes = {{0.3, 0.5, -0.4, 1.0}};
        scene.volumes.push_back(volume);
        scene.surfaces = {ball({-1.03, 0.57, 1.0}, 2.0), ball({1.01, -1.07, 2.0}, 1.5),
                          ball({1.53, 1.02, 1.0}, 2.5)};
        scene.surfaces[1].transparency = 0.5f;
        scene.surfaces[2].solid = false;
        scene.surfaces[2].clipPlanes = {{0.0, 0.6, -0.8, 1.0}};
        for (std::size_t i = 0; i < scene.surfaces[2].positions.size(); ++i)
            scene.surfaces[2].colors.emplace_back(1.0f, 0.4f, 0.2f,
                                                  0.3f + 0.2f * std::sin(0.3f * static_cast<float>(i)));
        expectReference(scene, "together");
    }
}

TEST(styledPictures, projectionsStandAmongOtherThings)
{
    for (const bool perspective : {false, true}) {
        vo::StyledVolume volume = turnedVolume(4);
        volume.projection = vo::RayProjection{};
        volume.clipPlanes = {{0.3, 0.5, -0.4, 1.0}};
        vo::StyledScene scene = sceneOf(perspective, volume);
        volume = turnedVolume(2);
        volume.worldFromLocal = glm::translate(glm::dmat4(1.0), {2.0, 1.0, 1.5});
        volume.spacing = 0.5;
        volume.projection = vo::RayProjection{vo::RayProjection::Type::average, 0.0f};
        scene.volumes.push_back(volume);
        expectReference(scene, "two projections", kSameSamples);
        volume.projection.reset();
        volume.worldFromLocal = glm::translate(glm::dmat4(1.0), {-2.0, 0.5, 1.0});
        scene.volumes.push_back(volume);
        expectReference(scene, "two projections and samples", 60.0);
        scene.surfaces = {ball({1.01, -1.07, 2.0}, 1.5)};
        scene.surfaces[0].transparency = 0.5f;
        expectReference(scene, "projections, samples and a translucent ball");
    }
}

// Engines read what comes through from textures; the reference goes straight to the light from each sample.
TEST(styledPictures, shadowsAreThoseOfStraightWays)
{
    vo::OpacityMap map;
    map.transferFunction = rampFunction();
    vo::Shaded shaded;
    shaded.lighting = true;
    shaded.shadows = true;
    shaded.specular = {0.3f, 0.3f, 0.3f};
    vo::StyledVolume volume = turnedVolume();
    volume.chains = {{styleWithReference(map), styleWithReference(shaded)}};
    volume.surroundings.lights.pop_back();
    vo::StyledScene scene = sceneOf(true, volume);
    scene.width = scene.height = 16;
    const std::vector<double> reference = vo::test::styledReference(scene);
    EXPECT_LT(psnr(castOf(scene, 0).rgba, reference), 35.0) << "shadows change next to nothing";
    vo::ShadowStore().add(scene.volumes[0], 0);
    EXPECT_GE(psnr(castOf(scene, 0).rgba, reference), kLeastDecibels);
}

} // namespace
