#pragma once

#include "style/voxel_texture.h"

#include <algorithm>
#include <cstdint>

namespace vo {

/// Lists of texels lie in textures of three dimensions, row after row and slice after slice, which hold more
/// than one row could: every OpenGL has 256 texels on an axis.
constexpr std::uint64_t kListRow = 256;

/// The texture that holds so many.
inline VoxelSize listSize(std::uint64_t texels)
{
    const std::uint64_t rows = std::max<std::uint64_t>((texels + kListRow - 1) / kListRow, 1);
    const std::uint64_t slices = (rows + kListRow - 1) / kListRow;
    return {static_cast<int>(rows > 1 ? kListRow : std::max<std::uint64_t>(texels, 1)),
            static_cast<int>(slices > 1 ? kListRow : rows), static_cast<int>(slices)};
}

/// GLSL: the place of a texel by its number.
constexpr const char* kListPlaceGlsl =
    "ivec3 listPlace(int i) { return ivec3(i & 255, i >> 8 & 255, i >> 16); }\n";

} // namespace vo
