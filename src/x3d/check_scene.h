#pragma once

#include "x3d/scene.h"

namespace vo {

/// Adds messages on what a scene needs and does not have: files that urls name, and components that its
/// profile does not bring. After checkView(), what that told is not told again.
void checkScene(Scene& scene);

} // namespace vo
