#pragma once

#include <string>
#include <vector>

namespace vo {

/// Seconds that one frame took, and the stages it went through. Stages need not add up to the whole.
struct FrameTime
{
    double whole = 0;
    double polygonize = 0;
    double upload = 0;
    double draw = 0;
};

/// The value in the middle; of an even number of values the mean of the two in the middle; 0 of none.
double median(std::vector<double> values);

/// One line: how many frames, and the medians of the whole and of each stage, in milliseconds.
std::string describeFrameTimes(const std::vector<FrameTime>& frames);

} // namespace vo
