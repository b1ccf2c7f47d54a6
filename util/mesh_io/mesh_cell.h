#pragma once

#include "geometry/cell_space.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// A cell of a mesh in space. Its coordinates hold what is left of exact zeros after rounding.
inline CellSpace cellSpace(CellKind kind, std::span<const std::int64_t> cell,
                           const std::vector<std::array<double, 3>>& points)
{
    const auto corner = [&](std::size_t i) {
        const auto& [x, y, z] = points[static_cast<std::size_t>(cell[i])];
        return glm::dvec3(x, y, z);
    };
    return CellSpace(kind, corner, std::ldexp(1.0, -44));
}

} // namespace vo
