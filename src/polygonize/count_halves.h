#pragma once

#include "polygonize/write_slices.h"

#include <array>

namespace vo {

/// Adds what planes make of a tetrahedron of bare positions below and above the face that parts it to the
/// counts of each plane; null: nobody counts these. `corners` are in order. Returns the first plane that it
/// does not do, because a vertex of a slice is too close to the face, say, or the end of all.
int countHalves(const std::array<const PlacedVertex*, 4>& corners, const HalvedTetra& tetra,
                const PlaneFamily& planes, const std::array<StackCount*, 2>& counts);

/// Counts up to so many planes behind the last one are read and written again as they were.
constexpr std::size_t kCountsBeyond = 8;

} // namespace vo
