#pragma once

#include "vout/occupied_blocks.h"
#include "vout/tetra_mesh.h"

namespace vo {

/// Tetrahedra of boxes of a grid that do not overlap; they share whole faces, whatever the sizes of boxes that meet. V3F,
/// voxels. Two flat ones, the last, hold the volume's corners unless the boxes fill it. Throws CallerError where there are
/// more than ints can number.
TetraMesh blockTetras(const BlockGrid& grid, std::span<const BlockBox> boxes);

} // namespace vo
