#pragma once

#include "cast/padded_voxels.h"
#include "style/styled_scene.h"

#include <cstdint>
#include <vector>

namespace vo {

/// Which chains the segments in blocks of PaddedVoxels have.
class SegmentBlocks
{
public:
    /// `blocks` are those of voxels of this size. In up to `threads` threads.
    SegmentBlocks(const VoxelBlocks& blocks, const VoxelSize& size, const Segments& segments, int chains,
                  int threads);

    /// True if another one of these would be the same.
    bool isOf(const VoxelBlocks& blocks, const VoxelSize& size, const Segments& segments, int chains) const;
    /// There are as many groups of chains as masks have bits: chain c is in group c % kGroups.
    static constexpr std::size_t kGroups = 64;

    /// Bit i of a block: samples in it may have a chain of group i.
    /// Empty where not known: of identifiers that repeat.
    const std::vector<std::uint64_t>& chainsIn() const { return masks_; }

private:
    std::uint64_t maskIn(const glm::ivec3& block) const;

    Segments segments_;
    glm::ivec3 blockCount_;
    VoxelSize size_;
    int chains_;
    std::vector<std::uint64_t> masks_;
};

} // namespace vo
