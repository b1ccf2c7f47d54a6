#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace vo {

// Where warps take a point. Points are measured from the middle of a box of `size`, in one unit along all
// axes; axes are 0, 1, 2, angles radians.

glm::dvec3 twisted(const glm::dvec3& point, const glm::dvec3& size, int axis, double angle);

/// The axis becomes an arc, its ends towards the upper end of another axis.
glm::dvec3 bent(const glm::dvec3& point, const glm::dvec3& size, int axis, int towards, double angle);

glm::dvec3 tapered(const glm::dvec3& point, const glm::dvec3& size, int axis, double factor);

/// Distances along one axis, directions along another one; swung along the third, or with an elevation of 0
/// as thick as before.
struct Fan
{
    int depthAxis;
    int beamAxis;
    double angle;
    double innerRadius;
    double outerRadius;
    double elevation = 0;
};

/// From the point that distances are measured from.
glm::dvec3 fanned(const glm::dvec3& point, const glm::dvec3& size, const Fan& fan);

/// Vectors in the cells of a grid that spans the box, x fastest.
struct VectorField
{
    std::span<const float> parts; ///< three a vector
    glm::ivec3 cells;
};

/// The vector at a point: trilinear between the middles of cells, beyond the outermost that of the nearest.
glm::dvec3 vectorAt(const glm::dvec3& point, const glm::dvec3& size, const VectorField& field);

} // namespace vo
