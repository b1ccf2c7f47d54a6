#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <sys/types.h>

#include "result.h"

namespace vo {

/// Work in a process of its own, for libraries that abort, print or grow on damaged files: a copy of this
/// process, without its standard error and with a bound on memory, that sends back bytes.
class IsolatedProcess
{
public:
    /// Sends bytes to the process that waits. What cannot be sent ends the work.
    using Send = std::function<void(std::span<const std::byte>)>;

    /// Begins `work` in the new process, which ends with it. It may read all that this process has in memory;
    /// what it changes nobody sees. It gets at most `moreMemory` bytes beside what this one has.
    static Result<IsolatedProcess> start(std::int64_t moreMemory,
                                         const std::function<void(const Send&)>& work);
    IsolatedProcess(IsolatedProcess&& other) noexcept;
    /// Ends the process if it still works.
    ~IsolatedProcess();

    /// Waits for the next bytes. False when the process ended before, or sent nothing for a minute.
    bool receive(std::span<std::byte> out);

private:
    IsolatedProcess(pid_t process, int pipe) : process_(process), pipe_(pipe) {}

    pid_t process_ = -1;
    int pipe_ = -1;
};

} // namespace vo
