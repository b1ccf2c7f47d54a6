#pragma once

#include "style/sample_batch.h"

#include <cmath>

namespace vo::test {

/// Places in a texture and up to a fifth of it beyond its faces, none at the border of two texels.
inline BatchVectors somePlaces()
{
    BatchVectors place{};
    for (std::size_t i = 0; i < kBatchSize; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis][i] = static_cast<float>(
                std::fmod(0.137 + 0.618034 * static_cast<double>(i * (axis + 1)), 1.4) - 0.2);
    return place;
}

} // namespace vo::test
