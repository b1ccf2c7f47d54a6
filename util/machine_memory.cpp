#include "machine_memory.h"

#include <algorithm>
#include <sys/resource.h>
#include <unistd.h>

namespace vo {

std::int64_t machineMemory()
{
    const std::int64_t there =
        static_cast<std::int64_t>(::sysconf(_SC_PHYS_PAGES)) * ::sysconf(_SC_PAGE_SIZE);
    rlimit space{};
    if (::getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return there;
    return std::min(there, static_cast<std::int64_t>(space.rlim_cur));
}

} // namespace vo
