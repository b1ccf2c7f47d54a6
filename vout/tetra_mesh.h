#pragma once

#include <vo/Geometry.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace vo {

/// Vertex numbers.
using Tetra = std::array<int, 4>;

/// Tetrahedra, four vertex numbers each, on records of `values` floats whose last three are the position.
struct TetraMesh
{
    int values = 3;
    std::vector<float> records;
    std::vector<int> tetras;

    std::size_t vertexCount() const { return records.size() / static_cast<std::size_t>(values); }
    const float* record(int vertex) const
    {
        return records.data() + static_cast<std::size_t>(vertex) * static_cast<std::size_t>(values);
    }
    glm::dvec3 position(int vertex) const
    {
        const float* p = record(vertex) + values - 3;
        return {p[0], p[1], p[2]};
    }
    /// Appends the mean of the records of `corners`, value by value; returns its number.
    template <typename Corners>
    int appendMean(const Corners& corners)
    {
        const auto number = static_cast<int>(vertexCount());
        for (int value = 0; value < values; ++value) {
            double sum = 0;
            for (const int corner : corners)
                sum += static_cast<double>(record(corner)[value]);
            records.push_back(static_cast<float>(sum / static_cast<double>(std::size(corners))));
        }
        return number;
    }
};

/// As that of four points (geometry/cell_space.h).
double sixfoldVolume(const TetraMesh& mesh, const Tetra& tetra);

/// A copy of a set. Throws CallerError for indices that are wrong, and records without a position.
TetraMesh meshOf(const voIndexedTetraSet& set);

/// The tetrahedra that have a volume and finite corners, all turned to positive volumes.
std::vector<Tetra> soundTetras(const TetraMesh& mesh);

/// Some tetrahedra of a mesh, and the vertices that they use in their order.
TetraMesh compacted(const TetraMesh& mesh, const std::vector<Tetra>& tetras);

/// The mesh as a set of its own. Throws std::bad_alloc.
std::unique_ptr<voIndexedTetraSet> tetraSet(const TetraMesh& mesh);

/// Throws CallerError where `cells` cells of up to `tetrasEach` tetrahedra are more than ints can number.
void requireCountable(std::size_t cells, int tetrasEach);

} // namespace vo
