#include "lookup_ramp.h"

#include <algorithm>
#include <cmath>

namespace vo {

std::vector<float> rampEntries(const RampSettings& ramp, double low, double high, int size, int components)
{
    std::vector<float> entries;
    for (int i = 0; i < size; ++i) {
        const double value = low + (high - low) * i / (size - 1);
        const double grey = std::clamp(0.5 + (value - ramp.center) / ramp.width, 0.0, 1.0);
        entries.insert(entries.end(), std::size_t(components - 1), float(grey));
        entries.push_back(float(ramp.opacity * grey));
    }
    return entries;
}

double sliceOpacity(double period, double extent)
{
    return 1 - std::exp(-10 * period / extent);
}

} // namespace vo
