#include "lookup/visible_values.h"

#include <algorithm>
#include <cmath>

namespace vo {

VisibleValues::VisibleValues(const Table& table)
{
    visibleBefore_.push_back(0);
    for (std::size_t i = 3; i < table.rgba.size(); i += 4)
        visibleBefore_.push_back(visibleBefore_.back() + (table.rgba[i] != 0.0f));
}

bool VisibleValues::any(float low, float high) const
{
    if (low > high) return false;
    if (!(low <= high)) return true; // not a number
    if (visibleBefore_.size() < 2) return low != 0.0f || high != 0.0f;
    const auto last = static_cast<double>(visibleBefore_.size() - 2);
    // A float that stands for an entry is off by its rounding.
    const double rounding = 2e-7 * last;
    const double first = std::floor(std::clamp(static_cast<double>(low), 0.0, 1.0) * last + rounding);
    const double end = std::ceil(std::clamp(static_cast<double>(high), 0.0, 1.0) * last - rounding);
    const auto from = static_cast<std::size_t>(std::min(first, last));
    const auto to = static_cast<std::size_t>(std::max(end, first));
    return visibleBefore_[std::min(to, visibleBefore_.size() - 2) + 1] != visibleBefore_[from];
}

} // namespace vo
