#pragma once

#include "volume_io/memory_block.h"
#include "volume_io/volume_io.h"
#include "volume_view/value_range.h"

#include <vector>

namespace vo {

/// What the values of a volume are, for a table that fits them.
struct VolumeValues
{
    std::array<std::int64_t, 3> size{};
    ChannelType type = ChannelType::uint8;
    std::array<double, 3> spacing{1, 1, 1};
    int channels = 1;
    bool alphaAdded = false;
    /// Whether the file says how the patient lies.
    bool isOriented = false;
    /// Values of the file that are 0 and 1 in a scene.
    ValueRange scene;
    /// Those that it has.
    ValueRange seen;
    /// Between what is around and what is of interest; and a value that only one of 500 voxels is above.
    double threshold = 0, high = 1;
    /// How many numbers are no whole ones, and the first of them.
    std::int64_t fractions = 0;
    double firstFraction = 0;
    /// All voxels, where there was memory to hold them at once; else empty.
    MemoryBlock voxels;
};

/// Opens a volume and looks at all of its voxels. `program` begins notes that are printed.
Result<VolumeValues> lookAtVolume(const char* program, const std::string& path);

/// The numbers of segments: what lookAtVolume() answers but for the threshold, and 1 for each number from 0
/// to the greatest that a voxel has, else 0; none of these unless all are whole ones from 0 to `most`.
struct LabelValues
{
    VolumeValues values;
    std::vector<int> isThere;
};
Result<LabelValues> lookAtLabels(const char* program, const std::string& path, int most);

} // namespace vo
