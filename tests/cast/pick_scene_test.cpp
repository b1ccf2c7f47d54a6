// What a ray through a picture meets first: tetrahedra, planes that clip, and what is left out.

#include "cast/pick_scene.h"
#include "styled_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
