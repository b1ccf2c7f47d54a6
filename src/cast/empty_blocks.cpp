#include "cast/empty_blocks.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
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

/// Up to which byte from each byte on voxels add nothing. Asking a table for each of many blocks takes
/// longer.
class ClearBytes
{
public:
    /// isClear(low, high), as a sampler answers.
    template <typename IsClear>
    explicit ClearBytes(const IsClear& isClear)
    {
        int end = 0; // of the bytes known to be clear from `low` on
        for (int low = 0; low < kBytes; ++low) {
            end = std::max(end, low);
            while (end < kBytes &&
                   isClear(kByteRaw * static_cast<float>(low), kByteRaw * static_cast<float>(end)))
                ++end;
            highest_[static_cast<std::size_t>(low)] = kByteRaw * static_cast<float>(end > low ? end - 1 : -1);
        }
    }

    bool hold(float low, float high) const
    {
        return high <= highest_[static_cast<std::size_t>(static_cast<int>(low * (1 / kByteRaw)))];
    }

private:
    static constexpr int kBytes = 256;
    std::array<float, kBytes> highest_;
};

/// Lowers distances in a row to those of a neighbouring row and one more.
void spread(const std::uint8_t* from, std::uint8_t* to, int count)
{
    const auto lower = [&](int x, std::uint8_t least) {
        to[x] = std::min<std::uint8_t>(to[x], static_cast<std::uint8_t>(least + 1));
    };
    // The ends by themselves: what lies between is without conditions, for vectors.
    for (int x = 1; x < count - 1; ++x)
        lower(x, std::min(std::min(from[x - 1], from[x]), from[x + 1]));
    lower(0, std::min(from[0], from[std::min(1, count - 1)]));
    lower(count - 1, std::min(from[std::max(count - 2, 0)], from[count - 1]));
}

void spreadAlong(std::uint8_t* row, int count)
{
    for (int x = 1; x < count; ++x)
        row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], row[x - 1] + 1));
    for (int x = count - 2; x >= 0; --x)
        row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], row[x + 1] + 1));
}

/// Makes lower bounds of distances out of 0 and kFarthest, from the distances between cubes of eight blocks.
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
    // Of blocks in cubes of eight that are so far apart.
    const auto atLeast = [](std::uint8_t eight) {
        return static_cast<std::uint8_t>(std::max<int>(2 * eight, 2) - 1);
    };
    const int pairs = count.x / 2;
    const auto rows = [&](std::size_t eightZ, const auto& visit) {
        const int first = 2 * static_cast<int>(eightZ);
        for (int z = first; z < std::min(first + 2, count.z); ++z)
            for (int y = 0; y < count.y; ++y)
                visit(distance + numberIn(count, 0, y, z), coarse.data() + numberIn(eights, 0, y / 2, z / 2));
    };
    parallelFor(static_cast<std::size_t>(eights.z), threads, [&](std::size_t eightZ) {
        rows(eightZ, [&](const std::uint8_t* own, std::uint8_t* eight) {
            for (int pair = 0; pair < pairs; ++pair)
                eight[pair] = std::min(eight[pair], std::min(own[2 * pair], own[2 * pair + 1]));
            if (count.x % 2) eight[pairs] = std::min(eight[pairs], own[count.x - 1]);
        });
    });
    findBlockDistances(eights, coarse.data());
    parallelFor(static_cast<std::size_t>(eights.z), threads, [&](std::size_t eightZ) {
        rows(eightZ, [&](std::uint8_t* own, const std::uint8_t* eight) {
            for (int pair = 0; pair < pairs; ++pair) {
                const std::uint8_t least = atLeast(eight[pair]);
                own[2 * pair] = std::min(own[2 * pair], least);
                own[2 * pair + 1] = std::min(own[2 * pair + 1], least);
            }
            if (count.x % 2) own[count.x - 1] = std::min(own[count.x - 1], atLeast(eight[pairs]));
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
    const auto isClear = [&](const float* range) {
        return addsNothing(range, grid.view().channels, plan, blending, grid.view().rawUnit);
    };
    const auto mark = [&](const auto& isEmpty) {
        parallelFor(static_cast<std::size_t>(size.z), threads, [&](std::size_t z) {
            const float* range = ranges.data() + 2 * channels * slice * z;
            std::uint8_t* const distance = blocks.distance.data() + slice * z;
            for (std::size_t i = 0; i < slice; ++i, range += 2 * channels)
                distance[i] = isEmpty(range) ? EmptyBlocks::kFarthest : 0;
        });
    };
    if (grid.view().kind == GridKind::bytes) {
        const ClearBytes clear([&](float low, float high) {
            const float range[] = {low, high};
            return isClear(range);
        });
        mark([&](const float* range) { return clear.hold(range[0], range[1]); });
    } else {
        mark(isClear);
    }
    spreadByEights(size, threads, blocks.distance.data());
}

} // namespace vo
