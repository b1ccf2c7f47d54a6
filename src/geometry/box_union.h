#pragma once

#include "core/box.h"
#include "geometry/tetra_view.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace vo {

/// A set of tetrahedra that fill boxes with faces across the axes, each part once.
struct BoxUnion
{
    Box bounds; ///< of all vertices, those of flat tetrahedra as well
    /// Coordinates where faces lie, ascending, from one end of the bounds to the other.
    std::array<std::vector<double>, 3> planes;
    /// 1 between planes where tetrahedra are, x fastest.
    std::vector<std::uint8_t> covered;

    /// Whether all of a box inside the bounds is filled.
    bool covers(const Box& box) const;
};

/// The boxes; nothing where there are none, tetrahedra overlap, faces that no two share are not across axes,
/// or coordinates are no multiples of a half. Flat tetrahedra fill nothing. Sorts the faces of all
/// tetrahedra, unless a coordinate says at once that these are not boxes.
std::optional<BoxUnion> boxUnion(const TetraView& tetras);

} // namespace vo
