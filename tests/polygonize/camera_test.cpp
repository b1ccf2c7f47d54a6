#include "polygonize/camera.h"

#include "gl_matrices.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace gl_matrices;

namespace {

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance)
{
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

const glm::dvec3 kEye(30, -20, 55);
const glm::dvec3 kTarget(3, 4, 5);
const glm::dvec3 kUp(0, 1, 0.2);

} // namespace

TEST(Camera, lookAtGivesEyeAndDirection)
{
    const auto camera = vo::findCamera(lookAt(kEye, kTarget, kUp), perspective(45, 1.5, 1, 200));
    ASSERT_TRUE(camera);
    EXPECT_TRUE(camera->perspective);
    const glm::dvec3 ahead = glm::normalize(kTarget - kEye);
    expectNear(camera->eye, kEye, 1e-10);
    expectNear(camera->direction, ahead, 1e-12);
    expectNear(camera->depthNormal, ahead, 1e-12);
    EXPECT_NEAR(camera->nearDepth, glm::dot(ahead, kEye) + 1, 1e-9);
    EXPECT_NEAR(camera->farDepth, glm::dot(ahead, kEye) + 200, 1e-8);
}

TEST(Camera, orthographicHasDirectionAndNoEye)
{
    const auto camera = vo::findCamera(lookAt(kEye, kTarget, kUp), ortho(-3, 5, -7, 2, -10, 90));
    ASSERT_TRUE(camera);
    EXPECT_FALSE(camera->perspective);
    const glm::dvec3 ahead = glm::normalize(kTarget - kEye);
    expectNear(camera->direction, ahead, 1e-12);
    expectNear(camera->depthNormal, ahead, 1e-12);
    EXPECT_NEAR(camera->nearDepth, glm::dot(ahead, kEye) - 10, 1e-9);
    EXPECT_NEAR(camera->farDepth, glm::dot(ahead, kEye) + 90, 1e-9);
    expectNear(camera->towards({1, 2, 3}), camera->direction, 0);
}

TEST(Camera, swappedOrthoLooksFromNearToFarPlane)
{
    const auto camera = vo::findCamera(glm::dmat4(1), ortho(-1, 1, -1, 1, 5, -5));
    ASSERT_TRUE(camera);
    expectNear(camera->direction, {0, 0, 1}, 1e-15);
    expectNear(camera->depthNormal, {0, 0, 1}, 1e-15);
    EXPECT_NEAR(camera->nearDepth, -5, 1e-12);
    EXPECT_NEAR(camera->farDepth, 5, 1e-12);
}

TEST(Camera, offAxisFrustumLooksAsideButIsCutAcrossItsAxis)
{
    const auto camera = vo::findCamera(lookAt(kEye, kTarget, kUp), frustum(1, 4, -3, -1, 2, 50));
    ASSERT_TRUE(camera);
    expectNear(camera->eye, kEye, 1e-10);
    const glm::dvec3 ahead = glm::normalize(kTarget - kEye);
    expectNear(camera->depthNormal, ahead, 1e-12);
    // The middle of the window on the near plane is (2.5, -2, -2) in eye space.
    EXPECT_NEAR(glm::dot(camera->direction, ahead), 2 / std::sqrt(2.5 * 2.5 + 4 + 4), 1e-12);
}

TEST(Camera, modelScaleTurnsNormalAndDirectionApart)
{
    const glm::dvec3 size(1, 2, 5);
    const glm::dmat4 turn = rotate(50, {1, 2, 3});
    for (const bool flat : {false, true}) {
        const glm::dmat4 projection = flat ? ortho(-9, 9, -9, 9, 1, 99) : perspective(30, 1, 1, 99);
        const auto camera = vo::findCamera(translate({0, 0, -40}) * turn * scale(size), projection);
        ASSERT_TRUE(camera);
        // In the turned frame both are -z; directions scale inversely, normals directly.
        const glm::dvec3 ahead = glm::dvec3(glm::transpose(turn) * glm::dvec4(0, 0, -1, 0));
        expectNear(camera->direction, glm::normalize(ahead / size), 1e-12);
        expectNear(camera->depthNormal, glm::normalize(ahead * size), 1e-12);
        if (!flat) expectNear(camera->eye, -40.0 * ahead / size, 1e-10);
    }
}

TEST(Camera, mirroredModelsSeeTheMirroredPlace)
{
    const glm::dmat4 mirror = scale({-1, 1, 1});
    const auto camera = vo::findCamera(lookAt(kEye, kTarget, kUp) * mirror, perspective(45, 1, 1, 100));
    ASSERT_TRUE(camera);
    const glm::dvec3 flip(-1, 1, 1);
    expectNear(camera->eye, flip * kEye, 1e-10);
    expectNear(camera->direction, flip * glm::normalize(kTarget - kEye), 1e-12);
    expectNear(camera->depthNormal, flip * glm::normalize(kTarget - kEye), 1e-12);
}

TEST(Camera, viewHiddenInTheProjectionIsFound)
{
    const glm::dmat4 view = lookAt(kEye, kTarget, kUp);
    const glm::dmat4 model = rotate(70, {3, 1, 2}) * scale({1, 1, 2});
    for (const glm::dmat4& projection : {perspective(45, 1, 1, 100), ortho(-9, 9, -9, 9, 1, 100)}) {
        const auto apart = vo::findCamera(view * model, projection);
        const auto hidden = vo::findCamera(model, projection * view);
        ASSERT_TRUE(apart && hidden);
        EXPECT_EQ(apart->perspective, hidden->perspective);
        expectNear(hidden->eye, apart->eye, 1e-9);
        expectNear(hidden->direction, apart->direction, 1e-12);
        expectNear(hidden->depthNormal, apart->depthNormal, 1e-12);
        EXPECT_NEAR(hidden->farDepth, apart->farDepth, 1e-8);
    }
}

TEST(Camera, obliqueNearPlaneDoesNotTurnTheDepth)
{
    glm::dmat4 projection = perspective(45, 1, 1, 100);
    const glm::dvec4 oblique(0.3, -0.2, -0.8,
                             -1.5); // a clip z of the application's own, to cut by the near plane
    for (int column = 0; column < 4; ++column)
        projection[column][2] = oblique[column];
    const auto camera = vo::findCamera(lookAt(kEye, kTarget, kUp), projection);
    ASSERT_TRUE(camera);
    expectNear(camera->eye, kEye, 1e-10);
    expectNear(camera->depthNormal, glm::normalize(kTarget - kEye), 1e-12);
}

TEST(Camera, quarterTurnsInSinglePrecisionLeaveTheDepthAlongAnAxis)
{
    const glm::mat4 away(translate({0, 0, -300})), scaled(scale({0.4, 0.4, 5}));
    for (const double x : {0, 90, 180, -90})
        for (const double z : {0, 90, 180, 270, -90})
            for (const glm::dmat4& projection : {perspective(45, 1, 1, 900), ortho(-9, 9, -9, 9, 1, 900)}) {
                const glm::mat4 turn = rotateInFloats(x, {1, 0, 0}) * rotateInFloats(z, {0, 0, 1});
                const glm::dvec3 exact =
                    glm::inverse(glm::dmat3(rotate(x, {1, 0, 0}) * rotate(z, {0, 0, 1}))) *
                    glm::dvec3(0, 0, -1);
                for (const glm::mat4& model : {away * turn, away * turn * scaled}) {
                    const auto camera = vo::findCamera(glm::dmat4(model), projection);
                    ASSERT_TRUE(camera);
                    EXPECT_EQ(camera->depthNormal, glm::round(exact)) << x << " " << z;
                }
            }
}

TEST(Camera, turnsOfAFewMillionthsCount)
{
    const double tilt = 3e-6;
    const auto camera =
        vo::findCamera(rotate(tilt * 180 / std::numbers::pi, {0, 1, 0}), ortho(-9, 9, -9, 9, 1, 9));
    ASSERT_TRUE(camera);
    EXPECT_NEAR(std::abs(camera->depthNormal.x), tilt, 1e-9);
}

TEST(Camera, cornersAreThoseOfTheViewVolume)
{
    const auto camera = vo::findCamera(glm::dmat4(1), frustum(-1, 3, -2, 5, 2, 20));
    ASSERT_TRUE(camera);
    expectNear(camera->corners[0], {-1, -2, -2}, 1e-12);
    expectNear(camera->corners[3], {3, 5, -2}, 1e-12);
    expectNear(camera->corners[6], {-10, 50, -20}, 1e-10);
}

TEST(Camera, distantViewersStayInPerspective)
{
    const auto camera = vo::findCamera(translate({0, 0, -1e6}), perspective(0.005, 1, 1e6 - 100, 1e6 + 100));
    ASSERT_TRUE(camera);
    EXPECT_TRUE(camera->perspective);
    EXPECT_NEAR(camera->eye.z, 1e6, 1e-3);
}

TEST(Camera, roundedOrthographicMatricesStayOrthographic)
{
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 1e-16);
    for (int i = 0; i < 50; ++i) {
        glm::dmat4 projection = ortho(-70, 70, -70, 70, -400, 400) * translate({5, 6, -300});
        for (int column = 0; column < 4; ++column)
            projection[column][3] += noise(random);
        const auto camera = vo::findCamera(rotate(20 * i, {1, 2, 3}), projection);
        ASSERT_TRUE(camera);
        EXPECT_FALSE(camera->perspective);
    }
}

TEST(Camera, viewVolumeWithoutEndHasInfiniteFarDepth)
{
    const glm::dmat4 endless = rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, -2}, {0, 0, -1, 0});
    const auto camera = vo::findCamera(translate({1, 2, -30}), endless);
    ASSERT_TRUE(camera);
    expectNear(camera->eye, {-1, -2, 30}, 1e-12);
    EXPECT_NEAR(camera->nearDepth, -29, 1e-12);
    EXPECT_TRUE(std::isinf(camera->farDepth));
}

TEST(Camera, singularOrNonFiniteMatricesHaveNone)
{
    const glm::dmat4 good = perspective(45, 1, 1, 100);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(vo::findCamera(scale({1, 1, 0}), good));
    EXPECT_FALSE(vo::findCamera(glm::dmat4(0), good));
    EXPECT_FALSE(vo::findCamera(glm::dmat4(1), glm::dmat4(0)));
    EXPECT_FALSE(vo::findCamera(rotate(37, {1, 2, 3}) * scale({1, 1, 0}) * rotate(11, {3, 1, 2}), good));
    EXPECT_FALSE(vo::findCamera(translate({nan, 0, 0}), good));
    EXPECT_FALSE(vo::findCamera(glm::dmat4(1), frustum(-1, 1, -1, 1, 0, 100)));
    EXPECT_FALSE(vo::findCamera(scale(glm::dvec3(std::numeric_limits<double>::infinity())), good));
    EXPECT_FALSE(vo::findCamera(scale(glm::dvec3(1e200)), scale(glm::dvec3(1e200)) * good));
}

TEST(Camera, smallOrFarModelsAreNotSingular)
{
    const glm::dmat4 projection = perspective(45, 1, 0.1, 1e5);
    EXPECT_TRUE(vo::findCamera(translate({0, 0, -1}) * scale(glm::dvec3(1e-8)), projection));
    EXPECT_TRUE(vo::findCamera(translate({1e5, -2e5, 1e5}), projection));
    EXPECT_TRUE(vo::findCamera(scale({1e-3, 1, 1e3}), projection));
}

TEST(Camera, towardsPointsFromTheEye)
{
    const auto camera = vo::findCamera(lookAt(kEye, kTarget, kUp), perspective(45, 1, 1, 100));
    ASSERT_TRUE(camera);
    expectNear(camera->towards({1, 2, 3}), glm::normalize(glm::dvec3(1, 2, 3) - kEye), 1e-12);
    expectNear(camera->towards(camera->eye), camera->direction, 0);
}
