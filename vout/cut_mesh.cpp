#include "vout/cut_mesh.h"

#include "vout/fill_cells.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vo {

namespace {

std::uint64_t edgeKey(int a, int b)
{
    const auto [low, high] = std::minmax(a, b);
    return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

/// Whether a polygon runs from one vertex to another one next to it.
bool runsAs(const std::vector<int>& loop, int from, int to)
{
    const auto place = std::find(loop.begin(), loop.end(), from);
    return (place + 1 == loop.end() ? loop.front() : *(place + 1)) == to;
}

} // namespace

CutMesh::CutMesh(const TetraMesh& mesh)
    : values_(mesh.values), snap_(snapDistance(mesh)), records_(mesh.records.begin(), mesh.records.end())
{
    passOf_.resize(mesh.vertexCount(), 0);
    distance_.resize(mesh.vertexCount());
    std::map<std::array<int, 3>, int> known; // by vertices in ascending order
    for (const Tetra& t : soundTetras(mesh)) {
        Cell& cell = inner_.emplace_back();
        for (const auto& [a, b, c] : {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {1u, 2u, 3u}, {2u, 0u, 3u}}) {
            std::array<int, 3> sorted{t[a], t[b], t[c]};
            std::sort(sorted.begin(), sorted.end());
            const auto [found, isNew] = known.try_emplace(sorted, static_cast<int>(faces_.size()));
            if (isNew) faces_.push_back({{t[a], t[b], t[c]}});
            const std::vector<int>& loop = faces_[static_cast<std::size_t>(found->second)].loop;
            cell.push_back({found->second, runsAs(loop, t[a], t[b])});
        }
    }
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
    // Edges that have vertices were looked at when these were made.
    const auto isKnown = [&](int vertex) { return passOf_[static_cast<std::size_t>(vertex)] == pass_; };
    if (!mayMake && !(isKnown(a) && isKnown(b))) return -1;
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

/// The vertices that this pass made on a face's edges.
void CutMesh::insertMiddles(Face& face)
{
    std::vector<int> whole;
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
        whole.push_back(face.loop[i]);
        if (const int middle = middleOf(face.loop[i], face.loop[(i + 1) % face.loop.size()], false); middle >= 0)
            whole.push_back(middle);
    }
    if (whole.size() > face.loop.size()) face.loop = std::move(whole);
}

/// A face with vertices on both sides becomes two, along the line between the first vertices that are not in front.
void CutMesh::splitFace(int number)
{
    std::vector<int> loop = faces_[static_cast<std::size_t>(number)].loop;
    const auto isInFront = [&](int vertex) { return side(vertex) > 0; };
    if (std::none_of(loop.begin(), loop.end(), isInFront) ||
        std::none_of(loop.begin(), loop.end(), [&](int vertex) { return side(vertex) < 0; }))
        return;
    // What is in front comes first, after the vertex before it.
    while (!isInFront(loop.front()) || isInFront(loop.back()))
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    const auto end = std::find_if_not(loop.begin(), loop.end(), isInFront);
    std::vector<int> front{loop.back()}, behind(end, loop.end());
    front.insert(front.end(), loop.begin(), end + 1);
    if (std::any_of(behind.begin(), behind.end(), isInFront) || behind.size() < 3) return;
    for (const auto& [part, vertices] : {std::pair(0, &front), std::pair(1, &behind)}) {
        faces_[static_cast<std::size_t>(number)].parts[part] = static_cast<int>(faces_.size());
        faces_.push_back({*vertices});
    }
}

/// Faces that were split give way to their parts.
void CutMesh::resolve(Cell& cell) const
{
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const Face& face = faces_[static_cast<std::size_t>(cell[i].face)];
        if (face.parts[0] < 0) continue;
        cell.push_back({face.parts[1], cell[i].outward});
        cell[i--].face = face.parts[0];
    }
}

/// Makes the vertices on edges, and the faces that they split, of all cells that are inside so far.
void CutMesh::splitFaces()
{
    std::vector<int> inner;
    for (const Cell& cell : inner_)
        for (const CellSide& cellSide : cell)
            inner.push_back(cellSide.face);
    std::sort(inner.begin(), inner.end());
    inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
    for (const int face : inner) {
        const std::vector<int>& loop = faces_[static_cast<std::size_t>(face)].loop;
        for (std::size_t i = 0; i < loop.size(); ++i)
            middleOf(loop[i], loop[(i + 1) % loop.size()], true);
    }
    if (!middles_.empty())
        for (Face& face : faces_)
            if (face.parts[0] < 0) insertMiddles(face);
    for (const int face : inner)
        splitFace(face);
    for (std::vector<Cell>* cells : {&inner_, &outer_})
        for (Cell& cell : *cells)
            resolve(cell);
}

/// A cell with faces on both sides becomes two; the new face is what the edges between them enclose. False where it lies on
/// one side.
bool CutMesh::splitCell(const Cell& cell, Cell& positive, Cell& negative)
{
    std::map<int, int> next; // along the faces in front, edges without the way back
    for (const CellSide& cellSide : cell) {
        const std::vector<int>& loop = faces_[static_cast<std::size_t>(cellSide.face)].loop;
        const bool isInFront = std::any_of(loop.begin(), loop.end(), [&](int vertex) { return side(vertex) > 0; });
        (isInFront ? positive : negative).push_back(cellSide);
        if (!isInFront) continue;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            int from = loop[i], to = loop[(i + 1) % loop.size()];
            if (side(from) > 0 || side(to) > 0) continue;
            if (!cellSide.outward) std::swap(from, to);
            if (const auto back = next.find(to); back != next.end() && back->second == from)
                next.erase(back);
            else
                next.emplace(from, to);
        }
    }
    const auto isBehind = [&](const CellSide& cellSide) {
        const std::vector<int>& loop = faces_[static_cast<std::size_t>(cellSide.face)].loop;
        return std::any_of(loop.begin(), loop.end(), [&](int vertex) { return side(vertex) < 0; });
    };
    if (positive.empty() || std::none_of(negative.begin(), negative.end(), isBehind) || next.size() < 3) return false;
    std::vector<int> loop;
    for (int vertex = next.begin()->first; next.contains(vertex);) {
        loop.push_back(vertex);
        const int following = next[vertex];
        next.erase(vertex);
        vertex = following;
    }
    if (!next.empty() || loop.size() < 3) return false;
    // It runs as the faces in front do: outward of what is behind.
    const auto face = static_cast<int>(faces_.size());
    faces_.push_back({loop});
    positive.push_back({face, false});
    negative.push_back({face, true});
    return true;
}

double CutMesh::middleDistance(const Cell& cell) const
{
    double sum = 0;
    int count = 0;
    for (const CellSide& cellSide : cell)
        for (const int vertex : faces_[static_cast<std::size_t>(cellSide.face)].loop) {
            sum += plane_.distance(position(vertex));
            ++count;
        }
    return sum / count;
}

void CutMesh::cut(const CutPlane& plane)
{
    plane_ = plane;
    ++pass_;
    middles_.clear();
    splitFaces();
    std::vector<Cell> stillInner;
    for (Cell& cell : inner_) {
        Cell positive, negative;
        if (splitCell(cell, positive, negative)) {
            stillInner.push_back(std::move(positive));
            outer_.push_back(std::move(negative));
        } else {
            (middleDistance(cell) >= 0 ? stillInner : outer_).push_back(std::move(cell));
        }
    }
    inner_.swap(stillInner);
}

TetraMesh CutMesh::tetrasOf(const std::vector<Cell>& cells) const
{
    TetraMesh all;
    all.values = values_;
    all.records.reserve(records_.size());
    for (const double value : records_)
        all.records.push_back(static_cast<float>(value));
    std::vector<std::array<int, 3>> surface;
    std::vector<Tetra> tetras, kept;
    for (const Cell& cell : cells) {
        surface.clear();
        for (const CellSide& cellSide : cell)
            for (std::array<int, 3> t : trianglesOf(faces_[static_cast<std::size_t>(cellSide.face)].loop, all)) {
                if (!cellSide.outward) std::swap(t[1], t[2]);
                surface.push_back(t);
            }
        fillCell(surface, snap_, all, tetras);
    }
    for (const Tetra& tetra : tetras)
        if (sixfoldVolume(all, tetra) > 0) kept.push_back(tetra);
    requireCountable(kept.size(), 1);
    return compacted(all, kept);
}

} // namespace vo
