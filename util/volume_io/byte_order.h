#pragma once

#include <cstddef>
#include <span>

namespace vo {

/// Reverses the bytes of each channel in place; channels of one byte stay as they are.
void swapBytes(std::span<std::byte> bytes, int bytesPerChannel);

} // namespace vo
