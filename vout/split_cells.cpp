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
constexpr int kFaceMiddle = kCellMiddle + 1;
constexpr int kPoints = kFaceMiddle + kMostFaces;

CellPieces fromMiddles(const CellShape& shape)
{
    CellPieces pieces;
    for (int f = 0; f < shape.faces; ++f)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& c = shape.face[static_cast<std::size_t>(f)].corner;
            pieces.add({kCellMiddle, c[i], c[(i + 1) % 4], kFaceMiddle + f});
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
        point_[kCellMiddle] = sum / static_cast<double>(cell.size());
        for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f) {
            glm::dvec3& middle = point_[kFaceMiddle + f];
            for (int i = 0; i < shape.face[f].corners; ++i)
                middle += point_[static_cast<std::size_t>(shape.face[f].corner[static_cast<std::size_t>(i)])];
            middle /= shape.face[f].corners;
        }
        rounding_ = std::ldexp(1.0, -22) * glm::max(glm::abs(lower), glm::abs(upper));
    }

    double volume(const CornerTetra& t) const
    {
        const auto at = [&](std::size_t i) { return point_[static_cast<std::size_t>(t[i])]; };
        return sixfoldVolume(at(0), at(1), at(2), at(3));
    }
    /// Whether rounding the corners to floats could make such a volume of nothing.
    bool isFlat(const CornerTetra& t) const
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
int handedness(const CellPieces& pieces, const CellSpace& space)
{
    double sum = 0;
    bool flat = true;
    for (const CornerTetra& tetra : pieces.all()) {
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
    bool takes(const CellPieces& pieces)
    {
        bool whole = true, insideOut = false;
        for (const CornerTetra& tetra : pieces.all()) {
            const bool positive = hand_ * space_.volume(tetra) > 0;
            whole = whole && positive;
            insideOut = insideOut || (!positive && !space_.isFlat(tetra));
        }
        if (whole || (!chosen_ && !insideOut)) chosen_ = pieces;
        return whole;
    }
    const std::optional<CellPieces>& chosen() const { return chosen_; }

private:
    const CellSpace& space_;
    int hand_;
    std::optional<CellPieces> chosen_;
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
    FaceCuts cutsOf(std::span<const int> cell) const
    {
        if (!isColored(cell)) return cutsFromSmallest(cells_.kind, cell);
        FaceCuts cuts{};
        for (std::size_t f = 0; f < static_cast<std::size_t>(shape_.faces); ++f)
            cuts[f] = !coloring_->color(cell[static_cast<std::size_t>(shape_.face[f].corner[0])]);
        return cuts;
    }

    /// False for a cell that is partly inside out.
    bool splitCell(std::span<const int> cell)
    {
        const CellSpace space(shape_, cell, mesh_);
        const FaceCuts cuts = cutsOf(cell);
        const int hand = handedness(splitFromMiddle(cells_.kind, cuts), space);
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

    void offerWays(std::span<const int> cell, const FaceCuts& cuts, Choice& choice) const
    {
        if (cells_.kind == CellKind::tetra) {
            choice.takes({1, {{{0, 1, 2, 3}}}});
            return;
        }
        if (cells_.kind == CellKind::hexa && split_ == HexaSplit::fromMiddles) {
            choice.takes(fromMiddles(shape_));
            return;
        }
        if (isColored(cell) && choice.takes(kFiveOfBox[coloring_->color(cell[0])])) return;
        // All faces at the smallest vertex number are cut from it, unless by colours.
        const auto smallest = static_cast<int>(std::min_element(cell.begin(), cell.end()) - cell.begin());
        for (int i = 0; i < shape_.corners; ++i) {
            const auto pieces = splitFromCorner(cells_.kind, cuts, (smallest + i) % shape_.corners);
            if (pieces && choice.takes(*pieces)) return;
        }
        choice.takes(splitFromMiddle(cells_.kind, cuts));
    }

    void append(const CellPieces& pieces, std::span<const int> cell, const CellSpace& space, int hand)
    {
        requireNumbers();
        std::array<int, kPoints> vertex;
        std::fill(vertex.begin(), vertex.end(), -1);
        std::copy(cell.begin(), cell.end(), vertex.begin());
        for (CornerTetra tetra : pieces.all()) {
            if (hand * space.volume(tetra) <= 0) {
                ++flat_;
                continue;
            }
            if (hand < 0) std::swap(tetra[2], tetra[3]);
            for (const int point : tetra) {
                int& number = vertex[static_cast<std::size_t>(point)];
                if (number < 0) number = point == kCellMiddle ? mesh_.appendMean(cell) : faceMiddle(cell, point);
                mesh_.tetras.push_back(number);
            }
        }
    }

    /// Throws CallerError where ints might not number what one more cell adds.
    void requireNumbers() const
    {
        if (mesh_.tetras.size() <= INT_MAX - 4 * kMostPieces && mesh_.vertexCount() <= INT_MAX - kPoints) return;
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
