#include "vox3d_navigation.h"

#include <algorithm>
#include <cmath>

namespace vo {
namespace {

Matrix turn(const std::array<double, 3>& axis, double angle)
{
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    if (!(length > 0)) return translation(0, 0, 0);
    const double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length;
    const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
    return {t * x * x + c,
            t * x * y + s * z,
            t * x * z - s * y,
            0,
            t * x * y - s * z,
            t * y * y + c,
            t * y * z + s * x,
            0,
            t * x * z + s * y,
            t * y * z - s * x,
            t * z * z + c,
            0,
            0,
            0,
            0,
            1};
}

} // namespace

MovedEye MovedEye::of(voX3DView& view)
{
    MovedEye eye;
    view.getCamera(eye.eyeFromWorld.data(), eye.projection.data());
    if (!view.getBounds(eye.center.data(), eye.radius)) eye.radius = 1;
    return eye;
}

void MovedEye::apply(voX3DView& view) const
{
    const double depth = -centerInEye()[2], reach = 1.01 * radius;
    const double far = std::max(depth + reach, 1e-3 * radius);
    const double near = isOrthographic() ? depth - reach : std::max(depth - reach, 1e-3 * far);
    Matrix fitted = projection;
    fitted[10] = (isOrthographic() ? -2 : -(far + near)) / (far - near);
    fitted[14] = (isOrthographic() ? -(far + near) : -2 * far * near) / (far - near);
    view.setCamera(eyeFromWorld.data(), fitted.data());
}

std::array<double, 3> MovedEye::centerInEye() const
{
    std::array<double, 3> to;
    for (std::size_t row = 0; row < 3; ++row)
        to[row] = eyeFromWorld[row] * center[0] + eyeFromWorld[4 + row] * center[1] +
                  eyeFromWorld[8 + row] * center[2] + eyeFromWorld[12 + row];
    return to;
}

void MovedEye::examine(const std::array<double, 3>& axis, double angle)
{
    const auto at = centerInEye();
    const Matrix there = translation(at[0], at[1], at[2]), back = translation(-at[0], -at[1], -at[2]);
    eyeFromWorld = product(product(there, turn(axis, angle)), product(back, eyeFromWorld));
}

void MovedEye::move(const std::array<double, 3>& by)
{
    eyeFromWorld = product(translation(by[0], by[1], by[2]), eyeFromWorld);
}

void MovedEye::approach(double factor)
{
    if (isOrthographic()) {
        for (const std::size_t i : {0u, 5u})
            projection[i] /= factor;
        return;
    }
    const double depth = std::max(-centerInEye()[2], radius * 1e-3);
    move({0, 0, depth * (1 - factor)});
}

void MovedEye::look(const std::array<double, 3>& axis, double angle)
{
    eyeFromWorld = product(turn(axis, angle), eyeFromWorld);
}

void MovedEye::resize(int oldWidth, int oldHeight, int width, int height)
{
    const double oldSide = std::min(oldWidth, oldHeight), side = std::min(width, height);
    projection[0] *= (oldWidth / oldSide) / (width / side);
    projection[5] *= (oldHeight / oldSide) / (height / side);
}

} // namespace vo
