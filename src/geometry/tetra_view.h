#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace vo {

/// Tetrahedra of somebody else's arrays: records of `valuesPerVertex` floats whose last three are the
/// position, and four record numbers for each tetrahedron, all in range (the caller has checked).
struct TetraView
{
    std::span<const float> records;
    int valuesPerVertex = 3;
    std::span<const int> indices;
    /// Where in a record its voxel coordinates begin, to which bricks are cut; -1: the position is them.
    int voxelColumn = -1;

    int tetraCount() const { return static_cast<int>(indices.size() / 4); }
    const float* record(int vertex) const
    {
        return records.data() + static_cast<std::size_t>(vertex) * static_cast<std::size_t>(valuesPerVertex);
    }
    glm::dvec3 position(int vertex) const
    {
        const float* p = record(vertex) + valuesPerVertex - 3;
        return {p[0], p[1], p[2]};
    }
};

} // namespace vo
