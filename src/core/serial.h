#pragma once

#include <atomic>
#include <cstdint>

namespace vo {

/// A number that nothing else in the process has: never 0.
inline std::uint64_t newSerial()
{
    static std::atomic<std::uint64_t> next{1};
    return next++;
}

} // namespace vo
