#include "byte_order.h"

#include <bit>
#include <utility>

#include "volume_io.h"

namespace vo {
namespace {

template <std::size_t Size>
void swapEach(std::span<std::byte> bytes)
{
    for (std::size_t i = 0; i + Size <= bytes.size(); i += Size)
        for (std::size_t k = 0; k < Size / 2; ++k)
            std::swap(bytes[i + k], bytes[i + Size - 1 - k]);
}

} // namespace

ByteOrder nativeByteOrder()
{
    return std::endian::native == std::endian::big ? ByteOrder::bigEndian : ByteOrder::littleEndian;
}

void swapBytes(std::span<std::byte> bytes, int bytesPerNumber)
{
    switch (bytesPerNumber) {
    case 2: return swapEach<2>(bytes);
    case 4: return swapEach<4>(bytes);
    case 8: return swapEach<8>(bytes);
    default: break;
    }
}

} // namespace vo
