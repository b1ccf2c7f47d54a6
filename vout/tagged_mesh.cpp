#include "vout/tagged_mesh.h"

#include "legacy/report.h"

#include <algorithm>
#include <climits>
#include <numeric>
#include <string>

namespace vo {

TaggedMesh::TaggedMesh(int values)
{
    if (values < 3) badValue("records of " + std::to_string(values) + " values have no position");
    mesh_.values = values;
}

void TaggedMesh::append(const TetraMesh& mesh, int tag)
{
    if (mesh.values != mesh_.values)
        badValue("records of " + std::to_string(mesh.values) + " values, those here have " +
                 std::to_string(mesh_.values));
    if (mesh.tetras.size() > INT_MAX - mesh_.tetras.size() || mesh.vertexCount() > INT_MAX - mesh_.vertexCount())
        badValue("there are more tetrahedra than can be numbered");
    const auto first = static_cast<int>(mesh_.vertexCount());
    mesh_.records.insert(mesh_.records.end(), mesh.records.begin(), mesh.records.end());
    for (const int vertex : mesh.tetras)
        mesh_.tetras.push_back(first + vertex);
    tags_.resize(mesh_.tetras.size() / VO_TETRA_VERTICES, tag);
    if (merges_) mergeVertices();
}

int TaggedMesh::mergeVertices()
{
    merges_ = true;
    const auto before = mesh_.vertexCount();
    const auto values = static_cast<std::size_t>(mesh_.values);
    std::vector<int> order(before);
    std::iota(order.begin(), order.end(), 0);
    const auto compare = [&](int a, int b) {
        const float *left = mesh_.record(a), *right = mesh_.record(b);
        return std::lexicographical_compare(left, left + values, right, right + values);
    };
    std::stable_sort(order.begin(), order.end(), compare);
    std::vector<int> same(before); // the first vertex of the same record
    for (std::size_t i = 0; i < before; ++i) {
        const bool isNew = i == 0 || compare(order[i - 1], order[i]);
        same[static_cast<std::size_t>(order[i])] = isNew ? order[i] : same[static_cast<std::size_t>(order[i - 1])];
    }
    std::vector<int> number(before);
    TetraMesh merged;
    merged.values = mesh_.values;
    for (std::size_t vertex = 0; vertex < before; ++vertex) {
        const auto first = static_cast<std::size_t>(same[vertex]);
        if (first != vertex) {
            number[vertex] = number[first];
            continue;
        }
        number[vertex] = static_cast<int>(merged.vertexCount());
        const float* record = mesh_.record(static_cast<int>(vertex));
        merged.records.insert(merged.records.end(), record, record + values);
    }
    for (const int vertex : mesh_.tetras)
        merged.tetras.push_back(number[static_cast<std::size_t>(vertex)]);
    mesh_ = std::move(merged);
    return static_cast<int>(before - mesh_.vertexCount());
}

bool TaggedMesh::hasTag(int tag) const
{
    return std::find(tags_.begin(), tags_.end(), tag) != tags_.end();
}

TetraMesh TaggedMesh::extract(int tag) const
{
    std::vector<Tetra> tetras;
    for (std::size_t i = 0; i < tags_.size(); ++i)
        if (tags_[i] == tag) {
            const int* t = mesh_.tetras.data() + VO_TETRA_VERTICES * i;
            tetras.push_back({t[0], t[1], t[2], t[3]});
        }
    return compacted(mesh_, tetras);
}

} // namespace vo
