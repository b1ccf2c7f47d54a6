#include "text_voxels.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>

#include "printable_text.h"

namespace vo {
namespace {

/// The bytes of a file one by one.
class Characters
{
public:
    Characters(const InputFile& file, std::int64_t offset) : file_(file), offset_(offset) {}

    /// -1 at the end of the file.
    Result<int> next()
    {
        if (used_ == filled_) {
            const auto count = std::min<std::int64_t>(static_cast<std::int64_t>(chunk_.size()),
                                                      std::max<std::int64_t>(file_.size() - offset_, 0));
            filled_ = static_cast<std::size_t>(count);
            used_ = 0;
            if (filled_ == 0) return -1;
            const auto part = std::as_writable_bytes(std::span(chunk_).first(filled_));
            if (auto read = file_.readAt(offset_, part); !read) return read.failure();
            offset_ += count;
        }
        return static_cast<int>(static_cast<unsigned char>(chunk_[used_++]));
    }

private:
    const InputFile& file_;
    std::int64_t offset_;
    std::array<char, 1 << 16> chunk_;
    std::size_t filled_ = 0, used_ = 0;
};

bool separates(int character)
{
    return character == ',' || (character >= 0 && character <= ' ');
}

template <class Number>
bool putNumber(const std::string& word, std::byte* out)
{
    const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const char* end = word.data() + word.size();
    Number number{};
    const auto parsed = std::from_chars(begin, end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) return false;
    std::memcpy(out, &number, sizeof number);
    return true;
}

bool putNumber(const std::string& word, StoredType type, std::byte* out)
{
    switch (type) {
    case StoredType::uint8: return putNumber<std::uint8_t>(word, out);
    case StoredType::int8: return putNumber<std::int8_t>(word, out);
    case StoredType::uint16: return putNumber<std::uint16_t>(word, out);
    case StoredType::int16: return putNumber<std::int16_t>(word, out);
    case StoredType::uint32: return putNumber<std::uint32_t>(word, out);
    case StoredType::int32: return putNumber<std::int32_t>(word, out);
    case StoredType::uint64: return putNumber<std::uint64_t>(word, out);
    case StoredType::int64: return putNumber<std::int64_t>(word, out);
    case StoredType::float32: return putNumber<float>(word, out);
    case StoredType::float64: return putNumber<double>(word, out);
    }
    return false;
}

int hexDigit(int character)
{
    if (character >= '0' && character <= '9') return character - '0';
    if (character >= 'a' && character <= 'f') return character - 'a' + 10;
    if (character >= 'A' && character <= 'F') return character - 'A' + 10;
    return -1;
}

} // namespace

Result<void> readNumberText(const InputFile& file, std::int64_t offset, StoredType type,
                            std::span<std::byte> out)
{
    constexpr std::size_t kLongestWord = 400;
    const auto step = static_cast<std::size_t>(bytesPerNumber(type));
    Characters characters(file, offset);
    std::string word;
    for (std::size_t at = 0; at < out.size();) {
        const auto character = characters.next();
        if (!character) return character.failure();
        if (*character >= 0 && !separates(*character) && word.size() < kLongestWord) {
            word += static_cast<char>(*character);
            continue;
        }
        if (!word.empty()) {
            if (!putNumber(word, type, out.data() + at)) {
                std::ranges::replace_if(
                    word, [](char c) { return c < ' ' || c > '~'; }, '.');
                return Failure{file.path() + ": expected a number of type " + storedTypeName(type) +
                               " as voxel value " + std::to_string(at / step) + ", found \"" +
                               printable(word, 40) + "\""};
            }
            word.clear();
            at += step;
        } else if (*character < 0) {
            return Failure{file.path() + ": cut off: expected " + std::to_string(out.size() / step) +
                           " numbers, found " + std::to_string(at / step)};
        }
    }
    return {};
}

Result<void> readHexBytes(const InputFile& file, std::int64_t offset, std::span<std::byte> out)
{
    Characters characters(file, offset);
    for (std::size_t digit = 0; digit < 2 * out.size();) {
        const auto character = characters.next();
        if (!character) return character.failure();
        if (separates(*character)) continue;
        const int value = hexDigit(*character);
        if (*character < 0)
            return Failure{file.path() + ": cut off: expected " + std::to_string(2 * out.size()) +
                           " hexadecimal digits, found " + std::to_string(digit)};
        if (value < 0)
            return Failure{file.path() + ": expected hexadecimal digits, found character " +
                           std::to_string(*character) + " after " + std::to_string(digit) + " of them"};
        std::byte& byte = out[digit / 2];
        byte = digit % 2 == 0 ? std::byte(value << 4) : byte | std::byte(value);
        ++digit;
    }
    return {};
}

} // namespace vo
