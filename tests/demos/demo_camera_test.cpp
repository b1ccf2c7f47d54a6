#include "volume_view/camera.h"
#include "trackball.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using vo::Matrix;
using vo::Model;
using vo::Orientation;
using vo::ViewVolume;

using Point = std::array<double, 3>;

Point transform(const Matrix& m, const Point& p)
{
    std::array<double, 4> q{};
    for (std::size_t row = 0; row < 4; ++row)
        q[row] = m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row];
    return {q[0] / q[3], q[1] / q[3], q[2] / q[3]};
}

void expectNear(const Point& a, const Point& b, double tolerance = 1e-9)
{
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance) << "axis " << i;
}

const Model kBrain{{181, 217, 181}, {1, 1, 2}};

TEST(Camera, centreOfTheVolumeIsTheMiddleOfThePicture)
{
    for (const double degrees : {0.0, 40.0}) {
        const ViewVolume view = vo::viewVolume(kBrain, degrees, 300, 200);
        const Matrix modelView = vo::modelViewMatrix(kBrain, {33, -71}, view);
        const Point eye = transform(modelView, {90.5, 108.5, 90.5});
        expectNear(eye, {0, 0, -view.distance});
        const Point ndc = transform(vo::projectionMatrix(view), eye);
        EXPECT_NEAR(ndc[0], 0, 1e-12);
        EXPECT_NEAR(ndc[1], 0, 1e-12);
        EXPECT_LT(std::abs(ndc[2]), 1);
    }
}

TEST(Camera, viewZeroZeroLooksAlongYWithZUp)
{
    const Model model{{2, 2, 2}, {1, 1, 1}};
    const Matrix m = vo::modelViewMatrix(model, {0, 0}, vo::viewVolume(model, 0, 1, 1));
    expectNear(transform(m, {2, 1, 1}), {1, 0, 0});  // x to the right
    expectNear(transform(m, {1, 1, 2}), {0, 1, 0});  // z up
    expectNear(transform(m, {1, 2, 1}), {0, 0, -1}); // y away
}

TEST(Camera, longitude180LooksFromTheFront)
{
    const Model model{{2, 2, 2}, {1, 1, 1}};
    const Matrix m = vo::modelViewMatrix(model, {0, 180}, vo::viewVolume(model, 0, 1, 1));
    expectNear(transform(m, {2, 1, 1}), {-1, 0, 0}); // x to the left: facing us
    expectNear(transform(m, {1, 2, 1}), {0, 0, 1});  // y towards the eye
}

TEST(Camera, orthographicHalfHeightIsHalfTheDiagonal)
{
    const double radius = std::sqrt(181. * 181 + 217. * 217 + 362. * 362) / 2;
    const ViewVolume wide = vo::viewVolume(kBrain, 0, 600, 200);
    EXPECT_NEAR(wide.halfHeight, radius, 1e-9);
    EXPECT_NEAR(wide.halfWidth, 3 * radius, 1e-9);
    const ViewVolume tall = vo::viewVolume(kBrain, 0, 200, 500);
    EXPECT_NEAR(tall.halfWidth, radius, 1e-9);
    EXPECT_NEAR(tall.halfHeight, 2.5 * radius, 1e-9);
}

TEST(Camera, cornersStayInsideTheViewVolume)
{
    for (const double degrees : {0.0, 0.1, 30.0, 120.0, 170.0}) {
        const ViewVolume view = vo::viewVolume(kBrain, degrees, 640, 480);
        for (int step = 0; step < 36; ++step) {
            const Matrix modelView = vo::modelViewMatrix(kBrain, {7.0 * step, 10.0 * step}, view);
            for (int corner = 0; corner < 8; ++corner) {
                const Point p{corner & 1 ? 181. : 0., corner & 2 ? 217. : 0., corner & 4 ? 181. : 0.};
                const Point ndc = transform(vo::projectionMatrix(view), transform(modelView, p));
                for (const double value : ndc)
                    ASSERT_LE(std::abs(value), 1 + 1e-9) << degrees << ' ' << step << ' ' << corner;
            }
        }
    }
}

TEST(Camera, perspectiveAngleSpansTheSmallerSide)
{
    const ViewVolume view = vo::viewVolume(kBrain, 60, 400, 200);
    EXPECT_NEAR(std::atan(view.halfHeight / view.distance) * 360 / M_PI, 60, 1e-9);
    EXPECT_NEAR(view.distance, 2 * vo::boundingRadius(kBrain), 1e-9);
    EXPECT_GT(view.nearDistance, 0);
}

TEST(Trackball, dragTurnsATenthOfADegreeAPixel)
{
    vo::Trackball trackball;
    trackball.press(100, 50, {10, 20});
    const Orientation turned = trackball.drag(130, 90);
    EXPECT_DOUBLE_EQ(turned.latitude, 10 - 4);
    EXPECT_DOUBLE_EQ(turned.longitude, 20 - 3);
    const Orientation back = trackball.drag(100, 50);
    EXPECT_DOUBLE_EQ(back.latitude, 10);
    EXPECT_DOUBLE_EQ(back.longitude, 20);
}

} // namespace
