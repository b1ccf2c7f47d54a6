#include "cast/ray_frame.h"

#include "polygonize/sampling_shells.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

/// Coordinates this close to a face of a box lie on it (voxels).
constexpr double kSnapDistance = 1e-5;
/// Rounding of planes that lie in faces of the geometry, and of the view volume: a part of the distance.
constexpr double kRounding = 1e-9;

using RayPoint = std::array<PixelRamp, 4>;

/// The point of depth z (normalised device coordinates) under each pixel's centre, homogeneous.
RayPoint unprojected(const glm::dmat4& objectFromClip, int width, int height, double z)
{
    const double perX = 2.0 / width, perY = 2.0 / height;
    RayPoint point;
    for (int row = 0; row < 4; ++row) {
        const double x = objectFromClip[0][row], y = objectFromClip[1][row];
        point[static_cast<std::size_t>(row)] = {objectFromClip[3][row] + z * objectFromClip[2][row] +
                                                    x * (0.5 * perX - 1.0) + y * (0.5 * perY - 1.0),
                                                x * perX, y * perY};
    }
    return point;
}

PixelRamp constant(double value)
{
    return {value, 0.0, 0.0};
}

PixelRamp dot(const glm::dvec3& v, const std::array<PixelRamp, 3>& ramps)
{
    return v.x * ramps[0] + v.y * ramps[1] + v.z * ramps[2];
}

/// Keeps dot(plane, (p, 1)) <= slack.
RayBound halfSpace(const glm::dvec4& plane, double slack, const RayFrame& frame)
{
    const glm::dvec3 normal(plane);
    return {dot(normal, frame.origin) + constant(plane.w), dot(normal, frame.direction), slack};
}

void setRays(const CastRequest& request, const Camera& camera, RayFrame& frame)
{
    const glm::dmat4 objectFromClip = glm::inverse(request.projection * request.model);
    // Lines of sight through one point: depth 0 lies ahead. Parallel ones: any depth will do.
    const RayPoint middle = unprojected(objectFromClip, request.width, request.height, 0.0);
    if (!camera.perspective) {
        const double w = middle[3].at;
        for (std::size_t i = 0; i < 3; ++i) {
            frame.origin[i] = (1.0 / w) * middle[i];
            frame.direction[i] = constant(camera.direction[static_cast<int>(i)]);
        }
        return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double eye = camera.eye[static_cast<int>(i)];
        frame.origin[i] = constant(eye);
        frame.direction[i] = middle[i] + (-eye) * middle[3];
    }
    const PixelRamp ahead = dot(camera.depthNormal, frame.direction);
    const double sign = ahead(0.5 * request.width, 0.5 * request.height) < 0.0 ? -1.0 : 1.0;
    const double size = sign / std::abs(ahead(0.5 * request.width, 0.5 * request.height));
    for (PixelRamp& ramp : frame.direction)
        ramp = size * ramp;
}

void setSamples(const CastRequest& request, const Camera& camera, RayFrame& frame)
{
    if (camera.perspective && request.sampling.mode == SamplingMode::spherical) {
        const ShellFamily shells = samplingShells(request.tetras, camera, request.sampling);
        frame.shells = true;
        frame.scale = shells.scale;
        frame.count = shells.count;
        frame.spacing = shells.spacing;
        frame.nearest = constant(shells.radius(shells.count - 1));
        return;
    }
    const PlaneFamily planes = samplingPlanes(request.tetras, camera, request.sampling);
    frame.count = planes.count;
    frame.spacing = planes.spacing;
    frame.nearest = constant(planes.offset(planes.count - 1)) + -1.0 * dot(planes.normal, frame.origin);
    frame.along = dot(planes.normal, frame.direction);
}

} // namespace

bool RayFrame::isParallel() const
{
    return std::ranges::all_of(direction,
                               [](const PixelRamp& ramp) { return ramp.dx == 0.0 && ramp.dy == 0.0; });
}

RayFrame rayFrame(const CastRequest& request, const Camera& camera)
{
    RayFrame frame;
    frame.pixels = {0, 0, request.width, request.height};
    setRays(request, camera, frame);
    setSamples(request, camera, frame);

    const glm::dmat4 rows = glm::transpose(request.projection * request.model);
    frame.clipZ = halfSpace(rows[2], 0.0, frame);
    frame.clipW = halfSpace(rows[3], 0.0, frame);
    const double size =
        std::abs(camera.nearDepth) + std::abs(std::isfinite(camera.farDepth) ? camera.farDepth : 0.0);
    for (const double side : {-1.0, 1.0}) { // z >= -w, z <= w
        const glm::dvec4 plane = side * rows[2] - rows[3];
        frame.bounds.push_back(
            halfSpace(plane, kRounding * (size * glm::length(glm::dvec3(plane)) + std::abs(plane.w)), frame));
    }
    if (camera.perspective) frame.bounds.push_back(halfSpace(-rows[3], 0.0, frame));
    const glm::dmat4 objectPlane = glm::transpose(request.model);
    for (const glm::vec4& plane : request.clipPlanes)
        frame.bounds.push_back(halfSpace(-(objectPlane * glm::dvec4(plane)), 0.0, frame));
    return frame;
}

void boundByBox(const CastRequest& request, const Box& box, RayFrame& frame)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec4 plane(0.0);
            plane[axis] = side;
            plane.w = side < 0.0 ? box.lower[axis] : -box.upper[axis];
            frame.bounds.push_back(halfSpace(plane, kSnapDistance, frame));
        }

    const glm::dmat4 clip = request.projection * request.model;
    glm::dvec2 low(1e9), high(-1e9);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                           corner & 4 ? box.upper.z : box.lower.z);
        const glm::dvec4 seen = clip * glm::dvec4(p, 1.0);
        if (!(seen.w > 0.0)) return; // around the eye: anywhere
        const glm::dvec2 pixel =
            (glm::dvec2(seen) / seen.w + 1.0) * 0.5 * glm::dvec2(request.width, request.height);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    PixelRectangle& pixels = frame.pixels;
    const auto whole = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    pixels.left = std::max(pixels.left, whole(std::floor(low.x - 1.0), request.width));
    pixels.bottom = std::max(pixels.bottom, whole(std::floor(low.y - 1.0), request.height));
    pixels.right = std::min(pixels.right, whole(std::ceil(high.x + 1.0), request.width));
    pixels.top = std::min(pixels.top, whole(std::ceil(high.y + 1.0), request.height));
}

void boundByConvexSet(const ConvexSet& set, RayFrame& frame)
{
    for (const glm::dvec4& plane : set.planes)
        frame.bounds.push_back(halfSpace(plane, kRounding * (1.0 + std::abs(plane.w)), frame));
}

} // namespace vo
