#pragma once

#include "core/serial.h"
#include "core/volume_size.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vo {

/// How a component of a texel is stored: unsigned numbers stand for 0 to 1, floats for themselves.
enum class TexelKind { uint8, uint16, float32 };

/// A texture of one, two or three dimensions (sizes of 1 beyond them): voxels, surface normals, transfer
/// functions. Texel i of n lies from i/n to (i+1)/n, its centre at (i + 1/2)/n. Not changed once it is made,
/// and shared.
struct VoxelTexture
{
    VoxelSize size;
    int components = 1; ///< L, LA, RGB or RGBA
    TexelKind kind = TexelKind::uint8;
    std::vector<std::byte> texels; ///< x fastest, then y, then z; components side by side
    bool nearest = false;          ///< the nearest texel alone, else linear between centres
    std::array<bool, 3> repeats{}; ///< along S, T and R; else what is outside has the value at the edge
    std::uint64_t serial = newSerial();
};

/// Bytes of one component: 1, 2 or 4.
constexpr std::size_t bytesOf(TexelKind kind)
{
    return kind == TexelKind::uint8 ? 1 : kind == TexelKind::uint16 ? 2 : 4;
}

} // namespace vo
