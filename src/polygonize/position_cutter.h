#pragma once

#include "geometry/face_sink.h"
#include "polygonize/box_lattice.h"
#include "polygonize/sampling_planes.h"

#include <array>
#include <cstddef>
#include <span>

namespace vo {

/// A tetrahedron of bare positions that boxes may cut. Corners go by position from the least; none is -0.
struct TetraInBoxes
{
    std::array<std::array<double, 3>, 4> corners;
    std::array<double, 4> offsets;   ///< along the planes' normal
    std::array<int, 4> firstInFront; ///< the first plane that has the corner in front
    bool mirrored;                   ///< the corners are negatively oriented
    /// Of each axis: the interval that holds all corners far from its ends, or a negative number.
    std::array<int, 3> interval;
};

/// What sliceTetra and BoxCutter make of bare positions, bit for bit, without memory of its own: axes and
/// boxes that are far from the tetrahedron are not looked at.
class PositionCutter
{
public:
    explicit PositionCutter(const BoxLattice& lattice) : lattice_(lattice) {}

    /// Slices a tetrahedron with all planes that meet it and hands the parts in boxes to `sink`. Returns
    /// false when the sink had no room.
    bool cut(const TetraInBoxes& tetra, const PlaneFamily& planes, FaceSink& sink);

private:
    /// Each axis leaves at most three vertices of one.
    static constexpr std::size_t kMostVertices = 108;
    struct Polygon
    {
        std::size_t count = 0;
        std::array<std::array<double, 3>, kMostVertices> at;

        void push(const std::array<double, 3>& point) { at[count++] = point; }
    };
    /// What of the lattice is near the tetrahedron on an axis.
    struct Near
    {
        bool cuts;
        std::span<const double> faces;
        int firstInterval, endInterval;
    };

    void findNear(const TetraInBoxes& tetra, int axis);
    void slice(const TetraInBoxes& tetra, double offset, unsigned mask);
    double snapped(const Near& near, double coordinate) const;
    bool cutAlong(std::size_t axis, const Polygon& polygon);
    bool emitTo(const Polygon& polygon);

    const BoxLattice& lattice_;
    std::array<Near, 3> near_;
    std::array<Polygon, 4> polygons_; ///< the slice, and what an interval of each axis left of it
    std::array<float, 3 * kMostVertices> face_;

    FaceSink* sink_ = nullptr;
    int sample_ = 0;
    BoxLattice::Cell cell_{};
    std::array<bool, 3> inUpperFace_{};
};

} // namespace vo
