#pragma once

#include "core/serial.h"
#include "core/volume_size.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
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

/// Whether the texture has all the texels it says, one to four components each.
bool isUsable(const VoxelTexture& texture);

/// What component `index` of all that the texels have stands for.
inline float numberAt(const VoxelTexture& texture, std::size_t index)
{
    const std::byte* const at = texture.texels.data() + index * bytesOf(texture.kind);
    std::uint16_t whole = 0;
    float number = 0.0f;
    switch (texture.kind) {
    case TexelKind::uint8: return static_cast<float>(std::to_integer<int>(*at)) / 255.0f;
    case TexelKind::uint16:
        std::memcpy(&whole, at, sizeof whole);
        return static_cast<float>(whole) / 65535.0f;
    case TexelKind::float32: std::memcpy(&number, at, sizeof number); break;
    }
    return number;
}

/// "4 x 5 x 6".
std::string sizeText(const VoxelSize& size);

} // namespace vo
