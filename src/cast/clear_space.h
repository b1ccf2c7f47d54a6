#pragma once

#include "cast/clear_blocks.h"

namespace vo {

/// Of a volume of one component that is drawn by samples or surfaces, whose voxels have these blocks.
ClearBlocks clearBlocksOf(const StyledVolume& volume, const VoxelBlocks& blocks);

} // namespace vo
