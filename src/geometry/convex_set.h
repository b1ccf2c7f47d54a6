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

/// The polyhedron; nothing when the tetrahedra leave gaps, overlap, are flat or not finite, meet other than
/// face to face, or their union is not convex or has more than 512 faces. Positions alone count, not vertex
/// numbers; faces may be uneven by as much as rounding to single precision makes them. Sorts the faces of all
/// tetrahedra: microseconds for a few, most of a second for a million, so keep what it says of a large set.
std::optional<ConvexSet> convexSet(const TetraView& tetras);

} // namespace vo
