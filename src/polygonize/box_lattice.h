#pragma once

#include "core/box.h"
#include "polygonize/slice_tetra.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// Clip boxes by the intervals that they span on each axis, so that a polygon is cut once per interval and
/// the boxes on both sides of a seam receive the same vertices. Boxes may repeat, and need not fill the
/// lattice.
class BoxLattice
{
public:
    struct Interval
    {
        double lower;
        double upper;
        int next; ///< the interval that begins where this one ends, or -1
    };
    /// An interval number per axis.
    using Cell = std::array<int, 3>;

    /// Takes other boxes; nothing happens when they are the same as before.
    void assign(std::span<const Box> boxes);

    /// Sorted by lower, then upper end.
    std::span<const Interval> intervals(int axis) const { return intervals_[static_cast<std::size_t>(axis)]; }

    /// The coordinates of all faces across an axis, sorted.
    std::span<const double> faces(int axis) const { return faces_[static_cast<std::size_t>(axis)]; }
    /// Half a unit in the last place of a coordinate of 128 is 4e-6: noise below this moves no voxel, but
    /// would lose a plane that lies in a face.
    static constexpr double kSnapDistance = 1e-5;
    /// Rounding leads a slice's vertices out of its tetrahedron by less than this and the distance at which
    /// faces draw them.
    static constexpr double kMargin = 2 * kSnapDistance;

    struct Entry
    {
        std::uint64_t cell;
        int box;
    };
    /// The boxes of a cell: one, none, or several equal ones.
    std::span<const Entry> boxes(const Cell& cell) const;
    /// Whether what lies in upper faces of a cell, on some axes, lies in a lower face of another box.
    bool belongsToNext(const Cell& cell, const std::array<bool, 3>& inUpperFace) const;

    /// True when intervals of an axis overlap nowhere, so that boxes do so only by being equal.
    bool standApart() const;

    /// Coordinates closer to a face of any box than rounding and single precision can tell take the face's
    /// own.
    void snap(CutPolygon& polygon) const;
    /// A coordinate on an axis, or the face that close to it.
    double snapped(int axis, double coordinate) const;

    /// The interval that a coordinate lies in, farther from any face than coordinates are drawn to faces; or
    /// one of these.
    static constexpr int kNearFace = -1; ///< or where intervals overlap, or between them
    static constexpr int kBelow = -2;    ///< outside of all
    static constexpr int kAbove = -3;
    int intervalAt(int axis, double coordinate) const;

private:
    std::uint64_t number(const Cell& cell) const;
    void findIntervals(int axis);
    void findStarts();
    int intervalOf(int axis, const Box& box) const;

    std::vector<Box> boxes_;
    std::array<bool, 3> overlapping_{};
    std::array<std::vector<Interval>, 3> intervals_;
    std::array<std::vector<double>, 3> faces_; ///< sorted coordinates of all faces across an axis
    std::vector<Entry> entries_;               ///< sorted by cell, then box
    std::vector<std::uint32_t> starts_; ///< the first entry of each cell, and the end; empty: too many cells
};

} // namespace vo
