#pragma once

#include "geometry/tetra_view.h"

#include <glm/vec4.hpp>

#include <optional>
#include <vector>

namespace vo {

/// A set of tetrahedra that fill a convex polyhedron, each part once.
struct ConvexSet
{
    std::vector<glm::dvec4> planes; ///< unit normals; dot(plane, (p, 1)) <= 0 inside; faces in one plane once
};

/// The polyhedron; nothing when the tetrahedra leave gaps, overlap, are flat or not finite, or their union is
/// not convex. Positions alone count, not vertex numbers.
std::optional<ConvexSet> convexSet(const TetraView& tetras);

} // namespace vo
