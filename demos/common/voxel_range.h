#pragma once

#include <vo/Appearance.h>

namespace vo {

/// The smallest and the largest value of voxels; low > high while nothing was seen.
struct ValueRange
{
    double low = 1;
    double high = 0;
};

/// Widens the range by the voxels of a brick of one channel, those alone that lie inside the volume. Values
/// that are no numbers are passed over.
void growRange(ValueRange& range, const voBrick& brick, int xVolumeSize, int yVolumeSize, int zVolumeSize);

/// All values of a type; of floats 0 to 1.
ValueRange fullRange(voDataType type);

} // namespace vo
