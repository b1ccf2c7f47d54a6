#pragma once

#include "core/box.h"
#include "polygonize/camera.h"

#include <span>
#include <vector>

namespace vo {

/// Numbers of the boxes, back to front. Exact for boxes that do not overlap and share axis intervals as the
/// bricks of a lattice do, from any eye, also one inside them.
std::vector<int> backToFront(std::span<const Box> boxes, const Camera& camera);

} // namespace vo
