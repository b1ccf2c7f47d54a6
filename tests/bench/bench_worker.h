#pragma once

#include <functional>
#include <string>
#include <vector>

/// One of the programs that a benchmark compares. The runner (run.py) starts it, waits until it is ready, and
/// lets all of a job work in turns by lines on standard input, so that disturbances meet them alike.
namespace bench {

struct Worker
{
    /// Does the work once, to its end. The number counts up from 0: views and tables differ by it, or caches
    /// would be measured.
    std::function<void(int)> work;
    /// The picture of the scene: four floats a pixel, premultiplied, rows from the bottom. None: no picture.
    std::function<std::vector<float>()> picture;
    /// "name": value pairs of JSON that say what was measured, joined by commas; asked after `work`.
    std::function<std::string()> facts;
};

/// Wall and CPU seconds of this process, all threads, and of its children that ended.
struct Clocks
{
    double wall = 0.0;
    double cpu = 0.0;
};
Clocks clocks();

/// Works once, writes "ready" and the wall seconds that it took, then obeys: "work N" works N times and
/// answers with the seconds of a plain loop, then wall and CPU seconds of each time; "picture PATH" writes
/// the picture's floats; "facts" answers with a JSON object; "quit" or the end of input ends it. Returns the
/// exit status.
int serve(const Worker& worker);

/// Runs `main`, which gets the arguments after the program's name; an exception becomes one line and
/// status 1.
int guarded(int argc, char** argv, const std::function<int(const std::vector<std::string>&)>& main);

/// A number as JSON has it.
std::string jsonPair(const std::string& name, double value);
std::string jsonPair(const std::string& name, const std::string& value);

/// Small turn of the view for frame `number`, degrees.
double turnOf(int number);

} // namespace bench
