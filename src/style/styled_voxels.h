#pragma once

#include "style/styled_scene.h"

namespace vo {

/// Whether the texels fill the voxels' size, and the box has an extent.
bool hasWholeVoxels(const StyledVolume& volume);

/// Sets n and gradient at the samples' places: central differences of brightness.
void findNormals(const VoxelTexture& voxels, const glm::vec3& dimensions, SampleBatch& batch);

} // namespace vo
