#pragma once

#include "cast/ray_frame.h"
#include "core/box.h"

#include <array>
#include <optional>
#include <vector>

namespace vo {

/// Samples j of a pixel with base + j * step <= 0, for numbers of the pixel.
struct SampleBound
{
    PixelRamp base;
    PixelRamp step;
};

/// Where the rays through pixels meet sampling planes: sample j, from the nearest (0) to count - 1, at
/// base + j * step in object space, and kept within all bounds.
struct SampleRamps
{
    std::array<PixelRamp, 3> base;
    std::array<PixelRamp, 3> step;
    int count = 0;
    std::vector<SampleBound> bounds;
};

/// The samples of a frame. Nothing where steps do not change evenly over the picture: with shells, and planes
/// seen in perspective that are not parallel to the viewport.
std::optional<SampleRamps> sampleRamps(const RayFrame& frame);

/// The bounds that the faces of a box are: lower x, y, z, then upper x, y, z.
std::array<SampleBound, 6> boxBounds(const SampleRamps& ramps, const Box& box);

} // namespace vo
