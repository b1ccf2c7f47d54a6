#include "vout/tetra_mesh.h"

#include "geometry/cell_space.h"
#include "legacy/report.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <string>

namespace vo {

double sixfoldVolume(const TetraMesh& mesh, const Tetra& t)
{
    return sixfoldVolume(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]), mesh.position(t[3]));
}

TetraMesh meshOf(const voIndexedTetraSet& set)
{
    const voVertexData& vertices = *set.getVertexData();
    const voIndices& indices = *set.getIndices();
    TetraMesh mesh;
    mesh.values = vertices.getValuesPerVertex();
    if (mesh.values < 3) badValue("records of " + std::to_string(mesh.values) + " values have no position");
    if (indices.getCount() % VO_TETRA_VERTICES != 0)
        badValue(std::to_string(indices.getCount()) + " indices, a multiple of 4 is needed");
    const auto floats = static_cast<std::size_t>(vertices.getCount()) * static_cast<std::size_t>(mesh.values);
    mesh.records.assign(vertices.getDataPtr(), vertices.getDataPtr() + floats);
    mesh.tetras.assign(indices.getDataPtr(), indices.getDataPtr() + indices.getCount());
    for (const int vertex : mesh.tetras)
        if (vertex < 0 || vertex >= vertices.getCount())
            badValue("vertex " + std::to_string(vertex) + " of " + std::to_string(vertices.getCount()));
    return mesh;
}

std::vector<Tetra> soundTetras(const TetraMesh& mesh)
{
    std::vector<Tetra> sound;
    sound.reserve(mesh.tetras.size() / VO_TETRA_VERTICES);
    for (std::size_t i = 0; i < mesh.tetras.size(); i += VO_TETRA_VERTICES) {
        Tetra t;
        std::copy_n(mesh.tetras.begin() + static_cast<std::ptrdiff_t>(i), 4, t.begin());
        const double volume = sixfoldVolume(mesh, t);
        if (volume == 0 || !std::isfinite(volume)) continue;
        if (volume < 0) std::swap(t[2], t[3]);
        sound.push_back(t);
    }
    return sound;
}

TetraMesh compacted(const TetraMesh& mesh, const std::vector<Tetra>& tetras)
{
    std::vector<int> number(mesh.vertexCount(), -1);
    for (const Tetra& tetra : tetras)
        for (const int vertex : tetra)
            number[static_cast<std::size_t>(vertex)] = 0;
    TetraMesh compact;
    compact.values = mesh.values;
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex) {
        if (number[vertex] < 0) continue;
        number[vertex] = static_cast<int>(compact.vertexCount());
        const float* record = mesh.record(static_cast<int>(vertex));
        compact.records.insert(compact.records.end(), record, record + mesh.values);
    }
    compact.tetras.reserve(VO_TETRA_VERTICES * tetras.size());
    for (const Tetra& tetra : tetras)
        for (const int vertex : tetra)
            compact.tetras.push_back(number[static_cast<std::size_t>(vertex)]);
    return compact;
}

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
