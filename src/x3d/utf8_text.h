#pragma once

#include <cstddef>
#include <string_view>

namespace vo {

/// Where bytes begin that are no UTF-8; npos where all are.
std::size_t firstWrongByte(std::string_view text);

} // namespace vo
