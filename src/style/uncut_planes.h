#pragma once

#include "style/styled_scene.h"

#include <cstddef>
#include <cstdint>

namespace vo {

/// Which of a surface's clip planes a triangle lies in but for rounding, given where it begins in
/// `triangles`: bit i for plane i, of the first 32. These do not cut it, wherever pixels look for edges.
std::uint32_t uncutPlanes(const StyledSurface& surface, std::size_t first);

/// Whether plane i is among them.
inline bool isUncut(std::uint32_t planes, std::size_t i)
{
    return i < 32 && (planes >> i & 1) != 0;
}

} // namespace vo
