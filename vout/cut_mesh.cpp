#include "vout/cut_mesh.h"

#include "legacy/report.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vo {

namespace {

constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

std::uint64_t edgeKey(int a, int b)
{
    const auto [low, high] = std::minmax(a, b);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

} // namespace

CutMesh::CutMesh(const TetraMesh& mesh)
    : values_(mesh.values), snap_(snapDistance(mesh)), records_(mesh.records.begin(), mesh.records.end()),
      inner_(soundTetras(mesh))
{
    passOf_.resize(mesh.vertexCount(), 0);
    distance_.resize(mesh.vertexCount());
}

glm::dvec3 CutMesh::position(int vertex) const
{
    const double* p = records_.data() + (static_cast<std::size_t>(vertex) + 1) * static_cast<std::size_t>(values_) - 3;
    return {p[0], p[1], p[2]};
}

/// Of the present plane: 1, 0 or -1.
int CutMesh::side(int vertex)
{
    const auto v = static_cast<std::size_t>(vertex);
    if (passOf_[v] != pass_) {
        passOf_[v] = pass_;
        distance_[v] = plane_.distance(position(vertex));
        if (std::abs(distance_[v]) <= snap_) distance_[v] = 0;
    }
    return (distance_[v] > 0) - (distance_[v] < 0);
}

/// The vertex where the plane cuts an edge; -1 where it does not, or none was made so far.
int CutMesh::middleOf(int a, int b, bool mayMake)
{
    if (side(a) * side(b) >= 0) return -1;
    if (const auto found = middles_.find(edgeKey(a, b)); found != middles_.end()) return found->second;
    if (!mayMake) return -1;
    const auto number = static_cast<int>(passOf_.size());
    const auto [low, high] = std::minmax(a, b);
    const double from = distance_[static_cast<std::size_t>(low)], to = distance_[static_cast<std::size_t>(high)];
    const double part = from / (from - to);
    for (int value = 0; value < values_; ++value) {
        const auto at = [&](int vertex) {
            return records_[static_cast<std::size_t>(vertex) * static_cast<std::size_t>(values_) +
                            static_cast<std::size_t>(value)];
        };
        const double interpolated = at(low) + part * (at(high) - at(low));
        records_.push_back(interpolated);
    }
    passOf_.push_back(pass_);
    distance_.push_back(0);
    middles_.emplace(edgeKey(a, b), number);
    return number;
}

/// Of a tetrahedron all of whose cut edges have their vertices.
void CutMesh::bisect(const Tetra& tetra, std::vector<Tetra>& pieces)
{
    int first = -1;
    const int* cutEdge = nullptr;
    for (const auto& edge : kEdges) {
        const int middle = middleOf(tetra[static_cast<std::size_t>(edge[0])],
                                    tetra[static_cast<std::size_t>(edge[1])], false);
        if (middle < 0 || (cutEdge && middle > first)) continue;
        first = middle;
        cutEdge = edge;
    }
    if (!cutEdge) {
        pieces.push_back(tetra);
        return;
    }
    for (const int end : {cutEdge[1], cutEdge[0]}) {
        Tetra half = tetra;
        half[static_cast<std::size_t>(end)] = first;
        bisect(half, pieces);
    }
}

/// Pieces lie on one side. Those that the plane seems to hold altogether are thin: most of them decides.
void CutMesh::sortOut(const std::vector<Tetra>& pieces, std::vector<Tetra>& stillInner)
{
    for (const Tetra& piece : pieces) {
        int sides = 0;
        for (const int vertex : piece)
            sides += side(vertex);
        const bool isInside = sides != 0 ? sides > 0
                                         : plane_.distance(0.25 * (position(piece[0]) + position(piece[1]) +
                                                                   position(piece[2]) + position(piece[3]))) >= 0;
        (isInside ? stillInner : outer_).push_back(piece);
    }
}

void CutMesh::cut(const CutPlane& plane)
{
    plane_ = plane;
    ++pass_;
    middles_.clear();
    for (const Tetra& tetra : inner_)
        for (const auto& edge : kEdges)
            middleOf(tetra[static_cast<std::size_t>(edge[0])], tetra[static_cast<std::size_t>(edge[1])], true);

    std::vector<Tetra> pieces;
    if (!middles_.empty()) {
        // Of those that are outside already, those at an edge that was cut.
        for (const Tetra& tetra : outer_)
            bisect(tetra, pieces);
        outer_.swap(pieces);
    }
    std::vector<Tetra> stillInner;
    for (const Tetra& tetra : inner_) {
        pieces.clear();
        bisect(tetra, pieces);
        sortOut(pieces, stillInner);
    }
    inner_.swap(stillInner);
}

TetraMesh CutMesh::rounded(const std::vector<Tetra>& tetras) const
{
    requireCountable(tetras.size(), 1);
    TetraMesh all;
    all.values = values_;
    all.records.reserve(records_.size());
    for (const double value : records_)
        all.records.push_back(static_cast<float>(value));
    std::vector<Tetra> kept;
    for (const Tetra& tetra : tetras)
        if (sixfoldVolume(all, tetra) > 0) kept.push_back(tetra);
    return compacted(all, kept);
}

} // namespace vo
