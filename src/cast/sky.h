#pragma once

#include "style/styled_scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace vo {

/// The background in a direction of the world: colour multiplied by opacity, and opacity.
glm::vec4 skyColor(const SkyColors& sky, const glm::dvec3& direction);

} // namespace vo
