#pragma once

#include "core/box.h"
#include "geometry/tetra_view.h"
#include "polygonize/camera.h"
#include "polygonize/polygon_stack.h"
#include "polygonize/polygonize.h"
#include "polygonize/sampling_planes.h"

#include <memory>
#include <span>

namespace vo {

/// In which order the runs of a stack lie.
enum class StackOrder {
    byBrick, ///< one run a brick, by number, in each from the farthest plane to the nearest
    bySample ///< a brick and a plane each, the farthest plane first
};

/// The polygons of polygonize(), all planes in one pass over the tetrahedra, in parallel where there are
/// many. The vertices are those of polygonize() bit for bit, for any number of threads; polygons may have
/// vertices that fall together, and so triangles without area. Planes only: spherical sampling of a
/// perspective view is polygonize()'s. Memory stays from call to call.
class StackSlicer
{
public:
    StackSlicer();
    ~StackSlicer();
    StackSlicer(const StackSlicer&) = delete;
    StackSlicer& operator=(const StackSlicer&) = delete;

    /// `threads`: at most so many; 0: as many as the machine has. The result is not complete, and the stack
    /// empty, when record numbers of 32 bits do not suffice.
    PolygonizeResult slice(const TetraView& tetras, std::span<const Box> clipBoxes, const Camera& camera,
                           const SamplingRequest& request, StackOrder order, int threads,
                           PolygonStack& stack);
    /// The same with planes that are given.
    PolygonizeResult slice(const TetraView& tetras, std::span<const Box> clipBoxes, const PlaneFamily& planes,
                           StackOrder order, int threads, PolygonStack& stack);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace vo
