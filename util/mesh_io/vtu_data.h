#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "volume_io/result.h"
#include "volume_io/volume_io.h"

namespace vo {

/// How the bytes of binary arrays stand in a VTU file.
struct VtuEncoding
{
    ByteOrder byteOrder = ByteOrder::littleEndian;
    /// Bytes of a number in front of the data: 4 or 8.
    int headerBytes = 4;
    bool compressed = false;
    bool base64 = true;
};

/// The `expected` bytes of an array that begins where `stored` does, which may hold more. `what` names the
/// file and the array for messages.
Result<std::string> vtuBytes(const VtuEncoding& encoding, std::string_view stored, std::int64_t expected,
                             const std::string& what);

} // namespace vo
