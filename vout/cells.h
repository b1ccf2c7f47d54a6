#pragma once

#include "geometry/cell_split.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace vo {

/// Cells of one kind, the vertex numbers of one after those of another.
struct Cells
{
    CellKind kind;
    std::vector<int> corners;

    std::size_t count() const { return corners.size() / static_cast<std::size_t>(shapeOf(kind).corners); }
    void add(std::initializer_list<int> cell) { corners.insert(corners.end(), cell); }
};

/// The boxes of a grid, so many along x, y and z; its vertices are numbered along x, then y, then z.
Cells boxGrid(const glm::ivec3& boxes);

/// A prism on each triangle, up to the vertices whose numbers are `above` more.
Cells prismsOn(std::span<const std::array<int, 3>> triangles, int above);

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
