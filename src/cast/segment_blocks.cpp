#include "cast/segment_blocks.h"

#include "core/parallel.h"
#include "style/styled_voxels.h"

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

struct TexelRange
{
    int first, last;
};

/// The texels that are nearest to places in a block, and those beside them, since places are not exact.
TexelRange texelsNear(int block, int voxels, int texels)
{
    constexpr float kEdge = 1 << PaddedVoxels::kBlockShift, kBeside = 0.01f;
    const float scale = static_cast<float>(texels) / static_cast<float>(voxels);
    const float from = static_cast<float>(block) * kEdge + 0.5f - static_cast<float>(PaddedVoxels::kPadding);
    const auto texel = [&](float cell) { return std::clamp(static_cast<int>(cell), 0, texels - 1); };
    return {texel(std::floor(from * scale - kBeside)), texel(std::floor((from + kEdge) * scale + kBeside))};
}

} // namespace

SegmentBlocks::SegmentBlocks(const VoxelBlocks& blocks, const VoxelSize& size, const Segments& segments,
                             int chains, int threads)
    : segments_(segments), blockCount_(blocks.count), size_(size), chains_(chains)
{
    if (segments.identifiers->repeats != std::array{false, false, false}) return;
    masks_.resize(blocks.ranges.size());
    const auto across = static_cast<std::size_t>(blockCount_.x),
               rows = static_cast<std::size_t>(blockCount_.y);
    if (masks_.empty()) return;
    parallelFor(static_cast<std::size_t>(blockCount_.z), threads, [&](std::size_t z) {
        for (std::size_t y = 0; y < rows; ++y)
            for (std::size_t x = 0; x < across; ++x)
                masks_[(z * rows + y) * across + x] = maskIn(glm::ivec3(x, y, z));
    });
}

bool SegmentBlocks::isOf(const VoxelBlocks& blocks, const VoxelSize& size, const Segments& segments,
                         int chains) const
{
    return segments_.identifiers->serial == segments.identifiers->serial &&
           segments_.component == segments.component && segments_.scale == segments.scale &&
           segments_.chainOf == segments.chainOf && segments_.beyond == segments.beyond &&
           chains_ == chains && blockCount_ == blocks.count && size_ == size;
}

std::uint64_t SegmentBlocks::maskIn(const glm::ivec3& block) const
{
    const VoxelSize& size = segments_.identifiers->size;
    TexelRange near[3];
    for (int axis = 0; axis < 3; ++axis)
        near[axis] = texelsNear(block[axis], size_[axis], size[axis]);
    std::uint64_t mask = 0;
    for (int z = near[2].first; z <= near[2].last; ++z)
        for (int y = near[1].first; y <= near[1].last; ++y)
            for (int x = near[0].first; x <= near[0].last; ++x) {
                const std::size_t texel = (static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y) +
                                           static_cast<std::size_t>(y)) *
                                              static_cast<std::size_t>(size.x) +
                                          static_cast<std::size_t>(x);
                const int chain = chainOfTexel(segments_, texel, chains_);
                if (chain >= 0) mask |= std::uint64_t{1} << static_cast<std::size_t>(chain) % kGroups;
            }
    return mask;
}

} // namespace vo
