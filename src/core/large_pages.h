#pragma once

#include <cstddef>
#include <memory>

namespace vo {

struct ReleaseLargePages
{
    void operator()(std::byte* memory) const;
};

/// Memory in large pages where the system has them: what is written all over finds small ones slowly. For
/// blocks of kLargePageBytes bytes and more.
using LargePages = std::unique_ptr<std::byte, ReleaseLargePages>;
constexpr std::size_t kLargePageBytes = std::size_t{1} << 21;

/// Not initialised; throws std::bad_alloc.
LargePages allocateLargePages(std::size_t bytes);

} // namespace vo
