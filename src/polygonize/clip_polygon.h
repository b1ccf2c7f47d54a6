#pragma once

#include "core/box.h"
#include "polygonize/slice_tetra.h"

#include <glm/vec4.hpp>

#include <span>

namespace vo {

/// What is left of a convex polygon inside lower <= voxel[axis] <= upper. Both planes cut the edges of
/// `polygon` itself. Fewer than 3 distinct vertices: `out` is empty.
void clipToSlab(const CutPolygon& polygon, int axis, double lower, double upper, CutPolygon& out);

/// What is left inside a box, faces included; axes in the order x, y, z. `scratch` and `out` differ from
/// `polygon`.
void clipToBox(const CutPolygon& polygon, const Box& box, CutPolygon& scratch, CutPolygon& out);

/// What is left where dot(plane.xyz, p) + plane.w >= 0.
void clipToHalfSpace(const CutPolygon& polygon, const glm::dvec4& plane, CutPolygon& out);

} // namespace vo
