#include "appearance/transposed_stacks.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace vo {

namespace {

/// Voxels from `lower` to below `upper`; empty where upper <= lower.
struct Region
{
    std::int64_t lower[3];
    std::int64_t upper[3];
};

Region commonRegion(const BrickExtent& a, const BrickExtent& b, const VoxelSize& volume)
{
    Region region;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t aUpper = std::int64_t{a.origin[axis]} + a.size[axis];
        const std::int64_t bUpper = std::int64_t{b.origin[axis]} + b.size[axis];
        region.lower[axis] =
            std::max({std::int64_t{0}, std::int64_t{a.origin[axis]}, std::int64_t{b.origin[axis]}});
        region.upper[axis] = std::min({std::int64_t{volume[axis]}, aUpper, bUpper});
    }
    return region;
}

bool isEmpty(const Region& region)
{
    return region.upper[0] <= region.lower[0] || region.upper[1] <= region.lower[1] ||
           region.upper[2] <= region.lower[2];
}

std::byte* address(const BrickVoxels& brick, std::size_t voxelBytes, std::int64_t x, std::int64_t y,
                   std::int64_t z)
{
    const BrickExtent& e = brick.extent;
    const std::int64_t row = (z - e.origin.z) * e.size.y + (y - e.origin.y);
    return brick.voxels.data() + static_cast<std::size_t>(row * e.size.x + (x - e.origin.x)) * voxelBytes;
}

template <std::size_t Bytes>
void copyColumn(const std::byte* source, std::size_t sourceStep, std::byte* target, std::size_t targetStep,
                std::int64_t count)
{
    for (std::int64_t i = 0; i < count; ++i)
        std::memcpy(target + static_cast<std::size_t>(i) * targetStep,
                    source + static_cast<std::size_t>(i) * sourceStep, Bytes);
}

/// Copies `count` voxels that lie apart. The sizes that formats have are compiled apart: a call of memcpy for
/// each voxel would dominate the making of the YZ stack.
void copyVoxels(const std::byte* source, std::size_t sourceStep, std::byte* target, std::size_t targetStep,
                std::int64_t count, std::size_t voxelBytes)
{
    switch (voxelBytes) {
    case 1: return copyColumn<1>(source, sourceStep, target, targetStep, count);
    case 2: return copyColumn<2>(source, sourceStep, target, targetStep, count);
    case 4: return copyColumn<4>(source, sourceStep, target, targetStep, count);
    case 8: return copyColumn<8>(source, sourceStep, target, targetStep, count);
    case 16: return copyColumn<16>(source, sourceStep, target, targetStep, count);
    default:
        for (std::int64_t i = 0; i < count; ++i, source += sourceStep, target += targetStep)
            std::memcpy(target, source, voxelBytes);
    }
}

void copyRegion(const BrickVoxels& source, const BrickVoxels& target, std::size_t voxelBytes,
                const Region& region)
{
    const std::int64_t columns = region.upper[0] - region.lower[0];
    const std::int64_t rows = region.upper[1] - region.lower[1];
    const auto rowBytes = static_cast<std::size_t>(columns) * voxelBytes;
    const std::size_t sourceStep = static_cast<std::size_t>(source.extent.size.x) * voxelBytes;
    const std::size_t targetStep = static_cast<std::size_t>(target.extent.size.x) * voxelBytes;
    for (std::int64_t z = region.lower[2]; z < region.upper[2]; ++z) {
        const std::byte* from = address(source, voxelBytes, region.lower[0], region.lower[1], z);
        std::byte* to = address(target, voxelBytes, region.lower[0], region.lower[1], z);
        if (columns == 1) {
            copyVoxels(from, sourceStep, to, targetStep, rows, voxelBytes);
            continue;
        }
        for (std::int64_t y = 0; y < rows; ++y)
            std::memcpy(to + static_cast<std::size_t>(y) * targetStep,
                        from + static_cast<std::size_t>(y) * sourceStep, rowBytes);
    }
}

} // namespace

void fillFromBricks(std::span<const BrickVoxels> sources, std::span<const BrickVoxels> targets,
                    std::size_t voxelBytes, const VoxelSize& volume)
{
    for (const BrickVoxels& target : targets)
        std::fill(target.voxels.begin(), target.voxels.end(), std::byte{0});
    // Sources outside: one XY slice stays in the cache while every XZ and YZ slice takes its part of it.
    for (const BrickVoxels& source : sources) {
        if (source.voxels.empty()) continue;
        assert(source.voxels.size() >= source.extent.size.count() * voxelBytes);
        for (const BrickVoxels& target : targets) {
            if (target.voxels.empty()) continue;
            assert(target.voxels.size() >= target.extent.size.count() * voxelBytes);
            const Region region = commonRegion(source.extent, target.extent, volume);
            if (!isEmpty(region)) copyRegion(source, target, voxelBytes, region);
        }
    }
}

} // namespace vo
