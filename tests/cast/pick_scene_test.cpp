// What a ray through a picture meets first: tetrahedra, planes that clip, and what is left out.

#include "cast/pick_scene.h"
#include "style/stipple_points.h"
#include "styled_scenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

namespace {

using namespace styled_scenes;
using vo::SceneHit;
using vo::StyledScene;

/// Of orthoScene(): the eye is at z = 20, a pixel is half a unit wide.
SceneHit pickAt(const StyledScene& scene, double x, double y, float threshold)
{
    return vo::pickScene(scene, 2.0 * (x + 10.0), 2.0 * (y + 10.0), threshold);
}

void expectNear(const glm::dvec3& found, const glm::dvec3& expected)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[axis], expected[axis], 1e-6) << "axis " << axis;
}

/// A corner of a cube, from -4 on 8 along each axis; S goes with y, T with z and R with x. Before it stand
/// one that is flat, and two with corners that are not there.
StyledScene cornerScene()
{
    auto tetras = std::make_shared<vo::StyledTetras>();
    tetras->positions = {{-4, -4, -4}, {4, -4, -4}, {-4, 4, -4}, {-4, -4, 4}};
    for (const glm::vec3& p : tetras->positions)
        tetras->places.push_back(glm::vec3(p.y, p.z, p.x) / 8.0f + 0.5f);
    tetras->indices = {0, 1, 2, 2, 0, 1, 2, 4, -1, 1, 2, 3, 0, 1, 2, 3};
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(constantTexture(0.5f, 0.25f)));
    scene.volumes[0].tetras = tetras;
    scene.volumes[0].id = 7;
    return scene;
}

TEST(pickScene, tetrahedraHaveBoundsAndPlacesOfTheirOwn)
{
    // The slanted face: x + y + z = -4.
    const SceneHit hit = pickAt(cornerScene(), -3.0, -2.5, -1.0f);
    ASSERT_EQ(hit.kind, SceneHit::Kind::bounds);
    EXPECT_EQ(hit.id, 7);
    expectNear(hit.local, {-3.0, -2.5, 1.5});
    expectNear(hit.place, {1.5 / 8.0, 5.5 / 8.0, 1.0 / 8.0});
    expectNear(glm::dvec3(hit.normal), glm::dvec3(std::sqrt(1.0 / 3.0)));
    EXPECT_NEAR(hit.depth, 18.5, 1e-9);
    EXPECT_EQ(pickAt(cornerScene(), 1.0, 0.0, -1.0f).kind, SceneHit::Kind::nothing);
}

TEST(pickScene, voxelsOfTetrahedraLieOnSamplingPlanes)
{
    const SceneHit hit = pickAt(cornerScene(), -3.0, -2.75, 0.2f);
    ASSERT_EQ(hit.kind, SceneHit::Kind::voxel);
    // Entered at z = 1.75; planes lie at depths of whole numbers and a half.
    expectNear(hit.local, {-3.0, -2.75, 1.5});
    EXPECT_NEAR(hit.opacity, 0.25f, 1e-6f);
    EXPECT_EQ(pickAt(cornerScene(), -3.0, -2.75, 0.3f).kind, SceneHit::Kind::nothing);
}

TEST(pickScene, projectionsStandWhereRaysEnter)
{
    StyledScene scene = orthoScene();
    for (const int id : {1, 2}) {
        scene.volumes.push_back(boxOf(constantTexture(0.5f, 0.25f)));
        scene.volumes.back().projection = vo::RayProjection{};
        scene.volumes.back().id = id;
    }
    // Entered at 17, where its first sample is at 17.5; the other one at 16, where it is at 18.
    scene.volumes[0].worldFromLocal[3].z = -1.0;
    scene.volumes[1].spacing = 4.0;
    const SceneHit hit = pickAt(scene, 0.5, 0.5, 0.2f);
    ASSERT_EQ(hit.kind, SceneHit::Kind::voxel);
    EXPECT_EQ(hit.id, 2);
    EXPECT_NEAR(hit.depth, 18.0, 1e-9);
}

TEST(pickScene, clipPlanesAreMetWhereTheyCut)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(constantTexture(0.5f, 0.25f)));
    scene.volumes[0].clipPlanes = {{0.0, 0.0, -1.0, 1.0}};
    const SceneHit hit = pickAt(scene, 0.5, 0.5, -1.0f);
    ASSERT_EQ(hit.kind, SceneHit::Kind::bounds);
    expectNear(hit.world, {0.5, 0.5, 1.0});
    expectNear(glm::dvec3(hit.normal), {0.0, 0.0, 1.0});
}

TEST(pickScene, ofFacesOfOnePlaneTheOpaqueOneOrTheFirstIsMet)
{
    for (const auto& [first, second, expected] :
         {std::tuple(0.0f, 0.0f, 1), {0.0f, 0.5f, 1}, {0.5f, 0.5f, 1}, {0.5f, 0.0f, 2}}) {
        StyledScene scene = orthoScene();
        for (const float transparency : {first, second}) {
            const auto size = static_cast<float>(5.3 + 0.7 * static_cast<double>(scene.surfaces.size()));
            vo::StyledSurface face;
            face.positions = {{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
            face.triangles = {0, 1, 2};
            face.solid = false;
            face.transparency = transparency;
            face.id = static_cast<int>(scene.surfaces.size()) + 1;
            face.worldFromLocal = glm::rotate(glm::dmat4(1.0), 0.7, {0.6, 0.8, 0.0});
            scene.surfaces.push_back(face);
        }
        for (int i = 0; i < 40; ++i)
            EXPECT_EQ(pickAt(scene, 0.031 * i - 0.6, 0.5 - 0.027 * i, -1.0f).id, expected)
                << first << " before " << second << ", " << i;
    }
}

TEST(pickScene, facesThatLieInClipPlanesAreMet)
{
    vo::StyledSurface face;
    face.positions = {{-5, -5, 0}, {5, -5, 0}, {0, 5, 0}};
    face.triangles = {0, 1, 2};
    face.solid = false;
    for (const double angle : {0.0, 0.3, -0.7, 1.1}) {
        face.worldFromLocal = glm::rotate(glm::dmat4(1.0), angle, {0.6, 0.8, 0.0});
        for (const float side : {1.0f, -1.0f}) {
            StyledScene scene = orthoScene();
            face.clipPlanes = {glm::dvec4(glm::vec4(face.worldFromLocal[2]) * side)};
            scene.surfaces = {face};
            for (const double x : {-0.7, 0.1, 0.9})
                EXPECT_EQ(pickAt(scene, x, 0.5, -1.0f).kind, SceneHit::Kind::surface) << angle << ", " << x;
            scene.surfaces[0].clipPlanes[0].w = -1e-3;
            EXPECT_EQ(pickAt(scene, 0.5, 0.5, -1.0f).kind, SceneHit::Kind::nothing) << angle;
        }
    }
}

TEST(pickScene, solidSurfacesAreMetFromOutsideAlone)
{
    // Two triangles; the nearer one looks away from the eye.
    vo::StyledSurface away, towards;
    away.positions = {{-5, -5, 1}, {5, -5, 1}, {0, 5, 1}};
    away.triangles = {2, 1, 0};
    away.id = 1;
    towards.positions = {{-5, -5, 0}, {5, -5, 0}, {0, 5, 0}};
    towards.triangles = {0, 1, 2};
    towards.id = 2;
    StyledScene scene = orthoScene();
    scene.surfaces = {away, towards};
    EXPECT_EQ(pickAt(scene, 0.0, 0.0, 0.0f).id, 2);
    scene.surfaces[0].solid = false;
    const SceneHit hit = pickAt(scene, 0.0, 0.0, 0.0f);
    EXPECT_EQ(hit.id, 1);
    expectNear(glm::dvec3(hit.normal), {0.0, 0.0, 1.0});
}

/// The box by a projection; its values along z.
StyledScene projectionOf(vo::RayProjection::Type type, const std::function<float(float)>& valueAt,
                         int components = 1)
{
    StyledScene scene = orthoScene();
    scene.volumes.push_back(boxOf(
        textureOf({1, 1, 8}, components, [&](const glm::vec3& place, int) { return valueAt(place.z); })));
    scene.volumes[0].projection = vo::RayProjection{type, 0.0f};
    return scene;
}

TEST(pickScene, projectionsLookAtTheFirstSampleAndTheLast)
{
    using Type = vo::RayProjection::Type;
    const auto rising = [](float z) { return z; };
    // Planes lie from 3.5 to -3.5.
    expectNear(pickAt(projectionOf(Type::max, rising), 0.5, 0.5, 0.0f).local, {0.5, 0.5, 3.5});
    expectNear(pickAt(projectionOf(Type::min, rising), 0.5, 0.5, 0.0f).local, {0.5, 0.5, -3.5});
    const SceneHit mean = pickAt(projectionOf(Type::average, rising, 2), 0.5, 0.5, 0.0f);
    EXPECT_NEAR(mean.opacity, 0.5f, 1e-5f);
    expectNear(mean.local, {0.5, 0.5, 3.5});
}

TEST(pickScene, projectionsLookAtTheMeanOfColors)
{
    StyledScene scene = orthoScene();
    // Red is the greatest in front, the mean behind.
    scene.volumes.push_back(boxOf(textureOf({1, 1, 8}, 3, [](const glm::vec3& place, int c) {
        return c == 0 ? place.z : 0.9f - 0.8f * place.z;
    })));
    scene.volumes[0].projection = vo::RayProjection{};
    EXPECT_NEAR(pickAt(scene, 0.5, 0.5, 0.0f).local.z, -3.5, 1e-6);
}

TEST(pickScene, projectionsHideWhatIsBehindTheirFirstSample)
{
    StyledScene scene = projectionOf(vo::RayProjection::Type::max, [](float z) { return 1.0f - z; });
    scene.volumes[0].id = 1;
    scene.volumes.push_back(boxOf(constantTexture(0.5f, 0.25f), glm::vec3(4.0f)));
    scene.volumes[1].id = 2;
    const SceneHit hit = pickAt(scene, 0.5, 0.5, 0.0f);
    EXPECT_EQ(hit.id, 1);
    EXPECT_NEAR(hit.local.z, -3.5, 1e-6) << "the one that is shown lies behind the second volume";
}

/// A surface at each value of what rises or falls along z.
StyledScene surfacesOf(const std::vector<float>& values, const std::function<float(float)>& valueAt)
{
    StyledScene scene = projectionOf(vo::RayProjection::Type::max, valueAt);
    scene.volumes[0].projection.reset();
    scene.volumes[0].surfaces = vo::IsoSurfaces{values, {{}}, 0.0f, nullptr};
    return scene;
}

TEST(pickScene, surfacesOfValuesComeBeforeTheirProjection)
{
    StyledScene scene = surfacesOf({0.5f}, [](float z) { return z; });
    scene.volumes[0].projection.emplace();
    const SceneHit hit = pickAt(scene, 0.5, 0.5, 0.0f);
    ASSERT_EQ(hit.kind, SceneHit::Kind::surface);
    expectNear(hit.local, {0.5, 0.5, 0.0});
}

TEST(pickScene, nearerOfTwoSurfacesInOneStepIsMet)
{
    const std::function<float(float)> rising = [](float z) { return z; };
    const std::function<float(float)> falling = [](float z) { return 1.0f - z; };
    for (const auto& [valueAt, z] : {std::pair(rising, 0.8), std::pair(falling, 1.6)}) {
        StyledScene scene = surfacesOf({0.3f, 0.6f}, valueAt);
        // One step, from the first voxel's centre to the last one's: the value is linear.
        scene.volumes[0].clipPlanes = {{0.0, 0.0, -1.0, 3.5}, {0.0, 0.0, 1.0, 3.5}};
        scene.volumes[0].spacing = 7.0;
        const SceneHit hit = pickAt(scene, 0.5, 0.5, 0.0f);
        ASSERT_EQ(hit.kind, SceneHit::Kind::surface);
        EXPECT_NEAR(hit.local.z, z, 1e-5);
    }
}

TEST(pickScene, normalsOfSurfacesLookAtTheEye)
{
    for (const bool rises : {true, false}) {
        const SceneHit hit =
            pickAt(surfacesOf({0.5f}, [rises](float z) { return rises ? z : 1.0f - z; }), 0.5, 0.5, 0.0f);
        ASSERT_EQ(hit.kind, SceneHit::Kind::surface);
        expectNear(glm::dvec3(hit.normal), {0.0, 0.0, 1.0});
    }
}

/// Which of the points is nearest to a pixel, of those that are as near the one nearest to the eye.
const vo::StipplePoint* pointNear(const std::vector<vo::StipplePoint>& points, int x, int y, double least,
                                  double most)
{
    const vo::StipplePoint* best = nullptr;
    int bestSquare = 9; // three pixels
    for (const vo::StipplePoint& point : points) {
        const int dx = static_cast<int>(std::floor(2.0 * (double(point.position.x) + 10.0))) - x;
        const int dy = static_cast<int>(std::floor(2.0 * (double(point.position.y) + 10.0))) - y;
        const double z = static_cast<double>(point.position.z);
        const int square = dx * dx + dy * dy;
        if (z < least || z > most || square > bestSquare) continue;
        if (best && square == bestSquare && point.position.z <= best->position.z) continue;
        best = &point;
        bestSquare = square;
    }
    return best;
}

TEST(pickScene, stipplesAreMetUpToThreePixelsAwayAndTheNearestFirst)
{
    StyledScene scene = orthoScene();
    scene.clipFromEye = glm::ortho(-10.0, 10.0, -10.0, 10.0, 18.0, 100.0); // points from z = 2 on are cut off
    scene.volumes.push_back(
        boxOf(textureOf({6, 6, 6}, 1, [](const glm::vec3& place, int) { return 0.05f + 0.2f * place.x; })));
    scene.volumes[0].stipple.emplace();
    scene.volumes[0].stipple->interiorFactor = 0.0f;
    const auto points = vo::stipplePoints(scene, scene.volumes[0], 1);
    ASSERT_GT(points.size(), 20u);
    vo::StyledSurface wall; // behind the middle
    wall.positions = {{-20, -20, -1}, {20, -20, -1}, {0, 20, -1}};
    wall.triangles = {0, 1, 2};
    wall.id = 5;
    scene.surfaces.push_back(wall);
    int far = 0;
    for (int y = 8; y < 32; ++y)
        for (int x = 8; x < 32; ++x) {
            const vo::StipplePoint* const expected = pointNear(points, x, y, -1.0, 2.0);
            const SceneHit hit = vo::pickScene(scene, x + 0.5, y + 0.5, 0.5f);
            ASSERT_EQ(hit.kind, expected ? SceneHit::Kind::voxel : SceneHit::Kind::surface) << x << " " << y;
            if (expected) expectNear(hit.local, glm::dvec3(expected->position));
            far += expected && hit.world.x < 0.5 * x - 10.0 - 1.0;
        }
    EXPECT_GT(far, 0) << "more than two pixels aside";
}

TEST(pickScene, nonsenseIsNotMet)
{
    StyledScene sound = orthoScene();
    sound.volumes.push_back(boxOf(constantTexture(0.5f, 0.25f)));
    EXPECT_EQ(pickAt(sound, 0.5, 0.5, 0.2f).kind, SceneHit::Kind::voxel);
    const std::vector<std::function<void(vo::StyledVolume&)>> spoils{
        [](vo::StyledVolume& v) { v.voxels = nullptr; },
        [](vo::StyledVolume& v) {
            auto few = std::make_shared<vo::VoxelTexture>(*v.voxels);
            few->size = {800, 800, 800};
            v.voxels = few;
        },
        [](vo::StyledVolume& v) { v.dimensions.x = 0.0f; },
        [](vo::StyledVolume& v) { v.worldFromLocal = glm::dmat4(0.0); },
        [](vo::StyledVolume& v) { v.spacing = 0.0; },
        [](vo::StyledVolume& v) {
            v.segments = vo::Segments{v.voxels, 2, 255.0f, {0}, 0};
        },
    };
    for (const auto& spoil : spoils) {
        StyledScene scene = sound;
        spoil(scene.volumes[0]);
        EXPECT_EQ(pickAt(scene, 0.5, 0.5, 0.2f).kind, SceneHit::Kind::nothing);
    }
    StyledScene scene = orthoScene();
    vo::StyledSurface surface;
    surface.positions = {{-5, -5, 0}, {5, -5, 0}, {0, 5, 0}};
    surface.triangles = {0, 1, 2};
    scene.surfaces.push_back(surface);
    EXPECT_EQ(pickAt(scene, 0.0, 0.0, 0.0f).kind, SceneHit::Kind::surface);
    scene.surfaces[0].triangles = {0, 1, 9};
    EXPECT_EQ(pickAt(scene, 0.0, 0.0, 0.0f).kind, SceneHit::Kind::nothing);
}

} // namespace
