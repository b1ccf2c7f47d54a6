#pragma once

#include "geometry/cell_split.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace vo {

/// Cells of one kind, the vertex numbers of one after those of another.
struct Cells
{
    CellKind kind;
    std::vector<int> corners;

    std::size_t count() const { return corners.size() / static_cast<std::size_t>(shapeOf(kind).corners); }
};

/// How a list of indices stands for cells: the first cell takes `window` of them, and each further one lies `step`
/// later. `place` says where in its window each corner stands; kFirstOfAll: the first index of the list.
struct Arrangement
{
    CellKind kind;
    int window;
    int step;
    std::array<int, kMostCorners> place;
};

constexpr int kFirstOfAll = -1;

extern const Arrangement kTetraFaceStrip, kTetraEdgeStrip, kHexaSet, kHexaStrip, kPrismSet, kPrismFaceStrip,
    kPrismBaseStrip, kPrismEdgeStrip, kPyramidSet, kPyramidStrip;

/// The cells that indices stand for. Throws CallerError where the indices are too many or too few, or point
/// outside 0 to vertexCount - 1.
Cells cellsOf(const Arrangement& arrangement, std::span<const int> indices, int vertexCount);

} // namespace vo
