#pragma once

#include <cstdint>

namespace vo {

/// Sizes in voxels, each at least 1.
struct VoxelSize
{
    int x = 1;
    int y = 1;
    int z = 1;

    int operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    /// Number of voxels; never overflows, since each size is below 2^31 and callers bound the product by
    /// memory.
    std::uint64_t count() const
    {
        return static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(z);
    }
    friend bool operator==(const VoxelSize&, const VoxelSize&) = default;
};

/// Position of a voxel's lower corner in the volume.
struct VoxelOrigin
{
    int x = 0;
    int y = 0;
    int z = 0;

    int operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    friend bool operator==(const VoxelOrigin&, const VoxelOrigin&) = default;
};

} // namespace vo
