#include "cast/picture_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// Pixels whose middle a range of the picture has, from `first` on among `count`.
void pixelsIn(double low, double high, int& first, int& count)
{
    // Rounding may have moved the range, and pixels look a little past their middle (edgeShift()).
    constexpr double kMargin = 4e-3;
    const double before = first - 1.0, after = static_cast<double>(first) + count;
    const auto begin = static_cast<int>(std::clamp(std::ceil(low - kMargin - 0.5), before + 1.0, after));
    const auto last = static_cast<int>(std::clamp(std::floor(high + kMargin - 0.5), before, after - 1.0));
    first = begin;
    count = std::max(last - begin + 1, 0);
}

} // namespace

PictureTile pixelsOf(std::span<const glm::dvec3> points, const PictureTile& tile)
{
    constexpr double kLeastW = 1e-9;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    double left = kFar, right = -kFar, bottom = kFar, top = -kFar;
    for (const glm::dvec3& point : points) {
        if (!(point.z > kLeastW)) return tile;
        left = std::min(left, point.x / point.z);
        right = std::max(right, point.x / point.z);
        bottom = std::min(bottom, point.y / point.z);
        top = std::max(top, point.y / point.z);
    }
    PictureTile pixels = tile;
    pixelsIn(left, right, pixels.x, pixels.width);
    pixelsIn(bottom, top, pixels.y, pixels.height);
    return pixels;
}

PictureTile TileGrid::tile(std::size_t number) const
{
    const int x = static_cast<int>(number % across()) * edge_,
              y = static_cast<int>(number / across()) * edge_;
    return {x, y, std::min(edge_, width_ - x), std::min(edge_, height_ - y)};
}

} // namespace vo
