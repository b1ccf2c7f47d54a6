#pragma once

#include "cast/clear_values.h"
#include "cast/padded_voxels.h"
#include "style/styled_scene.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// Blocks of PaddedVoxels in which nothing is seen.
class ClearBlocks
{
public:
    /// None.
    ClearBlocks() = default;
    /// Where all values are clear.
    ClearBlocks(const VoxelBlocks& blocks, const ClearValues& clear);
    /// Where none of the chains that are there (SegmentBlocks::chainsIn(); or nothing: all) makes anything
    /// that is seen: `chains` are the clear values of each, at least one.
    ClearBlocks(const VoxelBlocks& blocks, std::span<const ClearValues> chains,
                std::span<const std::uint64_t> chainsIn);
    /// Where no sample but the first of a ray changes a projection: all have the value that is chosen last,
    /// or add nothing.
    ClearBlocks(const VoxelBlocks& blocks, RayProjection::Type type);
    /// Where no value of a surface is crossed.
    ClearBlocks(const VoxelBlocks& blocks, const IsoSurfaces& surfaces);

    bool empty() const { return distance_.empty(); }
    const glm::ivec3& count() const { return count_; }
    /// To the next block that is not clear, in blocks, x fastest: 0 in those. A few bytes more follow.
    const std::vector<std::uint8_t>& distances() const { return distance_; }
    /// Of samples from `cell` on, `step` apart (both in cells of the voxels): how many at least lie in clear
    /// blocks that hang together.
    int leap(const glm::vec3& cell, const glm::vec3& step) const;

private:
    /// isClear(number of a block, least, greatest value in it).
    template <class IsClear>
    void mark(const VoxelBlocks& blocks, const IsClear& isClear);

    glm::ivec3 count_{0};
    std::vector<std::uint8_t> distance_;
};

/// The number of the block that has `cell`.
std::size_t blockAt(const glm::ivec3& blockCount, const glm::vec3& cell);
/// Of samples from `cell` on, `step` apart: how many at least lie in its block and in `distance` - 1 more in
/// every direction.
int samplesInBlocks(const glm::vec3& cell, const glm::vec3& step, int distance);

} // namespace vo
