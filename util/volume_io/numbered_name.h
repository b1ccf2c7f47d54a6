#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vo {

/// `pattern` with a number in place of its %d, %3d or %03d; nothing where there is no or another conversion.
std::optional<std::string> numberedName(const std::string& pattern, std::int64_t number);

} // namespace vo
