#pragma once

#include "draw/scene_resources.h"
#include "style/styled_scene.h"

namespace vo {

/// Draws the background over the whole viewport, with the blending that is set.
void drawSky(const StyledScene& scene, SceneResources& resources, SceneArrays& arrays);

} // namespace vo
