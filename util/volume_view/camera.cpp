#include "camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vo {
namespace {

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

Matrix turnAboutX(double degrees)
{
    const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    return {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1};
}

Matrix turnAboutZ(double degrees)
{
    const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    return {c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

} // namespace

double boundingRadius(const Model& model)
{
    return model.margin *
           std::hypot(model.size[0] * model.scale[0], model.size[1] * model.scale[1],
                      model.size[2] * model.scale[2]) /
           2;
}

ViewVolume viewVolume(const Model& model, double degrees, int width, int height)
{
    const double radius = boundingRadius(model);
    // Room for rounding: a corner that points at the eye must not be cut off.
    const double depth = 1.01 * radius;
    ViewVolume view{radius, radius, 0, -depth, depth};
    if (degrees > 0) {
        const double halfAngle = radians(degrees) / 2;
        view.distance = radius / std::sin(halfAngle);
        view.halfWidth = view.halfHeight = view.distance * std::tan(halfAngle);
        view.nearDistance = std::max(view.distance - depth, view.distance / 1000);
        view.farDistance = view.distance + depth;
    }
    const double smaller = std::min(width, height);
    view.halfWidth *= width / smaller;
    view.halfHeight *= height / smaller;
    return view;
}

Matrix modelViewMatrix(const Model& model, const Orientation& orientation, const ViewVolume& view)
{
    const auto& [x, y, z] = model.scale;
    Matrix matrix = translation(0, 0, -view.distance);
    matrix = product(matrix, turnAboutX(-orientation.latitude - 90));
    matrix = product(matrix, turnAboutZ(-orientation.longitude));
    matrix = product(matrix, {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1});
    return product(matrix, translation(-model.size[0] / 2, -model.size[1] / 2, -model.size[2] / 2));
}

Matrix projectionMatrix(const ViewVolume& view)
{
    const double n = view.nearDistance, f = view.farDistance;
    if (view.distance == 0) {
        return {1 / view.halfWidth, 0, 0, 0, 0, 1 / view.halfHeight, 0, 0, 0, 0, -2 / (f - n), 0, 0, 0,
                -(f + n) / (f - n), 1};
    }
    const double d = view.distance;
    return {d / view.halfWidth,   0, 0, 0, 0, d / view.halfHeight, 0, 0, 0, 0, -(f + n) / (f - n), -1, 0, 0,
            -2 * f * n / (f - n), 0};
}

} // namespace vo
