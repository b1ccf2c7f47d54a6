#include "deflate_check.h"

#include <algorithm>
#include <array>
#include <limits>
#include <zlib.h>

namespace vo {

bool isSoundDeflate(std::span<const std::byte> encoded, std::int64_t decodedBytes)
{
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return false;
    std::array<Bytef, 1 << 15> discarded;
    std::int64_t total = 0;
    int state = Z_OK;
    while (state == Z_OK) {
        if (stream.avail_in == 0) {
            const auto piece = std::min<std::size_t>(encoded.size(), std::numeric_limits<uInt>::max());
            stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(encoded.data()));
            stream.avail_in = static_cast<uInt>(piece);
            encoded = encoded.subspan(piece);
        }
        stream.next_out = discarded.data();
        stream.avail_out = static_cast<uInt>(discarded.size());
        state = inflate(&stream, Z_NO_FLUSH); // Z_BUF_ERROR where the stream is cut off
        total += static_cast<std::int64_t>(discarded.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && total >= decodedBytes;
}

} // namespace vo
