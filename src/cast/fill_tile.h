#pragma once

#include "cast/cast_request.h"
#include "cast/row_spans.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vo {

constexpr int kTileSide = 64; ///< pixels

/// How the texels of a brick lie in memory: one channel of bytes, shorts or floats as the caller holds them,
/// or any other, which filteredTexel reads.
enum class TexelStorage { byte1, short1, float1, any };

/// A brick ready to be sampled.
struct FillBrick
{
    TexelStorage storage = TexelStorage::any;
    BrickTexels texels;
    bool oneChannel = false; ///< red stands for all
    bool hasAlpha = true;
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
    int brick = 0;
    PixelBox box;
    std::size_t firstRow = 0; ///< of its spans, one a row of the box
    WindowGradient inverseW;
    float smallestInverseW = 0.0f;
    WindowGradient place[3]; ///< texels from the middle of the brick's first
    float lower[3] = {};     ///< bounds of place, inside the polygon and the brick
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
    int width = 0;
    int height = 0;
    std::span<const FillBrick> bricks;

    /// What a channel holds where nothing is drawn.
    float nothing() const;
};

/// The pixels of a tile, kTileSide a row.
struct FillTile
{
    int x = 0; ///< of the left lower pixel in the viewport
    int y = 0;
    std::vector<float> rgba;          ///< empty until something is drawn
    std::vector<float> transmittance; ///< over only
    std::vector<float> units;         ///< lengths that a sample stands for, with opacityPerLength
};

/// What was drawn behind that much or less of a pixel's light is left out; no channel changes by more, times
/// the largest value that fragments have.
constexpr float kOpaque = 1.0f / 4096.0f;

/// A polygon and its spans.
struct PolygonRows
{
    const FillPolygon* polygon;
    const RowSpan* rows;
};

/// Blends polygons into a tile, one after the other; for CastBlending::over from the nearest to the farthest.
void fillTile(const FillFrame& frame, std::span<const PolygonRows> polygons, FillTile& tile);

} // namespace vo
