#pragma once

#include <glm/vec3.hpp>

namespace vo {

/// An axis-aligned box between two corners, lower <= upper on each axis.
struct Box
{
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
};

} // namespace vo
