#pragma once

#include <cstdint>

namespace vo {

/// Bytes that a program may have at most: the machine's memory, or less where the caller's limits say so
/// (`ulimit -v`). At most 0 where that cannot be known.
std::int64_t machineMemory();

} // namespace vo
