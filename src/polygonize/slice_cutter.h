#pragma once

#include "polygonize/box_lattice.h"
#include "polygonize/cut_sections.h"
#include "polygonize/sampling_planes.h"

#include <array>
#include <cstddef>
#include <span>

namespace vo {

/// A tetrahedron that boxes may cut. Its corners go by position, from the least; no value is -0.
template <int kValues>
struct TetraInBoxes
{
    std::array<std::array<double, kValues>, 4> corners; ///< records, the position last
    std::size_t voxelColumn;                            ///< where the coordinates begin that boxes speak of
    std::array<double, 4> offsets;                      ///< along the planes' normal
    std::array<int, 4> firstInFront;                    ///< the first plane that has the corner in front
    bool mirrored;                                      ///< the corners are negatively oriented
    /// Of each axis: the interval that holds all corners far from its ends, or a negative number.
    std::array<int, 3> interval;
};

/// What sliceTetra and BoxCutter make of records of kValues, bit for bit, without memory of its own: axes and
/// boxes that are far from the tetrahedron are not looked at. Vertices may fall together. For 3, 6, 7, 9 and
/// 10 values.
template <int kValues>
class SliceCutter
{
public:
    explicit SliceCutter(const BoxLattice& lattice) : lattice_(lattice) {}

    /// Slices a tetrahedron with all planes that meet it, from `begin` on, and appends the parts in boxes.
    void cut(const TetraInBoxes<kValues>& tetra, const PlaneFamily& planes, int begin, CutSections& sections);

private:
    /// Each axis leaves at most three vertices of one.
    static constexpr std::size_t kMostVertices = 108;
    using Record = std::array<double, kValues>;
    struct Polygon
    {
        std::size_t count = 0;
        std::array<Record, kMostVertices> at;

        void push(const Record& record);
        void close();
    };
    /// What of the lattice is near the tetrahedron on an axis.
    struct Near
    {
        bool cuts;
        std::span<const double> faces;
        int firstInterval, endInterval;
        double low, high; ///< of the corners
    };

    void findNear(const TetraInBoxes<kValues>& tetra, int axis);
    bool describeNear(BoxesNearby& boxes) const;
    bool describeBoxes(BoxesNearby& boxes) const;
    void clip(const Polygon& polygon, std::size_t axis, double lower, double upper, Polygon& out) const;
    void meet(const Record& from, const Record& to, std::size_t column, double plane, Polygon& out) const;
    void slice(const TetraInBoxes<kValues>& tetra, double offset, unsigned mask);
    double snapped(const Near& near, double coordinate) const;
    void cutAlong(std::size_t axis, const Polygon& polygon);
    void emitTo(const Polygon& polygon);

    const BoxLattice& lattice_;
    std::array<Near, 3> near_;
    std::array<Polygon, 4> polygons_; ///< the slice, and what an interval of each axis left of it
    std::array<float, kValues * kMostVertices> face_;

    CutSections* sections_ = nullptr;
    std::size_t voxelColumn_ = 0;
    int sample_ = 0;
    BoxLattice::Cell cell_{};
    std::array<bool, 3> inUpperFace_{};
};

} // namespace vo
