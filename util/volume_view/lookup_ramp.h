#pragma once

#include <vector>

namespace vo {

/// A grey ramp in data values: 0 up to center - width / 2, 1 from center + width / 2.
struct RampSettings
{
    double center;
    double width;
    /// Alpha at the ramp's top.
    double opacity;
};

/// `size` entries of a table that begins and ends at the data values `low` and `high`: grey three times and
/// alpha, or (components 2) grey and alpha.
std::vector<float> rampEntries(const RampSettings& ramp, double low, double high, int size, int components);

/// Opacity of one slice such that slices `period` apart, over a tenth of `extent`, let 1/e of the light
/// through.
double sliceOpacity(double period, double extent);

} // namespace vo
