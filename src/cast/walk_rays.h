#pragma once

#include "cast/cast_picture.h"
#include "cast/cast_request.h"
#include "cast/ray_frame.h"
#include "cast/shading_plan.h"
#include "cast/voxel_grid.h"

#include <cstdint>

namespace vo {

/// Rays of less than this transmittance end: what lies behind would change a channel by less.
constexpr float kLeastTransmittance = 1.0f / 2048.0f;

/// Edge of the tiles that pictures are made in, pixels.
constexpr int kTile = 32;

/// All that the rays of one picture share.
struct RayJob
{
    const RayFrame* frame = nullptr;
    GridView grid;
    glm::dvec3 shift{0.0}; ///< grid coordinate less object coordinate
    const ShadingPlan* shading = nullptr;
    CastBlending blending = CastBlending::over;
    const glm::dmat3* gauge = nullptr; ///< CastRequest::opacityGauge, or nullptr
    const CastDepth* depth = nullptr;  ///< nullptr: no depth test
    int viewportWidth = 0;

    glm::ivec3 blockCount{0};
    const std::uint8_t* blockDistance = nullptr; ///< EmptyBlocks; nullptr: every sample is taken
    /// For max and min: no component of a fragment falls as the one channel rises.
    bool extremeOfRaw = false;
    const float* blockRanges = nullptr; ///< then: VoxelGrid::blockRanges, or nullptr
    CastPicture* picture = nullptr;
};

/// Walks the rays of a part of the picture, at most kTile pixels wide and high. The picture has the size and
/// the place of frame->pixels.
void walkRays(const RayJob& job, const PixelRectangle& tile);

} // namespace vo
