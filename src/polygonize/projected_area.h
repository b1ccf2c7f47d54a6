#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace vo {

/// Area that a convex polygon covers in normalised device coordinates, of 4 for the whole viewport: what the
/// view volume leaves of it, either side out. A polygon with a vertex that is not finite covers nothing.
double projectedArea(std::span<const glm::dvec3> polygon, const glm::dmat4& toClip);

} // namespace vo
