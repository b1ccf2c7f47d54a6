#pragma once

#include "geometry/tetra_view.h"
#include "polygonize/camera.h"
#include "polygonize/sampling_planes.h"

#include <glm/mat3x3.hpp>

#include <vector>

namespace vo {

/// Concentric shells round the eye, numbered from the farthest. Shell k holds the points p with
/// length((p - eye) / scale) = radius(k): with the sampling period as scale every ray from the eye meets the
/// shells at the distances that samples along its own direction are to have.
struct ShellFamily
{
    glm::dvec3 eye{0.0};
    glm::dvec3 scale{1.0};
    /// Orthonormal, in the scaled space: towards the set's middle, aside, and to the pole of the
    /// tessellation.
    glm::dmat3 frame{1.0};
    double first = 0.0;
    double spacing = 1.0; ///< above 0
    int count = 0;

    double radius(int k) const { return first - k * spacing; }
};

/// The largest distance between a shell and its facets, along a ray, in spacings.
constexpr double kChordError = 0.02;

/// The shells for a set of tetrahedra seen in a perspective view (docs/frames.md). For
/// SamplingSpace::primitive their number and place are those of the deepest tetrahedron; primitiveShells
/// gives each one's own.
ShellFamily samplingShells(const TetraView& tetras, const Camera& camera, const SamplingRequest& request);
ShellFamily primitiveShells(const ShellFamily& set, const DepthRange& range, const SamplingRequest& request);

/// Distances from the eye, in the scaled space, of a tetrahedron: 0 to the farthest vertex when the eye is
/// inside. Empty for one with vertices that are not finite.
DepthRange shellRange(const TetraView& tetras, int tetra, const ShellFamily& shells);

/// One shell as planar quadrilaterals (triangles at the poles) between circles of latitude and meridians.
/// Vertices lie as far outside the shell as the middles of the largest facets lie inside.
class ShellGrid
{
public:
    /// Shell `k` of a family.
    void assign(const ShellFamily& shells, int k);

    int rings() const { return rings_; }
    int sectors() const { return sectors_; } ///< of a ring

    /// Facets from ring firstRing to lastRing, from sector firstSector to lastSector, both inclusive. Sectors
    /// go on counting past a full turn.
    struct Range
    {
        int firstRing, lastRing;
        int firstSector, lastSector;
    };
    /// The facets that a cone of directions round `axis` (unit, scaled space) may meet.
    Range facetsInCone(const glm::dvec3& axis, double halfAngle) const;
    Range allFacets() const { return {0, rings_ - 1, 0, sectors_ - 1}; }

    /// Makes ready the vertices round a range of facets: rings firstRing to lastRing + 1, sectors likewise.
    void select(const Range& range);
    /// A vertex of the range; the same bits for the same vertex of the shell, whatever the range.
    glm::dvec3 vertex(int ring, int sector) const;

private:
    ShellFamily shells_;
    double radius_ = 0.0; ///< of the vertices
    int rings_ = 0;
    int sectors_ = 0;
    Range range_{};
    struct Turn
    {
        double cosine, sine;
    };
    std::vector<Turn> latitudes_, longitudes_; ///< of the range
};

} // namespace vo
