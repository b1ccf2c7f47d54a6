// Runs a program to its end as often as asked: what it costs from start to exit. A small process of its own,
// since a child's peak memory counts from the parent's.
//
//     measure_process PROGRAM ARGUMENT...
#include "bench_worker.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

void runOnce(const std::vector<std::string>& command)
{
    std::vector<char*> words;
    for (const std::string& word : command)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error(std::string("fork: ") + std::strerror(errno));
    if (child == 0) {
        // The runner reads standard output, and standard input holds its commands.
        const int nothing = open("/dev/null", O_RDWR);
        dup2(nothing, STDIN_FILENO);
        dup2(nothing, STDOUT_FILENO);
        execv(words[0], words.data());
        _exit(127);
    }
    int status = 0;
    if (waitpid(child, &status, 0) != child)
        throw std::runtime_error(std::string("waitpid: ") + std::strerror(errno));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw std::runtime_error(command[0] + " failed with status " + std::to_string(status));
}

int run(const std::vector<std::string>& arguments)
{
    if (arguments.empty()) throw std::invalid_argument("arguments: PROGRAM ARGUMENT...");
    bench::Worker worker;
    worker.work = [&](int) { runOnce(arguments); };
    worker.facts = [] {
        rusage children{};
        getrusage(RUSAGE_CHILDREN, &children);
        return bench::jsonPair("peakMiB", static_cast<double>(children.ru_maxrss) / 1024.0);
    };
    return bench::serve(worker);
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
