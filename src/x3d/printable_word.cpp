#include "x3d/printable_word.h"

namespace vo {

std::string printableWord(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string out(text.substr(0, kMost));
    for (char& letter : out)
        if (letter < ' ' || letter > '~') letter = '.';
    if (text.size() > kMost) out += "...";
    return out;
}

std::string quotedWord(std::string_view text)
{
    std::string out(1, '"');
    out += printableWord(text);
    out += '"';
    return out;
}

} // namespace vo
