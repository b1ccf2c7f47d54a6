#include "support/malloc_counter.h"

#include <atomic>
#include <cerrno>
#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define VOLUMIZER_SANITIZER_OWNS_MALLOC 1
#endif

namespace {

std::atomic<std::uint64_t> processCount{0};
thread_local std::uint64_t threadCount = 0;

void countOne()
{
    processCount.fetch_add(1, std::memory_order_relaxed);
    ++threadCount;
}

} // namespace

#ifdef VOLUMIZER_SANITIZER_OWNS_MALLOC

extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*onMalloc)(const volatile void*, std::size_t),
                                                         void (*onFree)(const volatile void*));

namespace {

[[maybe_unused]] const int hooksInstalled = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { countOne(); }, [](const volatile void*) {});

} // namespace

#else

// The GNU C library lets a program replace malloc and reach the original by these names. free stays its own.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

__attribute__((visibility("default"))) void* malloc(std::size_t size)
{
    countOne();
    return __libc_malloc(size);
}

__attribute__((visibility("default"))) void* calloc(std::size_t count, std::size_t size)
{
    countOne();
    return __libc_calloc(count, size);
}

__attribute__((visibility("default"))) void* realloc(void* block, std::size_t size)
{
    countOne();
    return __libc_realloc(block, size);
}

__attribute__((visibility("default"))) void* memalign(std::size_t alignment, std::size_t size)
{
    countOne();
    return __libc_memalign(alignment, size);
}

__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment, std::size_t size)
{
    countOne();
    return __libc_memalign(alignment, size);
}

__attribute__((visibility("default"))) int posix_memalign(void** block, std::size_t alignment,
                                                          std::size_t size)
{
    countOne();
    void* found = __libc_memalign(alignment, size);
    if (!found) return ENOMEM;
    *block = found;
    return 0;
}
}

#endif

namespace vo::test {

MallocCounter::MallocCounter() : threadStart_(threadCount), processStart_(processCount) {}

std::uint64_t MallocCounter::ofThisThread() const
{
    return threadCount - threadStart_;
}

std::uint64_t MallocCounter::ofProcess() const
{
    return processCount - processStart_;
}

} // namespace vo::test
