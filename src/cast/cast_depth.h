#pragma once

#include <span>

namespace vo {

/// Opaque things of the caller's, in window depths (0 to 1).
struct CastDepth
{
    std::span<const float>
        depths;             ///< one a pixel of the viewport, rows from the bottom; empty: no depth test
    bool orEqual = false;   ///< GL_LEQUAL, else GL_LESS
    double nearDepth = 0.0; ///< as glDepthRange
    double farDepth = 1.0;
};

} // namespace vo
