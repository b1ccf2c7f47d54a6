#include "cast/sample_ramps.h"

#include <cmath>

namespace vo {

namespace {

/// Changes of a number over the picture below this part of it are rounding.
constexpr double kRounding = 1e-12;

bool isConstant(const PixelRamp& ramp, const PixelRectangle& pixels)
{
    const double change =
        std::abs(ramp.dx) * std::max(pixels.right, 1) + std::abs(ramp.dy) * std::max(pixels.top, 1);
    return change <= kRounding * std::abs(ramp.at);
}

PixelRamp negative(const PixelRamp& ramp)
{
    return -1.0 * ramp;
}

PixelRamp plus(PixelRamp ramp, double number)
{
    ramp.at += number;
    return ramp;
}

} // namespace

std::optional<SampleRamps> sampleRamps(const RayFrame& frame)
{
    if (frame.shells || !isConstant(frame.along, frame.pixels) || frame.along.at == 0.0) return {};
    // Either the nearest plane is as far from the origins of all rays, or the rays are parallel.
    const bool evenlyFar = isConstant(frame.nearest, frame.pixels);
    if (!evenlyFar && !frame.isParallel()) return {};
    const double perOffset = 1.0 / frame.along.at;
    const auto baseOf = [&](const PixelRamp& origin, const PixelRamp& direction) {
        return origin + (evenlyFar ? perOffset * frame.nearest.at * direction
                                   : perOffset * direction.at * frame.nearest);
    };
    SampleRamps ramps;
    ramps.count = frame.count;
    for (std::size_t i = 0; i < 3; ++i) {
        ramps.base[i] = baseOf(frame.origin[i], frame.direction[i]);
        ramps.step[i] = frame.spacing * perOffset * frame.direction[i];
    }
    for (const RayBound& bound : frame.bounds)
        ramps.bounds.push_back({plus(baseOf(bound.origin, bound.direction), -bound.slack),
                                frame.spacing * perOffset * bound.direction});
    return ramps;
}

std::array<SampleBound, 6> boxBounds(const SampleRamps& ramps, const Box& box)
{
    std::array<SampleBound, 6> bounds;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        bounds[axis] = {negative(plus(ramps.base[axis], -box.lower[i])), negative(ramps.step[axis])};
        bounds[axis + 3] = {plus(ramps.base[axis], -box.upper[i]), ramps.step[axis]};
    }
    return bounds;
}

} // namespace vo
