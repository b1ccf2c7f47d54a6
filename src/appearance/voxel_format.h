#pragma once

#include <cstddef>

namespace vo {

/// Order and number of the channels of a voxel.
enum class Channels { intensity, luminance, luminanceAlpha, rgba, abgr };

/// How a channel, or for the packed types a whole voxel, is stored; host byte order.
enum class VoxelType {
    uint8,
    int8,
    uint8_332,
    uint16,
    int16,
    uint16_4444,
    uint16_5551,
    uint32,
    int32,
    uint32_8888,
    uint32_1010102,
    float32
};

/// What a texture holds and answers when sampled: (I,I,I,I), (L,L,L,1), (L,L,L,A), (R,G,B,A), (R,G,B,1).
enum class TexelFormat { intensity, luminance, luminanceAlpha, rgba, rgb };

struct VoxelFormat
{
    Channels channels = Channels::luminance;
    VoxelType type = VoxelType::uint8;
    friend bool operator==(const VoxelFormat&, const VoxelFormat&) = default;
};

bool isPacked(VoxelType type);
/// 1, 2 or 4.
int channelCount(Channels channels);
/// Bytes of one voxel.
std::size_t voxelBytes(VoxelFormat format);
/// Packed types hold all channels in one number, the first in its highest bits. 3_3_2 has red, green and
/// blue, goes with rgba and reads as opaque; the others hold the four channels of rgba or abgr. True when the
/// format can exist.
bool isValid(VoxelFormat format);

} // namespace vo
