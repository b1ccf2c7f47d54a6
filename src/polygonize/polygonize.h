#pragma once

#include "core/box.h"
#include "geometry/face_sink.h"
#include "geometry/tetra_view.h"
#include "polygonize/sampling_planes.h"

#include <memory>
#include <span>
#include <vector>

namespace vo {

/// Memory that polygonize keeps from call to call, so that a steady state allocates nothing.
class PolygonizeWorkspace
{
public:
    PolygonizeWorkspace();
    ~PolygonizeWorkspace();
    PolygonizeWorkspace(const PolygonizeWorkspace&) = delete;
    PolygonizeWorkspace& operator=(const PolygonizeWorkspace&) = delete;

    struct Private;
    std::unique_ptr<Private> d;
};

/// Planar convex polygons, 3 or more corners each.
struct FacetList
{
    std::vector<glm::dvec3> corners; ///< of all facets, one after the other
    std::vector<int> counts;         ///< of corners, a facet

    void clear()
    {
        corners.clear();
        counts.clear();
    }
};

struct PolygonizeResult
{
    int samples = 0;      ///< sampling planes used
    double spacing = 0.0; ///< between them, along the view direction
    bool complete = true; ///< false: the sink had no room, the rest is missing
};

/// Slices every tetrahedron with every plane, cuts the slices to the clip boxes by their voxel coordinates,
/// and hands the polygons to `sink` as (box number, plane number). Boxes keep their lower faces and drop
/// their upper ones, except those that bound the union of all boxes. Polygons are convex and run
/// counterclockwise for a viewer in front of them in voxel space; neighbours, across tetrahedra and boxes,
/// share vertices bit for bit. A face that lies in a plane is yielded by its tetrahedron on the viewer's
/// side, on the set's nearest plane by the one behind.
PolygonizeResult polygonize(const TetraView& tetras, std::span<const Box> clipBoxes, const Camera& camera,
                            const SamplingRequest& request, PolygonizeWorkspace& workspace, FaceSink& sink);

/// The same with planes that are given.
PolygonizeResult polygonize(const TetraView& tetras, std::span<const Box> clipBoxes,
                            const PlaneFamily& planes, PolygonizeWorkspace& workspace, FaceSink& sink);

/// Sampling surfaces of any shape.
class FacetSource
{
public:
    virtual ~FacetSource() = default;

    /// Fills `facets` with planar convex polygons, that part of a surface which the box may meet at least.
    /// Neighbours share vertices bit for bit.
    virtual void facetsOf(int surface, const Box& box, FacetList& facets) = 0;
};

/// The same with `count` surfaces that are given, numbered from 0; polygons run round as the facets do.
/// Facets with corners that are not finite, and those without area, are passed over.
PolygonizeResult polygonize(const TetraView& tetras, std::span<const Box> clipBoxes, FacetSource& surfaces,
                            int count, PolygonizeWorkspace& workspace, FaceSink& sink);

} // namespace vo
