#pragma once

#include "support/reference.h"

#include <array>
#include <functional>
#include <vector>

namespace vo::test {

/// What tetrahedra emit and absorb, in double precision and without samples on planes: each is crossed by a
/// ray once, what it does between the ends is integrated finely, and the pieces are put together by their
/// distance.
struct CellScene
{
    std::vector<Tetrahedron> tetras;
    /// Red, green, blue, and the opacity of a length of 1, inside a tetrahedron, from the weights of its
    /// corners.
    std::function<std::array<double, 4>(std::size_t tetra, const std::array<double, 4>& weights)> colorAt;
    View view;
    int width = 0; ///< pixels
    int height = 0;
};

/// The integral along the ray through each pixel's centre, over black. No pixel is masked.
Picture integrateCells(const CellScene& scene);

} // namespace vo::test
