#pragma once

#include "cast/cast_request.h"
#include "cast/row_spans.h"
#include "cast/shading_plan.h"
#include "cast/voxel_grid.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vo {

constexpr int kTileSide = 64; ///< pixels

/// What samples are taken from: a grid, which several bricks may share, or one brick that makes none.
struct FillSampler
{
    const VoxelGrid* grid = nullptr; ///< nullptr: `texels`, places are those of filteredTexel
    BrickTexels texels;
    const std::uint8_t* blockDistance = nullptr; ///< EmptyBlocks of the grid; nullptr: every sample is taken
    const ShadingPlan* plan = nullptr;           ///< with colours of vertices, as if they were 1
    bool keepsAlpha = false;                     ///< replacing leaves the colour's alpha
};

/// Places of samples are counted in so many parts of a voxel.
constexpr double kPlaceParts = 32768.0;

/// From voxel coordinates to the places of a sampler, in voxels.
struct FillBrick
{
    int sampler = 0;
    glm::dvec3 scale{1.0};
    glm::dvec3 shift{0.0};
    glm::dvec3 lower{0.0}; ///< of places that can be sampled
    glm::dvec3 upper{0.0};
};

/// A number that changes linearly over the window: `value` in the middle of the pixel (x0, y0) of a polygon's
/// box, and its change a pixel.
struct WindowGradient
{
    float value = 0.0f;
    float dx = 0.0f;
    float dy = 0.0f;
};

/// A polygon to fill. With perspective, place and color are those times inverseW.
struct FillPolygon
{
    int sampler = 0;
    PixelBox box;
    std::size_t firstRow = 0; ///< of its spans, one a row of the box
    WindowGradient inverseW;
    float smallestInverseW = 0.0f;
    WindowGradient place[3]; ///< 1 / kPlaceParts voxel
    float lower[3] = {};     ///< bounds of place, inside the polygon and the sampler
    float upper[3] = {};
    WindowGradient depth;
    WindowGradient color[4];
};

/// What becomes of the samples of a frame.
struct FillFrame
{
    CastShading shading;
    CastBlending blending = CastBlending::over;
    bool perspective = false;
    bool vertexColor = false;
    bool opacityPerLength = false;
    bool terminates = false; ///< opacities are 0 to 1
    CastDepth depth;
    int width = 0; ///< of the viewport
    std::span<const FillSampler> samplers;
    /// A table after interpolation for samples of one channel: for each entry red, green, blue, alpha, and
    /// what is added to them on the way to the next; the current colour is worked in. Empty: none, or not
    /// alike for all polygons.
    std::span<const float> entries;

    /// What a channel holds where nothing is drawn.
    float nothing() const;
};

/// The pixels of a tile, kTileSide a row.
struct FillTile
{
    int x = 0; ///< of the left lower pixel in the viewport
    int y = 0;
    std::vector<float> rgba;          ///< empty until something is drawn
    std::vector<float> transmittance; ///< where fragments hide what is behind them
    std::vector<float> units;         ///< lengths that a sample stands for, with opacityPerLength
};

/// What lies behind so little of a pixel's light is left out: a channel changes by no more than that times
/// the largest value that fragments have.
constexpr float kOpaque = 1.0f / 4096.0f;
/// The same where colours count whole, whatever their alpha, and those of a thousand fragments may add up.
constexpr float kOpaqueToWhole = kOpaque / 1024.0f;

/// A polygon and its spans.
struct PolygonRows
{
    const FillPolygon* polygon;
    const RowSpan* rows;
};

/// Blends polygons into a tile, one after the other; where they hide what is behind them, from the nearest to
/// the farthest.
void fillTile(const FillFrame& frame, std::span<const PolygonRows> polygons, FillTile& tile);

} // namespace vo
