#include "vout/cells.h"

#include "legacy/report.h"

#include "vout/tetra_mesh.h"

#include <string>

namespace vo {

namespace {

void checkCount(const Arrangement& a, std::size_t count)
{
    const auto window = static_cast<std::size_t>(a.window), step = static_cast<std::size_t>(a.step);
    if (count == 0 || (count >= window && (count - window) % step == 0)) return;
    const std::string more = " and any number of times " + std::to_string(a.step) + " more";
    badValue(std::to_string(count) + " indices, " + std::to_string(a.window) + more + " are needed");
}

} // namespace

Cells boxGrid(const glm::ivec3& boxes)
{
    Cells cells{CellKind::hexa, {}};
    const int line = boxes.x + 1, layer = line * (boxes.y + 1);
    for (int k = 0; k < boxes.z; ++k)
        for (int j = 0; j < boxes.y; ++j)
            for (int i = 0; i < boxes.x; ++i) {
                const int a = k * layer + j * line + i, b = a + layer;
                cells.add({a, a + 1, a + line + 1, a + line, b, b + 1, b + line + 1, b + line});
            }
    return cells;
}

Cells prismsOn(std::span<const std::array<int, 3>> triangles, int above)
{
    Cells prisms{CellKind::prism, {}};
    for (const auto& [a, b, c] : triangles)
        prisms.add({a, b, c, above + a, above + b, above + c});
    return prisms;
}

const Arrangement kTetraFaceStrip{CellKind::tetra, 4, 1, {0, 1, 2, 3}};
const Arrangement kTetraEdgeStrip{CellKind::tetra, 4, 2, {0, 1, 2, 3}};
const Arrangement kHexaSet{CellKind::hexa, 8, 8, {0, 1, 2, 3, 4, 5, 6, 7}};
const Arrangement kHexaStrip{CellKind::hexa, 8, 4, {0, 1, 2, 3, 4, 5, 6, 7}};
const Arrangement kPrismSet{CellKind::prism, 6, 6, {0, 1, 2, 3, 4, 5}};
const Arrangement kPrismFaceStrip{CellKind::prism, 6, 2, {0, 2, 4, 1, 3, 5}};
const Arrangement kPrismBaseStrip{CellKind::prism, 6, 3, {0, 1, 2, 3, 4, 5}};
const Arrangement kPrismEdgeStrip{CellKind::prism, 6, 4, {0, 2, 4, 1, 3, 5}};
const Arrangement kPyramidSet{CellKind::pyramid, 5, 5, {0, 1, 2, 3, 4}};
const Arrangement kPyramidStrip{CellKind::pyramid, 5, 2, {1, 2, 4, 3, kFirstOfAll}};

Cells cellsOf(const Arrangement& arrangement, std::span<const int> indices, int vertexCount)
{
    checkCount(arrangement, indices.size());
    for (const int index : indices)
        if (index < 0 || index >= vertexCount)
            badValue("vertex " + std::to_string(index) + " is outside 0 to " + std::to_string(vertexCount - 1));
    Cells cells{arrangement.kind, {}};
    const auto window = static_cast<std::size_t>(arrangement.window);
    const auto step = static_cast<std::size_t>(arrangement.step);
    const auto corners = static_cast<std::size_t>(shapeOf(arrangement.kind).corners);
    for (std::size_t first = 0; first + window <= indices.size(); first += step)
        for (std::size_t corner = 0; corner < corners; ++corner) {
            const int place = arrangement.place[corner];
            cells.corners.push_back(place == kFirstOfAll ? indices[0]
                                                         : indices[first + static_cast<std::size_t>(place)]);
        }
    return cells;
}

} // namespace vo
