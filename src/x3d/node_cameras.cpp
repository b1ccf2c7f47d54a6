#include "x3d/node_cameras.h"

#include "x3d/node_transform.h"
#include "x3d/node_values.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

void ViewBox::add(const glm::dvec3& point)
{
    low = glm::min(low, point);
    high = glm::max(high, point);
}

void ViewBox::add(const ViewBox& box, const glm::dmat4& matrix)
{
    for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
        const glm::dvec4 at((corner & 1 ? box.high : box.low).x, (corner & 2 ? box.high : box.low).y,
                            (corner & 4 ? box.high : box.low).z, 1.0);
        add(glm::dvec3(matrix * at));
    }
}

namespace {

constexpr double kUsualAngle = 0.785398;

bool isOrtho(const PlacedNode& viewpoint)
{
    return isOf(viewpoint.node, "OrthoViewpoint");
}

double fieldOfView(const PlacedNode& viewpoint)
{
    return viewpoint.node ? static_cast<double>(floatOf(*viewpoint.node, "fieldOfView", 0.785398f))
                          : kUsualAngle;
}

/// Half the width and the height of what is seen at depth 1; the angle is that of the smaller side.
glm::dvec2 halfSides(const PlacedNode& viewpoint, int width, int height)
{
    const double half = std::tan(fieldOfView(viewpoint) / 2.0);
    const double smaller = std::min(width, height);
    return {half * width / smaller, half * height / smaller};
}

struct Rectangle
{
    glm::dvec2 low{-1.0}, high{1.0};
};

/// Of an OrthoViewpoint, made wider or higher until it has the window's shape.
Rectangle seenRectangle(const PlacedNode& viewpoint, int width, int height)
{
    Rectangle seen;
    const auto& field = floatsOf(*viewpoint.node, "fieldOfView");
    if (field.size() >= 4 && field[0] < field[2] && field[1] < field[3])
        seen = {{field[0], field[1]}, {field[2], field[3]}};
    const double scale = glm::length(glm::dvec3(viewpoint.worldFromLocal[1]));
    const glm::dvec2 center = (seen.low + seen.high) * (scale / 2.0);
    glm::dvec2 half = (seen.high - seen.low) * (scale / 2.0);
    const double shape = static_cast<double>(width) / height;
    half = {std::max(half.x, half.y * shape), std::max(half.y, half.x / shape)};
    return {center - half, center + half};
}

struct DepthRange
{
    double near, far;
};

double marginOf(const ViewBox& box)
{
    const double reach = std::max(std::abs(box.low.z), std::abs(box.high.z));
    return 0.01 * glm::length(box.high - box.low) + 1e-6 * reach;
}

/// Whether a box of eye space reaches into the pyramid that is `half` of its depth wide to each side.
bool isInView(const ViewBox& box, const glm::dvec2& half)
{
    const double farthest = -box.low.z;
    return !box.isEmpty() && farthest > 0.0 && box.low.x <= half.x * farthest &&
           box.high.x >= -half.x * farthest && box.low.y <= half.y * farthest &&
           box.high.y >= -half.y * farthest;
}

/// Before all that is seen, as far as a thousandth of its own depth: what is small and near stays where there
/// is something large and far, down to a millionth, which OpenGL's depths still tell apart.
double nearPlane(const std::vector<ViewBox>& eyeBoxes, const glm::dvec2& half, double far)
{
    double near = far;
    for (const ViewBox& box : eyeBoxes) {
        if (!isInView(box, half)) continue;
        const double margin = marginOf(box);
        near = std::min(near, std::max(-box.high.z - margin, (-box.low.z + margin) * 1e-3));
    }
    return near < far ? std::max(near, far * 1e-6) : far * 1e-3;
}

DepthRange depthRange(const PlacedNode& viewpoint, const std::vector<ViewBox>& eyeBoxes, int width,
                      int height)
{
    ViewBox eye;
    for (const ViewBox& box : eyeBoxes)
        eye.add(box, glm::dmat4(1.0));
    DepthRange range{0.1, 100.0};
    if (!eye.isEmpty()) {
        const double margin = marginOf(eye);
        range = {std::max(-eye.high.z - margin, 0.0), -eye.low.z + margin};
        if (!(range.far > 0.0))
            range = {0.1, 100.0};
        else if (!isOrtho(viewpoint))
            range.near = nearPlane(eyeBoxes, halfSides(viewpoint, width, height), range.far);
    }
    if (!viewpoint.node) return range;
    const double near = floatOf(*viewpoint.node, "nearDistance", -1.0f);
    const double far = floatOf(*viewpoint.node, "farDistance", -1.0f);
    if (near > 0.0 && far > near) return {near, far};
    if (far > 0.0) range = {std::min(range.near, far * 0.5), far};
    if (near > 0.0) range = {near, std::max(range.far, near * 2.0)};
    return range;
}

} // namespace

glm::dmat4 eyeFromWorldOf(const PlacedNode& viewpoint)
{
    if (!viewpoint.node) return glm::dmat4(1.0);
    const glm::dvec3 position(vec3Of(*viewpoint.node, "position"));
    const glm::dmat4 worldFromView = glm::translate(viewpoint.worldFromLocal, position) *
                                     rotationMatrix(vec4Of(*viewpoint.node, "orientation"));
    const glm::dmat3 eyeAxes = glm::transpose(rigidAxes(worldFromView));
    return glm::translate(glm::dmat4(eyeAxes), -glm::dvec3(worldFromView[3]));
}

glm::dmat4 eyeThatSeesAll(const PlacedNode& viewpoint, const glm::dmat4& eyeFromWorld, const ViewBox& world,
                          int width, int height)
{
    if (world.isEmpty()) return glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -10)) * eyeFromWorld;
    const glm::dmat3 axes(eyeFromWorld);
    const glm::dvec3 center = axes * (world.low + world.high) * 0.5;
    const double extent = glm::length(world.high - world.low) * 0.5;
    const double radius = extent > 0.0 ? extent : 1e-6;
    double distance = radius * 2.0;
    if (!isOrtho(viewpoint)) {
        const glm::dvec2 half = halfSides(viewpoint, width, height);
        distance = radius / std::sin(std::atan(std::min(half.x, half.y)));
    }
    return glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -distance) - center) * glm::dmat4(axes);
}

glm::dmat4 clipFromEyeOf(const PlacedNode& viewpoint, const std::vector<ViewBox>& eyeBoxes, int width,
                         int height)
{
    const DepthRange depth = depthRange(viewpoint, eyeBoxes, width, height);
    if (isOrtho(viewpoint)) {
        const Rectangle seen = seenRectangle(viewpoint, width, height);
        return glm::ortho(seen.low.x, seen.high.x, seen.low.y, seen.high.y, depth.near, depth.far);
    }
    const glm::dvec2 half = halfSides(viewpoint, width, height) * depth.near;
    return glm::frustum(-half.x, half.x, -half.y, half.y, depth.near, depth.far);
}

} // namespace vo
