#pragma once

#include "polygonize/write_slices.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace vo {

/// What is known of some tetrahedra; the corners of each are sorted by position, which
/// is enough: an edge between two at one place is never cut.
struct TetraLooks
{
    static constexpr std::size_t kMost = 64;
    using Numbers = std::array<std::int32_t, kMost>;

    alignas(64) std::array<Numbers, 4> changes; ///< planes that have one corner more in front, from the least
    alignas(64) Numbers box;                    ///< the only one that holds it, far from all faces; or -1
    alignas(64) Numbers order;                  ///< as SlicedTetra has it
    alignas(64) Numbers mirrored;               ///< not 0: in this order it is negatively oriented
    alignas(64) Numbers solid;                  ///< 0: it has no volume, or one that is no number
};

/// Looks at up to TetraLooks::kMost tetrahedra, four vertex numbers each.
void lookAtTetras(const PlacedVertex* places, std::span<const int> vertices, TetraLooks& looks);

} // namespace vo
