#include "cast/sight_limits.h"

#include "cast/scene_rays.h"

#include <limits>

namespace vo {

double SightLimits::at(int x, int y) const
{
    constexpr double kFar = std::numeric_limits<double>::infinity();
    if (there_.depths.empty()) return kFar;
    const auto depth = static_cast<double>(
        there_.depths[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)]);
    const double span = there_.farDepth - there_.nearDepth;
    if (span == 0.0) return there_.nearDepth < depth ? kFar : -kFar;
    if (span < 0.0 || depth >= there_.farDepth) return kFar;
    return rays_.depthAt(x + 0.5, y + 0.5, 2.0 * (depth - there_.nearDepth) / span - 1.0);
}

} // namespace vo
