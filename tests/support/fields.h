#pragma once

#include "core/volume_size.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vo::test {

/// A volume whose voxels are known by construction. `values` holds `channels` (1, 2 or 4) numbers a voxel,
/// then x fastest, then y, then z: what OpenGL reads from the voxels (0 to 1 for unsigned integers). One
/// channel stands for (v, v, v, v), two for (l, l, l, a), four for (r, g, b, a).
struct Field
{
    VoxelSize size;
    int channels = 1;
    std::vector<float> values;

    std::size_t index(int x, int y, int z) const;
    float& at(int x, int y, int z, int channel = 0);
    float at(int x, int y, int z, int channel = 0) const;
};

/// One channel: function(centre of the voxel), that is at i + 0.5, in voxels.
Field fieldOf(const VoxelSize& size, const std::function<double(const glm::dvec3& centre)>& function);

Field constantField(const VoxelSize& size, double value);
/// value + dot(gradient, centre of the voxel); not clamped.
Field rampField(const VoxelSize& size, const glm::dvec3& gradient, double value = 0.0);
/// From 0 to 1 along an axis, first to last voxel centre.
Field axisRampField(const VoxelSize& size, int axis);
/// 1 in the centre, 0 from `radius` times half the smallest side on, with a smooth slope.
Field ballField(const VoxelSize& size, double radius = 0.9);
/// Cubes of `period` voxels, half a period wide, of falling value from the centre of the volume outwards.
Field cubesField(const VoxelSize& size, int period);
/// Every voxel at random in 0 to 1.
Field noiseField(const VoxelSize& size, unsigned seed);
/// A letter F on each of the three faces through the origin, an eighth of the smallest side deep: on the x
/// face (y to its right, z up) of value 1, on the y face (x right, z up) of 2/3, on the z face (x right, y
/// up) of 1/3. A mirrored, turned or exchanged axis shows.
Field letterFField(const VoxelSize& size);

/// The channels of several one-channel fields of one size side by side: 2 or 4 of them.
Field combined(const std::vector<Field>& channels);
/// The field with its outermost `layers` zero on all six sides.
Field withEmptyBorder(Field field, int layers = 1);
/// Each value clamped to 0 to 1 and rounded to a multiple of 1 / levels: what voxels of 8 (255) or 16 (65535)
/// bits hold.
Field quantised(Field field, int levels = 255);

/// Voxels to hand to the library: value x 255 or x 65535, clamped and rounded.
std::vector<std::uint8_t> toBytes(const Field& field);
std::vector<std::uint16_t> toShorts(const Field& field);

} // namespace vo::test
