#pragma once

#include "volume_io/volume_io.h"

#include <vo/Enums.h>

#include <optional>

/// The library's name of the type of a file's channels.
inline voDataType dataTypeOf(vo::ChannelType type)
{
    switch (type) {
    case vo::ChannelType::uint8: return voDataTypeScope::UNSIGNED_BYTE;
    case vo::ChannelType::int8: return voDataTypeScope::BYTE;
    case vo::ChannelType::uint16: return voDataTypeScope::UNSIGNED_SHORT;
    case vo::ChannelType::int16: return voDataTypeScope::SHORT;
    case vo::ChannelType::float32: return voDataTypeScope::FLOAT;
    }
    return voDataTypeScope::DEFAULT;
}

/// And back; nothing for types that no file arrives in.
inline std::optional<vo::ChannelType> channelTypeOf(voDataType dataType)
{
    for (const vo::ChannelType type : {vo::ChannelType::uint8, vo::ChannelType::int8, vo::ChannelType::uint16,
                                       vo::ChannelType::int16, vo::ChannelType::float32})
        if (dataTypeOf(type) == dataType) return type;
    return {};
}
