#pragma once

#include "volume_view/value_range.h"

#include <vo/Appearance.h>

#include <cstddef>
#include <vector>

namespace vo {

/// Widens the range by the voxels of a brick of one channel, those alone that lie inside the volume. Values
/// that are no numbers are passed over.
void growRange(ValueRange& range, const voBrick& brick, int xVolumeSize, int yVolumeSize, int zVolumeSize);

/// Widens the range by `count` values of a type that lie from number `first` on.
void growRange(ValueRange& range, voDataType type, const void* values, std::size_t first, std::size_t count);

/// All values of a type; of floats 0 to 1.
ValueRange fullRange(voDataType type);

/// Channels of a type one after the other, as numbers. Packed types have no channels to read: all 0.
std::vector<double> channelValues(voDataType type, const void* channels, std::size_t count);

} // namespace vo
