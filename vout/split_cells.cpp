#include "vout/split_cells.h"

#include "legacy/report.h"

#include "vout/hexa_coloring.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <map>
#include <optional>

namespace vo {

namespace {

// Points of a cell: its corners, its middle, and the middles of its faces.
constexpr int kMiddle = kMostCorners;
constexpr int kFaceMiddle = kMiddle + 1;
constexpr int kPoints = kFaceMiddle + kMostFaces;
constexpr int kMostTetras = 24;

using Tetra = std::array<int, 4>; ///< points

/// One way to split a cell.
struct Pieces
{
    int count = 0;
    std::array<Tetra, kMostTetras> tetra{};

    void add(const Tetra& piece) { tetra[static_cast<std::size_t>(count++)] = piece; }
    std::span<const Tetra> all() const { return {tetra.data(), static_cast<std::size_t>(count)}; }
};

/// The guide's cube (page 76), whose faces are cut between the corners 0, 2, 5 and 7, and its mirror image.
constexpr Tetra kFive[2][5] = {
    {{0, 5, 2, 7}, {3, 0, 2, 7}, {1, 5, 2, 0}, {2, 6, 7, 5}, {5, 0, 4, 7}},
    {{1, 3, 4, 6}, {2, 3, 1, 6}, {0, 3, 4, 1}, {3, 6, 7, 4}, {4, 5, 1, 6}},
};

/// How the faces of a cell are cut: faces of four corners from their corner 0 to 2, else from 1 to 3.
using Cuts = std::array<bool, kMostFaces>;

/// Tetrahedra from a point to the triangles of a face.
void addCone(int tip, const CellFace& face, bool fromFirst, Pieces& pieces)
{
    const auto& c = face.corner;
    if (face.corners == 3) {
        pieces.add({tip, c[0], c[1], c[2]});
    } else if (fromFirst) {
        pieces.add({tip, c[0], c[1], c[2]});
        pieces.add({tip, c[0], c[2], c[3]});
    } else {
        pieces.add({tip, c[0], c[1], c[3]});
        pieces.add({tip, c[1], c[2], c[3]});
    }
}

int placeIn(const CellFace& face, int corner)
{
    for (int i = 0; i < face.corners; ++i)
        if (face.corner[static_cast<std::size_t>(i)] == corner) return i;
    return -1;
}

/// Tetrahedra from one corner to the faces opposite. Not possible where a face at the corner is cut elsewhere.
std::optional<Pieces> fromCorner(const CellShape& shape, const Cuts& cuts, int corner)
{
    Pieces pieces;
    for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f) {
        const CellFace& face = shape.face[f];
        const int place = placeIn(face, corner);
        if (place < 0) {
            addCone(corner, face, cuts[f], pieces);
        } else if (face.corners == 4 && cuts[f] != (place % 2 == 0)) {
            return {};
        }
    }
    return pieces;
}

Pieces fromMiddle(const CellShape& shape, const Cuts& cuts)
{
    Pieces pieces;
    for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f)
        addCone(kMiddle, shape.face[f], cuts[f], pieces);
    return pieces;
}

Pieces fromMiddles(const CellShape& shape)
{
    Pieces pieces;
    for (int f = 0; f < shape.faces; ++f)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& c = shape.face[static_cast<std::size_t>(f)].corner;
            pieces.add({kMiddle, c[i], c[(i + 1) % 4], kFaceMiddle + f});
        }
    return pieces;
}

/// A cell in space, to judge pieces by.
class CellSpace
{
public:
    CellSpace(const CellShape& shape, std::span<const int> cell, const TetraMesh& mesh)
    {
        glm::dvec3 lower(HUGE_VAL), upper(-HUGE_VAL), sum(0);
        for (std::size_t i = 0; i < cell.size(); ++i) {
            point_[i] = mesh.position(cell[i]);
            lower = glm::min(lower, point_[i]);
            upper = glm::max(upper, point_[i]);
            sum += point_[i];
        }
        point_[kMiddle] = sum / static_cast<double>(cell.size());
        for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f) {
            glm::dvec3& middle = point_[kFaceMiddle + f];
            for (int i = 0; i < shape.face[f].corners; ++i)
                middle += point_[static_cast<std::size_t>(shape.face[f].corner[static_cast<std::size_t>(i)])];
            middle /= shape.face[f].corners;
        }
        rounding_ = std::ldexp(1.0, -22) * glm::max(glm::abs(lower), glm::abs(upper));
    }

    double volume(const Tetra& t) const
    {
        const auto at = [&](std::size_t i) { return point_[static_cast<std::size_t>(t[i])]; };
        return sixfoldVolume(at(0), at(1), at(2), at(3));
    }
    /// Whether rounding the corners to floats could make such a volume of nothing.
    bool isFlat(const Tetra& t) const
    {
        const auto at = [&](std::size_t i) { return point_[static_cast<std::size_t>(t[i])]; };
        const glm::dvec3 a = at(1) - at(0), b = at(2) - at(0), c = at(3) - at(0);
        const glm::dvec3 faces = glm::abs(glm::cross(a, b)) + glm::abs(glm::cross(b, c)) +
                                 glm::abs(glm::cross(c, a)) + glm::abs(glm::cross(b - a, c - a));
        return std::abs(glm::dot(glm::cross(a, b), c)) <= glm::dot(rounding_, faces);
    }

private:
    std::array<glm::dvec3, kPoints> point_{};
    glm::dvec3 rounding_; ///< how far a corner may lie from where it should
};

/// +1 or -1 for a cell of one handedness or the other; 0 where it has no volume.
int handedness(const Pieces& pieces, const CellSpace& space)
{
    double sum = 0;
    bool flat = true;
    for (const Tetra& tetra : pieces.all()) {
        sum += space.volume(tetra);
        flat = flat && space.isFlat(tetra);
    }
    return flat ? 0 : sum < 0 ? -1 : 1;
}

/// Chooses among ways to split a cell: the first whose pieces all have a volume, else the first that has none inside
/// out.
class Choice
{
public:
    Choice(const CellSpace& space, int hand) : space_(space), hand_(hand) {}

    /// Whether the search is over.
    bool takes(const Pieces& pieces)
    {
        bool whole = true, insideOut = false;
        for (const Tetra& tetra : pieces.all()) {
            const bool positive = hand_ * space_.volume(tetra) > 0;
            whole = whole && positive;
            insideOut = insideOut || (!positive && !space_.isFlat(tetra));
        }
        if (whole || (!chosen_ && !insideOut)) chosen_ = pieces;
        return whole;
    }
    const std::optional<Pieces>& chosen() const { return chosen_; }

private:
    const CellSpace& space_;
    int hand_;
    std::optional<Pieces> chosen_;
};

/// Tetrahedra of a cell that needs no vertex of its own.
int piecesOf(CellKind kind, HexaSplit split)
{
    switch (kind) {
    case CellKind::tetra: return 1;
    case CellKind::pyramid: return 2;
    case CellKind::prism: return 3;
    case CellKind::hexa: break;
    }
    return static_cast<int>(split);
}

class Splitter
{
public:
    Splitter(const Cells& cells, HexaSplit split, TetraMesh& mesh)
        : cells_(cells), shape_(shapeOf(cells.kind)), split_(split), mesh_(mesh)
    {
        if (cells.kind == CellKind::hexa && split == HexaSplit::five)
            coloring_.emplace(cells, static_cast<int>(mesh.vertexCount()));
    }

    std::size_t run()
    {
        for (std::size_t i = 0; i < cells_.count(); ++i) {
            const auto corners = static_cast<std::size_t>(shape_.corners);
            const auto cell = std::span(cells_.corners).subspan(i * corners, corners);
            if (!splitCell(cell))
                badValue(std::string(shape_.name) + " " + std::to_string(i) + " is partly inside out");
        }
        return flat_;
    }

private:
    bool isColored(std::span<const int> cell) const { return coloring_ && coloring_->isPossible(cell[0]); }

    /// Faces at a vertex that is first in numbers or colours are cut from it.
    Cuts cutsOf(std::span<const int> cell) const
    {
        Cuts cuts{};
        for (std::size_t f = 0; f < static_cast<std::size_t>(shape_.faces); ++f) {
            std::array<int, 4> v{};
            for (std::size_t i = 0; i < 4; ++i)
                v[i] = cell[static_cast<std::size_t>(shape_.face[f].corner[i])];
            cuts[f] = isColored(cell) ? !coloring_->color(v[0])
                                      : std::min(v[0], v[2]) <= std::min(v[1], v[3]);
        }
        return cuts;
    }

    /// False for a cell that is partly inside out.
    bool splitCell(std::span<const int> cell)
    {
        const CellSpace space(shape_, cell, mesh_);
        const Cuts cuts = cutsOf(cell);
        const int hand = handedness(fromMiddle(shape_, cuts), space);
        if (hand == 0) {
            ++flat_;
            return true;
        }
        Choice choice(space, hand);
        offerWays(cell, cuts, choice);
        if (!choice.chosen()) return false;
        append(*choice.chosen(), cell, space, hand);
        return true;
    }

    void offerWays(std::span<const int> cell, const Cuts& cuts, Choice& choice) const
    {
        if (cells_.kind == CellKind::tetra) {
            choice.takes({1, {{{0, 1, 2, 3}}}});
            return;
        }
        if (cells_.kind == CellKind::hexa && split_ == HexaSplit::fromMiddles) {
            choice.takes(fromMiddles(shape_));
            return;
        }
        if (isColored(cell)) {
            Pieces five;
            for (const Tetra& tetra : kFive[coloring_->color(cell[0])])
                five.add(tetra);
            if (choice.takes(five)) return;
        }
        // All faces at the smallest vertex number are cut from it, unless by colours.
        const auto smallest = static_cast<int>(std::min_element(cell.begin(), cell.end()) - cell.begin());
        for (int i = 0; i < shape_.corners; ++i) {
            const auto pieces = fromCorner(shape_, cuts, (smallest + i) % shape_.corners);
            if (pieces && choice.takes(*pieces)) return;
        }
        choice.takes(fromMiddle(shape_, cuts));
    }

    void append(const Pieces& pieces, std::span<const int> cell, const CellSpace& space, int hand)
    {
        requireNumbers();
        std::array<int, kPoints> vertex;
        std::fill(vertex.begin(), vertex.end(), -1);
        std::copy(cell.begin(), cell.end(), vertex.begin());
        for (Tetra tetra : pieces.all()) {
            if (hand * space.volume(tetra) <= 0) {
                ++flat_;
                continue;
            }
            if (hand < 0) std::swap(tetra[2], tetra[3]);
            for (const int point : tetra) {
                int& number = vertex[static_cast<std::size_t>(point)];
                if (number < 0) number = point == kMiddle ? mesh_.appendMean(cell) : faceMiddle(cell, point);
                mesh_.tetras.push_back(number);
            }
        }
    }

    /// Throws CallerError where ints might not number what one more cell adds.
    void requireNumbers() const
    {
        if (mesh_.tetras.size() <= INT_MAX - 4 * kMostTetras && mesh_.vertexCount() <= INT_MAX - kPoints) return;
        badValue("more tetrahedra than " + std::to_string(INT_MAX) + " indices hold");
    }

    /// The vertex in the middle of a face, which neighbours share.
    int faceMiddle(std::span<const int> cell, int point)
    {
        std::array<int, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] =
                cell[static_cast<std::size_t>(shape_.face[static_cast<std::size_t>(point - kFaceMiddle)].corner[i])];
        std::sort(corners.begin(), corners.end());
        const auto [found, isNew] = faceMiddles_.try_emplace(corners, 0);
        if (isNew) found->second = mesh_.appendMean(corners);
        return found->second;
    }

    const Cells& cells_;
    const CellShape& shape_;
    HexaSplit split_;
    TetraMesh& mesh_;
    std::optional<HexaColoring> coloring_;
    std::map<std::array<int, 4>, int> faceMiddles_; ///< by corners in ascending order
    std::size_t flat_ = 0;
};

} // namespace

HexaSplit hexaSplit(int tetras)
{
    for (const HexaSplit split : {HexaSplit::five, HexaSplit::fromSmallest, HexaSplit::fromMiddles})
        if (static_cast<int>(split) == tetras) return split;
    badValue(std::to_string(tetras) + " tetrahedra in a box, 5, 6 or 24 are possible");
}

std::size_t splitCells(const Cells& cells, HexaSplit split, TetraMesh& mesh)
{
    requireCountable(cells.count(), piecesOf(cells.kind, split));
    return Splitter(cells, split, mesh).run();
}

} // namespace vo
