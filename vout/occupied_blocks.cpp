#include "vout/occupied_blocks.h"

#include "legacy/report.h"

#include <algorithm>
#include <string>

namespace vo {

namespace {

constexpr double kMostBlocks = 1 << 24;

/// Calls with each block of a box, those along the first axis of `order` one after the other.
template <typename Visit>
void forBlocks(const BlockBox& box, const BlockPlace& order, Visit visit)
{
    const auto a = static_cast<std::size_t>(order[0]), b = static_cast<std::size_t>(order[1]),
               c = static_cast<std::size_t>(order[2]);
    BlockPlace block{};
    for (block[c] = box.lower[c]; block[c] < box.upper[c]; ++block[c])
        for (block[b] = box.lower[b]; block[b] < box.upper[b]; ++block[b])
            for (block[a] = box.lower[a]; block[a] < box.upper[a]; ++block[a])
                visit(block);
}

constexpr BlockPlace kInMemory{0, 1, 2};

bool isFull(const BlockGrid& grid, const BlockBox& box)
{
    bool full = true;
    forBlocks(box, kInMemory, [&](const BlockPlace& block) { full = full && grid.occupied[grid.index(block)]; });
    return full;
}

/// The box that grows from a block along the axes in order.
BlockBox grownBox(const BlockGrid& free, const BlockPlace& from, const BlockPlace& order)
{
    BlockBox box{from, {from[0] + 1, from[1] + 1, from[2] + 1}};
    for (const int number : order) {
        const auto axis = static_cast<std::size_t>(number);
        while (box.upper[axis] < free.count[axis]) {
            BlockBox next = box;
            next.lower[axis] = box.upper[axis];
            next.upper[axis] = box.upper[axis] + 1;
            if (!isFull(free, next)) break;
            ++box.upper[axis];
        }
    }
    return box;
}

std::vector<BlockBox> mergedInOrder(const BlockGrid& grid, const BlockPlace& order)
{
    std::vector<BlockBox> boxes;
    BlockGrid free = grid;
    forBlocks({{0, 0, 0}, grid.count}, order, [&](const BlockPlace& from) {
        if (!free.occupied[free.index(from)]) return;
        boxes.push_back(grownBox(free, from, order));
        forBlocks(boxes.back(), kInMemory, [&](const BlockPlace& block) { free.occupied[free.index(block)] = 0; });
    });
    return boxes;
}

/// Voxels that count in a block, on one axis.
struct Reach
{
    int first, end;
};

Reach reachOf(const BlockGrid& grid, std::size_t axis, int block)
{
    return {std::max(grid.voxel(axis, block) - 1, 0), std::min(grid.voxel(axis, block + 1) + 1, grid.size[axis])};
}

/// Of a layer of voxels as the reader gave it, those of some columns and rows.
ValueBounds boundsIn(std::span<const double> layer, const BlockPlace& size, const Reach& columns, const Reach& rows)
{
    ValueBounds bounds;
    for (int z = 0; z < size[2]; ++z)
        for (int y = rows.first; y < rows.end; ++y) {
            const auto row = (static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) +
                              static_cast<std::size_t>(y)) *
                             static_cast<std::size_t>(size[0]);
            for (int x = columns.first; x < columns.end; ++x) {
                const double value = layer[row + static_cast<std::size_t>(x)];
                // False for what is no number.
                if (value < bounds.low) bounds.low = value;
                if (value > bounds.high) bounds.high = value;
            }
        }
    return bounds;
}

} // namespace

BlockGrid BlockGrid::of(const BlockPlace& size, int side)
{
    if (side < 1) badValue("blocks of " + std::to_string(side) + " voxels a side");
    BlockGrid grid;
    grid.size = size;
    const int longest = *std::ranges::max_element(size);
    grid.side = std::min(side, std::max(longest, 1));
    double blocks = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (size[axis] < 1) badValue("a volume of " + std::to_string(size[axis]) + " voxels along an axis");
        grid.count[axis] = (size[axis] - 1) / grid.side + 1;
        blocks *= grid.count[axis];
    }
    if (blocks > kMostBlocks)
        badValue(std::to_string(static_cast<unsigned long long>(std::min(blocks, 1e19))) + " blocks, at most " +
                 std::to_string(static_cast<long long>(kMostBlocks)) + " are possible");
    grid.occupied.assign(static_cast<std::size_t>(blocks), 0);
    return grid;
}

std::vector<ValueBounds> blockBounds(const BlockGrid& grid, const VoxelReader& read)
{
    std::vector<ValueBounds> bounds;
    std::vector<double> layer;
    for (int z = 0; z < grid.count[2]; ++z) {
        const Reach slices = reachOf(grid, 2, z);
        const BlockPlace size{grid.size[0], grid.size[1], slices.end - slices.first};
        layer.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                     static_cast<std::size_t>(size[2]));
        read({0, 0, slices.first}, size, layer.data());
        for (int y = 0; y < grid.count[1]; ++y)
            for (int x = 0; x < grid.count[0]; ++x)
                bounds.push_back(boundsIn(layer, size, reachOf(grid, 0, x), reachOf(grid, 1, y)));
    }
    return bounds;
}

std::vector<BlockBox> mergedBoxes(const BlockGrid& grid)
{
    BlockPlace order = kInMemory;
    std::vector<BlockBox> fewest = mergedInOrder(grid, order);
    while (fewest.size() > 1 && std::ranges::next_permutation(order).found) {
        std::vector<BlockBox> boxes = mergedInOrder(grid, order);
        if (boxes.size() < fewest.size()) fewest = std::move(boxes);
    }
    return fewest;
}

std::vector<BlockBox> separateBoxes(const BlockGrid& grid)
{
    std::vector<BlockBox> boxes;
    forBlocks({{0, 0, 0}, grid.count}, kInMemory, [&](const BlockPlace& block) {
        if (grid.occupied[grid.index(block)]) boxes.push_back({block, {block[0] + 1, block[1] + 1, block[2] + 1}});
    });
    return boxes;
}

double voxelCount(const BlockGrid& grid, std::span<const BlockBox> boxes)
{
    double count = 0;
    for (const BlockBox& box : boxes) {
        double voxels = 1;
        for (std::size_t axis = 0; axis < 3; ++axis)
            voxels *= grid.voxel(axis, box.upper[axis]) - grid.voxel(axis, box.lower[axis]);
        count += voxels;
    }
    return count;
}

} // namespace vo
