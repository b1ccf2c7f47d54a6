#pragma once

#include "vout/tetra_mesh.h"

#include <span>
#include <vector>

namespace vo {

/// The triangles of a flat convex polygon, by its vertices' numbers, in its sense. From the vertex of the smallest number
/// where none of them is thin, else from another one, else as evenly as it can be.
std::vector<std::array<int, 3>> trianglesOf(std::span<const int> loop, const TetraMesh& mesh);

/// Fills a convex cell with tetrahedra on the triangles of its surface, counter-clockwise as seen from outside: from one of
/// its vertices that is so high above all others' triangles, else from a new one in its middle.
void fillCell(std::span<const std::array<int, 3>> surface, double leastHeight, TetraMesh& mesh,
              std::vector<Tetra>& tetras);

} // namespace vo
