#include "core/parallel.h"
#include "style/shadow_grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// Steps from the centre of a texel, each to the next plane of texels along one axis.
struct LightSteps
{
    std::size_t axis = 0, across = 1, up = 2;
    long sign = 1;
    std::array<float, 3> step{}; ///< in texels
    float length = 0.0f;         ///< local, of a step
    float first = 0.0f;          ///< where shadows begin, in steps
    float last = 0.0f;           ///< where the box ends, or the light stands
};

class LightWalk
{
public:
    LightWalk(const ShadowGrid& grid, const StyleLight& light)
        : grid_(grid),
          light_(light), size_{grid.size.x, grid.size.y, grid.size.z}, stride_{1, size_[0],
                                                                               size_[0] * size_[1]}
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            next_[axis] = size_[axis] > 1 ? stride_[axis] : 0;
            highest_[axis] = std::nextafter(static_cast<float>(size_[axis] - 1), 0.0f);
        }
    }

    float throughTo(const std::array<long, 3>& texel) const
    {
        const LightSteps steps = stepsFrom(texel);
        if (!(steps.last > steps.first)) return 1.0f;
        return grid_.hasSurfaces ? throughSurfaces(texel, steps) : throughSamples(texel, steps);
    }

private:
    LightSteps stepsFrom(const std::array<long, 3>& texel) const
    {
        glm::vec3 way = -light_.direction;
        if (light_.kind != StyleLight::Kind::directional)
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                const float position =
                    grid_.box.low[axis] + (static_cast<float>(texel[a]) + 0.5f) * grid_.edges[axis];
                way[axis] = light_.position[axis] - position;
            }
        const glm::vec3 inTexels = way / grid_.edges;
        const glm::vec3 sizes = glm::abs(inTexels);
        LightSteps steps;
        steps.axis = sizes.x >= sizes.y && sizes.x >= sizes.z ? 0 : sizes.y >= sizes.z ? 1 : 2;
        const float most = sizes[static_cast<int>(steps.axis)];
        if (!(most > 0.0f) || !std::isfinite(glm::length(way))) return steps;
        steps.across = steps.axis == 0 ? 1 : 0;
        steps.up = steps.axis == 2 ? 1 : 2;
        steps.sign = inTexels[static_cast<int>(steps.axis)] > 0.0f ? 1 : -1;
        steps.length = glm::length(way) / most;
        steps.first = shadowOffset(grid_, way) / steps.length;
        steps.last =
            light_.kind == StyleLight::Kind::directional ? std::numeric_limits<float>::infinity() : most;
        for (std::size_t a = 0; a < 3; ++a) {
            const float step = inTexels[static_cast<int>(a)] / most;
            const float room = step > 0.0f ? static_cast<float>(size_[a] - texel[a]) - 0.5f
                                           : static_cast<float>(texel[a]) + 0.5f;
            steps.step[a] = step;
            if (step != 0.0f) steps.last = std::min(steps.last, room / std::abs(step));
        }
        return steps;
    }

    /// Where a coordinate lies: the first neighbour's offset, and the second's weight.
    struct Between
    {
        long offset;
        float weight;
    };

    Between betweenAt(std::size_t axis, float coordinate) const
    {
        const float inside = std::max(std::min(coordinate, highest_[axis]), 0.0f);
        const auto low = static_cast<int>(inside);
        return {low * stride_[axis], inside - static_cast<float>(low)};
    }

    /// The grid `number` steps away: linear between four texels of a plane.
    float gridAt(const std::array<long, 3>& texel, const LightSteps& steps, long number) const
    {
        const auto coordinate = [&](std::size_t axis) {
            return static_cast<float>(texel[axis]) + steps.step[axis] * static_cast<float>(number);
        };
        const long plane = std::clamp(texel[steps.axis] + steps.sign * number, 0L, size_[steps.axis] - 1);
        const Between u = betweenAt(steps.across, coordinate(steps.across));
        const Between v = betweenAt(steps.up, coordinate(steps.up));
        const long right = next_[steps.across], above = next_[steps.up];
        const float* const at = grid_.texels.data() + plane * stride_[steps.axis] + u.offset + v.offset;
        const float low = at[0] + (at[right] - at[0]) * u.weight;
        const float high = at[above] + (at[above + right] - at[above]) * u.weight;
        return low + (high - low) * v.weight;
    }

    /// A sample counts for the part of the way to the middles between it and its neighbours.
    float throughSamples(const std::array<long, 3>& texel, const LightSteps& steps) const
    {
        const float most = kMostDepth / steps.length;
        float sum = 0.0f;
        const auto begin = static_cast<long>(std::ceil(steps.first - 0.5f));
        for (long number = begin; static_cast<float>(number) - 0.5f < steps.last && sum < most; ++number) {
            const auto middle = static_cast<float>(number);
            const float part = std::min(middle + 0.5f, steps.last) - std::max(middle - 0.5f, steps.first);
            sum += std::max(part, 0.0f) * gridAt(texel, steps, number);
        }
        return std::exp(-sum * steps.length);
    }

    float throughSurfaces(const std::array<long, 3>& texel, const LightSteps& steps) const
    {
        float through = 1.0f;
        auto number = static_cast<long>(std::ceil(steps.first));
        float before = gridAt(texel, steps, number);
        for (++number; static_cast<float>(number) <= steps.last && through >= kLeastThrough; ++number) {
            const float here = gridAt(texel, steps, number);
            for (const ShadowGrid::Surface& surface : grid_.surfaces)
                if ((before < surface.value && here >= surface.value) ||
                    (before >= surface.value && here < surface.value))
                    through *= surface.through;
            before = here;
        }
        return through;
    }

    const ShadowGrid& grid_;
    const StyleLight& light_;
    std::array<long, 3> size_, stride_, next_{};
    std::array<float, 3> highest_{}; ///< coordinates that have a neighbour above
};

} // namespace

std::vector<std::uint16_t> lightThrough(const ShadowGrid& grid, const StyleLight& light, int threads)
{
    std::vector<std::uint16_t> through(grid.size.count());
    const LightWalk walk(grid, light);
    parallelFor(static_cast<std::size_t>(grid.size.z), threads, [&](std::size_t z) {
        std::size_t to = z * static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y);
        for (long y = 0; y < grid.size.y; ++y)
            for (long x = 0; x < grid.size.x; ++x)
                through[to++] = static_cast<std::uint16_t>(
                    std::lround(65535.0f * walk.throughTo({x, y, static_cast<long>(z)})));
    });
    return through;
}

} // namespace vo
