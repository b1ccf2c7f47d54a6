#include "mesh_io.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vo {
namespace {

using Point = std::array<double, 3>;

/// Chooses among ways to split a cell: the first whose tetrahedra all have a volume, else the first of which
/// none is inside out.
class Choice
{
public:
    Choice(const Mesh& mesh, std::span<const std::int64_t> cell)
    {
        double size = 0, farthest = 0;
        for (std::size_t i = 0; i < cell.size(); ++i) {
            point_[i] = mesh.points[static_cast<std::size_t>(cell[i])];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                point_[kCellMiddle][axis] += point_[i][axis] / static_cast<double>(cell.size());
                size = std::max(size, std::abs(point_[i][axis] - point_[0][axis]));
                farthest = std::max(farthest, std::abs(point_[i][axis]));
            }
        }
        noise_ = std::ldexp(size * size * farthest, -44);
    }

    /// Whether the search is over.
    bool takes(const CellPieces& pieces)
    {
        double smallest = HUGE_VAL;
        for (const CornerTetra& tetra : pieces.all())
            smallest = std::min(smallest, volume(tetra));
        if (smallest > noise_ || (!chosen_ && smallest >= -noise_)) chosen_ = pieces;
        return smallest > noise_;
    }
    /// Those that have a volume are worth keeping.
    bool isFlat(const CornerTetra& tetra) const { return volume(tetra) <= noise_; }
    const std::optional<CellPieces>& chosen() const { return chosen_; }
    const Point& middle() const { return point_[kCellMiddle]; }

private:
    double volume(const CornerTetra& t) const
    {
        const auto at = [&](std::size_t i) -> const Point& { return point_[static_cast<std::size_t>(t[i])]; };
        return sixfoldVolume(at(0), at(1), at(2), at(3));
    }

    std::array<Point, kMostCorners + 1> point_{};
    double noise_ = 0;
    std::optional<CellPieces> chosen_;
};

void appendPieces(SplitMesh& split, const Choice& choice, std::span<const std::int64_t> cell,
                  std::int64_t cellNumber)
{
    std::int64_t middle = -1;
    for (const CornerTetra& piece : choice.chosen()->all()) {
        if (choice.isFlat(piece)) continue;
        std::array<std::int64_t, 4> tetra{};
        for (std::size_t i = 0; i < 4; ++i) {
            if (piece[i] == kCellMiddle && middle < 0) {
                middle = static_cast<std::int64_t>(split.points.size());
                split.points.push_back(choice.middle());
                split.middleOfCell.push_back(cellNumber);
            }
            tetra[i] = piece[i] == kCellMiddle ? middle : cell[static_cast<std::size_t>(piece[i])];
        }
        split.tetras.push_back(tetra);
        split.cellOfTetra.push_back(cellNumber);
    }
}

} // namespace

double sixfoldVolume(const Point& a, const Point& b, const Point& c, const Point& d)
{
    Point ab, ac, ad;
    for (std::size_t i = 0; i < 3; ++i) {
        ab[i] = b[i] - a[i];
        ac[i] = c[i] - a[i];
        ad[i] = d[i] - a[i];
    }
    return ab[0] * (ac[1] * ad[2] - ac[2] * ad[1]) + ab[1] * (ac[2] * ad[0] - ac[0] * ad[2]) +
           ab[2] * (ac[0] * ad[1] - ac[1] * ad[0]);
}

SplitMesh splitMesh(const Mesh& mesh)
{
    SplitMesh split;
    split.points = mesh.points;
    split.tetras.reserve(mesh.cellCount());
    split.cellOfTetra.reserve(mesh.cellCount());
    std::size_t first = 0;
    for (std::size_t i = 0; i < mesh.cellCount(); ++i) {
        const auto corners = static_cast<std::size_t>(shapeOf(mesh.kinds[i]).corners);
        const auto cell = std::span(mesh.corners).subspan(first, corners);
        first += corners;
        const auto number = static_cast<std::int64_t>(i);
        if (mesh.kinds[i] == CellKind::tetra) {
            split.tetras.push_back({cell[0], cell[1], cell[2], cell[3]});
            split.cellOfTetra.push_back(number);
            continue;
        }
        Choice choice(mesh, cell);
        offerSplits(mesh.kinds[i], cell, [&](const CellPieces& pieces) { return choice.takes(pieces); });
        if (choice.chosen()) appendPieces(split, choice, cell, number);
    }
    return split;
}

std::vector<double> valuesAtPoints(const Mesh& mesh, const SplitMesh& split, const MeshField& pointField)
{
    const auto components = static_cast<std::size_t>(pointField.components);
    std::vector<double> values = pointField.values;
    values.reserve(split.points.size() * components);
    std::size_t cell = 0, first = 0;
    for (const std::int64_t of : split.middleOfCell) {
        for (; cell < static_cast<std::size_t>(of); ++cell)
            first += static_cast<std::size_t>(shapeOf(mesh.kinds[cell]).corners);
        const auto corners = static_cast<std::size_t>(shapeOf(mesh.kinds[cell]).corners);
        for (std::size_t k = 0; k < components; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < corners; ++i)
                sum += values[static_cast<std::size_t>(mesh.corners[first + i]) * components + k];
            values.push_back(sum / static_cast<double>(corners));
        }
    }
    return values;
}

} // namespace vo
