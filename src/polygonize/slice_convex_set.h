#pragma once

#include "core/box.h"
#include "geometry/convex_set.h"
#include "polygonize/box_lattice.h"
#include "polygonize/convex_body.h"
#include "polygonize/polygon_stack.h"
#include "polygonize/sampling_planes.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// Slices a convex polyhedron as one body, for records of bare positions: a polygon for each plane and box
/// where polygonize() makes one for each tetrahedron. Otherwise the same: boxes keep their lower faces,
/// polygons run counterclockwise for the viewer, boxes share vertices bit for bit, and on the set's nearest
/// plane a face of the set counts. Memory stays from call to call.
class ConvexSlicer
{
public:
    /// The boxes stand apart. `bounds` and `nearest`: of the set, as rangeOfSet says. The stack becomes one
    /// run a box, by number, from the farthest plane to the nearest.
    void slice(const ConvexSet& set, const Box& bounds, const PlaneFamily& planes, double nearest,
               const BoxLattice& boxes, PolygonStack& stack);

private:
    struct Level
    {
        ConvexBody rest, spare, part, unused;
    };

    void makeBody(const ConvexSet& set, const Box& bounds);
    void findHeadOn(const Box& bounds);
    void cutAlong(int axis, const ConvexBody& body);
    void measure(const ConvexBody& body, int axis, double coordinate);
    void cutAcross(int axis, const ConvexBody& body);
    bool belongsToNext(int plane) const;
    void sliceInto(int box, const ConvexBody& body);
    void slicePlanes(const ConvexBody& body, int begin, int end);
    std::span<const float> polygonAt(int plane);
    void append(std::span<const float> polygon);

    BodyCutter cutter_;
    std::array<Level, 3> levels_;
    ConvexBody body_, spare_, unused_;
    std::vector<double> distances_;

    const BoxLattice* boxes_ = nullptr;
    PolygonStack* stack_ = nullptr;
    PlaneFamily planes_;
    double nearest_ = 0.0;
    BoxLattice::Cell cell_{};
    int headOn_ = -1;                   ///< the axis that all planes are across, but for rounding
    std::vector<double> planeLevels_;   ///< where on that axis; on a face of a box if rounding may lead there
    std::vector<std::uint8_t> onFace_;  ///< whether it was moved there
    int beginPlane_ = 0, endPlane_ = 0; ///< that are to be cut

    struct Line
    {
        glm::dvec3 from, to;
        double fromOffset, toOffset;
    };
    std::vector<double> offsets_;
    std::vector<int> firstInFront_, changes_;
    std::vector<std::uint8_t> inFront_;
    std::vector<CutBodyEdge> edges_;
    std::vector<Line> lines_;
    std::vector<float> polygon_;
};

} // namespace vo
