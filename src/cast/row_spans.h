#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelBox
{
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    bool empty() const { return x0 >= x1 || y0 >= y1; }
};

/// A vertex in the window, x from the left and y from the bottom, in 1/256 pixel; at most 2^20 pixels away
/// from 0.
struct SnappedVertex
{
    std::int32_t x;
    std::int32_t y;
};

constexpr int kSubpixels = 256;

/// Pixels left <= x < right of a row.
struct RowSpan
{
    std::int16_t left;
    std::int16_t right;
};

/// Appends the pixels of a width * height window (up to 32767 each) whose centres lie in a polygon, a span
/// for each row of the box that comes back, and returns that box. A centre on an edge belongs to the polygon
/// to the edge's right or, where the edge is level, above it, so that neighbours share none and miss none.
/// What a self-crossing polygon winds round twice is outside. Where a row has several spans, further layers
/// of spans follow the first, each for all rows of the box; `layers` is their number.
PixelBox appendRowSpans(std::span<const SnappedVertex> polygon, int width, int height,
                        std::vector<RowSpan>& rows, int& layers);

} // namespace vo
