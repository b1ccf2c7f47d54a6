#pragma once

#include "style/styled_scene.h"

namespace vo {

/// Whether its numbers make sense: voxels and segments have all their texels, lengths are above 0, it has
/// chains, and a place in the world. What does not is left out of pictures.
bool isSound(const StyledVolume& volume);
/// The same of a surface: triangles name positions that are there, and lists for positions are as long.
bool isSound(const StyledSurface& surface);

/// Which of a volume's chains its segment at a place (S, T, R) has, below 0 for none; 0 without segments.
int chainAt(const StyledVolume& volume, const glm::vec3& place);

/// The same, of `chains`, for texel number `texel` of the identifiers.
int chainOfTexel(const Segments& segments, std::size_t texel, int chains);

/// Sets n to the change of brightness from one voxel to the next along each axis: half the difference of the
/// two neighbours.
void findChanges(const VoxelTexture& voxels, SampleBatch& batch);
/// From the change over a shortest edge, local, in n: n and gradient.
void normalsFromChanges(SampleBatch& batch);
/// Both for the box of a volume.
void findNormals(const VoxelTexture& voxels, const glm::vec3& dimensions, SampleBatch& batch);

} // namespace vo
