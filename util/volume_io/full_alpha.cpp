#include "full_alpha.h"

#include <cstring>
#include <limits>

namespace vo {

std::array<std::byte, 4> fullAlpha(ChannelType type)
{
    std::array<std::byte, 4> bytes{};
    const auto put = [&bytes](auto value) { std::memcpy(bytes.data(), &value, sizeof value); };
    switch (type) {
    case ChannelType::uint8: put(std::numeric_limits<std::uint8_t>::max()); break;
    case ChannelType::int8: put(std::numeric_limits<std::int8_t>::max()); break;
    case ChannelType::uint16: put(std::numeric_limits<std::uint16_t>::max()); break;
    case ChannelType::int16: put(std::numeric_limits<std::int16_t>::max()); break;
    case ChannelType::float32: put(1.0f); break;
    }
    return bytes;
}

} // namespace vo
