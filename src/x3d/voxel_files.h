#pragma once

#include "style/voxel_texture.h"

#include "x3d/scene.h"

#include <cstdint>
#include <memory>
#include <string>

namespace vo {

/// What a texture is for: colours and values from 0 to 1, or whole numbers, which stay as they are.
enum class TexelUse { values, identifiers };

/// How much of a file is read: its voxels, or only what it says of them before.
enum class VoxelReading { whole, sizesAlone };

/// A texture, or why there is none.
struct TextureResult
{
    std::shared_ptr<VoxelTexture> texture;
    std::string reason;
    std::string note = {}; ///< what of the file is not as it says; "" where all is
};

/// Bytes that one texture may have: half of the machine's memory.
std::uint64_t mostTextureBytes();

/// The voxels of a file of any format that volume_io opens, the first at (0, 0, 0). uint8 and uint16 stay as
/// they are; int8, int16 and float32 are scaled so that the smallest number of the file becomes 0 and the
/// largest 1, or all 0 where they do not differ, with a note; of floats what is no number counts as the
/// smallest, and infinity as the largest, with a note.
/// Identifiers become uint16, whatever they were. An alpha that the file does not have is left out. Without
/// its voxels, a texture has no texels.
TextureResult readVoxelFile(const std::string& path, TexelUse use,
                            VoxelReading reading = VoxelReading::whole);

/// The same of what was read of the file.
TextureResult textureOf(ReadVoxels voxels, const std::string& path, TexelUse use);

} // namespace vo
