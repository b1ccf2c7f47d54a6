#pragma once

#include "draw/scene_programs.h"

namespace vo {

/// Blends the texture of unit 0, a finished picture whose colours are multiplied by their opacity, pixel by
/// pixel over the framebuffer: over all of the viewport, which begins at its lower left corner, without a
/// look at depths. For the scope of a ScopedSceneState; a vertex array is bound.
void blendTexture(const SceneContext& context, ScenePrograms& programs);

} // namespace vo
