#pragma once

#include "appearance/voxel_format.h"

#include <cstddef>
#include <span>

namespace vo {

/// Reads `count` voxels as normalised (red, green, blue, alpha), 4 * count floats, in the way OpenGL reads
/// pixels: unsigned n-bit v / (2^n - 1), signed max(v / (2^(n-1) - 1), -1), floats as they are; one channel
/// is (v, v, v, v), two are (l, l, l, a), abgr is reordered.
void decodeVoxels(std::span<const std::byte> voxels, VoxelFormat format, std::size_t count, float* rgba);

/// The reverse: clamped to what the type holds (floats hold anything), rounded to nearest. One channel takes
/// luminance 0.30 R + 0.59 G + 0.11 B (exactly v for grey); two also alpha.
void encodeVoxels(const float* rgba, std::size_t count, VoxelFormat format, std::span<std::byte> voxels);

/// Changes the channels of voxels, or their type, in place when source == target (storage then has room for
/// the larger of both); otherwise they must not overlap. Exact, not by way of floats, where the type stays
/// and channels are only copied.
void convertVoxels(const std::byte* source, VoxelFormat sourceFormat, std::byte* target,
                   VoxelFormat targetFormat, std::size_t count);

/// Maps [low, high] linearly to the values that a texture shows as 0 to 1, clamping and rounding: 0-255,
/// 0-127 (int8), 0-65535, 0-32767 (int16), 0-(2^32-1), 0-(2^31-1), 0.0-1.0. All channels alike. Not for
/// packed types. Does nothing when high <= low.
void stretchRange(std::span<std::byte> voxels, VoxelFormat format, double low, double high);

} // namespace vo
