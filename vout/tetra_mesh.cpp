#include "vout/tetra_mesh.h"

#include "legacy/report.h"

#include <algorithm>
#include <climits>

namespace vo {

std::unique_ptr<voIndexedTetraSet> tetraSet(const TetraMesh& mesh)
{
    const auto vertexCount = static_cast<int>(mesh.vertexCount());
    const auto indexCount = static_cast<int>(mesh.tetras.size());
    auto set = std::make_unique<voIndexedTetraSet>(vertexCount, mesh.values, indexCount);
    voVertexData& vertices = *set->getVertexData();
    voIndices& indices = *set->getIndices();
    if (vertices.getCountMax() != vertexCount || indices.getCountMax() != indexCount) throw std::bad_alloc();
    std::copy(mesh.records.begin(), mesh.records.end(), vertices.getDataPtr());
    std::copy(mesh.tetras.begin(), mesh.tetras.end(), indices.getDataPtr());
    vertices.setCount(vertexCount);
    indices.setCount(indexCount);
    return set;
}

void requireCountable(std::size_t cells, int tetrasEach)
{
    const auto most = static_cast<std::size_t>(INT_MAX / (VO_TETRA_VERTICES * tetrasEach));
    if (cells > most)
        badValue(std::to_string(cells) + " cells, at most " + std::to_string(most) + " can be numbered");
}

} // namespace vo
