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

/// Finds slices, of which each tetrahedron meets few.
class TetraSlicer
{
public:
    /// Borrows both.
    TetraSlicer(const StyledTetras& tetras, const ShadowGrid& grid);

    TetraSlice slice(int z) const;

private:
    const StyledTetras& tetras_;
    const ShadowGrid& grid_;
    std::vector<std::vector<int>> near_; ///< the tetrahedra that may lie in each slice, in their order
};

/// What all tetrahedra lie in that are not flat and whose corners are there; nothing without any.
std::optional<LocalBox> boundsOf(const StyledTetras& tetras);

} // namespace vo
