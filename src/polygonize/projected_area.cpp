#include "polygonize/projected_area.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <vector>

namespace vo {

namespace {

/// Clip coordinates inside the view volume have dot(plane, p) >= 0 for each of these.
constexpr double kViewVolume[6][4] = {{0, 0, 1, 1},  {0, 0, -1, 1}, {1, 0, 0, 1},
                                      {-1, 0, 0, 1}, {0, 1, 0, 1},  {0, -1, 0, 1}};

void clip(std::vector<glm::dvec4>& polygon, const glm::dvec4& plane)
{
    std::vector<glm::dvec4> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4& a = polygon[i];
        const glm::dvec4& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double da = glm::dot(plane, a), db = glm::dot(plane, b);
        if (da >= 0.0) left.push_back(a);
        if ((da >= 0.0) != (db >= 0.0)) left.push_back(a + (da / (da - db)) * (b - a));
    }
    polygon = std::move(left);
}

} // namespace

double projectedArea(std::span<const glm::dvec3> polygon, const glm::dmat4& toClip)
{
    std::vector<glm::dvec4> corners;
    for (const glm::dvec3& p : polygon) {
        if (!std::isfinite(p.x + p.y + p.z)) return 0.0;
        corners.push_back(toClip * glm::dvec4(p, 1.0));
    }
    for (const auto& [x, y, z, w] : kViewVolume)
        clip(corners, {x, y, z, w});

    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const auto at = [&](std::size_t k) { return glm::dvec3(corners[k]) / corners[k].w; };
        const glm::dvec3 a = at(i) - at(0), b = at(i + 1) - at(0);
        const double part = a.x * b.y - a.y * b.x;
        if (std::isfinite(part)) twice += part;
    }
    return 0.5 * std::abs(twice);
}

} // namespace vo
