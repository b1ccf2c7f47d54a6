#pragma once

#include "style/styled_scene.h"

namespace vo {

/// The picture of a scene, computed without OpenGL. Opaque and translucent surfaces, volumes that overlap,
/// and the sky stand in the right order in every pixel. `threads`: at most so many; 0: as many as the machine
/// has. Throws std::bad_alloc.
void castScene(const StyledScene& scene, int threads, ScenePicture& picture);

} // namespace vo
