#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// How cells with faces of three and four corners fall into tetrahedra that meet those of their neighbours.
namespace vo {

/// What solids are made of. Corners: the bottom counter-clockwise as seen from above, then what is above it,
/// in the same order; a pyramid's tip comes last.
enum class CellKind { tetra, pyramid, prism, hexa };

constexpr int kMostCorners = 8;
constexpr int kMostFaces = 6;

/// A face: corner numbers counter-clockwise as seen from outside; three or four.
struct CellFace
{
    int corners;
    std::array<int, 4> corner;
};

/// The faces of a cell.
struct CellShape
{
    const char* name;
    int corners;
    int faces;
    std::array<CellFace, kMostFaces> face;
};

/// In the order of CellKind.
inline constexpr std::array<CellShape, 4> kCellShapes{
    {{"tetrahedron", 4, 4, {{{3, {0, 2, 1}}, {3, {0, 1, 3}}, {3, {1, 2, 3}}, {3, {2, 0, 3}}}}},
     {"pyramid", 5, 5, {{{4, {0, 3, 2, 1}}, {3, {0, 1, 4}}, {3, {1, 2, 4}}, {3, {2, 3, 4}}, {3, {3, 0, 4}}}}},
     {"prism",
      6,
      5,
      {{{3, {0, 2, 1}}, {3, {3, 4, 5}}, {4, {0, 1, 4, 3}}, {4, {1, 2, 5, 4}}, {4, {2, 0, 3, 5}}}}},
     {"hexahedron",
      8,
      6,
      {{{4, {0, 3, 2, 1}},
        {4, {4, 5, 6, 7}},
        {4, {0, 1, 5, 4}},
        {4, {1, 2, 6, 5}},
        {4, {2, 3, 7, 6}},
        {4, {3, 0, 4, 7}}}}}}};

constexpr const CellShape& shapeOf(CellKind kind)
{
    return kCellShapes[static_cast<std::size_t>(kind)];
}

/// Corner number of the point in the middle of a cell.
constexpr int kCellMiddle = kMostCorners;

/// Corner numbers of a tetrahedron of positive volume: d sees a, b, c clockwise, the first is a.
using CornerTetra = std::array<int, 4>;

/// Tetrahedra of a hexahedron that is cut from the middles of its faces, and of any cell at most.
constexpr int kMostPieces = 24;

/// One way to split a cell.
struct CellPieces
{
    int count = 0;
    std::array<CornerTetra, kMostPieces> tetra{};

    constexpr void add(const CornerTetra& piece) { tetra[static_cast<std::size_t>(count++)] = piece; }
    constexpr std::span<const CornerTetra> all() const&
    {
        return {tetra.data(), static_cast<std::size_t>(count)};
    }
    std::span<const CornerTetra> all() && = delete;
};

/// The box of five tetrahedra whose faces are cut between the corners 0, 2, 5 and 7, and its mirror image.
inline constexpr CellPieces kFiveOfBox[2] = {
    {5, {{{0, 5, 2, 7}, {3, 0, 2, 7}, {1, 5, 2, 0}, {2, 6, 7, 5}, {5, 0, 4, 7}}}},
    {5, {{{1, 3, 4, 6}, {2, 3, 1, 6}, {0, 3, 4, 1}, {3, 6, 7, 4}, {4, 5, 1, 6}}}},
};

/// For each face whether it is cut from its first corner to its third; else from its second to its fourth.
/// Of no meaning for faces of three corners.
using FaceCuts = std::array<bool, kMostFaces>;

/// Each face is cut from the smallest of its vertex numbers, by which the cells on both sides agree.
template <typename Vertex>
constexpr FaceCuts cutsFromSmallest(CellKind kind, std::span<const Vertex> cell)
{
    const CellShape& shape = shapeOf(kind);
    FaceCuts cuts{};
    for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f) {
        if (shape.face[f].corners < 4) continue;
        const auto vertex = [&](std::size_t i) {
            return cell[static_cast<std::size_t>(shape.face[f].corner[i])];
        };
        cuts[f] = std::min(vertex(0), vertex(2)) <= std::min(vertex(1), vertex(3));
    }
    return cuts;
}

/// Adds the tetrahedra from a point to the triangles of a face.
constexpr void addCone(int tip, const CellFace& face, bool fromFirst, CellPieces& pieces)
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

/// Tetrahedra from one corner to the faces opposite. None where a face at the corner is cut elsewhere.
constexpr std::optional<CellPieces> splitFromCorner(CellKind kind, const FaceCuts& cuts, int corner)
{
    const CellShape& shape = shapeOf(kind);
    CellPieces pieces;
    for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f) {
        const CellFace& face = shape.face[f];
        const auto end = face.corner.begin() + face.corners;
        const auto place = std::find(face.corner.begin(), end, corner);
        if (place == end) {
            addCone(corner, face, cuts[f], pieces);
        } else if (face.corners == 4 && cuts[f] != ((place - face.corner.begin()) % 2 == 0)) {
            return std::nullopt;
        }
    }
    return pieces;
}

/// Tetrahedra from the middle to all faces: possible whatever the cuts.
constexpr CellPieces splitFromMiddle(CellKind kind, const FaceCuts& cuts)
{
    const CellShape& shape = shapeOf(kind);
    CellPieces pieces;
    for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f)
        addCone(kCellMiddle, shape.face[f], cuts[f], pieces);
    return pieces;
}

/// The five of a hexahedron whose faces happen to be cut for them; null for others.
constexpr const CellPieces* fiveOfBox(const FaceCuts& cuts)
{
    const CellShape& shape = shapeOf(CellKind::hexa);
    unsigned ends = 0;
    for (std::size_t f = 0; f < kMostFaces; ++f)
        for (const std::size_t i : {std::size_t(0), std::size_t(2)})
            ends |= 1u << shape.face[f].corner[i + (cuts[f] ? 0 : 1)];
    constexpr unsigned kEven = 1u << 0 | 1u << 2 | 1u << 5 | 1u << 7;
    if ((ends & ~kEven) == 0) return &kFiveOfBox[0];
    if ((ends & kEven) == 0) return &kFiveOfBox[1];
    return nullptr;
}

/// Shows `visit` the ways to split a cell that its neighbours' faces allow, the one of fewest tetrahedra
/// first, that from the middle last, until it returns true. There are always ways without the middle: from
/// the corner of the smallest number. They fail only for cells out of shape.
template <typename Vertex, typename Visit>
constexpr void offerSplits(CellKind kind, std::span<const Vertex> cell, Visit visit)
{
    const FaceCuts cuts = cutsFromSmallest(kind, cell);
    if (kind == CellKind::tetra) {
        visit(CellPieces{1, {{{0, 1, 2, 3}}}});
        return;
    }
    if (kind == CellKind::hexa)
        if (const CellPieces* five = fiveOfBox(cuts); five && visit(*five)) return;
    const auto smallest = static_cast<int>(std::min_element(cell.begin(), cell.end()) - cell.begin());
    const int corners = shapeOf(kind).corners;
    for (int i = 0; i < corners; ++i) {
        const auto pieces = splitFromCorner(kind, cuts, (smallest + i) % corners);
        if (pieces && visit(*pieces)) return;
    }
    visit(splitFromMiddle(kind, cuts));
}

} // namespace vo
