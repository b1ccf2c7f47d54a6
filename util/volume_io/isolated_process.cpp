#include "isolated_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace vo {
namespace {

constexpr int kPatienceMilliseconds = 60'000;

/// Bytes of address space in use; 0 if unknown.
rlim_t addressSpace()
{
    unsigned long pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    return static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void limitThisProcess(std::int64_t moreMemory)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int number : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGPIPE})
        std::signal(number, SIG_DFL);
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    rlimit memory{};
    if (const rlim_t now = addressSpace(); now > 0 && ::getrlimit(RLIMIT_AS, &memory) == 0) {
        memory.rlim_cur = std::min(memory.rlim_max, now + static_cast<rlim_t>(moreMemory));
        ::setrlimit(RLIMIT_AS, &memory);
    }
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
    }
}

void sendAll(int pipe, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(pipe, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) ::_exit(1);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

} // namespace

Result<IsolatedProcess> IsolatedProcess::start(std::int64_t moreMemory,
                                               const std::function<void(const Send&)>& work)
{
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        return Failure{std::string("cannot make a pipe: ") + std::strerror(errno)};
    const pid_t process = ::fork();
    if (process == 0) {
        ::close(ends[0]);
        limitThisProcess(moreMemory);
        try {
            work([&ends](std::span<const std::byte> bytes) { sendAll(ends[1], bytes); });
        } catch (...) {
            ::_exit(1);
        }
        ::_exit(0); // nothing of the original's is written or destroyed
    }
    ::close(ends[1]);
    if (process > 0) return IsolatedProcess(process, ends[0]);
    const int error = errno;
    ::close(ends[0]);
    return Failure{std::string("cannot start a process: ") + std::strerror(error)};
}

IsolatedProcess::IsolatedProcess(IsolatedProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)), pipe_(std::exchange(other.pipe_, -1))
{
}

IsolatedProcess::~IsolatedProcess()
{
    if (pipe_ >= 0) ::close(pipe_);
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

bool IsolatedProcess::receive(std::span<std::byte> out)
{
    while (!out.empty()) {
        pollfd wait{pipe_, POLLIN, 0};
        const int ready = ::poll(&wait, 1, kPatienceMilliseconds);
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return false;
        const ssize_t count = ::read(pipe_, out.data(), out.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        out = out.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

} // namespace vo
