#pragma once

#include "core/box.h"
#include "geometry/tetra_view.h"
#include "polygonize/camera.h"

#include <optional>

namespace vo {

/// spherical: shells round the eye in perspective views (sampling_shells.h), viewportAligned in others.
enum class SamplingMode { viewportAligned, axisAligned, spherical };
enum class SamplingSpace { viewVolume, object, primitive };

/// What the caller asks of the sampling planes.
struct SamplingRequest
{
    SamplingMode mode = SamplingMode::viewportAligned;
    SamplingSpace space = SamplingSpace::object;
    std::optional<glm::dvec3> period; ///< voxels, each above 0; nothing: exactly maxSamples planes
    int maxSamples = 1;               ///< at least 1
    /// Axis across a stack of two-dimensional bricks (0, 1, 2), or -1: then planes are anchored at voxel
    /// centres.
    int stackAxis = -1;
};

/// Parallel planes, numbered from the farthest: plane k holds the points p with
/// dot(normal, p) = first - k * spacing.
struct PlaneFamily
{
    glm::dvec3 normal{0, 0,
                      1}; ///< points away from the viewer; scaled so that offsets are lengths along the view
    double first = 0.0;
    double spacing = 1.0; ///< along the view direction, above 0
    int count = 0;

    double offset(int k) const { return first - k * spacing; }
};

/// Offsets along a view, from the viewer's end; nearest > farthest: empty.
struct DepthRange
{
    double nearest = 0.0;
    double farthest = 0.0;

    bool empty() const { return !(nearest <= farthest); }
};

/// The first plane that has a point with this offset in front; so have those after it. A point on a plane
/// counts as in front, but on planes at `nearest`, the nearest point of the set, and before it as behind: so
/// a face there is yielded by what lies behind.
int firstPlaneInFront(const PlaneFamily& planes, double nearest, double offset);

/// What the planes of one view have in common.
struct SamplingAxis
{
    glm::dvec3 normal{0, 0, 1}; ///< as in PlaneFamily
    int axis = -1;              ///< 0, 1 or 2 for planes across an axis
    bool anchored = false;      ///< to voxel centres along `axis`
    std::optional<double> step; ///< wanted spacing; nothing: exactly maxSamples planes
    DepthRange set;             ///< extent of the tetrahedra's vertices
};

/// Slabs of equal thickness fill the range; a plane in the middle of each.
PlaneFamily centredPlanes(const SamplingAxis& axis, const DepthRange& range, int maxSamples);
/// First plane on the far end, last one on the near end.
PlaneFamily spanningPlanes(const SamplingAxis& axis, const DepthRange& range, int maxSamples);

/// Axis most parallel to the view: 0, 1 or 2. Ties go to the later axis.
int closestAxis(const Camera& camera);

/// Extent of the vertices along a normal.
DepthRange rangeOfSet(const TetraView& tetras, const glm::dvec3& normal);

SamplingAxis samplingAxis(const TetraView& tetras, const Camera& camera, const SamplingRequest& request);

/// The planes for a set of tetrahedra (docs/frames.md). For SamplingSpace::primitive these are the planes of
/// the tetrahedron with the largest extent; primitivePlanes gives each one's own. Vertices that are not
/// finite count as absent. Count 0: no tetrahedra, or a view volume without end.
PlaneFamily samplingPlanes(const TetraView& tetras, const Camera& camera, const SamplingRequest& request);
PlaneFamily samplingPlanes(const TetraView& tetras, const SamplingAxis& axis, const Camera& camera,
                           const SamplingRequest& request);
PlaneFamily primitivePlanes(const TetraView& tetras, int tetra, const Camera& camera,
                            const SamplingRequest& request);
PlaneFamily primitivePlanes(const TetraView& tetras, int tetra, const SamplingAxis& axis,
                            const SamplingRequest& request);

} // namespace vo
