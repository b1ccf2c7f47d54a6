#pragma once

#include "cast/clear_blocks.h"

#include <cstdint>
#include <span>

namespace vo {

/// Of a volume that is drawn by samples or surfaces, whose voxels have these blocks. `chainsIn`:
/// SegmentBlocks::chainsIn(), or nothing.
ClearBlocks clearBlocksOf(const StyledVolume& volume, const VoxelBlocks& blocks,
                          std::span<const std::uint64_t> chainsIn);

} // namespace vo
