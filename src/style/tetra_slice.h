#pragma once

#include "style/shadow_grid.h"

#include <optional>
#include <vector>

namespace vo {

/// The texels of one slice of a grid by the tetrahedra in which their centres lie.
struct TetraSlice
{
    std::vector<int> tetras;       ///< of each texel, the first of several; below 0: none
    std::vector<glm::vec3> places; ///< S, T, R of each texel that lies in one
};

TetraSlice tetraSliceOf(const StyledTetras& tetras, const ShadowGrid& grid, int z);

/// What all tetrahedra lie in that are not flat and whose corners are there; nothing without any.
std::optional<LocalBox> boundsOf(const StyledTetras& tetras);

} // namespace vo
