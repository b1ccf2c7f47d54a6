#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

#include "volume_io/stored_voxels.h"

namespace vo {

/// A number of any type and byte order, at any address.
template <typename Number>
Number storedNumber(const char* from, ByteOrder order)
{
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), from, sizeof(Number));
    if (order != nativeByteOrder()) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
}

/// Calls `work` with a value of the type.
template <typename Work>
void withNumberOf(StoredType type, Work work)
{
    switch (type) {
    case StoredType::uint8: return work(std::uint8_t());
    case StoredType::int8: return work(std::int8_t());
    case StoredType::uint16: return work(std::uint16_t());
    case StoredType::int16: return work(std::int16_t());
    case StoredType::uint32: return work(std::uint32_t());
    case StoredType::int32: return work(std::int32_t());
    case StoredType::uint64: return work(std::uint64_t());
    case StoredType::int64: return work(std::int64_t());
    case StoredType::float32: return work(float());
    case StoredType::float64: return work(double());
    }
}

inline bool isWhole(StoredType type)
{
    return type != StoredType::float32 && type != StoredType::float64;
}

/// Numbers of a type that fill `bytes`, one after the other. Of what is no whole number, whole ones are
/// asked for by no caller.
template <typename Out>
void convertNumbers(StoredType type, ByteOrder order, std::string_view bytes, Out* out)
{
    withNumberOf(type, [&]<typename Number>(Number) {
        for (std::size_t i = 0; i + sizeof(Number) <= bytes.size(); i += sizeof(Number))
            *out++ = static_cast<Out>(storedNumber<Number>(bytes.data() + i, order));
    });
}

} // namespace vo
