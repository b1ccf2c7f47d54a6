#include "cast/empty_blocks.h"

#include <algorithm>
#include <cassert>

namespace vo {

namespace {

bool addsNothing(const float* ranges, int channels, const ShadingPlan& plan, CastBlending blending,
                 float unit)
{
    const auto zero = [&](int component) {
        const float* own = ranges + (channels == 4 ? 2 * component : 0);
        return plan.isZero(component, own[0], own[1], unit);
    };
    switch (blending) {
    case CastBlending::over:
    case CastBlending::alphaSum: return zero(3);
    case CastBlending::premultiplied:
    case CastBlending::sum: return zero(0) && zero(1) && zero(2) && zero(3);
    case CastBlending::max:
    case CastBlending::min: break;
    }
    return false;
}

/// Lowers distances in a row to those of a neighbouring row and one more.
void spread(const std::uint8_t* from, std::uint8_t* to, int count)
{
    for (int x = 0; x < count; ++x) {
        const int least = std::min({from[std::max(x - 1, 0)], from[x], from[std::min(x + 1, count - 1)]});
        to[x] = static_cast<std::uint8_t>(std::min<int>(to[x], least + 1));
    }
}

void spreadAlong(std::uint8_t* row, int count)
{
    for (int x = 1; x < count; ++x)
        row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], row[x - 1] + 1));
    for (int x = count - 2; x >= 0; --x)
        row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], row[x + 1] + 1));
}

} // namespace

void findBlockDistances(const glm::ivec3& count, std::uint8_t* distance)
{
    const auto row = [&](int y, int z) {
        return distance + (static_cast<std::size_t>(z) * static_cast<std::size_t>(count.y) +
                           static_cast<std::size_t>(y)) *
                              static_cast<std::size_t>(count.x);
    };
    const auto take = [&](int y, int z, int way) {
        for (const int dy : {-1, 0, 1})
            if (y + dy >= 0 && y + dy < count.y && z + way >= 0 && z + way < count.z)
                spread(row(y + dy, z + way), row(y, z), count.x);
        if (y + way >= 0 && y + way < count.y) spread(row(y + way, z), row(y, z), count.x);
        spreadAlong(row(y, z), count.x);
    };
    // Two passes over all blocks, each taking the half of the neighbours that it has passed.
    for (int z = 0; z < count.z; ++z)
        for (int y = 0; y < count.y; ++y)
            take(y, z, -1);
    for (int z = count.z - 1; z >= 0; --z)
        for (int y = count.y - 1; y >= 0; --y)
            take(y, z, 1);
}

void findEmptyBlocks(const VoxelGrid& grid, const ShadingPlan& plan, CastBlending blending,
                     EmptyBlocks& blocks)
{
    const int channels = grid.view().channels;
    const std::span<const float> ranges = grid.blockRanges();
    const std::size_t count = ranges.size() / static_cast<std::size_t>(2 * channels);
    blocks.distance.assign(count + 4, 0);
    for (std::size_t i = 0; i < count; ++i)
        if (addsNothing(ranges.data() + i * static_cast<std::size_t>(2 * channels), channels, plan, blending,
                        grid.view().rawUnit))
            blocks.distance[i] = EmptyBlocks::kFarthest;
    findBlockDistances(grid.blockCount(), blocks.distance.data());
}

} // namespace vo
