#pragma once

#include <array>

namespace vo {

constexpr int kBatchSize = 64;

/// Numbers of up to kBatchSize samples side by side, so that a loop over them becomes vectors.
using BatchFloats = std::array<float, kBatchSize>;
using BatchVectors = std::array<BatchFloats, 3>;

/// Samples of one volume on their way through a chain of styles. Names are those of the standard. Space is
/// that of the volume node: local coordinates, in which `dimensions` counts.
struct SampleBatch
{
    int count = 0;
    std::array<BatchFloats, 4>
        voxel;             ///< components as the voxel texture answers, 0 to 1; unused ones undefined
    BatchVectors place;    ///< texture coordinates S, T, R
    BatchVectors position; ///< local
    BatchVectors V;        ///< unit vectors from the sample to the eye
    BatchVectors n;        ///< unit normals, away from higher values; 0 0 0 where there is none
    BatchFloats gradient;  ///< |Df|, the change of the value over a voxel's shortest edge
    BatchVectors Cv;       ///< colour so far, not multiplied by opacity
    BatchFloats Ov;        ///< opacity so far, of a unit of length
};

} // namespace vo
