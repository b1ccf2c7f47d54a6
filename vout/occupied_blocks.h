#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace vo {

using BlockPlace = std::array<int, 3>;

/// A volume in cubic blocks, the last ones of an axis cut short by the volume's end.
struct BlockGrid
{
    int side = 8;       ///< voxels
    BlockPlace size{};  ///< of the volume, voxels
    BlockPlace count{}; ///< of blocks
    std::vector<std::uint8_t> occupied; ///< 0 or 1, x fastest

    /// Nothing is occupied. Throws CallerError for sizes below 1, or more than 2^24 blocks.
    static BlockGrid of(const BlockPlace& size, int side);

    std::size_t index(const BlockPlace& block) const
    {
        const auto at = [&](std::size_t axis) { return static_cast<std::size_t>(block[axis]); };
        return (at(2) * static_cast<std::size_t>(count[1]) + at(1)) * static_cast<std::size_t>(count[0]) + at(0);
    }
    /// Where block `block` of an axis begins, or the one before ends; voxels.
    int voxel(std::size_t axis, int block) const
    {
        return block == count[axis] ? size[axis] : block * side;
    }
};

/// Blocks from `lower` to before `upper`.
struct BlockBox
{
    BlockPlace lower{};
    BlockPlace upper{};
};

/// The lowest and the highest of some values; low > high: of none.
struct ValueBounds
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

/// Fills in `size` voxels from `origin` on, x fastest, a value each.
using VoxelReader = std::function<void(const BlockPlace& origin, const BlockPlace& size, double* values)>;

/// The bounds of each block and the voxels next to it. Values that are no numbers are passed over. Reads a layer of
/// blocks at a time.
std::vector<ValueBounds> blockBounds(const BlockGrid& grid, const VoxelReader& read);

/// Boxes that do not overlap and cover the occupied blocks alone: each grows along one axis, then another, then the third,
/// as far as it can; of all orders of axes that with the fewest.
std::vector<BlockBox> mergedBoxes(const BlockGrid& grid);

/// The occupied blocks, a box each.
std::vector<BlockBox> separateBoxes(const BlockGrid& grid);

/// Voxels in boxes.
double voxelCount(const BlockGrid& grid, std::span<const BlockBox> boxes);

} // namespace vo
