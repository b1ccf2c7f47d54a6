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
    ClearBlocks(const PaddedVoxels& voxels, const ClearValues& clear);
    /// Where no value of a surface is crossed.
    ClearBlocks(const PaddedVoxels& voxels, const IsoSurfaces& surfaces);

    bool empty() const { return distance_.empty(); }
    /// Of samples from `cell` on, `step` apart (both in cells of the voxels): how many at least lie in clear
    /// blocks that hang together.
    int leap(const glm::vec3& cell, const glm::vec3& step) const;

private:
    template <class IsClear>
    void mark(const PaddedVoxels& voxels, const IsClear& isClear);

    glm::ivec3 count_{0};
    std::vector<std::uint8_t> distance_; ///< to the next block that is not clear, in blocks; 0 in those
};

} // namespace vo
