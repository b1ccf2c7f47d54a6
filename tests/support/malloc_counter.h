#pragma once

#include <cstdint>

namespace vo::test {

/// Counts the allocations of this thread, or of the whole process, by new, malloc and their relatives, since
/// it was made. Frees are not counted. Link only into programs that use it: it replaces malloc there.
class MallocCounter
{
public:
    MallocCounter();

    std::uint64_t ofThisThread() const; ///< ask in the thread that made it
    std::uint64_t ofProcess() const;

private:
    std::uint64_t threadStart_;
    std::uint64_t processStart_;
};

} // namespace vo::test
