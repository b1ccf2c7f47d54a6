#include "cast/empty_blocks.h"

#include "core/parallel.h"

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

/// Makes lower bounds of distances out of 0 and others, from the distances between cubes of eight blocks.
void spreadByEights(const glm::ivec3& count, int threads, std::uint8_t* distance)
{
    const glm::ivec3 eights = (count + 1) / 2;
    const auto numberIn = [](const glm::ivec3& size, int x, int y, int z) {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(size.x) *
                   (static_cast<std::size_t>(y) +
                    static_cast<std::size_t>(size.y) * static_cast<std::size_t>(z));
    };
    constexpr int kFarthestEight = EmptyBlocks::kFarthest / 2;
    std::vector<std::uint8_t> coarse(numberIn(eights, 0, 0, eights.z), kFarthestEight);
    const auto rows = [&](std::size_t eightZ, const auto& visit) {
        const int first = 2 * static_cast<int>(eightZ);
        for (int z = first; z < std::min(first + 2, count.z); ++z)
            for (int y = 0; y < count.y; ++y)
                visit(distance + numberIn(count, 0, y, z), coarse.data() + numberIn(eights, 0, y / 2, z / 2));
    };
    parallelFor(static_cast<std::size_t>(eights.z), threads, [&](std::size_t eightZ) {
        rows(eightZ, [&](const std::uint8_t* own, std::uint8_t* eight) {
            for (int x = 0; x < count.x; ++x)
                if (own[x] == 0) eight[x / 2] = 0;
        });
    });
    findBlockDistances(eights, coarse.data());
    parallelFor(static_cast<std::size_t>(eights.z), threads, [&](std::size_t eightZ) {
        rows(eightZ, [&](std::uint8_t* own, const std::uint8_t* eight) {
            for (int x = 0; x < count.x; ++x)
                if (own[x] != 0) own[x] = static_cast<std::uint8_t>(std::max(2 * eight[x / 2] - 1, 1));
        });
    });
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

void findEmptyBlocks(const VoxelGrid& grid, const ShadingPlan& plan, CastBlending blending, int threads,
                     EmptyBlocks& blocks)
{
    const auto channels = static_cast<std::size_t>(grid.view().channels);
    const std::span<const float> ranges = grid.blockRanges();
    const std::size_t count = ranges.size() / (2 * channels);
    const glm::ivec3 size = grid.blockCount();
    const auto slice = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    blocks.distance.assign(count + 4, 0);
    parallelFor(static_cast<std::size_t>(size.z), threads, [&](std::size_t z) {
        for (std::size_t i = z * slice; i < (z + 1) * slice; ++i)
            if (addsNothing(ranges.data() + 2 * channels * i, grid.view().channels, plan, blending,
                            grid.view().rawUnit))
                blocks.distance[i] = EmptyBlocks::kFarthest;
    });
    spreadByEights(size, threads, blocks.distance.data());
}

} // namespace vo
