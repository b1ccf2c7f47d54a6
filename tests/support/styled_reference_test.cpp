#include "support/styled_reference.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>

namespace vo::test {
namespace {

constexpr double kExact = 1e-6; // floats in scenes

std::shared_ptr<VoxelTexture> texture(VoxelSize size, int components, const std::vector<float>& values)
{
    auto made = std::make_shared<VoxelTexture>();
    made->size = size;
    made->components = components;
    made->kind = TexelKind::float32;
    const auto bytes = std::as_bytes(std::span(values));
    made->texels.assign(bytes.begin(), bytes.end());
    return made;
}

/// A cube of `size` voxels a side that has `valueAt` of their z (0 to size - 1), an edge of 1 each; seen from
/// z = 100 along -z by parallel rays, one pixel each 1 x 1 voxel wide; the sky is clear.
template <class ValueAt>
StyledScene cubeAlongZ(int size, const ValueAt& valueAt)
{
    std::vector<float> values;
    for (int z = 0; z < size; ++z)
        values.insert(values.end(), static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                      static_cast<float>(valueAt(z)));
    StyledScene scene;
    scene.width = scene.height = size;
    scene.background.opacity = 0.0f;
    const double half = size / 2.0;
    scene.clipFromEye = glm::ortho(-half, half, -half, half, 1.0, 200.0);
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -100));
    StyledVolume volume;
    volume.dimensions = glm::vec3(static_cast<float>(size));
    volume.voxels = texture({size, size, size}, 1, values);
    scene.volumes.push_back(volume);
    return scene;
}

std::array<double, 4> pixel(const StyledScene& scene, int x, int y)
{
    const std::vector<double> picture = styledReference(scene);
    const std::size_t at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x)) *
        4;
    return {picture[at], picture[at + 1], picture[at + 2], picture[at + 3]};
}

std::array<double, 4> middlePixel(const StyledScene& scene)
{
    return pixel(scene, scene.width / 2, scene.height / 2);
}

StyledSurface square(double z, const glm::vec3& emissive, float transparency)
{
    StyledSurface surface;
    const auto depth = static_cast<float>(z);
    surface.positions = {{-9, -9, depth}, {9, -9, depth}, {9, 9, depth}, {-9, 9, depth}};
    surface.normals.assign(4, glm::vec3(0, 0, 1));
    surface.triangles = {0, 1, 2, 0, 2, 3};
    surface.lit = false;
    surface.emissive = emissive;
    surface.transparency = transparency;
    return surface;
}

TEST(StyledReference, constantOpacityIsThatOfTheLengthWhateverTheSpacing)
{
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.25; });
    for (const double spacing : {1.0, 0.5, 0.1}) {
        scene.volumes[0].spacing = spacing;
        const double alpha = 1.0 - std::pow(0.75, 4.0);
        EXPECT_NEAR(middlePixel(scene)[3], alpha, kExact);
        EXPECT_NEAR(middlePixel(scene)[0], alpha * 0.25, kExact);
    }
}

TEST(StyledReference, opacityIsOfLengthsInLocalSpace)
{
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.25; });
    scene.volumes[0].worldFromLocal = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, 3));
    scene.volumes[0].spacing = 3.0 / 7.0;
    scene.volumes[0].unitLength = 0.5;
    EXPECT_NEAR(middlePixel(scene)[3], 1.0 - std::pow(0.75, 8.0), kExact);
}

TEST(StyledReference, obliqueRaysAreLonger)
{
    // A slab 4 thick seen under 60 degrees: rays of 8 in it, as long as they meet neither side.
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.25; });
    scene.volumes[0].dimensions = {400, 400, 4};
    scene.volumes[0].spacing = 8.0 / 64.0;
    scene.eyeFromWorld =
        scene.eyeFromWorld * glm::rotate(glm::dmat4(1.0), std::numbers::pi / 3.0, glm::dvec3(0, 1, 0));
    EXPECT_NEAR(middlePixel(scene)[3], 1.0 - std::pow(0.75, 8.0), kExact);
}

TEST(StyledReference, perspectiveRaysHaveTheirOwnLength)
{
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.25; });
    scene.volumes[0].dimensions = {400, 400, 4};
    scene.volumes[0].spacing = 0.125;
    scene.clipFromEye = glm::frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 1000.0);
    // The centre of the corner pixel is 3/4 of the way to the corner, in both directions.
    const double slope = std::sqrt(1.0 + 2.0 * 0.75 * 0.75);
    EXPECT_NEAR(pixel(scene, 3, 3)[3], 1.0 - std::pow(0.75, 4.0 * slope), kExact);
}

TEST(StyledReference, nearerSamplesAreInFront)
{
    // The nearer half is white and half opaque, the farther black and opaque.
    StyledScene scene = cubeAlongZ(2, [](int) { return 0.0; });
    scene.volumes[0].voxels = texture({1, 1, 2}, 2, {0.0f, 1.0f, 1.0f, 0.5f});
    auto nearest = std::make_shared<VoxelTexture>(*scene.volumes[0].voxels);
    nearest->nearest = true;
    scene.volumes[0].voxels = nearest;
    EXPECT_NEAR(middlePixel(scene)[0], 0.5, kExact);
    EXPECT_NEAR(middlePixel(scene)[3], 1.0, kExact);
}

TEST(StyledReference, volumesThatOverlapAreJoinedSampleBySample)
{
    StyledScene scene = cubeAlongZ(1, [](int) { return 0.0; });
    scene.volumes[0].voxels = texture({1, 1, 1}, 2, {1.0f, 0.5f});
    scene.volumes[0].spacing = 0.5;
    scene.volumes.push_back(scene.volumes[0]);
    scene.volumes[1].voxels = texture({1, 1, 1}, 2, {0.0f, 0.5f});
    // Opacity 1 - sqrt(1/2) each, white and black in turn, four of them.
    const double a = 1.0 - std::sqrt(0.5);
    EXPECT_NEAR(middlePixel(scene)[0], a * (1.0 + 0.5), kExact);
    EXPECT_NEAR(middlePixel(scene)[3], 0.75, kExact);
}

TEST(StyledReference, opaqueSurfacesHideWhatLiesBehindThem)
{
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.25; });
    scene.volumes[0].spacing = 0.125;
    scene.surfaces.push_back(square(1.0, {0, 1, 0}, 0.0f));
    const auto color = middlePixel(scene);
    EXPECT_NEAR(color[0], 0.25 * 0.25, kExact);
    EXPECT_NEAR(color[1], 0.25 * 0.25 + 0.75, kExact);
}

TEST(StyledReference, translucentSurfacesStandBetweenSamples)
{
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.5; });
    scene.volumes[0].spacing = 0.125;
    scene.surfaces.push_back(square(1.0, {0, 0, 1}, 0.5f));
    const auto color = middlePixel(scene);
    const double behind = 0.25 * (1.0 - std::pow(0.5, 3.0));
    EXPECT_NEAR(color[0], 0.5 * (0.5 + behind), kExact);
    EXPECT_NEAR(color[2], 0.5 * (0.5 + behind) + 0.25, kExact);
    EXPECT_NEAR(color[3], 0.5 + 0.25 + behind, kExact);
}

TEST(StyledReference, solidSurfacesAreSeenFromOutsideAlone)
{
    StyledScene scene = cubeAlongZ(1, [](int) { return 0.0; });
    scene.surfaces.push_back(square(0.0, {0, 1, 0}, 0.0f));
    scene.surfaces[0].triangles = {0, 2, 1, 0, 3, 2};
    EXPECT_EQ(middlePixel(scene)[3], 0.0);
    scene.surfaces[0].solid = false;
    EXPECT_EQ(middlePixel(scene)[3], 1.0);
    scene.surfaces[0].solid = true;
    scene.surfaces[0].triangles = {0, 1, 2, 0, 2, 3};
    EXPECT_EQ(middlePixel(scene)[3], 1.0);
    // Mirrored, outside is still where it was.
    scene.surfaces[0].worldFromLocal = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1));
    EXPECT_EQ(middlePixel(scene)[3], 1.0);
}

TEST(StyledReference, surfacesAreLit)
{
    StyledScene scene = cubeAlongZ(1, [](int) { return 0.0; });
    scene.surfaces.push_back(square(0.0, {0, 0, 0}, 0.0f));
    scene.surfaces[0].lit = true;
    scene.surfaces[0].diffuse = {0.5f, 0.25f, 1.0f};
    StyleLight light;
    light.direction = {0.6f, 0.0f, -0.8f};
    light.ambientIntensity = 0.5f;
    scene.surfaces[0].lights = {light};
    const auto color = middlePixel(scene);
    EXPECT_NEAR(color[0], 0.5 * (0.8 + 0.5 * 0.2), kExact);
    EXPECT_NEAR(color[1], 0.25 * (0.8 + 0.5 * 0.2), kExact);
}

TEST(StyledReference, clipPlanesCutVolumes)
{
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.25; });
    scene.volumes[0].spacing = 0.125;
    scene.volumes[0].clipPlanes = {{0.0, 0.0, -1.0, 1.0}}; // z <= 1
    EXPECT_NEAR(middlePixel(scene)[3], 1.0 - std::pow(0.75, 3.0), kExact);
}

TEST(StyledReference, projectionsTakeOneSampleOrTheMean)
{
    // From the eye on (z downwards): 0.2, 0.9, 0.1, 0.6, at voxel centres.
    constexpr std::array kValues{0.6, 0.1, 0.9, 0.2};
    StyledScene scene = cubeAlongZ(4, [&](int z) { return kValues[static_cast<std::size_t>(z)]; });
    const auto projected = [&](RayProjection::Type type, float threshold) {
        scene.volumes[0].projection = RayProjection{type, threshold};
        EXPECT_NEAR(middlePixel(scene)[3], 1.0, kExact);
        return middlePixel(scene)[0];
    };
    EXPECT_NEAR(projected(RayProjection::Type::max, 0.0f), 0.9, kExact);
    EXPECT_NEAR(projected(RayProjection::Type::min, 0.0f), 0.1, kExact);
    EXPECT_NEAR(projected(RayProjection::Type::average, 0.0f), 0.45, kExact);
    EXPECT_NEAR(projected(RayProjection::Type::max, 0.15f), 0.9, kExact);
    EXPECT_NEAR(projected(RayProjection::Type::max, 0.95f), 0.9, kExact);
    EXPECT_NEAR(projected(RayProjection::Type::min, 0.3f), 0.2, kExact);
    EXPECT_NEAR(projected(RayProjection::Type::min, 0.15f), 0.1, kExact);
}

TEST(StyledReference, firstLocalMaximumIsNotTheGreatest)
{
    constexpr std::array kValues{0.9, 0.1, 0.5, 0.4};
    StyledScene scene = cubeAlongZ(4, [&](int z) { return kValues[static_cast<std::size_t>(z)]; });
    scene.volumes[0].projection = RayProjection{RayProjection::Type::max, 0.3f};
    EXPECT_NEAR(middlePixel(scene)[0], 0.5, kExact);
}

TEST(StyledReference, projectionsDoNotLookBehindOpaqueSurfaces)
{
    // From the eye on: 0.2, 0.9, 0.1, 0.6; a surface stands behind the first.
    constexpr std::array kValues{0.6, 0.1, 0.9, 0.2};
    StyledScene scene = cubeAlongZ(4, [&](int z) { return kValues[static_cast<std::size_t>(z)]; });
    scene.volumes[0].projection = RayProjection{};
    scene.surfaces.push_back(square(1.0, {0, 1, 0}, 0.5f));
    EXPECT_NEAR(middlePixel(scene)[0], 0.9, kExact);
    scene.surfaces[0].transparency = 0.0f;
    EXPECT_NEAR(middlePixel(scene)[0], 0.2, kExact);
}

TEST(StyledReference, surfacesOfAValueLieWhereTheVoxelsHaveIt)
{
    // Values rise with z; a plane of translucent colour stands just before and just behind the crossing.
    StyledScene scene = cubeAlongZ(8, [](int z) { return 0.1 * z; });
    scene.volumes[0].spacing = 0.37;
    Shaded red{};
    red.hasMaterial = true;
    red.diffuse = {1, 0, 0};
    IsoSurfaces surfaces;
    surfaces.values = {0.4f};
    surfaces.chains = {{styleWithReference(red)}};
    scene.volumes[0].surfaces = surfaces;
    EXPECT_NEAR(middlePixel(scene)[0], 0.4, kExact);
    EXPECT_NEAR(middlePixel(scene)[3], 0.4, kExact);
    // Voxel 4 is centred at z = 0.5.
    scene.surfaces.push_back(square(0.5 + 1e-4, {0, 1, 0}, 0.0f));
    EXPECT_NEAR(middlePixel(scene)[0], 0.0, kExact);
    scene.surfaces[0] = square(0.5 - 1e-4, {0, 1, 0}, 0.0f);
    EXPECT_NEAR(middlePixel(scene)[0], 0.4, kExact);
    scene.volumes[0].surfaces->surfaceTolerance = 0.11f;
    EXPECT_NEAR(middlePixel(scene)[0], 0.0, kExact);
}

TEST(StyledReference, severalValuesAreSeenThroughEachOther)
{
    StyledScene scene = cubeAlongZ(8, [](int z) { return 0.1 * z; });
    IsoSurfaces surfaces;
    surfaces.values = {0.21f, 0.23f, 0.5f};
    surfaces.chains = {{}};
    scene.volumes[0].surfaces = surfaces;
    const double expected = 0.5 * 0.5 + 0.5 * (0.23 * 0.23 + 0.77 * 0.21 * 0.21);
    EXPECT_NEAR(middlePixel(scene)[0], expected, kExact);
}

TEST(StyledReference, segmentsHaveTheirOwnChains)
{
    StyledScene scene = cubeAlongZ(4, [](int) { return 0.25; });
    auto identifiers = std::make_shared<VoxelTexture>();
    identifiers->size = {2, 1, 1};
    identifiers->texels = {std::byte{1}, std::byte{7}};
    Segments segments;
    segments.identifiers = identifiers;
    segments.chainOf = {0, -1};
    segments.beyond = 1;
    scene.volumes[0].segments = segments;
    scene.volumes[0].chains = {{}, {styleWithReference(OpacityMap{{}, true, 1})}};
    EXPECT_EQ(pixel(scene, 1, 1)[3], 0.0);
    EXPECT_NEAR(pixel(scene, 2, 1)[3], 1.0 - std::pow(0.25, 4.0), kExact);
}

TEST(StyledReference, gradientsAreCentralDifferencesOverTheShortestEdge)
{
    StyledScene scene = cubeAlongZ(8, [](int z) { return 0.1 * z; });
    const VoxelTexture& voxels = *scene.volumes[0].voxels;
    // z is three times as long, so that its edge is 3 where the shortest is 1.
    const glm::dvec3 dimensions(8, 8, 24);
    const glm::dmat3 placeFromLocal(glm::dvec3(1 / 8.0, 0, 0), glm::dvec3(0, 1 / 8.0, 0),
                                    glm::dvec3(0, 0, 1 / 24.0));
    const glm::dvec3 df = referenceGradient(voxels, dimensions, glm::dvec3(0.5), placeFromLocal);
    EXPECT_NEAR(df.x, 0.0, kExact);
    EXPECT_NEAR(df.z, 0.1 / 3.0, kExact);
    ReferenceSample sample;
    setNormal(df, sample);
    EXPECT_NEAR(sample.n.z, -1.0, kExact);
    EXPECT_NEAR(sample.gradient, 0.1 / 3.0, kExact);
}

TEST(StyledReference, tetrahedraCarryPlacesAndNormals)
{
    // A ramp along T that lies along z: the place (S,T,R) of position p is (x, z, y), about.
    std::vector<float> ramp;
    for (int i = 0; i < 8; ++i)
        ramp.push_back(0.1f * static_cast<float>(i));
    StyledScene scene = cubeAlongZ(2, [](int) { return 0.0; });
    StyledVolume& volume = scene.volumes[0];
    volume.voxels = texture({1, 8, 1}, 1, ramp);
    volume.dimensions = {8, 8, 8};
    auto tetras = std::make_shared<StyledTetras>();
    tetras->positions = {{-20, -20, -4}, {40, -20, -4}, {-20, 40, -4}, {0, 0, 4}};
    tetras->indices = {0, 1, 2, 3};
    for (const glm::vec3& p : tetras->positions)
        tetras->places.emplace_back(p.x / 8 + 0.5f, p.z / 8 + 0.5f, p.y / 8 + 0.5f);
    volume.tetras = tetras;
    // At the apex's foot rays go from z = 4 down to -4, but for what the sides cut off.
    SilhouetteEnhancement silhouette{0.0f, 1.0f, 1.0f, {}};
    volume.chains = {{styleWithReference(silhouette)}};
    // The normal is along the view: nothing to be seen.
    EXPECT_NEAR(middlePixel(scene)[3], 0.0, 1e-5);
    volume.chains = {{}};
    EXPECT_GT(middlePixel(scene)[3], 0.5);
}

TEST(StyledReference, theSkyGoesFromZenithToNadir)
{
    StyledScene scene;
    scene.width = scene.height = 1;
    scene.clipFromEye = glm::frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 1000.0);
    scene.background.skyAngles = {1.0f, 2.0f};
    scene.background.sky = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto towards = [&](double elevation) {
        scene.eyeFromWorld = glm::rotate(glm::dmat4(1.0), -elevation, glm::dvec3(1, 0, 0));
        return middlePixel(scene);
    };
    // Half a quarter turn above the horizon: 0.785 from the zenith.
    const double quarter = std::numbers::pi / 4;
    EXPECT_NEAR(towards(quarter)[0], 1.0 - quarter, kExact);
    EXPECT_NEAR(towards(quarter)[1], quarter, kExact);
    EXPECT_NEAR(towards(-quarter)[2], 1.0, kExact);
    scene.background.groundAngles = {1.0f};
    scene.background.ground = {{0, 0, 0}, {1, 1, 1}};
    EXPECT_NEAR(towards(-quarter)[0], quarter, kExact);
}

TEST(StyledReference, unknownStylesAreRefused)
{
    StyledScene scene = cubeAlongZ(1, [](int) { return 0.5; });
    scene.volumes[0].chains = {{makeStyle(ToneMapped{})}};
    EXPECT_THROW(styledReference(scene), std::invalid_argument);
}

} // namespace
} // namespace vo::test
