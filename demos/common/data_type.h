#pragma once

#include "volume_io/volume_io.h"

#include <vo/Enums.h>

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
