#pragma once

#include "appearance/voxel_format.h"
#include "core/volume_size.h"
#include "lookup/table.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <span>

namespace vo {

/// The voxels of a brick as a texture of OpenGL holds them. Places are in voxels from the brick's lower
/// corner: voxel i spans [i, i + 1].
struct BrickTexels
{
    VoxelSize size;
    VoxelFormat format;
    TexelFormat texel = TexelFormat::intensity;
    std::span<const std::byte> voxels; ///< in `format`, x fastest, all of them
    const Table* classified = nullptr; ///< the table before interpolation, if one is active
};

/// True for voxels whose texture holds unsigned numbers, 0 to 1: those of at most 16 bits a channel, and
/// packed ones.
bool clampsTexels(VoxelType type);

/// Number, x fastest, of the voxel that holds a place; beyond the brick the outermost.
std::size_t nearestVoxel(const VoxelSize& size, const glm::dvec3& place);

/// What the texture answers: red, green, blue and alpha, linear between the centres of voxels, beyond the
/// outermost centres that of the nearest.
glm::dvec4 filteredTexel(const BrickTexels& brick, const glm::dvec3& place);

} // namespace vo
