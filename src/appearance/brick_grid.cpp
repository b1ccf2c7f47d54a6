#include "appearance/brick_grid.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace vo {

namespace {

constexpr std::int64_t kMaxCount = std::int64_t{1} << 62;

/// One axis of a request; `overlap` is what neighbours really share, so that bricks always step on.
struct AxisRequest
{
    std::int64_t volume;
    std::int64_t brick;
    std::int64_t overlap;

    std::int64_t step() const { return brick - overlap; }
};

AxisRequest axisOf(const BrickGridRequest& request, int axis)
{
    assert(request.volume[axis] >= 1 && request.brick[axis] >= 1 && request.overlap >= 0);
    const std::int64_t brick = request.brick[axis];
    return {request.volume[axis], brick, std::min<std::int64_t>(request.overlap, brick - 1)};
}

std::int64_t countOnAxis(const AxisRequest& axis, PartialBricks partial)
{
    const std::int64_t toCover = axis.volume - axis.overlap;
    const std::int64_t rounding = partial == PartialBricks::truncate ? 0 : axis.step() - 1;
    return std::max<std::int64_t>(1, (toCover + rounding) / axis.step());
}

std::int64_t sizeAt(const AxisRequest& axis, PartialBricks partial, std::int64_t origin)
{
    const std::int64_t left = axis.volume - origin;
    if (left >= axis.brick || partial == PartialBricks::augment) return axis.brick;
    if (partial == PartialBricks::truncate) return left;
    const auto covering = std::bit_ceil(static_cast<std::uint64_t>(left));
    return std::min(axis.brick, static_cast<std::int64_t>(covering));
}

struct Span
{
    int origin;
    int size;
};

std::vector<Span> spansOnAxis(const BrickGridRequest& request, int axisNumber)
{
    const AxisRequest axis = axisOf(request, axisNumber);
    const std::int64_t count = countOnAxis(axis, request.partial);
    std::vector<Span> spans;
    spans.reserve(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t origin = i * axis.step();
        spans.push_back({static_cast<int>(origin), static_cast<int>(sizeAt(axis, request.partial, origin))});
    }
    return spans;
}

std::int64_t saturatingProduct(std::int64_t a, std::int64_t b)
{
    return a > kMaxCount / b ? kMaxCount : a * b;
}

} // namespace

std::int64_t brickCount(const BrickGridRequest& request)
{
    std::int64_t count = 1;
    for (int axis = 0; axis < 3; ++axis)
        count = saturatingProduct(count, countOnAxis(axisOf(request, axis), request.partial));
    return count;
}

std::vector<BrickExtent> brickGrid(const BrickGridRequest& request)
{
    const auto xs = spansOnAxis(request, 0);
    const auto ys = spansOnAxis(request, 1);
    const auto zs = spansOnAxis(request, 2);
    std::vector<BrickExtent> bricks;
    bricks.reserve(xs.size() * ys.size() * zs.size());
    for (const Span& z : zs)
        for (const Span& y : ys)
            for (const Span& x : xs)
                bricks.push_back({{x.origin, y.origin, z.origin}, {x.size, y.size, z.size}});
    return bricks;
}

Box clipBox(const glm::dvec3& origin, const glm::dvec3& size, const VoxelSize& volume, int overlap)
{
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const double volumeSize = volume[axis];
        const double thinnest = std::min(size[axis], volumeSize);
        const double half = 0.5 * std::clamp<double>(overlap, 0.0, std::max(0.0, thinnest - 1.0));
        const double lower = half;
        const double upper = volumeSize - half;
        box.lower[axis] = std::clamp(origin[axis] + half, lower, upper);
        box.upper[axis] = std::clamp(origin[axis] + size[axis] - half, box.lower[axis], upper);
    }
    return box;
}

} // namespace vo
