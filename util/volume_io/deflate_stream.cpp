#include "deflate_stream.h"

#include <algorithm>
#include <array>
#include <zlib.h>

namespace vo {
namespace {

// Deflate makes at most 1032 bytes of one.
constexpr std::int64_t kMostBytesPerFileByte = 1032;
constexpr int kGzipOrZlib = 15 + 32;
constexpr std::size_t kChunk = 1 << 16;

} // namespace

struct DeflateStream::State
{
    State(const InputFile& from, std::int64_t at) : file(from), offset(at)
    {
        ready = inflateInit2(&stream, kGzipOrZlib) == Z_OK;
    }
    ~State()
    {
        if (ready) inflateEnd(&stream);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    Failure damaged(const char* what) const
    {
        return {file.path() + ": damaged: cannot decompress before byte " + std::to_string(offset) + ": " +
                (stream.msg ? stream.msg : what)};
    }
    Result<void> refill();
    Result<bool> beginsNextMember();

    const InputFile& file;
    std::int64_t offset; // of the encoded bytes to come
    std::array<std::byte, kChunk> encoded;
    z_stream stream{};
    bool ready = false;
    bool ended = false;
};

Result<void> DeflateStream::State::refill()
{
    if (stream.avail_in > 0) return {};
    const auto count =
        std::min<std::int64_t>(static_cast<std::int64_t>(encoded.size()), file.size() - offset);
    if (count <= 0)
        return Failure{file.path() + ": cut off: expected more compressed voxels, found the end of the file"};
    if (auto read = file.readAt(offset, std::span(encoded).first(std::size_t(count))); !read) return read;
    offset += count;
    stream.next_in = reinterpret_cast<Bytef*>(encoded.data());
    stream.avail_in = static_cast<uInt>(count);
    return {};
}

/// After the end of a member: whether another gzip member follows. Anything else, padding mostly, is ignored.
Result<bool> DeflateStream::State::beginsNextMember()
{
    if (stream.avail_in == 0 && offset >= file.size()) return false;
    if (auto filled = refill(); !filled) return filled.failure();
    if (stream.next_in[0] != 0x1f) return false;
    if (inflateReset(&stream) != Z_OK) return damaged("cannot go on");
    return true;
}

DeflateStream::DeflateStream(const InputFile& file, std::int64_t offset)
    : state_(std::make_unique<State>(file, offset))
{
}
DeflateStream::DeflateStream(DeflateStream&&) noexcept = default;
DeflateStream::~DeflateStream() = default;

Result<std::int64_t> DeflateStream::readSome(std::span<std::byte> out)
{
    State& state = *state_;
    if (!state.ready) return state.damaged("no memory for the decompressor");
    const auto wanted = static_cast<std::int64_t>(out.size());
    while (!out.empty() && !state.ended) {
        if (auto filled = state.refill(); !filled) return filled.failure();
        const auto piece = std::min<std::size_t>(out.size(), 1u << 30);
        state.stream.next_out = reinterpret_cast<Bytef*>(out.data());
        state.stream.avail_out = static_cast<uInt>(piece);
        const int result = inflate(&state.stream, Z_NO_FLUSH);
        out = out.subspan(piece - state.stream.avail_out);
        if (result == Z_STREAM_END) {
            const auto next = state.beginsNextMember();
            if (!next) return next.failure();
            state.ended = !*next;
        } else if (result != Z_OK && result != Z_BUF_ERROR) {
            return state.damaged("no deflate stream");
        }
    }
    return wanted - static_cast<std::int64_t>(out.size());
}

Result<void> DeflateStream::read(std::span<std::byte> out)
{
    const auto count = readSome(out);
    if (!count) return count.failure();
    if (*count == static_cast<std::int64_t>(out.size())) return {};
    return Failure{state_->file.path() + ": expected " +
                   std::to_string(static_cast<std::int64_t>(out.size()) - *count) +
                   " more bytes, found the end of the compressed data"};
}

Result<void> DeflateStream::skip(std::int64_t bytes)
{
    std::array<std::byte, kChunk> passed;
    for (; bytes > 0; bytes -= static_cast<std::int64_t>(passed.size())) {
        const auto count = std::min<std::int64_t>(bytes, static_cast<std::int64_t>(passed.size()));
        if (auto done = read(std::span(passed).first(std::size_t(count))); !done) return done;
    }
    return {};
}

Result<void> DeflateStream::finish()
{
    std::array<std::byte, kChunk> passed;
    for (;;) {
        const auto count = readSome(passed);
        if (!count) return count.failure();
        if (*count < static_cast<std::int64_t>(passed.size())) return {};
    }
}

Result<MemoryBlock> DeflateStream::readBlock(std::int64_t bytes)
{
    const InputFile& file = state_->file;
    if (bytes / kMostBytesPerFileByte > file.size())
        return Failure{file.path() + ": expected " + std::to_string(bytes) +
                       " bytes of voxels, found a compressed file of " + std::to_string(file.size()) +
                       " bytes, which cannot hold them"};
    auto block = MemoryBlock::allocate(file.path(), bytes);
    if (!block) return block.failure();
    if (auto done = read(block->bytes()); !done) return done.failure();
    if (auto done = finish(); !done) return done.failure();
    return block;
}

bool beginsLikeGzip(std::span<const std::byte> bytes)
{
    return bytes.size() >= 3 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b} &&
           bytes[2] == std::byte{8};
}

} // namespace vo
