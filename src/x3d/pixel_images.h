#pragma once

#include "x3d/scene.h"
#include "x3d/voxel_files.h"

namespace vo {

/// The image of a PixelTexture or a PixelTexture3D.
TextureResult pixelImage(const Node& node);

} // namespace vo
