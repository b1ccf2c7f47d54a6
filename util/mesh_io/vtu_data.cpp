#include "vtu_data.h"

#include <algorithm>
#include <vector>
#include <zlib.h>

#include "stored_numbers.h"

namespace vo {
namespace {

// Deflate makes at most 1032 bytes of one.
constexpr std::int64_t kMostBytesPerStoredByte = 1032;

int base64Digit(char c)
{
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// The bytes of an array from front to back. In base64 parts may follow each other that are padded each.
class StoredBytesOf
{
public:
    StoredBytesOf(bool base64, std::string_view stored) : base64_(base64), stored_(stored) {}

    /// Bytes that are left, at most.
    std::int64_t most() const
    {
        const auto left = static_cast<std::int64_t>(stored_.size() - at_);
        return waiting_ + (base64_ ? left / 4 * 3 + 3 : left);
    }
    /// Appends `count` bytes to `out`; false where there are less.
    bool take(std::int64_t count, std::string& out)
    {
        if (count > most()) return false;
        out.reserve(out.size() + static_cast<std::size_t>(count));
        if (!base64_) {
            const auto part = stored_.substr(at_, static_cast<std::size_t>(count));
            at_ += part.size();
            out += part;
            return true;
        }
        for (; count > 0; --count) {
            if (waiting_ == 0 && !decodeFour()) return false;
            out += decoded_[static_cast<std::size_t>(decodedCount_ - waiting_--)];
        }
        return true;
    }

private:
    /// The next four digits.
    bool decodeFour()
    {
        unsigned bits = 0;
        int digits = 0, padding = 0;
        while (digits + padding < 4) {
            if (at_ == stored_.size()) return false;
            const char c = stored_[at_];
            const int digit = base64Digit(c);
            if (digit >= 0 && padding == 0) {
                bits = bits << 6 | static_cast<unsigned>(digit);
                ++digits;
            } else if (c == '=') {
                bits <<= 6;
                ++padding;
            } else if (c != ' ' && c != '\n' && c != '\r' && c != '\t') {
                return false;
            }
            ++at_;
        }
        for (std::size_t i = 0; i < 3; ++i)
            decoded_[i] = static_cast<char>(bits >> (16 - 8 * i));
        waiting_ = decodedCount_ = digits - 1;
        return waiting_ > 0;
    }

    bool base64_;
    std::string_view stored_;
    std::size_t at_ = 0;
    std::array<char, 3> decoded_{};
    int decodedCount_ = 0, waiting_ = 0;
};

class ArrayReader
{
public:
    ArrayReader(const VtuEncoding& encoding, std::string_view stored, const std::string& what)
        : encoding_(encoding), stored_(encoding.base64, stored), what_(what)
    {
    }

    Result<std::string> read(std::int64_t expected)
    {
        if (encoding_.compressed) return decompress(expected);
        std::string bytes;
        std::int64_t found = 0;
        if (!number(found)) return cutOff();
        if (found != expected) return wrongSize(expected, found);
        if (!stored_.take(expected, bytes)) return cutOff();
        return bytes;
    }

private:
    bool number(std::int64_t& value)
    {
        std::string bytes;
        if (!stored_.take(encoding_.headerBytes, bytes)) return false;
        value = encoding_.headerBytes == 8
                    ? storedNumber<std::int64_t>(bytes.data(), encoding_.byteOrder)
                    : std::int64_t(storedNumber<std::uint32_t>(bytes.data(), encoding_.byteOrder));
        return true;
    }
    Failure cutOff() const { return {what_ + ": cut off, or no base64: expected more bytes, found the end"}; }
    Failure wrongSize(std::int64_t expected, std::int64_t found) const
    {
        return {what_ + ": expected " + std::to_string(expected) + " bytes, found " + std::to_string(found)};
    }

    /// Blocks of one size but for the last, each compressed; in front of them their number and sizes.
    Result<std::string> decompress(std::int64_t expected)
    {
        std::int64_t blocks = 0, size = 0, lastSize = 0;
        if (!number(blocks)) return cutOff();
        if (blocks == 0) return expected == 0 ? Result<std::string>(std::string()) : wrongSize(expected, 0);
        if (!number(size) || !number(lastSize)) return cutOff();
        if (blocks < 0 || size < 0 || lastSize < 0 || blocks > stored_.most() / encoding_.headerBytes)
            return Failure{what_ + ": expected the sizes of compressed blocks, found " +
                           std::to_string(blocks) + " blocks of " + std::to_string(size) + " bytes"};
        std::int64_t total = 0;
        if (__builtin_mul_overflow(blocks - (lastSize > 0), size, &total) ||
            __builtin_add_overflow(total, lastSize, &total) || total != expected)
            return wrongSize(expected, total);
        if (total / kMostBytesPerStoredByte > stored_.most())
            return Failure{what_ + ": expected " + std::to_string(total) + " bytes, found at most " +
                           std::to_string(stored_.most()) + " compressed ones, which cannot hold them"};
        std::vector<std::int64_t> packedSizes(static_cast<std::size_t>(blocks));
        for (std::int64_t& packed : packedSizes)
            if (!number(packed) || packed < 0) return cutOff();
        std::string out(static_cast<std::size_t>(total), '\0');
        std::int64_t at = 0;
        for (std::size_t i = 0; i < packedSizes.size(); ++i) {
            const std::int64_t wanted = i + 1 == packedSizes.size() && lastSize > 0 ? lastSize : size;
            std::string packed;
            if (!stored_.take(packedSizes[i], packed)) return cutOff();
            uLongf length = static_cast<uLongf>(wanted);
            const int result =
                uncompress(reinterpret_cast<Bytef*>(out.data()) + at, &length,
                           reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
            if (result != Z_OK || length != static_cast<uLongf>(wanted))
                return Failure{what_ + ": damaged: cannot decompress block " + std::to_string(i)};
            at += wanted;
        }
        return out;
    }

    VtuEncoding encoding_;
    StoredBytesOf stored_;
    std::string what_;
};

} // namespace

Result<std::string> vtuBytes(const VtuEncoding& encoding, std::string_view stored, std::int64_t expected,
                             const std::string& what)
{
    return ArrayReader(encoding, stored, what).read(expected);
}

} // namespace vo
