#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

/// Timing of one case, printed as one line: name, size, median, spread.
namespace bench {

/// Median of the repetitions, and half the distance between their quartiles, in seconds.
struct Timing
{
    double median = 0.0;
    double spread = 0.0;
};

/// Runs `work` until `seconds` have passed and at least 5 times, after one run that is not counted.
template <class Work>
Timing measure(const Work& work, double seconds = 1.0)
{
    using Clock = std::chrono::steady_clock;
    const auto elapsed = [](Clock::time_point since) {
        return std::chrono::duration<double>(Clock::now() - since).count();
    };
    work();
    std::vector<double> times;
    for (const Clock::time_point start = Clock::now(); times.size() < 5 || elapsed(start) < seconds;) {
        const Clock::time_point begin = Clock::now();
        work();
        times.push_back(elapsed(begin));
    }
    std::sort(times.begin(), times.end());
    const auto quantile = [&](double q) {
        return times[static_cast<std::size_t>(q * static_cast<double>(times.size() - 1))];
    };
    return {quantile(0.5), 0.5 * (quantile(0.75) - quantile(0.25))};
}

inline void printLine(const std::string& name, const std::string& size, const Timing& timing)
{
    std::printf("%-40s %-34s %10.3f ms +- %.3f\n", name.c_str(), size.c_str(), 1e3 * timing.median,
                1e3 * timing.spread);
}

} // namespace bench
