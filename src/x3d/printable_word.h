#pragma once

#include <string>
#include <string_view>

namespace vo {

/// The beginning of text from a file, fit to stand in a message: anything but ASCII letters and signs becomes
/// a dot.
std::string printableWord(std::string_view text);
/// The same in quotes.
std::string quotedWord(std::string_view text);

} // namespace vo
