#pragma once

#include "volume_io/volume_io.h"

namespace vo {

/// What the values of one channel are.
struct ChannelStatistics
{
    /// Of the finite values; low > high where there is none.
    double low = 1, high = 0;
    double mean = 0;
    /// Values that are no numbers, and infinite ones; they count nowhere else.
    std::int64_t notANumber = 0, infinite = 0;
    /// Numbers of values in parts of equal width from low to high; one for each value where an integer type
    /// has no more of them than parts.
    std::vector<std::int64_t> histogram;
};

/// Reads all voxels, twice, a slice or less at a time. `bins` parts at most; progress is shown for the
/// program of this name. Gives up when interrupted.
Result<std::vector<ChannelStatistics>> statisticsOf(const char* program, const std::string& path,
                                                    VolumeFile& volume, std::size_t bins);

} // namespace vo
