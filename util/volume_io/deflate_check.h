#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace vo {

/// Whether `encoded` begins with a whole zlib stream, its checksum right, of at least `decodedBytes` bytes.
/// libtiff stops when it has the bytes that it wants and leaves the checksum unread, so that damage goes
/// unnoticed.
bool isSoundDeflate(std::span<const std::byte> encoded, std::int64_t decodedBytes);

} // namespace vo
