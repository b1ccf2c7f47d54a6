#include "numbered_name.h"

#include <cstdlib>

namespace vo {

std::optional<std::string> numberedName(const std::string& pattern, std::int64_t number)
{
    const auto percent = pattern.find('%');
    if (percent == std::string::npos) return std::nullopt;
    const auto letter = pattern.find_first_not_of("0123456789", percent + 1);
    if (letter == std::string::npos || pattern[letter] != 'd' || letter - percent > 4 ||
        pattern.find('%', letter) != std::string::npos)
        return std::nullopt;
    const std::string width = pattern.substr(percent + 1, letter - percent - 1);
    const bool zeros = width.starts_with('0');
    std::string digits = std::to_string(number);
    const auto wanted = width.empty() ? 0 : static_cast<std::size_t>(std::atoi(width.c_str()));
    if (digits.size() < wanted) digits.insert(0, wanted - digits.size(), zeros ? '0' : ' ');
    return pattern.substr(0, percent) + digits + pattern.substr(letter + 1);
}

} // namespace vo
