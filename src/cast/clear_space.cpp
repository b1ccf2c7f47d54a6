#include "cast/clear_space.h"

#include "cast/cast_volume.h"

namespace vo {

ClearBlocks clearBlocksOf(const StyledVolume& volume, const VoxelBlocks& blocks,
                          std::span<const std::uint64_t> chainsIn)
{
    const int components = volume.voxels->components;
    if (blocks.ranges.empty()) return {};
    if (volume.surfaces) return components == 1 ? ClearBlocks(blocks, *volume.surfaces) : ClearBlocks();
    const std::vector<ChainPlan> plans(volume.chains.begin(), volume.chains.end());
    return ClearBlocks(blocks, clearValuesOf(plans, components), chainsIn);
}

} // namespace vo
