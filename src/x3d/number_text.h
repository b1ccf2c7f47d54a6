#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace vo {

/// A number that fills the whole word and is finite. Numbers too small for the type become 0; a sign and an
/// exponent may have a plus.
template <typename Number>
bool parseNumber(std::string_view word, Number& number)
{
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, number);
    if (parsed.ec == std::errc::result_out_of_range && parsed.ptr == end) {
        const auto exponent = word.find_first_of("eE");
        const bool isTiny = exponent != word.npos && exponent + 1 < word.size() && word[exponent + 1] == '-';
        number = 0;
        return isTiny || word.find_first_not_of("-0.") == word.npos ||
               (exponent == word.npos && (word.starts_with("0.") || word.starts_with("-0.") ||
                                          word.starts_with(".") || word.starts_with("-.")));
    }
    return parsed.ec == std::errc() && parsed.ptr == end && std::isfinite(number);
}

/// A whole number in 32 bits, decimal or hexadecimal (0x...). Hexadecimal ones may use all bits, decimal ones
/// only where `mayBeUnsigned`: what is above 2^31 - 1 becomes negative.
inline bool parseInteger(std::string_view word, bool mayBeUnsigned, std::int32_t& number)
{
    const bool isNegative = word.starts_with('-');
    if (isNegative || word.starts_with('+')) word.remove_prefix(1);
    const bool isHex = word.starts_with("0x") || word.starts_with("0X");
    if (isHex) word.remove_prefix(2);
    std::uint64_t size = 0;
    const char* const end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, size, isHex ? 16 : 10);
    if (parsed.ec != std::errc() || parsed.ptr != end) return false;
    const std::uint64_t most = isNegative ? 0x80000000u : isHex || mayBeUnsigned ? 0xffffffffu : 0x7fffffffu;
    if (size > most) return false;
    const auto bits = static_cast<std::uint32_t>(size);
    number = static_cast<std::int32_t>(isNegative ? 0u - bits : bits);
    return true;
}

/// The shortest text that is read as the same number.
template <typename Number>
std::string numberText(Number number)
{
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    return {digits, end};
}

} // namespace vo
