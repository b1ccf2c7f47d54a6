#include "core/large_pages.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace vo {

LargePages allocateLargePages(std::size_t bytes)
{
    const auto start = static_cast<std::byte*>(::operator new(bytes, std::align_val_t(kLargePageBytes)));
#if defined(__linux__)
    madvise(start, bytes / kLargePageBytes * kLargePageBytes, MADV_HUGEPAGE); // in vain where there are none
#endif
    return LargePages(start);
}

void ReleaseLargePages::operator()(std::byte* memory) const
{
    ::operator delete(memory, std::align_val_t(kLargePageBytes));
}

} // namespace vo
