// Cameras, transforms, lights, levels, clip planes and limits of what is drawn of a scene.

#include <gtest/gtest.h>

#include "view_scene.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace vo {
namespace {

const std::string kVoxels = "<PixelTexture3D image='1 2 2 2 0 255 0 0 0 0 0 0'/>";
/// A volume that is nothing but there.
const std::string kVolume = "<VolumeData>" + kVoxels + "</VolumeData>";

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double error = 1e-6)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[axis], expected[axis], error) << "axis " << axis;
}

glm::dvec3 moved(const glm::dmat4& matrix, const glm::dvec3& point)
{
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

/// Where a point is in the picture, -1 to 1.
glm::dvec3 inPicture(const StyledScene& scene, const glm::dvec3& world)
{
    const glm::dvec4 clip = scene.clipFromEye * scene.eyeFromWorld * glm::dvec4(world, 1.0);
    return glm::dvec3(clip) / clip.w;
}

TEST(StyledView, transformScalesRotatesAndMovesAboutItsCenter)
{
    const ViewedScene s(
        "<Transform translation='10 0 0' center='1 0 0' rotation='0 0 1 1.5707963' scale='2 1 1'>" + kVolume +
        "</Transform>");
    ASSERT_EQ(s.drawn.volumes.size(), 1u);
    const glm::dmat4& matrix = s.drawn.volumes[0].worldFromLocal;
    expectNear(moved(matrix, {1, 0, 0}), {11, 0, 0});
    expectNear(moved(matrix, {2, 0, 0}), {11, 2, 0});
    expectNear(moved(matrix, {1, 1, 0}), {10, 0, 0});
}

TEST(StyledView, scaleOrientationTurnsTheAxesOfTheScale)
{
    const ViewedScene s("<Transform scaleOrientation='0 0 1 0.7853982' scale='3 1 1'>" + kVolume +
                        "</Transform>");
    const glm::dmat4& matrix = s.drawn.volumes.at(0).worldFromLocal;
    expectNear(moved(matrix, {1, 1, 0}), {3, 3, 0});
    expectNear(moved(matrix, {1, -1, 0}), {1, -1, 0});
}

TEST(StyledView, groupsMultiplyFromTheOutside)
{
    const ViewedScene s("<Transform translation='1 0 0'><Group><Transform scale='2 2 2'>" + kVolume +
                        "</Transform></Group></Transform>");
    expectNear(moved(s.drawn.volumes.at(0).worldFromLocal, {1, 0, 0}), {3, 0, 0});
}

TEST(StyledView, viewpointsAngleIsThatOfTheSmallerSide)
{
    ViewedScene s("<Viewpoint position='0 0 5' fieldOfView='1.5707963'/>" + kVolume);
    ViewRequest request;
    request.width = 200;
    request.height = 100;
    s.draw(request);
    expectNear({inPicture(s.drawn, {0, 5, 0}).y, inPicture(s.drawn, {5, 0, 0}).x, 0}, {1, 0.5, 0});
    request.width = 100;
    request.height = 200;
    s.draw(request);
    expectNear({inPicture(s.drawn, {0, 5, 0}).y, inPicture(s.drawn, {5, 0, 0}).x, 0}, {0.5, 1, 0});
}

TEST(StyledView, viewpointInScaledGroupStaysRigid)
{
    const ViewedScene s("<Transform translation='0 0 3' rotation='0 1 0 1.5707963' scale='2 1 5'>"
                        "<Viewpoint position='0 0 1'/></Transform>" +
                        kVolume);
    const glm::dmat4 worldFromEye = glm::inverse(s.drawn.eyeFromWorld);
    expectNear(glm::dvec3(worldFromEye[3]), {5, 0, 3}, 1e-5);
    expectNear(glm::dvec3(worldFromEye[2]), {1, 0, 0}, 1e-6);
    expectNear(glm::dvec3(worldFromEye[1]), {0, 1, 0});
    EXPECT_NEAR(glm::determinant(glm::dmat3(worldFromEye)), 1.0, 1e-9);
}

TEST(StyledView, withoutViewpointAllIsSeen)
{
    const ViewedScene s("<Transform translation='100 7 0'>" + kVolume +
                        "</Transform><Transform translation='0 0 -50'>" + kVolume + "</Transform>");
    for (const StyledVolume& volume : s.drawn.volumes)
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 at(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
            const glm::dvec3 seen = inPicture(s.drawn, moved(volume.worldFromLocal, at));
            EXPECT_LE(std::max({std::abs(seen.x), std::abs(seen.y), std::abs(seen.z)}), 1.0);
        }
}

} // namespace
} // namespace vo
