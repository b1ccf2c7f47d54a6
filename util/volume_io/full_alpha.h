#pragma once

#include <array>
#include <cstddef>

#include "volume_io.h"

namespace vo {

/// The bytes of full alpha, for files that have none: the largest value of a type, 1 for float.
std::array<std::byte, 4> fullAlpha(ChannelType type);

} // namespace vo
