#pragma once

#include "core/box.h"
#include "geometry/face_sink.h"
#include "polygonize/box_lattice.h"
#include "polygonize/slice_tetra.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace vo {

/// Cuts convex polygons to boxes by their voxel coordinates. Boxes keep their lower faces and drop an upper
/// one where another box begins, so that a polygon that lies in a seam is yielded once; on the outer faces of
/// all boxes it is kept. Both sides of a seam get the same vertices, bit for bit. Its memory stays from call
/// to call.
class BoxCutter
{
public:
    /// The boxes to cut to; nothing happens when they are the same as before.
    void assign(std::span<const Box> boxes) { lattice_.assign(boxes); }

    /// Moves the polygon's coordinates onto faces of boxes that are no farther than rounding may lead
    /// (docs/frames.md), cuts it, and hands the parts in single precision to `sink` as (box number,
    /// `sample`). Returns false when the sink had no room.
    bool cut(CutPolygon& polygon, int sample, FaceSink& sink);

private:
    bool cutAlong(int axis, const CutPolygon& polygon);
    bool emitTo(const CutPolygon& polygon);
    std::span<const float> rounded(const CutPolygon& polygon);

    BoxLattice lattice_;
    std::array<CutPolygon, 3> cuts_; ///< what an interval of each axis left
    std::vector<float> face_;

    FaceSink* sink_ = nullptr;
    int sample_ = 0;
    BoxLattice::Cell cell_{};
    std::array<bool, 3> inUpperFace_{};
};

} // namespace vo
