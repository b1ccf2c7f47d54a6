#pragma once

#include "style/sample_batch.h"
#include "style/voxel_texture.h"

#include <array>
#include <cstddef>

namespace vo {

/// Numbers of PaddedVoxels as they lie in memory. Borrowed.
struct PaddedGrid
{
    /// Voxels on each side that say what is outside.
    static constexpr int kPadding = 2;

    const std::byte* numbers = nullptr; ///< x fastest, the padding's first
    TexelKind kind = TexelKind::uint8;
    VoxelSize size; ///< without padding
    bool nearest = false;
    std::array<bool, 3> repeats{};
    float unit = 1.0f; ///< of a stored number
    std::ptrdiff_t row = 0, slice = 0;
    bool far = false; ///< more bytes than 31 bits count
};

/// PaddedVoxels::values() and changes(), by vectors. May write all of the batch.
void sampleValues(const PaddedGrid& grid, int count, const BatchVectors& place, BatchFloats& value);
void sampleChanges(const PaddedGrid& grid, int count, const BatchVectors& place, BatchVectors& change);

} // namespace vo
