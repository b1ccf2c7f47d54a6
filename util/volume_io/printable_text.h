#pragma once

#include <string>

namespace vo {

/// The beginning of text from a file, fit to stand in a message: anything but ASCII letters and signs becomes
/// a dot.
inline std::string printable(std::string text, std::size_t most = 80)
{
    if (text.size() > most) text.resize(most);
    for (char& letter : text)
        if (letter < ' ' || letter > '~') letter = '.';
    return text;
}

} // namespace vo
