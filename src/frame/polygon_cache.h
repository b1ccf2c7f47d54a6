#pragma once

#include "core/box.h"
#include "geometry/convex_set.h"
#include "geometry/kept_tetras.h"
#include "geometry/tetra_view.h"
#include "polygonize/box_lattice.h"
#include "polygonize/camera.h"
#include "polygonize/polygon_stack.h"
#include "polygonize/polygonize.h"
#include "polygonize/sampling_planes.h"
#include "polygonize/slice_convex_set.h"
#include "polygonize/slice_stack.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vo {

/// What the polygons of a frame depend on.
struct PolygonRequest
{
    TetraView tetras;
    std::span<const Box> clipBoxes;
    Camera camera;
    SamplingRequest sampling;
};

/// The polygons of a frame as triangles, in runs that lie in one brick each. Kept from frame to frame while
/// what they depend on stays the same. Bare positions that fill a convex polyhedron are sliced as one body,
/// so that a plane has one polygon in a brick.
class PolygonCache
{
public:
    /// Makes the polygons anew unless the request is the last one again; its camera may have turned by up to
    /// `threshold` degrees, and the eye of spherical sampling moved as far as that many degrees seen from the
    /// middle of the tetrahedra. Returns true when they were made anew.
    bool update(const PolygonRequest& request, double threshold);
    void invalidate() { valid_ = false; }

    std::span<const float> records() const { return stack_.records.all(); }
    std::span<const std::uint32_t> indices() const { return stack_.indices.all(); }

    using Run = PolygonStack::Run;
    /// Usually one run a brick, by number, in each from the farthest sample to the nearest: bricks are boxes,
    /// and drawn in an order of boxes.
    std::span<const Run> runs() const { return stack_.runs; }
    /// True when bricks have no order, since voxel coordinates that differ from positions put them anywhere:
    /// then runs are a brick and a sample each, farthest first, to be drawn as they come.
    bool bricksInterleave() const { return bricksInterleave_; }
    int samples() const { return samples_; }
    /// Of the polygons as they are; others have another.
    std::uint64_t serial() const { return serial_; }
    /// For which the polygons were made; the view may have turned since.
    const Camera& camera() const { return keyCamera_; }

private:
    struct Polygon
    {
        int brick;
        int sample;
        std::uint32_t first;
        std::uint32_t count;
    };
    class Collector;

    bool isCurrent(const PolygonRequest& request, double threshold) const;
    void remember(const PolygonRequest& request);
    void cutShells(const PolygonRequest& request);
    bool sliceAsOneBody(const PolygonRequest& request);
    const std::optional<ConvexSet>& body(const TetraView& tetras);
    void sortIntoBins(std::size_t brickCount, int samples);

    bool valid_ = false;
    std::uint64_t serial_ = 0;
    KeptTetras keyTetras_;
    std::vector<Box> keyBoxes_;
    Camera keyCamera_;
    SamplingRequest keySampling_;

    int framesOfTetras_ = 0;        ///< for which polygons were made of the same tetrahedra
    bool bodySought_ = false;       ///< among them
    std::optional<ConvexSet> body_; ///< that they fill
    BoxLattice boxes_;
    ConvexSlicer convexSlicer_;
    StackSlicer slicer_;

    PolygonizeWorkspace workspace_;
    PolygonStack stack_;
    std::vector<Polygon> polygons_;
    std::vector<std::uint32_t> order_;
    std::vector<std::size_t> binStarts_;
    bool bricksInterleave_ = false;
    int samples_ = 0;
};

} // namespace vo
