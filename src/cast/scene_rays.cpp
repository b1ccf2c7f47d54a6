#include "cast/scene_rays.h"

#include "cast/edge_shift.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// The line that one point of the picture is, from the near to the far plane of the view volume.
struct Line
{
    DepthRay ray;
    RayPart depths;
};

Line lineOf(const glm::dmat4& eyeFromClip, const glm::dvec2& place)
{
    const glm::dvec4 from = eyeFromClip * glm::dvec4(place, -1.0, 1.0);
    const glm::dvec4 to = eyeFromClip * glm::dvec4(place, 1.0, 1.0);
    const glm::dvec3 start = glm::dvec3(from) / from.w;
    // The far end may be at infinity: w is 0 then, or on the other side.
    glm::dvec3 along = glm::dvec3(to) * from.w - glm::dvec3(from) * to.w;
    along /= -along.z;
    const double farther = to.w / from.w;
    const bool ends = farther > 1e-12;
    return {{start + along * start.z, along},
            {-start.z, ends ? -to.z / to.w : std::numeric_limits<double>::infinity()}};
}

bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

void RayPart::cut(double value, double slope)
{
    if (slope == 0.0 || !std::isfinite(slope)) {
        if (!(value >= 0.0)) end = -std::numeric_limits<double>::infinity();
        return;
    }
    const double crossing = -value / slope;
    if (slope > 0.0)
        begin = std::max(begin, crossing);
    else
        end = std::min(end, crossing);
}

std::optional<SceneRays> SceneRays::of(const StyledScene& scene)
{
    if (scene.width < 1 || scene.height < 1) return std::nullopt;
    if (!isInvertible(scene.eyeFromWorld) || !isInvertible(scene.clipFromEye)) return std::nullopt;
    SceneRays rays;
    rays.worldFromEye_ = glm::inverse(scene.eyeFromWorld);
    rays.eyeFromClip_ = glm::inverse(scene.clipFromEye);
    rays.pixel_ = {2.0 / scene.width, 2.0 / scene.height};
    const Line middle = lineOf(rays.eyeFromClip_, {0.0, 0.0});
    if (!isFinite(middle.ray.origin) || !isFinite(middle.ray.direction)) return std::nullopt;
    rays.depths_ = middle.depths;
    rays.shift_ = edgeShift(scene);
    return rays;
}

DepthRay SceneRays::ray(double x, double y) const
{
    return lineOf(eyeFromClip_, {x * pixel_.x - 1.0, y * pixel_.y - 1.0}).ray;
}

glm::dmat4 edgeShift(const StyledScene& scene)
{
    const glm::dmat4 eyeFromClip = glm::inverse(scene.clipFromEye);
    const glm::dvec2 past(2.0 * kPixelsPastCenter / scene.width, 2.0 * kPixelsAboveCenter / scene.height);
    const DepthRay middle = lineOf(eyeFromClip, {0.0, 0.0}).ray, beside = lineOf(eyeFromClip, past).ray;
    glm::dmat4 shift(1.0);
    shift[2] -= glm::dvec4(beside.direction - middle.direction, 0.0);
    shift[3] += glm::dvec4(beside.origin - middle.origin, 0.0);
    return shift;
}

glm::dvec3 windowOf(const StyledScene& scene, const glm::dvec4& eye)
{
    const glm::dvec4 clip = scene.clipFromEye * eye;
    return {(clip.x + clip.w) * 0.5 * scene.width, (clip.y + clip.w) * 0.5 * scene.height, clip.w};
}

double SceneRays::depthAt(double x, double y, double z) const
{
    const glm::dvec4 point = eyeFromClip_ * glm::dvec4(x * pixel_.x - 1.0, y * pixel_.y - 1.0, z, 1.0);
    return -point.z / point.w;
}

DepthRay transformed(const glm::dmat4& matrix, const DepthRay& ray)
{
    return {glm::dvec3(matrix * glm::dvec4(ray.origin, 1.0)),
            glm::dvec3(matrix * glm::dvec4(ray.direction, 0.0))};
}

} // namespace vo
