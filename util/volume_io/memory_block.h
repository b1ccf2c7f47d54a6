#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>

#if defined(__linux__)
#include <sys/mman.h>
#endif

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
        block.bytes_.reset(allocated(static_cast<std::size_t>(bytes)));
        if (!block.bytes_)
            return Failure{path + ": expected memory for " + std::to_string(bytes) +
                           " bytes of voxels, found less"};
        block.size_ = bytes;
        return block;
    }

    std::span<std::byte> bytes() const { return {bytes_.get(), static_cast<std::size_t>(size_)}; }

private:
    struct Free
    {
        void operator()(std::byte* bytes) const { std::free(bytes); }
    };

    /// In large pages where the system has them: small ones take as long to get as to fill.
    static std::byte* allocated(std::size_t bytes)
    {
        constexpr std::size_t kLargePage = std::size_t{1} << 21;
#if defined(__linux__)
        if (bytes >= 2 * kLargePage) {
            void* large = nullptr;
            if (::posix_memalign(&large, kLargePage, bytes) != 0) return nullptr;
            ::madvise(large, bytes / kLargePage * kLargePage, MADV_HUGEPAGE);
            return static_cast<std::byte*>(large);
        }
#endif
        return static_cast<std::byte*>(std::malloc(std::max<std::size_t>(bytes, 1)));
    }

    std::unique_ptr<std::byte[], Free> bytes_;
    std::int64_t size_ = 0;
};

} // namespace vo
