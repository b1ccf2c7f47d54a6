#pragma once

#include "vout/cells.h"
#include "vout/tetra_mesh.h"

namespace vo {

/// How hexahedra are split: `five` by a table, in its two mirror images; `fromSmallest` as every other cell;
/// `fromMiddles` into 24.
enum class HexaSplit { five = 5, fromSmallest = 6, fromMiddles = 24 };

/// The split into so many tetrahedra. Throws CallerError where there is none.
HexaSplit hexaSplit(int tetras);

/// Appends the tetrahedra of cells whose corners are vertices of the mesh. A face of four corners is cut from the
/// smallest of its vertex numbers (but see HexaSplit), so that neighbours agree. Cells whose shape does not allow what
/// their faces ask for get a vertex in the middle. Tetrahedra have positive volumes; those that are flat are left out.
/// Returns how many are. Throws CallerError for a cell that is partly inside out, or too many.
std::size_t splitCells(const Cells& cells, HexaSplit split, TetraMesh& mesh);

} // namespace vo
