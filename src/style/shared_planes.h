#pragma once

#include "style/styled_scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace vo {

/// A plane in which several faces lie.
struct SharedPlane
{
    glm::dvec4 plane{0.0};                ///< eye space: dot(plane, (p, 1)) = 0
    glm::dvec3 depth{0.0}, weight{0.0};   ///< eye depth: dot(depth, (x, y, 1)) / dot(weight, (x, y, 1))
    double nearest = 0.0, farthest = 0.0; ///< eye depths of these triangles

    /// Eye depth of the plane at normalised device coordinates, no farther off than its triangles.
    double depthAt(double x, double y) const;
};

/// Triangles of several surfaces that lie in one plane but for rounding, and in scenes of no more than
/// kMostWithinSurfaces triangles those of one surface that overlap. Engines take the depths of all their
/// pixels from the plane, so that these are equal where they meet. Nothing is looked for among more than
/// kMostTriangles; of more than kMostPlanes those of the largest triangles count.
class SharedPlanes
{
public:
    static constexpr std::size_t kMostTriangles = 200'000, kMostWithinSurfaces = 2000, kMostPlanes = 1024;

    explicit SharedPlanes(const StyledScene& scene);

    /// Of the triangle whose corners begin at `first` in a surface of the scene, by number; below 0: none.
    int numberOf(std::size_t surface, std::size_t first) const
    {
        return surface < numbers_.size() && !numbers_[surface].empty() ? numbers_[surface][first / 3] : -1;
    }
    /// Whether a surface has triangles in such planes.
    bool anyOf(std::size_t surface) const { return surface < numbers_.size() && !numbers_[surface].empty(); }
    /// Nothing below 0.
    const SharedPlane* find(int number) const
    {
        return number < 0 ? nullptr : &planes_[static_cast<std::size_t>(number)];
    }

private:
    std::vector<SharedPlane> planes_;
    std::vector<std::vector<int>> numbers_; ///< by surface, and triangle; empty where it has none
};

} // namespace vo
