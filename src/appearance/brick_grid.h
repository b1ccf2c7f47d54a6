#pragma once

#include "core/box.h"
#include "core/volume_size.h"

#include <cstdint>
#include <vector>

namespace vo {

enum class PartialBricks { truncate, augment, augmentTight };

struct BrickExtent
{
    VoxelOrigin origin;
    VoxelSize size;
    friend bool operator==(const BrickExtent&, const BrickExtent&) = default;
};

/// How a volume is cut into bricks (guide, page 29; docs/frames.md). On each axis bricks step by size -
/// overlap; an overlap of the brick's size or more counts as size - 1 there, so that a brick 1 thick has
/// none: truncate has max(1, floor((V-ov)/(B-ov))) of them, the other two ceil((V-ov)/(B-ov)), at least 1;
/// augmentTight shrinks the last to the next power of two that covers what is left. A brick larger than the
/// volume is as large as asked for with augment, the next power of two (at most the size asked for) with
/// augmentTight, and the volume's size with truncate.
struct BrickGridRequest
{
    VoxelSize volume;
    VoxelSize brick;
    int overlap = 0; ///< layers shared by neighbours, at least 0
    PartialBricks partial = PartialBricks::truncate;
};

/// Number of bricks, without making them; saturates at 2^62.
std::int64_t brickCount(const BrickGridRequest& request);
/// The bricks, x fastest, then y, then z. Ask brickCount first: nothing bounds the memory here.
std::vector<BrickExtent> brickGrid(const BrickGridRequest& request);

/// Clip box: [origin + ov/2, origin + size - ov/2], clipped to [ov/2, V - ov/2]. On each axis ov is at most
/// the brick's and the volume's thickness less 1: what is 1 thick is kept whole. Never inverted; boxes of
/// neighbours meet exactly.
Box clipBox(const glm::dvec3& origin, const glm::dvec3& size, const VoxelSize& volume, int overlap);

} // namespace vo
