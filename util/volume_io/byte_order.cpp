#include "byte_order.h"

#include <bit>
#include <utility>

#include "volume_io.h"

namespace vo {

ByteOrder nativeByteOrder()
{
    return std::endian::native == std::endian::big ? ByteOrder::bigEndian : ByteOrder::littleEndian;
}

void swapBytes(std::span<std::byte> bytes, int bytesPerChannel)
{
    if (bytesPerChannel == 2) {
        for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
            std::swap(bytes[i], bytes[i + 1]);
    } else if (bytesPerChannel == 4) {
        for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
            std::swap(bytes[i], bytes[i + 3]);
            std::swap(bytes[i + 1], bytes[i + 2]);
        }
    }
}

} // namespace vo
