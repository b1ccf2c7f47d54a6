#include "frame_times.h"

#include <algorithm>
#include <cstdio>

namespace vo {
namespace {

double medianMilliseconds(const std::vector<FrameTime>& frames, double FrameTime::*part)
{
    std::vector<double> seconds;
    for (const FrameTime& frame : frames)
        seconds.push_back(frame.*part);
    return 1000 * median(seconds);
}

} // namespace

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string describeFrameTimes(const std::vector<FrameTime>& frames)
{
    char line[200];
    std::snprintf(
        line, sizeof line, "%zu frames, median %.2f ms: polygonize %.2f ms, upload %.2f ms, draw %.2f ms",
        frames.size(), medianMilliseconds(frames, &FrameTime::whole),
        medianMilliseconds(frames, &FrameTime::polygonize), medianMilliseconds(frames, &FrameTime::upload),
        medianMilliseconds(frames, &FrameTime::draw));
    return line;
}

} // namespace vo
