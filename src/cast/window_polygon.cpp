#include "cast/window_polygon.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace vo {

namespace {

/// A sampling plane may lie on the near or on the far plane: noise must not lose it.
constexpr double kDepthSlack = 1e-6;
/// Polygons end at so many times the window's size from its middle, so that pixels can be counted.
constexpr double kGuard = 16.0;

bool comesFirst(const glm::dvec3& a, const glm::dvec3& b)
{
    for (int axis = 0; axis < 3; ++axis)
        if (a[axis] != b[axis]) return a[axis] < b[axis];
    return false;
}

PolygonVertex between(const PolygonVertex& a, const PolygonVertex& b, double share)
{
    PolygonVertex v;
    v.position = a.position + share * (b.position - a.position);
    for (std::size_t i = 0; i < v.values.size(); ++i)
        v.values[i] = a.values[i] + share * (b.values[i] - a.values[i]);
    return v;
}

PolygonVertex crossing(const PolygonVertex& a, double da, const PolygonVertex& b, double db)
{
    return comesFirst(a.position, b.position) ? between(a, b, da / (da - db)) : between(b, a, db / (db - da));
}

} // namespace

WindowProjection::WindowProjection(const CastRequest& request)
    : clipFromObject_(request.projection * request.model), width_(request.width), height_(request.height),
      nearDepth_(request.depth.nearDepth), farDepth_(request.depth.farDepth)
{
    const glm::dmat4 rows = glm::transpose(clipFromObject_);
    const glm::dvec4 w = rows[3];
    perspective_ = w.x != 0.0 || w.y != 0.0 || w.z != 0.0;
    for (const double sign : {1.0, -1.0}) {
        halfSpaces_.push_back((1.0 + kDepthSlack) * w + sign * rows[2]);
        halfSpaces_.push_back(kGuard * w + sign * rows[0]);
        halfSpaces_.push_back(kGuard * w + sign * rows[1]);
    }
    const glm::dmat4 eyeRows = glm::transpose(request.model);
    for (const glm::vec4& plane : request.clipPlanes) {
        glm::dvec4 object(0.0);
        for (int row = 0; row < 4; ++row)
            object += static_cast<double>(plane[row]) * eyeRows[row];
        halfSpaces_.push_back(object);
    }
    callersPlanes_ = request.clipPlanes.size();
}

bool WindowProjection::isInside(const PolygonVertex& vertex, const glm::dvec4& clip) const
{
    const double guard = kGuard * clip.w;
    const bool inView = std::abs(clip.z) <= (1.0 + kDepthSlack) * clip.w && std::abs(clip.x) <= guard &&
                        std::abs(clip.y) <= guard && clip.w > 0.0;
    if (!inView || callersPlanes_ == 0) return inView;
    const glm::dvec4 point(vertex.position, 1.0);
    for (std::size_t i = halfSpaces_.size() - callersPlanes_; i < halfSpaces_.size(); ++i)
        if (!(glm::dot(halfSpaces_[i], point) >= 0.0)) return false;
    return true;
}

void WindowProjection::cut(std::vector<PolygonVertex>& polygon)
{
    for (const glm::dvec4& halfSpace : halfSpaces_) {
        distances_.clear();
        for (const PolygonVertex& vertex : polygon)
            distances_.push_back(glm::dot(halfSpace, glm::dvec4(vertex.position, 1.0)));
        scratch_.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::size_t next = i + 1 < polygon.size() ? i + 1 : 0;
            const bool inside = distances_[i] >= 0.0;
            if (inside) scratch_.push_back(polygon[i]);
            if (inside != (distances_[next] >= 0.0))
                scratch_.push_back(crossing(polygon[i], distances_[i], polygon[next], distances_[next]));
        }
        polygon.swap(scratch_);
    }
}

WindowVertex WindowProjection::toWindow(const PolygonVertex& vertex, const glm::dvec4& clip) const
{
    WindowVertex window;
    window.inverseW = 1.0 / clip.w;
    window.x = (0.5 + 0.5 * clip.x * window.inverseW) * width_;
    window.y = (0.5 + 0.5 * clip.y * window.inverseW) * height_;
    window.depth = nearDepth_ + (0.5 + 0.5 * clip.z * window.inverseW) * (farDepth_ - nearDepth_);
    window.values = vertex.values;
    return window;
}

void WindowProjection::project(std::vector<PolygonVertex>& polygon, std::vector<WindowVertex>& seen)
{
    seen.clear();
    clip_.clear();
    bool inside = true;
    for (const PolygonVertex& vertex : polygon) {
        clip_.push_back(clipFromObject_ * glm::dvec4(vertex.position, 1.0));
        inside = inside && isInside(vertex, clip_.back());
    }
    if (!inside) {
        cut(polygon);
        clip_.clear();
        for (const PolygonVertex& vertex : polygon)
            clip_.push_back(clipFromObject_ * glm::dvec4(vertex.position, 1.0));
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (!(clip_[i].w > 0.0)) return seen.clear();
        seen.push_back(toWindow(polygon[i], clip_[i]));
    }
}

} // namespace vo
