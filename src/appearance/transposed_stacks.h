#pragma once

#include "appearance/brick_grid.h"

#include <cstddef>
#include <span>

namespace vo {

/// Bricks of one set with their voxels, `voxelBytes` each, x fastest; those without voxels are skipped.
struct BrickVoxels
{
    BrickExtent extent;
    std::span<std::byte> voxels;
};

/// Fills the target bricks from the source bricks wherever both cover a voxel of the volume; voxels that no
/// source brick covers become zero. Makes the XZ and YZ stacks from the XY stack.
void fillFromBricks(std::span<const BrickVoxels> sources, std::span<const BrickVoxels> targets,
                    std::size_t voxelBytes, const VoxelSize& volume);

} // namespace vo
