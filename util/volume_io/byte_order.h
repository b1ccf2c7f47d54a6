#pragma once

#include <cstddef>
#include <span>

namespace vo {

/// Reverses the bytes of each number (of 2, 4 or 8 bytes) in place; numbers of one byte stay as they are.
void swapBytes(std::span<std::byte> bytes, int bytesPerNumber);

} // namespace vo
