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

/// Of what draws slices: samples, or surfaces between them and the next slice behind.
VolumeProgram sliceProgram(const StyledVolume& volume);

} // namespace vo
