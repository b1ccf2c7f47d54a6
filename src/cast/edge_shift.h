#pragma once

#include "style/styled_scene.h"

#include <glm/mat4x4.hpp>

namespace vo {

/// Moves what a pixel's ray passes, in eye space, to where the pixel looks for edges (kPixelsPastCenter). The
/// matrices must be invertible.
glm::dmat4 edgeShift(const StyledScene& scene);

} // namespace vo
