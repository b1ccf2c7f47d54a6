#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <string>

#include "result.h"

namespace vo {

/// Bytes of a size that a file decides, without initial values. Running out of memory is a failure, not an
/// exception.
class MemoryBlock
{
public:
    MemoryBlock() = default;

    /// `path` begins the message.
    static Result<MemoryBlock> allocate(const std::string& path, std::int64_t bytes)
    {
        MemoryBlock block;
        block.bytes_.reset(new (std::nothrow) std::byte[static_cast<std::size_t>(bytes)]);
        if (!block.bytes_)
            return Failure{path + ": expected memory for " + std::to_string(bytes) +
                           " bytes of voxels, found less"};
        block.size_ = bytes;
        return block;
    }

    std::span<std::byte> bytes() const { return {bytes_.get(), static_cast<std::size_t>(size_)}; }

private:
    std::unique_ptr<std::byte[]> bytes_;
    std::int64_t size_ = 0;
};

} // namespace vo
