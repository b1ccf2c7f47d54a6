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
    /// In up to `threads` threads.
    SegmentBlocks(const PaddedVoxels& voxels, const Segments& segments, int chains, int threads);

    /// True if another one of these would be the same.
    bool isOf(const PaddedVoxels& voxels, const Segments& segments, int chains) const;
    /// Bit i of a block: samples in it may have chain i; the last bit stands for all chains from there on.
    /// Empty where not known: of identifiers that repeat.
    const std::vector<std::uint64_t>& chainsIn() const { return masks_; }

private:
    std::uint64_t maskIn(const PaddedVoxels& voxels, const glm::ivec3& block) const;

    Segments segments_;
    glm::ivec3 blockCount_;
    VoxelSize size_;
    int chains_;
    std::vector<std::uint64_t> masks_;
};

} // namespace vo
