#include "cast/clear_space.h"

#include "cast/cast_volume.h"

namespace vo {

ClearBlocks clearBlocksOf(const StyledVolume& volume, const VoxelBlocks& blocks)
{
    if (blocks.ranges.empty()) return {};
    if (volume.surfaces) return ClearBlocks(blocks, *volume.surfaces);
    const std::vector<ChainPlan> plans(volume.chains.begin(), volume.chains.end());
    return ClearBlocks(blocks, ClearValues(plans));
}

} // namespace vo
