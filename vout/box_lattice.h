#pragma once

#include "vout/split_cells.h"

#include <glm/vec3.hpp>

#include <vector>

namespace vo {

/// Boxes over a box of a volume, with vertices that move. Everything in voxels.
class Lattice
{
public:
    /// Without vertices.
    Lattice() = default;
    /// Throws CallerError for numbers that make no lattice.
    Lattice(const glm::ivec3& boxes, const glm::dvec3& lower, const glm::dvec3& upper);

    const glm::ivec3& boxes() const { return boxes_; }
    const glm::dvec3& lower() const { return lower_; }
    const glm::dvec3& upper() const { return upper_; }
    int vertexCount() const { return static_cast<int>(positions_.size()); }
    int vertexNumber(int i, int j, int k) const { return (k * (boxes_.y + 1) + j) * (boxes_.x + 1) + i; }
    glm::dvec3 voxel(int vertex) const;
    const std::vector<glm::dvec3>& positions() const { return positions_; }

    /// One position a vertex. Throws CallerError for those that floats do not hold.
    void moveTo(std::vector<glm::dvec3> positions);
    void moveVertex(int vertex, const glm::dvec3& position);
    /// Every vertex back to its voxel coordinates.
    void reset();

    /// Records of the voxel coordinates, then the position.
    TetraMesh tetras(HexaSplit split) const;

private:
    glm::ivec3 boxes_{0};
    glm::dvec3 lower_{0}, upper_{0};
    std::vector<glm::dvec3> positions_;
};

/// Tetrahedra by the sign of their volume in space. Flat: no volume that rounding their corners to floats
/// could not make.
struct FoldCount
{
    int inverted = 0;
    int flat = 0;
};
FoldCount countFolds(const TetraMesh& mesh);

} // namespace vo
