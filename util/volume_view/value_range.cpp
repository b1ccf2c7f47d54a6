#include "value_range.h"

namespace vo {
namespace {

template <typename Value>
void growBy(ValueRange& range, const std::byte* values, std::size_t count)
{
    growRange(range, reinterpret_cast<const Value*>(values), count);
}

template <typename Value>
ValueRange allOf()
{
    return {double(std::numeric_limits<Value>::lowest()), double(std::numeric_limits<Value>::max())};
}

} // namespace

void growRange(ValueRange& range, ChannelType type, const std::byte* values, std::size_t count)
{
    switch (type) {
    case ChannelType::uint8: return growBy<std::uint8_t>(range, values, count);
    case ChannelType::int8: return growBy<std::int8_t>(range, values, count);
    case ChannelType::uint16: return growBy<std::uint16_t>(range, values, count);
    case ChannelType::int16: return growBy<std::int16_t>(range, values, count);
    case ChannelType::float32: return growBy<float>(range, values, count);
    }
}

ValueRange fullRange(ChannelType type)
{
    switch (type) {
    case ChannelType::uint8: return allOf<std::uint8_t>();
    case ChannelType::int8: return allOf<std::int8_t>();
    case ChannelType::uint16: return allOf<std::uint16_t>();
    case ChannelType::int16: return allOf<std::int16_t>();
    case ChannelType::float32: break;
    }
    return {0, 1};
}

} // namespace vo
