#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "volume_io/result.h"

/// What the programs of this folder share: how they are called, interrupted and how they say what is wrong.
namespace vo {

struct Utility
{
    const char* name;
    const char* help; // what -help prints
    /// Does the work with the words after the program's name; a failure becomes the program's one line.
    Result<void> (*run)(const std::vector<std::string>& arguments);
};

/// The whole main program: -h, -help, -version, then run(). 0, or 1 after one line on standard error.
int runUtility(const Utility& utility, int argc, char** argv);

/// Whether SIGINT or SIGTERM came. Who writes a file looks now and then and gives up, so that the unfinished
/// file is removed.
bool interrupted();

/// While it lives, SIGINT and SIGTERM end the program at once: for work that takes long, does not look at
/// interrupted() and has no file open for writing.
class EndsWhenInterrupted
{
public:
    EndsWhenInterrupted();
    ~EndsWhenInterrupted();
    EndsWhenInterrupted(const EndsWhenInterrupted&) = delete;
    EndsWhenInterrupted& operator=(const EndsWhenInterrupted&) = delete;

private:
    void (*onInterrupt_)(int);
    void (*onTerminate_)(int);
};

/// While it lives, SIGINT and SIGTERM do no more than interrupted() tells, also where they would end the
/// program at once: for work that has a file open for writing.
class NoticesInterrupts
{
public:
    NoticesInterrupts();
    ~NoticesInterrupts();
    NoticesInterrupts(const NoticesInterrupts&) = delete;
    NoticesInterrupts& operator=(const NoticesInterrupts&) = delete;

private:
    void (*onInterrupt_)(int);
    void (*onTerminate_)(int);
};

/// Prints how far the work is, on a terminal only.
void showProgress(const char* program, const char* what, std::int64_t done, std::int64_t all);

/// A dot for each character that moves a terminal's cursor, or more.
std::string withoutControls(std::string text);

/// Prints a line on standard error, with the program's name in front, and without controls.
void warn(const char* program, const std::string& text);

/// A failure when the output is one of the inputs, or a file that is no TIFF: a forgotten output's name would
/// cost the last input.
Result<void> checkOutput(const std::string& output, const std::vector<std::string>& inputs);

/// A whole number from `least` to `most`; `name` begins the message.
Result<std::int64_t> parsedWhole(const std::string& name, const std::string& text, std::int64_t least,
                                 std::int64_t most = 0x7fffffff);

} // namespace vo
