#pragma once

#include <vector>

namespace vo {

/// What a frame adds to what is there: the pixels of a rectangle of the viewport, rows from the bottom.
/// over and premultiplied: red, green, blue as they add up, and the part of what is behind that shows through
/// (result = rgb + transmittance * behind); `alpha` is what GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA leaves over
/// an alpha of 0. Others: red, green, blue and alpha of the blended fragments; pixels without any hold what
/// changes nothing (0 for sums, minus infinity for max, infinity for min), and `alpha` is empty.
struct CastPicture
{
    int x = 0; ///< of the left lower pixel in the viewport
    int y = 0;
    int width = 0; ///< 0: nothing is seen
    int height = 0;
    std::vector<float> rgbt;
    std::vector<float> alpha;
};

} // namespace vo
