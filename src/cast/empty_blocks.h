#pragma once

#include "cast/shading_plan.h"
#include "cast/voxel_grid.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vo {

/// How far it is at least from each block of a grid to the next one that may hold something, in blocks along
/// the axis that is farthest: 0 for those that may. At most kFarthest. A few bytes more follow, for reading
/// four at a time.
struct EmptyBlocks
{
    static constexpr int kFarthest = 31;
    std::vector<std::uint8_t> distance;
};

/// Of `count` blocks, x fastest, those that are 0 stay so; others become their distance to the next that is,
/// at most what they are.
void findBlockDistances(const glm::ivec3& count, std::uint8_t* distance);

/// Blocks of which every sample adds exactly nothing in this blending (over, sum, alphaSum). Into memory that
/// is kept; in up to `threads` threads.
void findEmptyBlocks(const VoxelGrid& grid, const ShadingPlan& plan, CastBlending blending, int threads,
                     EmptyBlocks& blocks);

} // namespace vo
