#include "mesh_cell.h"
#include "mesh_io.h"

namespace vo {
namespace {

/// Those pieces that have a volume.
void appendPieces(SplitMesh& split, const CellPieces& pieces, const CellSpace& space,
                  std::span<const std::int64_t> cell, std::int64_t cellNumber)
{
    std::int64_t middle = -1;
    for (const CornerTetra& piece : pieces.all()) {
        if (space.isFlat(piece)) continue;
        std::array<std::int64_t, 4> tetra{};
        for (std::size_t i = 0; i < 4; ++i) {
            if (piece[i] == kCellMiddle && middle < 0) {
                middle = static_cast<std::int64_t>(split.points.size());
                const glm::dvec3& place = space.at(kCellMiddle);
                split.points.push_back({place.x, place.y, place.z});
                split.middleOfCell.push_back(cellNumber);
            }
            tetra[i] = piece[i] == kCellMiddle ? middle : cell[static_cast<std::size_t>(piece[i])];
        }
        split.tetras.push_back(tetra);
        split.cellOfTetra.push_back(cellNumber);
    }
}

} // namespace

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
        const CellSpace space = cellSpace(mesh.kinds[i], cell, mesh.points);
        SplitChoice choice(space, 1);
        offerSplits(mesh.kinds[i], cell, [&](const CellPieces& pieces) { return choice.takes(pieces); });
        if (choice.chosen()) appendPieces(split, *choice.chosen(), space, cell, number);
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
