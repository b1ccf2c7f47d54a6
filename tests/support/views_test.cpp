#include "support/views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

using namespace vo::test;

glm::dvec3 transformed(const Matrix& m, const glm::dvec3& p)
{
    double result[4];
    for (std::size_t row = 0; row < 4; ++row)
        result[row] = m[row] * p.x + m[4 + row] * p.y + m[8 + row] * p.z + m[12 + row];
    return {result[0] / result[3], result[1] / result[3], result[2] / result[3]};
}

void expectNear(const glm::dvec3& found, const glm::dvec3& expected)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[axis], expected[axis], 1e-12) << "axis " << axis;
}

TEST(Matrices, quarterTurnsGoFromXToYToZ)
{
    expectNear(transformed(rotation(90, 0, 0, 1), {1, 0, 0}), {0, 1, 0});
    expectNear(transformed(rotation(90, 1, 0, 0), {0, 1, 0}), {0, 0, 1});
    expectNear(transformed(rotation(90, 0, 2, 0), {0, 0, 1}), {1, 0, 0});
}

TEST(Matrices, productDoesTheSecondFirst)
{
    const Matrix both = multiply(translation(1, 2, 3), scaling(2, 3, 4));
    expectNear(transformed(both, {1, 1, 1}), {3, 5, 7});
}

TEST(Matrices, projectionsSendTheirCornersToThoseOfTheCube)
{
    expectNear(transformed(ortho(1, 3, -2, 6, 5, 9), {1, -2, -5}), {-1, -1, -1});
    expectNear(transformed(ortho(1, 3, -2, 6, 5, 9), {3, 6, -9}), {1, 1, 1});
    expectNear(transformed(frustum(-1, 3, -2, 6, 1, 4), {-1, -2, -1}), {-1, -1, -1});
    expectNear(transformed(frustum(-1, 3, -2, 6, 1, 4), {12, 24, -4}), {1, 1, 1});
    expectNear(transformed(perspective(90, 2, 1, 10), {2, 1, -1}), {1, 1, -1});
}

TEST(GuideModel, levelViewHasXToTheRightAndZUp)
{
    const Matrix model = guideModel({0, 0}, {10, 20, 30});
    expectNear(transformed(model, {5, 10, 15}), {0, 0, 0});
    expectNear(transformed(model, {6, 10, 15}), {1, 0, 0});
    expectNear(transformed(model, {5, 10, 16}), {0, 1, 0});
    expectNear(transformed(model, {5, 11, 15}), {0, 0, -1});
}

TEST(GuideModel, halfATurnShowsTheSideOfLargeY)
{
    const Matrix model = guideModel({0, 180}, {10, 20, 30}, {1, 1, 2});
    expectNear(transformed(model, {5, 11, 15}), {0, 0, 1});
    expectNear(transformed(model, {6, 10, 15}), {-1, 0, 0});
    expectNear(transformed(model, {5, 10, 16}), {0, 2, 0});
}

TEST(OrthographicView, halfTheSmallerSideIsHalfTheDiagonal)
{
    const vo::VoxelSize volume{30, 40, 120}; // diagonal 130
    const View view = orthographicView({0, 0}, volume, 400, 200);
    const glm::dvec3 centre{15, 20, 60};
    const Matrix whole = multiply(view.projection, view.model);
    expectNear(transformed(whole, centre), {0, 0, 0});
    expectNear(transformed(whole, centre + glm::dvec3(0, 0, 65)), {0, 1, 0});
    expectNear(transformed(whole, centre + glm::dvec3(130, 0, 0)), {1, 0, 0});
}

TEST(PerspectiveView, theBallAroundTheVolumeJustFits)
{
    const vo::VoxelSize volume{30, 40, 120};
    const View view = perspectiveView({0, 0}, volume, 200, 400, 60);
    const Matrix whole = multiply(view.projection, view.model);
    const glm::dvec3 centre{15, 20, 60};
    // The line of sight at 30 degrees touches the ball at 65 (sin 30, cos 30) towards the viewer and to the
    // side.
    const glm::dvec3 touched = centre + 65.0 * glm::dvec3(std::sqrt(0.75), -0.5, 0);
    EXPECT_NEAR(transformed(whole, touched).x, 1.0, 1e-12);
    EXPECT_NEAR(transformed(whole, centre + glm::dvec3(0, 65, 0)).z, 1.0, 0.2);
    EXPECT_LT(transformed(whole, centre + glm::dvec3(0, 65, 0)).z, 1.0);
    EXPECT_GT(transformed(whole, centre - glm::dvec3(0, 65, 0)).z, -1.0);
}

TEST(Views, fixedOnesAre36AndDiffer)
{
    const auto views = fixedViews();
    std::set<std::pair<double, double>> different;
    for (const Angles& view : views)
        different.insert({view.latitude, view.longitude});
    EXPECT_EQ(different.size(), 36u);
}

TEST(Views, randomOnesAreTheSameForTheSameSeed)
{
    const auto views = randomViews(20, 5);
    const auto again = randomViews(20, 5);
    const auto other = randomViews(20, 6);
    for (std::size_t i = 0; i < views.size(); ++i) {
        EXPECT_EQ(views[i].latitude, again[i].latitude);
        EXPECT_EQ(views[i].longitude, again[i].longitude);
        EXPECT_NE(views[i].latitude, other[i].latitude);
        EXPECT_LE(std::abs(views[i].latitude), 90.0);
    }
}

TEST(RandomRotation, keepsLengthsAndHandedness)
{
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Matrix turn = randomRotation(seed);
        const glm::dvec3 x = transformed(turn, {1, 0, 0});
        const glm::dvec3 y = transformed(turn, {0, 1, 0});
        const glm::dvec3 z = transformed(turn, {0, 0, 1});
        EXPECT_NEAR(x.x * x.x + x.y * x.y + x.z * x.z, 1.0, 1e-12);
        EXPECT_NEAR(x.x * y.x + x.y * y.y + x.z * y.z, 0.0, 1e-12);
        expectNear(z, {x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x});
    }
}

} // namespace
