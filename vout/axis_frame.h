#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace vo {

/// Two unit vectors across an axis and each other: x and y for an axis along z.
struct AxisFrame
{
    glm::dvec3 u;
    glm::dvec3 v;

    explicit AxisFrame(const glm::dvec3& axis)
    {
        const glm::dvec3 along = glm::normalize(axis);
        const glm::dvec3 aside = std::abs(along.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
        u = glm::normalize(glm::cross(aside, along));
        v = glm::cross(along, u);
    }
    /// The direction at an angle in radians, from u to v.
    glm::dvec3 at(double angle) const { return std::cos(angle) * u + std::sin(angle) * v; }
};

} // namespace vo
