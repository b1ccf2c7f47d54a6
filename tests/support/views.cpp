#include "support/views.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace vo::test {

namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// 0 to 1; not a standard distribution, since those differ between libraries.
double uniform(std::mt19937& random)
{
    return random() / 4294967296.0;
}

/// Half the width and half the height of a window whose smaller side is 2 long.
struct WindowShape
{
    double x;
    double y;
};

WindowShape windowShape(int width, int height)
{
    const double smaller = std::min(width, height);
    return {width / smaller, height / smaller};
}

} // namespace

Matrix identity()
{
    return scaling(1, 1, 1);
}

Matrix multiply(const Matrix& a, const Matrix& b)
{
    Matrix product{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t i = 0; i < 4; ++i)
                product[4 * column + row] += a[4 * i + row] * b[4 * column + i];
    return product;
}

Matrix translation(double x, double y, double z)
{
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

Matrix scaling(double x, double y, double z)
{
    return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1};
}

Matrix rotation(double degrees, double x, double y, double z)
{
    const double length = std::sqrt(x * x + y * y + z * z);
    const double a = x / length;
    const double b = y / length;
    const double c = z / length;
    const double cosine = std::cos(degrees * kRadians);
    const double sine = std::sin(degrees * kRadians);
    const double rest = 1.0 - cosine;
    return {a * a * rest + cosine,
            a * b * rest + c * sine,
            a * c * rest - b * sine,
            0, //
            a * b * rest - c * sine,
            b * b * rest + cosine,
            b * c * rest + a * sine,
            0, //
            a * c * rest + b * sine,
            b * c * rest - a * sine,
            c * c * rest + cosine,
            0, //
            0,
            0,
            0,
            1};
}

Matrix ortho(double left, double right, double bottom, double top, double near, double far)
{
    return {2 / (right - left),
            0,
            0,
            0,
            0,
            2 / (top - bottom),
            0,
            0,
            0,
            0,
            -2 / (far - near),
            0,
            -(right + left) / (right - left),
            -(top + bottom) / (top - bottom),
            -(far + near) / (far - near),
            1};
}

Matrix frustum(double left, double right, double bottom, double top, double near, double far)
{
    return {2 * near / (right - left),
            0,
            0,
            0,
            0,
            2 * near / (top - bottom),
            0,
            0,
            (right + left) / (right - left),
            (top + bottom) / (top - bottom),
            -(far + near) / (far - near),
            -1,
            0,
            0,
            -2 * far * near / (far - near),
            0};
}

Matrix perspective(double degreesHigh, double aspect, double near, double far)
{
    const double top = near * std::tan(0.5 * degreesHigh * kRadians);
    return frustum(-top * aspect, top * aspect, -top, top, near, far);
}

Matrix guideModel(const Angles& angles, const VoxelSize& volume, const glm::dvec3& scale)
{
    Matrix model = rotation(-angles.latitude - 90.0, 1, 0, 0);
    model = multiply(model, rotation(-angles.longitude, 0, 0, 1));
    model = multiply(model, scaling(scale.x, scale.y, scale.z));
    return multiply(model, translation(-0.5 * volume.x, -0.5 * volume.y, -0.5 * volume.z));
}

double halfDiagonal(const VoxelSize& volume, const glm::dvec3& scale)
{
    return 0.5 * std::hypot(volume.x * scale.x, volume.y * scale.y, volume.z * scale.z);
}

View orthographicView(const Angles& angles, const VoxelSize& volume, int width, int height,
                      const glm::dvec3& scale)
{
    const double half = halfDiagonal(volume, scale);
    const WindowShape shape = windowShape(width, height);
    return {guideModel(angles, volume, scale),
            ortho(-half * shape.x, half * shape.x, -half * shape.y, half * shape.y, -2 * half, 2 * half)};
}

View perspectiveView(const Angles& angles, const VoxelSize& volume, int width, int height, double degreesHigh,
                     const glm::dvec3& scale)
{
    const double half = halfDiagonal(volume, scale);
    const WindowShape shape = windowShape(width, height);
    const double distance = half / std::sin(0.5 * degreesHigh * kRadians);
    const double near = 0.5 * (distance - half);
    const double side = near * std::tan(0.5 * degreesHigh * kRadians);
    return {
        multiply(translation(0, 0, -distance), guideModel(angles, volume, scale)),
        frustum(-side * shape.x, side * shape.x, -side * shape.y, side * shape.y, near, distance + 2 * half)};
}

std::vector<Angles> fixedViews()
{
    std::vector<Angles> views;
    for (const double latitude : {0.0, 90.0, -40.0})
        for (int i = 0; i < 12; ++i)
            views.push_back({latitude, 30.0 * i});
    return views;
}

std::vector<Angles> randomViews(int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<Angles> views;
    for (int i = 0; i < count; ++i) {
        const double height = 2.0 * uniform(random) - 1.0;
        views.push_back({std::asin(height) / kRadians, 360.0 * uniform(random)});
    }
    return views;
}

Matrix randomRotation(unsigned seed)
{
    std::mt19937 random(seed);
    const double first = 360.0 * uniform(random);
    const double tilt = std::acos(2.0 * uniform(random) - 1.0) / kRadians;
    const double second = 360.0 * uniform(random);
    return multiply(rotation(first, 0, 0, 1), multiply(rotation(tilt, 1, 0, 0), rotation(second, 0, 0, 1)));
}

} // namespace vo::test
