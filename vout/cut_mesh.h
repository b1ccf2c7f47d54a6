#pragma once

#include "vout/convex_planes.h"

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>

namespace vo {

/// Splits tetrahedra into what lies inside of all planes and what does not. In between they are convex cells
/// whose faces are polygons that two neighbours share: a plane splits a face once, for both, and an edge by one
/// vertex, for all. Only cells that are inside so far are split; what lies at their edges gets the new vertices.
/// In the end each face is cut into triangles, again for both, and each cell into tetrahedra on them.
class CutMesh
{
public:
    explicit CutMesh(const TetraMesh& mesh);

    /// Moves what lies outside of the plane out of what was inside so far.
    void cut(const CutPlane& plane);

    /// Records rounded to floats, vertices in use alone, tetrahedra of positive volume alone.
    TetraMesh inside() const { return tetrasOf(inner_); }
    TetraMesh outside() const { return tetrasOf(outer_); }

private:
    /// A convex polygon; vertices may lie on its edges. Once it is split, its parts stand for it.
    struct Face
    {
        std::vector<int> loop;
        int parts[2] = {-1, -1};
    };
    /// A face of a cell; `outward`: counter-clockwise as seen from outside.
    struct CellSide
    {
        int face;
        bool outward;
    };
    using Cell = std::vector<CellSide>;

    glm::dvec3 position(int vertex) const;
    int side(int vertex);
    int middleOf(int a, int b, bool mayMake);
    void insertMiddles(Face& face);
    void splitFace(int face);
    void resolve(Cell& cell) const;
    bool splitCell(const Cell& cell, Cell& positive, Cell& negative);
    double middleDistance(const Cell& cell) const;
    void splitFaces();
    TetraMesh tetrasOf(const std::vector<Cell>& cells) const;

    int values_;
    double snap_;
    std::vector<double> records_;
    std::vector<Face> faces_;
    std::vector<Cell> inner_, outer_;

    // Of the present plane.
    CutPlane plane_{};
    int pass_ = 0;
    std::vector<int> passOf_;      ///< the pass in which the next was found, by vertex
    std::vector<double> distance_; ///< 0 for what the plane goes through
    std::unordered_map<std::uint64_t, int> middles_; ///< by edge
};

} // namespace vo
