#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <vector>

namespace vo {

/// Throws CallerError for a polygon that touches or crosses itself, or has corners in one place. Time grows with the
/// square of its corners.
void requireSimple(const std::vector<glm::dvec2>& polygon);

/// The triangles of a simple polygon, concave or not, by its corners' numbers; all have an area, and all corners are
/// in use. Throws CallerError where rounding leaves no way to cut it.
std::vector<std::array<int, 3>> trianglesOf(const std::vector<glm::dvec2>& polygon);

} // namespace vo
