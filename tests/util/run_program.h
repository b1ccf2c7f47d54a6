#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace vo {

struct ProgramRun
{
    int status = -1;    // exit status; -1 where the program ended by a signal
    std::string output; // standard output and standard error together
};

/// Runs a shell command and waits for it.
inline ProgramRun runProgram(const std::string& command)
{
    ProgramRun run;
    FILE* pipe = ::popen(("exec 2>&1; " + command).c_str(), "r");
    if (!pipe) return run;
    std::array<char, 4096> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        run.output.append(buffer.data(), count);
    const int status = ::pclose(pipe);
    if (WIFEXITED(status)) run.status = WEXITSTATUS(status);
    return run;
}

} // namespace vo
