#pragma once

#include "appearance/voxel_format.h"
#include "core/volume_size.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace vo {

/// For drawing a volume is cut into cubic cells of so many voxels.
inline constexpr int kCellSide = 4;

/// The lowest and the highest value that samples inside a cell can read; low > high: none.
struct ValueRange
{
    float low = std::numeric_limits<float>::infinity();
    float high = -std::numeric_limits<float>::infinity();
};

/// Which component of a voxel, as decodeVoxels reads it.
enum class VoxelComponent { red = 0, alpha = 3 };

/// The ranges of the cells that a brick meets.
struct CellRanges
{
    VoxelOrigin first;              ///< number of the lowest cell
    VoxelSize count;                ///< cells along each axis
    std::vector<ValueRange> ranges; ///< x fastest
};

/// Cells of a volume: cell c spans [c, c + 1] * side on each axis.
struct CellGrid
{
    int side = kCellSide;
    /// Cells that a brick does not meet, but is beside, are told about it too.
    bool besideBrick = false;
};

/// The ranges of a brick whose lower corner is at `origin` (not negative) of the volume. A sample on the
/// border of a cell reads half a voxel beyond it, so one layer of the brick's voxels around a cell counts as
/// well.
CellRanges cellRanges(std::span<const std::byte> voxels, VoxelFormat format, const VoxelSize& size,
                      const VoxelOrigin& origin, VoxelComponent component, const CellGrid& grid = {});

} // namespace vo
