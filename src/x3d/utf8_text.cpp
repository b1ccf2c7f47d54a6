#include "x3d/utf8_text.h"

#include <algorithm>
#include <cstdint>

namespace vo {
namespace {

/// Bytes of a character that begins like this; 0 where none does.
std::size_t lengthOf(unsigned char first)
{
    return first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
}

/// Characters that are written longer than they need, halves of pairs, and what is beyond the last.
bool isForbidden(std::uint32_t code, std::size_t length)
{
    return (length == 3 && code < 0x800) || (length == 4 && code < 0x10000) || code > 0x10ffff ||
           (code >= 0xd800 && code < 0xe000);
}

/// Whether a character of so many bytes stands here.
bool isCharacter(std::string_view text, std::size_t length)
{
    std::uint32_t code = static_cast<unsigned char>(text[0]) & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto next = static_cast<unsigned char>(text[i]);
        if ((next & 0xc0u) != 0x80) return false;
        code = code << 6 | (next & 0x3fu);
    }
    return !isForbidden(code, length);
}

} // namespace

std::size_t firstWrongByte(std::string_view text)
{
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = lengthOf(static_cast<unsigned char>(text[at]));
        if (length == 0 || length > text.size() - at) return at;
        if (length > 1 && !isCharacter(text.substr(at), length)) return at;
        at += length;
    }
    return text.npos;
}

} // namespace vo
