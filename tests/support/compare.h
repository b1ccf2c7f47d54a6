#pragma once

#include "support/reference.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vo::test {

/// How far two pictures are apart in red, green and blue (premultiplied over black, peak 1). `all` reads
/// every pixel, `masked` leaves out those within 1/200 pixel of the edge of a slice.
struct Comparison
{
    double psnrMasked =
        0.0; ///< decibels, over pixels of opacity above 1/255; infinite when equal, NaN when there are none
    double psnrAll = 0.0;
    double largestMasked = 0.0; ///< difference of one channel, over every pixel
    double largestAll = 0.0;
    double fractionOff = 0.0;     ///< of all pixels: those with a channel off by more than 1/255
    std::size_t opaquePixels = 0; ///< of opacity above 1/255
    std::size_t maskedPixels = 0; ///< left out of `masked`

    /// One line.
    std::string summary() const;
};

/// `picture`: four floats a pixel, rows from the bottom, as glReadPixels gives them; its alpha is not read.
Comparison compare(std::span<const float> picture, const Picture& reference);
/// Two drawn pictures of one size; counts pixels where the second has a channel above 1/255, masks none.
Comparison compareDrawn(std::span<const float> picture, std::span<const float> other);

/// What a target of 8 bits a channel holds, as floats.
std::vector<float> fromBytes(std::span<const std::uint8_t> rgba);

} // namespace vo::test
