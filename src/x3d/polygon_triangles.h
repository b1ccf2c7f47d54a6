#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace vo {

/// Twice the area of a polygon along its normal: counterclockwise from where it points.
glm::dvec3 areaVector(std::span<const glm::vec3> corners);

/// The triangles of a polygon by its corners' numbers, turning as it does: always two fewer than corners. A
/// polygon that is not flat is looked at along its normal; one that crosses itself is cut somehow. Time grows
/// with the square of its corners, or more.
std::vector<std::array<int, 3>> polygonTriangles(std::span<const glm::vec3> corners);

} // namespace vo
