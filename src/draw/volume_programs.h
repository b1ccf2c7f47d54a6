#pragma once

#include "style/glsl_chain.h"
#include "style/styled_scene.h"

#include <string>

namespace vo {

/// Where the parts of a vertex record of slices lie. Places of its own, and how they change with the local
/// position (three columns), are those of tetrahedra.
enum SliceAttribute : unsigned { kSliceVoxel = 0, kSlicePlace = 1, kSlicePlaceFromLocal = 2 };

/// The texts of a volume's program, and what its chains have of uniforms and textures.
struct VolumeProgram
{
    std::string vertexText, fragmentText;
    GlslChain chains;
};

/// Whether all samples of a ray become one colour.
bool isProjected(const StyledVolume& volume);

/// What draws slices: samples, or surfaces between them and the next slice behind. That of a projection draws
/// a whole picture, corners of which are attribute 0; `opaqueDepths`: a texture says where rays end.
VolumeProgram volumeProgram(const StyledVolume& volume, bool opaqueDepths);

} // namespace vo
