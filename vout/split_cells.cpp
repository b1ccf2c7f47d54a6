#include "vout/split_cells.h"

#include "geometry/cell_space.h"
#include "legacy/report.h"

#include "vout/hexa_coloring.h"

#include <algorithm>
#include <climits>
#include <map>
#include <optional>

namespace vo {

namespace {

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

/// How far off a coordinate of 1 may be as a float.
constexpr double kFloatPrecision = 0x1p-22;

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
        const auto corner = [&](std::size_t i) { return mesh_.position(cell[i]); };
        const CellSpace space(cells_.kind, corner, kFloatPrecision);
        const FaceCuts cuts = cutsOf(cell);
        const int hand = space.handedness(splitFromMiddle(cells_.kind, cuts));
        if (hand == 0) {
            ++flat_;
            return true;
        }
        SplitChoice choice(space, hand);
        offerWays(cell, cuts, choice);
        if (!choice.chosen()) return false;
        append(*choice.chosen(), cell, space, hand);
        return true;
    }

    void offerWays(std::span<const int> cell, const FaceCuts& cuts, SplitChoice& choice) const
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
        std::array<int, kCellPoints> vertex;
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
        if (mesh_.tetras.size() <= INT_MAX - 4 * kMostPieces && mesh_.vertexCount() <= INT_MAX - kCellPoints) return;
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
