#include "cast/clear_blocks.h"

#include "cast/empty_blocks.h"
#include "cast/segment_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

template <class IsClear>
void ClearBlocks::mark(const VoxelBlocks& blocks, const IsClear& isClear)
{
    count_ = blocks.count;
    distance_.resize(blocks.ranges.size() + 4);
    std::size_t clear = 0;
    for (std::size_t block = 0; block < blocks.ranges.size(); ++block) {
        const auto [low, high] = blocks.ranges[block];
        distance_[block] = isClear(block, low, high) ? EmptyBlocks::kFarthest : 0;
        clear += distance_[block] != 0 ? 1 : 0;
    }
    if (clear == 0)
        distance_.clear();
    else
        findBlockDistances(count_, distance_.data());
}

ClearBlocks::ClearBlocks(const VoxelBlocks& blocks, const ClearValues& clear)
{
    if (!clear.empty())
        mark(blocks, [&](std::size_t, float low, float high) { return clear.hasAll(low, high); });
}

ClearBlocks::ClearBlocks(const VoxelBlocks& blocks, std::span<const ClearValues> chains,
                         std::span<const std::uint64_t> chainsIn)
{
    const std::size_t groups = std::min(chains.size(), SegmentBlocks::kGroups);
    std::vector<ClearValues> clearIn(chains.begin(), chains.begin() + static_cast<std::ptrdiff_t>(groups));
    for (std::size_t chain = groups; chain < chains.size(); ++chain)
        clearIn[chain % groups].keepCommon(chains[chain]);
    mark(blocks, [&](std::size_t block, float low, float high) {
        const std::uint64_t there = chainsIn.empty() ? ~std::uint64_t{0} : chainsIn[block];
        for (std::size_t group = 0; group < groups; ++group)
            if ((there >> group & 1u) != 0 && !clearIn[group].hasAll(low, high)) return false;
        return true;
    });
}

ClearBlocks::ClearBlocks(const VoxelBlocks& blocks, RayProjection::Type type)
{
    float least = std::numeric_limits<float>::infinity(), greatest = -least;
    for (const auto& [low, high] : blocks.ranges) {
        least = std::min(least, low);
        greatest = std::max(greatest, high);
    }
    mark(blocks, [&](std::size_t, float low, float high) {
        switch (type) {
        case RayProjection::Type::max: return high <= least;
        case RayProjection::Type::min: return low >= greatest;
        case RayProjection::Type::average: break;
        }
        return low == 0.0f && high == 0.0f;
    });
}

ClearBlocks::ClearBlocks(const VoxelBlocks& blocks, const IsoSurfaces& surfaces)
{
    mark(blocks, [&](std::size_t, float low, float high) {
        return std::none_of(surfaces.values.begin(), surfaces.values.end(),
                            [&](float value) { return low < value && high >= value; });
    });
}

int ClearBlocks::leap(const glm::vec3& cell, const glm::vec3& step) const
{
    const int distance = distance_[blockAt(count_, cell)];
    return distance == 0 ? 0 : samplesInBlocks(cell, step, distance);
}

std::size_t blockAt(const glm::ivec3& blockCount, const glm::vec3& cell)
{
    const glm::ivec3 block = glm::ivec3(cell) >> PaddedVoxels::kBlockShift;
    return (static_cast<std::size_t>(block.z) * static_cast<std::size_t>(blockCount.y) +
            static_cast<std::size_t>(block.y)) *
               static_cast<std::size_t>(blockCount.x) +
           static_cast<std::size_t>(block.x);
}

int samplesInBlocks(const glm::vec3& cell, const glm::vec3& step, int distance)
{
    constexpr float kEdge = 1 << PaddedVoxels::kBlockShift;
    const glm::ivec3 block = glm::ivec3(cell) >> PaddedVoxels::kBlockShift;
    float samples = 1e6f;
    for (int axis = 0; axis < 3; ++axis) {
        const int end = step[axis] > 0.0f ? block[axis] + distance : block[axis] - distance + 1;
        const float way = static_cast<float>(end) * kEdge - cell[axis];
        if (std::abs(step[axis]) > 1e-9f) samples = std::min(samples, way / step[axis]);
    }
    // A little less: the place after many steps is not exact.
    return std::max(static_cast<int>(samples * 0.9999f), 1);
}

} // namespace vo
