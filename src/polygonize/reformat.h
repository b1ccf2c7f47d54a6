#pragma once

#include "core/box.h"
#include "core/record_layout.h"
#include "geometry/face_sink.h"
#include "polygonize/box_cutter.h"
#include "polygonize/slice_tetra.h"

#include <glm/vec4.hpp>

#include <optional>
#include <span>
#include <vector>

namespace vo {

/// Cross-sections: polygons through a volume, cut to its bricks (multi-planar reformatting).
struct ReformatRequest
{
    std::span<const Box> clipBoxes;
    /// Axis across a stack of two-dimensional bricks, one voxel thick each (0, 1, 2), or -1.
    int stackAxis = -1;
    RecordLayout layout;
};

/// A square in the plane dot(plane.xyz, p) + plane.w = 0 that covers all boxes, counterclockwise for a viewer
/// on the positive side. Voxel coordinates are the positions, colours are 1. The normal is not zero.
CutPolygon planeThroughBoxes(const glm::dvec4& plane, std::span<const Box> boxes, const RecordLayout& layout);

/// A planar polygon without crossing edges as convex ones: itself, or triangles between its vertices.
/// Repeated vertices are passed over. Nothing when edges cross.
std::optional<std::vector<CutPolygon>> convexParts(const CutPolygon& polygon);

/// Cuts a convex polygon to the clip boxes and hands the parts to `sink` as (box number, 0); every point of
/// it inside the boxes is yielded once.
///
/// In a stack every point is yielded twice, with colours multiplied by weights that add up to 1: a brick gets
/// the part within one voxel of its slice's middle, weight 1 there and 0 in the middles of the neighbours, so
/// that the sum of both textures is what a three-dimensional texture shows. Before the first middle and
/// beyond the last, one slice has weight 1. The layout has colours then.
///
/// Returns false when the sink had no room.
bool reformat(CutPolygon polygon, const ReformatRequest& request, BoxCutter& cutter, FaceSink& sink);

} // namespace vo
