// Which triangles of several surfaces lie in one plane, and how far away that is.

#include "style/shared_planes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace vo;

/// A square round the local origin, of two triangles.
StyledSurface square(double half, const glm::dmat4& worldFromLocal)
{
    const auto h = static_cast<float>(half);
    StyledSurface surface;
    surface.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
    surface.triangles = {0, 1, 2, 0, 2, 3};
    surface.worldFromLocal = worldFromLocal;
    return surface;
}

glm::dmat4 moved(const glm::dvec3& by)
{
    return glm::translate(glm::dmat4(1.0), by);
}

glm::dmat4 turned(double angle)
{
    return glm::rotate(glm::dmat4(1.0), angle, glm::normalize(glm::dvec3(1.0, 1.0, 0.3)));
}

StyledScene sceneOf(const std::vector<StyledSurface>& surfaces, bool perspective = true)
{
    StyledScene scene;
    scene.surfaces = surfaces;
    scene.eyeFromWorld = moved({0.1, 0.2, -9.0});
    scene.clipFromEye =
        perspective ? glm::perspective(0.6, 1.0, 0.1, 100.0) : glm::ortho(-2.0, 3.0, -2.0, 2.0, 0.1, 100.0);
    return scene;
}

TEST(sharedPlanes, theyAreOfSeveralSurfaces)
{
    for (const double angle : {0.0, 0.7, -2.1, 3.0}) {
        const glm::dmat4 turn = turned(angle);
        // The same plane by other numbers, one of them rounded, and seen from its other side.
        StyledSurface baked = square(1.0, glm::dmat4(1.0));
        for (glm::vec3& position : baked.positions)
            position = glm::vec3(turn * glm::dvec4(glm::dvec3(position), 1.0));
        std::swap(baked.triangles[1], baked.triangles[2]);
        const SharedPlanes planes(
            sceneOf({square(1.5, turn * moved({0.3, 7.0, 0.0})), baked,
                     square(1.0, turn * moved({0.0, 0.0, 1e-3})), square(1.0, turn * turned(1e-3))}));
        const int shared = planes.numberOf(0, 0);
        ASSERT_EQ(shared, 0) << angle;
        EXPECT_EQ(planes.numberOf(0, 3), shared);
        EXPECT_EQ(planes.numberOf(1, 0), shared) << angle;
        EXPECT_EQ(planes.numberOf(1, 3), shared) << angle;
        EXPECT_FALSE(planes.anyOf(2) || planes.anyOf(3)) << angle;
        EXPECT_EQ(planes.find(planes.numberOf(2, 0)), nullptr);
    }
}

TEST(sharedPlanes, oneSurfaceAloneHasNone)
{
    for (const double angle : {0.0, 0.7, -2.1}) {
        const StyledSurface alone = square(1.0, turned(angle));
        EXPECT_FALSE(SharedPlanes(sceneOf({alone})).anyOf(0)) << angle;
        EXPECT_FALSE(SharedPlanes(sceneOf({alone, StyledSurface()})).anyOf(0)) << angle;
    }
}

TEST(sharedPlanes, overlapsWithinASurfaceCountInSmallScenes)
{
    StyledSurface twice = square(1.0, turned(0.7));
    for (const glm::vec3 corner : {glm::vec3(0.9f, 0.5f, 0.0f), {3.0f, 0.0f, 0.0f}, {3.0f, 1.0f, 0.0f}})
        twice.positions.push_back(corner);
    twice.triangles.insert(twice.triangles.end(), {4, 5, 6});
    EXPECT_EQ(SharedPlanes(sceneOf({twice})).numberOf(0, 6), 0);
    twice.triangles.resize(3 * SharedPlanes::kMostWithinSurfaces + 3, 0);
    EXPECT_FALSE(SharedPlanes(sceneOf({twice})).anyOf(0));
    twice.triangles.resize(9);
    twice.positions[4].x = 1.1f;
    EXPECT_FALSE(SharedPlanes(sceneOf({twice})).anyOf(0));
}

TEST(sharedPlanes, theirDepthsAreThoseOfTheirPoints)
{
    for (const bool perspective : {false, true}) {
        const glm::dmat4 turn = turned(0.7);
        const StyledScene scene = sceneOf({square(1.0, turn), square(1.5, turn)}, perspective);
        const SharedPlanes planes(scene);
        const SharedPlane* const plane = planes.find(planes.numberOf(1, 0));
        ASSERT_NE(plane, nullptr);
        for (const glm::dvec2 place : {glm::dvec2(0.2, -1.4), glm::dvec2(-1.0, 0.7), glm::dvec2(0.0, 0.0)}) {
            const glm::dvec4 eye = scene.eyeFromWorld * turn * glm::dvec4(place, 0.0, 1.0);
            const glm::dvec4 clip = scene.clipFromEye * eye;
            EXPECT_NEAR(plane->depthAt(clip.x / clip.w, clip.y / clip.w), -eye.z, 1e-9);
            EXPECT_NEAR(glm::dot(plane->plane, eye), 0.0, 1e-9);
        }
        // Beside its triangles it is as far away as the nearest and the farthest of their corners.
        for (const glm::vec3& corner : {scene.surfaces[1].positions[1], scene.surfaces[1].positions[3]}) {
            const glm::dvec4 eye = scene.eyeFromWorld * turn * glm::dvec4(glm::dvec3(corner), 1.0);
            const glm::dvec4 clip = scene.clipFromEye * eye;
            EXPECT_NEAR(plane->depthAt(1.2 * clip.x / clip.w, 1.2 * clip.y / clip.w), -eye.z, 1e-9);
        }
    }
}

TEST(sharedPlanes, nothingIsLookedForAmongTooManyTriangles)
{
    StyledSurface many = square(1.0, glm::dmat4(1.0));
    many.triangles.resize(3 * SharedPlanes::kMostTriangles, 0);
    EXPECT_FALSE(SharedPlanes(sceneOf({many, square(1.0, glm::dmat4(1.0))})).anyOf(0));
    many.triangles.resize(3 * 1000);
    EXPECT_TRUE(SharedPlanes(sceneOf({many, square(1.0, glm::dmat4(1.0))})).anyOf(0));
}

} // namespace
