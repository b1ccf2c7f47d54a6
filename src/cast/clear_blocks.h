#pragma once

#include "cast/clear_values.h"
#include "cast/padded_voxels.h"
#include "style/styled_scene.h"

#include <glm/vec3.hpp>

#include <cstdint>
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
    template <class IsClear>
    void mark(const VoxelBlocks& blocks, const IsClear& isClear);

    glm::ivec3 count_{0};
    std::vector<std::uint8_t> distance_;
};

} // namespace vo
