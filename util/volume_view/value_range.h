#pragma once

#include "volume_io/volume_io.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace vo {

/// The smallest and the largest value of voxels; low > high while nothing was seen.
struct ValueRange
{
    double low = 1;
    double high = 0;
};

/// Widens the range to all of another.
inline void growRange(ValueRange& range, const ValueRange& by)
{
    if (by.low > by.high) return;
    if (range.low > range.high) {
        range = by;
        return;
    }
    range.low = std::min(range.low, by.low);
    range.high = std::max(range.high, by.high);
}

/// Widens the range by `count` values. Values that are no numbers, or infinite, are passed over.
template <typename Value>
void growRange(ValueRange& range, const Value* values, std::size_t count)
{
    using Limits = std::numeric_limits<Value>;
    Value low = Limits::max(), high = Limits::lowest();
    for (std::size_t i = 0; i < count; ++i) {
        const Value value = values[i];
        if constexpr (std::is_floating_point_v<Value>) {
            const bool finite = std::abs(value) <= Limits::max(); // not for NaN
            low = finite && value < low ? value : low;
            high = finite && value > high ? value : high;
        } else {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (low <= high) growRange(range, {static_cast<double>(low), static_cast<double>(high)});
}

/// Widens the range by `count` values of a type.
void growRange(ValueRange& range, ChannelType type, const std::byte* values, std::size_t count);

/// All values of a type; of floats 0 to 1.
ValueRange fullRange(ChannelType type);

} // namespace vo
