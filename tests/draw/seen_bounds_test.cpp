// Where in a picture volumes may be seen, and which of them stand alone there.

#include "draw/seen_bounds.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

namespace {

using namespace vo;

/// The eye is at the origin; x and y of a picture are those over the depth.
StyledScene rightAngledScene()
{
    StyledScene scene;
    scene.clipFromEye = glm::perspective(std::acos(-1.0) / 2.0, 1.0, 0.01, 100.0);
    return scene;
}

StyledVolume boxAt(const glm::dvec3& center, const glm::vec3& dimensions)
{
    StyledVolume volume;
    volume.worldFromLocal = glm::translate(glm::dmat4(1.0), center);
    volume.dimensions = dimensions;
    return volume;
}

std::vector<bool> standingAloneOf(const StyledScene& scene, const StyledVolume& one,
                                  const StyledVolume& other)
{
    const std::array volumes{&one, &other};
    return standingAlone(scene, volumes);
}

const std::vector kBoth{true, true}, kNeither{false, false};

TEST(seenBounds, holdAllCorners)
{
    const SeenBounds bounds = seenBounds(rightAngledScene(), boxAt({1.0, 0.0, -5.0}, {2.0f, 4.0f, 2.0f}));
    EXPECT_NEAR(bounds.nearest, 4.0, 1e-9);
    EXPECT_NEAR(bounds.farthest, 6.0, 1e-9);
    EXPECT_NEAR(bounds.lower.x, 0.0, 1e-9);
    EXPECT_NEAR(bounds.upper.x, 0.5, 1e-9);
    EXPECT_NEAR(bounds.lower.y, -0.5, 1e-9);
    EXPECT_NEAR(bounds.upper.y, 0.5, 1e-9);
}

TEST(seenBounds, areAllOfThePictureWhereAPointIsBehindTheEye)
{
    const std::array before{glm::vec3(0.5f, 0.1f, -1.0f), glm::vec3(0.6f, 0.2f, -1.0f)};
    const std::array behind{before[0], before[1], glm::vec3(-2.0f, -0.3f, 1.0f)};
    std::array turned = behind;
    for (glm::vec3& point : turned)
        point *= glm::vec3(-1.0f, -1.0f, 1.0f);
    const auto boundsOf = [](std::span<const glm::vec3> points) {
        return seenBounds(rightAngledScene(), glm::dmat4(1.0), points);
    };
    EXPECT_NEAR(boundsOf(before).lower.x, 0.5, 1e-6);
    for (const auto& points : {behind, turned})
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_LE(boundsOf(points).lower[axis], -1.0) << axis;
            EXPECT_GE(boundsOf(points).upper[axis], 1.0) << axis;
        }
}

TEST(standingAlone, isWhatNothingStandsAmong)
{
    StyledScene scene = rightAngledScene();
    const StyledVolume box = boxAt({0.0, 0.0, -5.0}, glm::vec3(2.0f));
    EXPECT_EQ(standingAloneOf(scene, box, boxAt({0.5, 0.5, -5.5}, glm::vec3(2.0f))), kNeither);
    EXPECT_EQ(standingAloneOf(scene, box, boxAt({3.0, 0.0, -5.0}, glm::vec3(2.0f))), kBoth) << "beside it";
    EXPECT_EQ(standingAloneOf(scene, box, boxAt({0.0, -3.0, -5.0}, glm::vec3(2.0f))), kBoth) << "below it";
    EXPECT_EQ(standingAloneOf(scene, box, boxAt({0.0, 0.0, -8.0}, glm::vec3(2.0f))), kBoth) << "behind it";
    const StyledVolume beside = boxAt({3.0, 0.0, -5.0}, glm::vec3(2.0f));
    StyledSurface pane;
    pane.positions = {{-0.5f, -0.5f, -5.0f}, {0.5f, -0.5f, -5.0f}, {0.0f, 0.5f, -5.0f}};
    pane.triangles = {0, 1, 2};
    scene.surfaces = {pane};
    EXPECT_EQ(standingAloneOf(scene, box, beside), kBoth) << "opaque";
    scene.surfaces[0].transparency = 0.5f;
    EXPECT_EQ(standingAloneOf(scene, box, beside), (std::vector{false, true}));
}

TEST(standingAlone, isNotAVolumeRoundTheEyeWithAnotherOneInIt)
{
    // Its corners are seen at 1/4 of the picture, its sides beyond all of it.
    const StyledVolume round = boxAt({0.0, 0.0, 0.0}, {1.0f, 1.0f, 4.0f});
    for (const glm::dvec3 side :
         {glm::dvec3(-0.4, 0, 0), glm::dvec3(0.4, 0, 0), glm::dvec3(0, -0.4, 0), glm::dvec3(0, 0.4, 0)})
        EXPECT_EQ(
            standingAloneOf(rightAngledScene(), round, boxAt(side - glm::dvec3(0, 0, 0.5), glm::vec3(0.1f))),
            kNeither);
}

} // namespace
