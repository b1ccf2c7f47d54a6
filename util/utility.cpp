#include "utility.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <fstream>
#include <filesystem>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <sys/resource.h>
#include <unistd.h>

namespace vo {
namespace {

volatile std::sig_atomic_t interruptedFlag = 0;

void notice(int)
{
    interruptedFlag = 1;
}

bool isOneOf(const char* argument, std::initializer_list<const char*> words)
{
    return std::ranges::any_of(words, [&](const char* word) { return std::strcmp(argument, word) == 0; });
}

bool isHelp(const char* argument)
{
    return isOneOf(argument, {"-h", "-help", "--help"});
}

bool isVersion(const char* argument)
{
    return isOneOf(argument, {"-version", "--version"});
}

int fail(const Utility& utility, const std::string& text)
{
    warn(utility.name, text);
    return 1;
}

/// Writes out what is left of standard output.
int flushed(const Utility& utility)
{
    return std::fflush(stdout) == 0 && !std::ferror(stdout)
               ? 0
               : fail(utility, "cannot write to standard output");
}

int print(const Utility& utility, const char* text)
{
    std::fputs(text, stdout);
    return flushed(utility);
}

} // namespace

int runUtility(const Utility& utility, int argc, char** argv)
try {
    if (std::any_of(argv + 1, argv + argc, isHelp)) return print(utility, utility.help);
    if (std::any_of(argv + 1, argv + argc, isVersion))
        return print(utility, "Volumizer " VOLUMIZER_VERSION "\n");
    std::signal(SIGINT, notice);
    std::signal(SIGTERM, notice);
    // Past the largest size of a file that is allowed writing then fails, and cleans up, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    const auto done = utility.run({argv + 1, argv + argc});
    if (!done) std::fflush(stdout);
    return done ? flushed(utility) : fail(utility, done.failure().text);
} catch (const std::bad_alloc&) {
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    return fail(utility, "expected more memory than the " + std::to_string(used.ru_maxrss) +
                             " KiB in use, found no more");
}

bool interrupted()
{
    return interruptedFlag != 0;
}

EndsWhenInterrupted::EndsWhenInterrupted()
    : onInterrupt_(std::signal(SIGINT, SIG_DFL)), onTerminate_(std::signal(SIGTERM, SIG_DFL))
{
}

EndsWhenInterrupted::~EndsWhenInterrupted()
{
    std::signal(SIGINT, onInterrupt_);
    std::signal(SIGTERM, onTerminate_);
}

NoticesInterrupts::NoticesInterrupts()
    : onInterrupt_(std::signal(SIGINT, notice)), onTerminate_(std::signal(SIGTERM, notice))
{
}

NoticesInterrupts::~NoticesInterrupts()
{
    std::signal(SIGINT, onInterrupt_);
    std::signal(SIGTERM, onTerminate_);
}

void showProgress(const char* program, const char* what, std::int64_t done, std::int64_t all)
{
    if (!::isatty(STDERR_FILENO)) return;
    std::fprintf(stderr, "\r%s: %s %lld of %lld%s", program, what, static_cast<long long>(done),
                 static_cast<long long>(all), done == all ? "\n" : "");
}

void warn(const char* program, const std::string& text)
{
    std::fprintf(stderr, "%s: %s\n", program, withoutControls(text).c_str());
}

std::string withoutControls(std::string text)
{
    for (char& letter : text)
        if ((letter >= 0 && letter < ' ') || letter == 0x7f) letter = '.';
    return text;
}

Result<void> checkOutput(const std::string& output, const std::vector<std::string>& inputs)
{
    std::error_code none;
    for (const std::string& input : inputs)
        if (std::filesystem::equivalent(input, output, none))
            return Failure{output + ": expected an output that is no input, found the file " + input};
    if (!std::filesystem::is_regular_file(output, none) || std::filesystem::file_size(output, none) == 0)
        return {};
    char mark[2] = {0, 0};
    std::ifstream(output, std::ios::binary).read(mark, 2);
    const std::string_view begin(mark, 2);
    if (begin == "II" || begin == "MM") return {};
    return Failure{output + ": expected a new file or a TIFF file to replace, found another file"};
}

Result<std::int64_t> parsedWhole(const std::string& name, const std::string& text, std::int64_t least,
                                 std::int64_t most)
{
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size() && value >= least && value <= most)
        return value;
    return Failure{name + ": expected a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most) + ", found \"" + text + "\""};
}

} // namespace vo
