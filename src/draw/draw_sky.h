#pragma once

#include "draw/scene_resources.h"
#include "style/styled_scene.h"

namespace vo {

/// Draws the background over the whole viewport, as far away as can be, with the blending and the depth test
/// that are set.
void drawSky(const StyledScene& scene, SceneResources& resources, SceneArrays& arrays);

} // namespace vo
