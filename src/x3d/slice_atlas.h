#pragma once

#include "x3d/scene.h"
#include "x3d/voxel_files.h"

namespace vo {

/// What is wrong with the counts of an ImageTextureAtlas; "" where they are right.
std::string atlasObjection(const Node& node);

/// The slices of an ImageTextureAtlas whose counts are right, cut from its picture, which is of one slice.
/// They lie in rows, the first in the picture's first row at its left; each keeps its rows in their order.
TextureResult atlasSlices(const Node& node, std::shared_ptr<VoxelTexture> picture);

} // namespace vo
