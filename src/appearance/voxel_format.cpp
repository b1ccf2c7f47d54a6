#include "appearance/voxel_format.h"

namespace vo {

namespace {

std::size_t typeBytes(VoxelType type)
{
    switch (type) {
    case VoxelType::uint8:
    case VoxelType::int8:
    case VoxelType::uint8_332: return 1;
    case VoxelType::uint16:
    case VoxelType::int16:
    case VoxelType::uint16_4444:
    case VoxelType::uint16_5551: return 2;
    case VoxelType::uint32:
    case VoxelType::int32:
    case VoxelType::uint32_8888:
    case VoxelType::uint32_1010102:
    case VoxelType::float32: return 4;
    }
    return 0;
}

} // namespace

bool isPacked(VoxelType type)
{
    switch (type) {
    case VoxelType::uint8_332:
    case VoxelType::uint16_4444:
    case VoxelType::uint16_5551:
    case VoxelType::uint32_8888:
    case VoxelType::uint32_1010102: return true;
    case VoxelType::uint8:
    case VoxelType::int8:
    case VoxelType::uint16:
    case VoxelType::int16:
    case VoxelType::uint32:
    case VoxelType::int32:
    case VoxelType::float32: return false;
    }
    return false;
}

int channelCount(Channels channels)
{
    switch (channels) {
    case Channels::intensity:
    case Channels::luminance: return 1;
    case Channels::luminanceAlpha: return 2;
    case Channels::rgba:
    case Channels::abgr: return 4;
    }
    return 0;
}

std::size_t voxelBytes(VoxelFormat format)
{
    const std::size_t bytes = typeBytes(format.type);
    return isPacked(format.type) ? bytes : bytes * static_cast<std::size_t>(channelCount(format.channels));
}

bool isValid(VoxelFormat format)
{
    if (!isPacked(format.type)) return true;
    if (format.type == VoxelType::uint8_332) return format.channels == Channels::rgba;
    return channelCount(format.channels) == 4;
}

} // namespace vo
