#pragma once

#include "x3d/scene.h"

namespace vo {

/// Adds messages on slice atlases that cannot be cut, which it reads, and on pictures that are the one slice
/// of an ImageTexture3D.
void checkTextures(Scene& scene);

} // namespace vo
