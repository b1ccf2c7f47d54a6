#pragma once

#include <array>
#include <cmath>

#include <vector>

namespace bench {

/// Parallel planes: the points p with dot(normal, p) = depth. `normal` has length 1 and points away from the
/// viewer, depths rise.
struct Planes
{
    std::array<double, 3> normal{};
    std::vector<double> depths;

    double depthOf(const std::array<float, 3>& p) const
    {
        return normal[0] * static_cast<double>(p[0]) + normal[1] * static_cast<double>(p[1]) +
               normal[2] * static_cast<double>(p[2]);
    }
};

/// `count` planes evenly through [0, side]^3, oblique.
inline Planes makePlanes(int count, double side)
{
    Planes planes;
    const double length = std::sqrt(0.5 * 0.5 + 0.33 * 0.33 + 0.8 * 0.8);
    planes.normal = {0.5 / length, 0.33 / length, 0.8 / length};
    const double extent = side * (planes.normal[0] + planes.normal[1] + planes.normal[2]);
    for (int i = 0; i < count; ++i)
        planes.depths.push_back(extent * (i + 0.5) / count);
    return planes;
}

} // namespace bench
