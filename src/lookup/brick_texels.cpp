#include "lookup/brick_texels.h"

#include "appearance/convert_voxels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace vo {

namespace {

std::size_t numberOf(const VoxelSize& size, const std::array<int, 3>& index)
{
    const auto at = [&](std::size_t axis) { return static_cast<std::size_t>(index[axis]); };
    return at(0) + static_cast<std::size_t>(size.x) * (at(1) + static_cast<std::size_t>(size.y) * at(2));
}

glm::dvec4 texelAt(const BrickTexels& brick, std::size_t number)
{
    const std::size_t bytes = voxelBytes(brick.format);
    float c[4];
    decodeVoxels(brick.voxels.subspan(number * bytes, bytes), brick.format, 1, c);
    if (brick.classified) {
        applyTable(*brick.classified, c, 1);
        return {c[0], c[1], c[2], c[3]};
    }
    if (clampsTexels(brick.format.type))
        for (float& value : c)
            value = std::clamp(value, 0.0f, 1.0f);
    switch (brick.texel) {
    case TexelFormat::intensity: return {c[0], c[0], c[0], c[0]};
    case TexelFormat::luminance: return {c[0], c[0], c[0], 1.0};
    case TexelFormat::luminanceAlpha: return {c[0], c[0], c[0], c[3]};
    case TexelFormat::rgba: return {c[0], c[1], c[2], c[3]};
    case TexelFormat::rgb: return {c[0], c[1], c[2], 1.0};
    }
    return glm::dvec4(0.0);
}

} // namespace

bool clampsTexels(VoxelType type)
{
    switch (type) {
    case VoxelType::uint32:
    case VoxelType::int32:
    case VoxelType::float32: return false;
    case VoxelType::uint8:
    case VoxelType::int8:
    case VoxelType::uint8_332:
    case VoxelType::uint16:
    case VoxelType::int16:
    case VoxelType::uint16_4444:
    case VoxelType::uint16_5551:
    case VoxelType::uint32_8888:
    case VoxelType::uint32_1010102: break;
    }
    return true;
}

std::size_t nearestVoxel(const VoxelSize& size, const glm::dvec3& place)
{
    std::array<int, 3> index{};
    for (int axis = 0; axis < 3; ++axis)
        if (place[axis] > 0.0) // not for NaN
            index[static_cast<std::size_t>(axis)] =
                static_cast<int>(std::min(std::floor(place[axis]), size[axis] - 1.0));
    return numberOf(size, index);
}

glm::dvec4 filteredTexel(const BrickTexels& brick, const glm::dvec3& place)
{
    assert(brick.voxels.size() / voxelBytes(brick.format) >= brick.size.count());
    std::array<int, 3> below{}, above{};
    glm::dvec3 weight(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double last = brick.size[axis] - 1.0;
        const double inside = place[axis] > 0.5 ? std::min(place[axis] - 0.5, last) : 0.0;
        const auto a = static_cast<std::size_t>(axis);
        below[a] = static_cast<int>(inside);
        above[a] = std::min(below[a] + 1, brick.size[axis] - 1);
        weight[axis] = inside - below[a];
    }
    glm::dvec4 sum(0.0);
    for (unsigned corner = 0; corner < 8; ++corner) {
        std::array<int, 3> index{};
        double share = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool upper = corner >> axis & 1u;
            const double w = weight[static_cast<int>(axis)];
            index[axis] = upper ? above[axis] : below[axis];
            share *= upper ? w : 1.0 - w;
        }
        if (share > 0.0) sum += share * texelAt(brick, numberOf(brick.size, index));
    }
    return sum;
}

} // namespace vo
