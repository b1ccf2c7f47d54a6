#pragma once

#include <memory>
#include <vector>

#include "input_file.h"
#include "memory_block.h"

namespace vo {

/// Bytes of a file from some place on that are compressed with gzip or zlib, decoded from front to back. Gzip
/// members that follow each other are one stream.
class DeflateStream
{
public:
    /// `file` must stay while this object lives.
    DeflateStream(const InputFile& file, std::int64_t offset);
    DeflateStream(DeflateStream&&) noexcept;
    ~DeflateStream();

    /// Fills `out`; a failure where the stream is damaged or ends before.
    Result<void> read(std::span<std::byte> out);
    /// As many bytes as there are, up to the size of `out`; how many.
    Result<std::int64_t> readSome(std::span<std::byte> out);
    /// Passes over `bytes` bytes.
    Result<void> skip(std::int64_t bytes);
    /// Decodes what is left, so that its checksums are compared.
    Result<void> finish();

    /// Reads `bytes` bytes into memory of their own, then finish(). What no compressed file of this size can
    /// hold is refused before memory is asked for.
    Result<MemoryBlock> readBlock(std::int64_t bytes);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Whether `bytes` begin like a gzip file.
bool beginsLikeGzip(std::span<const std::byte> bytes);

} // namespace vo
