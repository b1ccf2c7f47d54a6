#pragma once

#include "cast/cast_depth.h"

#include <cstddef>

namespace vo {

class SceneRays;

/// How far the rays of a picture see before they meet what is there. Everything is borrowed.
class SightLimits
{
public:
    SightLimits(const CastDepth& there, const SceneRays& rays, int width)
        : there_(there), rays_(rays), width_(static_cast<std::size_t>(width))
    {
    }

    /// Of a pixel, in eye space: infinite where nothing is in the way, as everywhere in a depth range that
    /// falls.
    double at(int x, int y) const;

private:
    const CastDepth& there_;
    const SceneRays& rays_;
    std::size_t width_;
};

} // namespace vo
