#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "volume_io/printable_text.h"
#include "volume_io/result.h"

namespace vo {

/// Words and numbers of a text, or of the text parts of a file.
class TextScanner
{
public:
    TextScanner(const std::string& path, std::string_view text) : path_(path), text_(text) {}

    const std::string& path() const { return path_; }
    std::size_t position() const { return at_; }
    void seek(std::size_t position) { at_ = position; }
    std::size_t left() const { return text_.size() - at_; }
    std::string_view text() const { return text_; }
    /// The bytes from here on, passed over; the caller has looked at left().
    std::string_view take(std::size_t count)
    {
        const auto taken = text_.substr(at_, count);
        at_ += taken.size();
        return taken;
    }

    void skipBlanks()
    {
        while (at_ < text_.size() && isBlank(text_[at_]))
            ++at_;
    }
    bool atEnd()
    {
        skipBlanks();
        return at_ == text_.size();
    }
    /// The next word, "" at the end.
    std::string_view word()
    {
        skipBlanks();
        const std::size_t from = at_;
        while (at_ < text_.size() && !isBlank(text_[at_]))
            ++at_;
        return text_.substr(from, at_ - from);
    }
    /// The next word, which stays.
    std::string_view peek()
    {
        const std::size_t from = at_;
        const auto found = word();
        at_ = from;
        return found;
    }
    /// What is left of the line, without its end, which is passed over.
    std::string_view line()
    {
        const std::size_t end = text_.find('\n', at_);
        auto found = text_.substr(at_, end - at_);
        at_ = end == std::string_view::npos ? text_.size() : end + 1;
        if (found.ends_with('\r')) found.remove_suffix(1);
        return found;
    }
    /// The character that stands next is passed over, if it is this one.
    bool skip(char character)
    {
        skipBlanks();
        if (at_ == text_.size() || text_[at_] != character) return false;
        ++at_;
        return true;
    }

    /// The next number, which may end where a word does not: at a comma or a bracket. False, and nothing
    /// passed over, where there is none.
    template <typename Number>
    bool number(Number& value)
    {
        skipBlanks();
        const char* begin = text_.data() + at_;
        const char* const end = text_.data() + text_.size();
        if (begin != end && *begin == '+') ++begin;
        const auto parsed = std::from_chars(begin, end, value);
        if (parsed.ec == std::errc::invalid_argument) return false;
        if (parsed.ec == std::errc::result_out_of_range) {
            if constexpr (std::is_integral_v<Number>) return false;
            // Too small or too large for the type.
            const std::string_view digits(begin, static_cast<std::size_t>(parsed.ptr - begin));
            value = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos ? Number(0)
                                                                                         : Number(HUGE_VAL);
        }
        at_ = static_cast<std::size_t>(parsed.ptr - text_.data());
        return true;
    }

    /// Whether so many numbers could stand in what is left: each takes a digit and a blank.
    bool couldHold(std::int64_t numbers) const
    {
        return numbers >= 0 && static_cast<std::uint64_t>(numbers) <= (std::uint64_t(left()) + 1) / 2;
    }

    /// That something else stands here.
    Failure expected(const std::string& what)
    {
        const std::string found = atEnd() ? "the end" : printable(std::string(peek()), 40);
        return {path_ + ": " + place() + ": expected " + what + ", found \"" + found + "\""};
    }
    /// "line 12", or, in a file with other bytes than text, "byte 340".
    std::string place() const
    {
        if (text_.find('\0') != std::string_view::npos) return "byte " + std::to_string(at_);
        std::int64_t lines = 1;
        for (const char c : text_.substr(0, at_))
            lines += c == '\n';
        return "line " + std::to_string(lines);
    }

    static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

private:
    std::string path_;
    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace vo
