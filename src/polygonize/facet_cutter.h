#pragma once

#include "core/box.h"
#include "geometry/tetra_view.h"
#include "polygonize/slice_tetra.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace vo {

/// A tetrahedron made ready to be met by facets: small planar convex polygons of a sampling surface.
class FacetTetra
{
public:
    FacetTetra(const TetraView& tetras, int tetra);

    bool isFlat() const { return flat_; } ///< or not finite: no facet meets it
    const Box& bounds() const { return bounds_; }

    /// Signed distances, in units that differ by face, from the planes of the four faces; those of a face
    /// that two tetrahedra share differ in nothing but the sign, if at all. Above 0, and on some faces 0 too,
    /// is inside.
    std::array<double, 4> distances(const glm::dvec3& point) const;
    bool isInside(int face, double distance) const
    {
        return distance > 0.0 || (distance == 0.0 && faces_[static_cast<std::size_t>(face)].keeps);
    }

private:
    friend class FacetCutter;
    struct Face
    {
        std::array<int, 3> corners; ///< in the order of their records
        glm::dvec3 origin;
        glm::dvec3 normal; ///< the same for both tetrahedra that share the face
        double sign;       ///< of the distance of what lies inside
        bool keeps;        ///< what lies in the face counts as inside
    };

    void makeFace(int opposite);
    glm::dvec3 position(int corner) const;
    const double* record(int corner) const { return records_.data() + corner * values_; }

    int values_;
    int voxelColumn_;
    std::vector<double> records_;
    std::array<Face, 4> faces_; ///< opposite the corner of the same number
    std::array<double, 4> heights_;
    Box bounds_;
    bool flat_ = false;
};

/// A corner of a facet and its distances from a tetrahedron's faces.
struct FacetCorner
{
    glm::dvec3 position;
    std::array<double, 4> distances;
};

/// Cuts facets to tetrahedra, every value interpolated. Facets that share an edge, and tetrahedra that share
/// a face, get the same vertices there: corners of a facet stay what they are, cuts of a facet's edge come
/// from the edge's own ends, cuts of a tetrahedron's edge from that edge's ends. A facet that lies in a
/// shared face is yielded once.
class FacetCutter
{
public:
    /// What of the facet, 3 or more corners in order, lies inside the tetrahedron: in the same order in
    /// `out`, or nothing.
    void cut(const FacetTetra& tetra, std::span<const FacetCorner> facet, CutPolygon& out);

private:
    /// A vertex on the way: where two lines meet, that of the edge before and its own. Lines 0 to 3 are
    /// faces, 4 and above edges of the facet.
    struct Vertex
    {
        int line; ///< of the edge that begins here
        std::array<double, 4> distances;
    };

    void clip(const FacetTetra& tetra, int face);
    void place(const FacetTetra& tetra, std::span<const FacetCorner> facet, int before, int line,
               double* record);
    void onFacetEdge(const FacetTetra& tetra, std::span<const FacetCorner> facet, int edge, int face,
                     double* record);
    void onTetraEdge(const FacetTetra& tetra, std::span<const FacetCorner> facet, int face, int other,
                     double* record);
    static void insideTetra(const FacetTetra& tetra, const FacetCorner& corner, double* record);

    std::vector<Vertex> polygon_, clipped_;
};

} // namespace vo
