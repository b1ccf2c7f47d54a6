#pragma once

#include "vout/convex_planes.h"

#include <cstdint>
#include <unordered_map>

namespace vo {

/// Splits tetrahedra into what lies inside of all planes and what does not. Edges that planes cut get one vertex each;
/// every tetrahedron at such an edge is bisected there, in the order of those vertices' numbers, which decides how its
/// faces are split: all that share a face split it alike.
class CutMesh
{
public:
    explicit CutMesh(const TetraMesh& mesh);

    /// Moves what lies outside of the plane out of what was inside so far.
    void cut(const CutPlane& plane);

    /// Records rounded to floats, vertices in use alone, tetrahedra of positive volume alone.
    TetraMesh inside() const { return rounded(inner_); }
    TetraMesh outside() const { return rounded(outer_); }

private:
    glm::dvec3 position(int vertex) const;
    int side(int vertex);
    int middleOf(int a, int b, bool mayMake);
    void bisect(const Tetra& tetra, std::vector<Tetra>& pieces);
    void sortOut(const std::vector<Tetra>& pieces, std::vector<Tetra>& stillInner);
    TetraMesh rounded(const std::vector<Tetra>& tetras) const;

    int values_;
    double snap_;
    std::vector<double> records_;
    std::vector<Tetra> inner_, outer_;

    // Of the present plane.
    CutPlane plane_{};
    int pass_ = 0;
    std::vector<int> passOf_;      ///< the pass in which the two below were found, by vertex
    std::vector<double> distance_; ///< 0 for what the plane goes through
    std::unordered_map<std::uint64_t, int> middles_; ///< by edge
};

} // namespace vo
