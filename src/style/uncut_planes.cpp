#include "style/uncut_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vo {

namespace {

/// Numbers of files are in single precision: a few of its last digits may be missing of each product.
bool isOn(const glm::dvec4& plane, const glm::dvec4& point)
{
    constexpr double kRounding = 4e-7;
    double sum = 0.0, size = 0.0;
    for (int i = 0; i < 4; ++i) {
        sum += plane[i] * point[i];
        size += std::abs(plane[i] * point[i]);
    }
    return std::abs(sum) <= kRounding * size;
}

} // namespace

std::uint32_t uncutPlanes(const StyledSurface& surface, std::size_t first)
{
    std::uint32_t uncut = 0;
    if (surface.clipPlanes.empty()) return uncut;
    std::array<glm::dvec4, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto vertex = static_cast<std::size_t>(surface.triangles[first + i]);
        corners[i] = surface.worldFromLocal * glm::dvec4(glm::dvec3(surface.positions[vertex]), 1.0);
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(surface.clipPlanes.size(), 32); ++i)
        if (std::ranges::all_of(corners,
                                [&](const auto& corner) { return isOn(surface.clipPlanes[i], corner); }))
            uncut |= 1U << i;
    return uncut;
}

} // namespace vo
