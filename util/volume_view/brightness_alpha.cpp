#include "brightness_alpha.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace vo {
namespace {

float brighter(float a, float b)
{
    return std::fmax(a, b);
}

template <typename Value>
Value brighter(Value a, Value b)
{
    return a < b ? b : a;
}

template <typename Value>
void setAlpha(std::span<std::byte> voxels)
{
    std::array<Value, 4> rgba;
    for (std::size_t i = 0; i < voxels.size(); i += sizeof rgba) {
        std::memcpy(&rgba, &voxels[i], sizeof rgba);
        rgba[3] = brighter(brighter(rgba[0], rgba[1]), rgba[2]);
        std::memcpy(&voxels[i], &rgba, sizeof rgba);
    }
}

} // namespace

void setBrightnessAlpha(ChannelType type, std::span<std::byte> voxels)
{
    switch (type) {
    case ChannelType::uint8: return setAlpha<std::uint8_t>(voxels);
    case ChannelType::int8: return setAlpha<std::int8_t>(voxels);
    case ChannelType::uint16: return setAlpha<std::uint16_t>(voxels);
    case ChannelType::int16: return setAlpha<std::int16_t>(voxels);
    case ChannelType::float32: return setAlpha<float>(voxels);
    }
}

} // namespace vo
