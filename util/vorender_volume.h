#pragma once

#include "volume_io/memory_block.h"
#include "volume_io/volume_io.h"
#include "volume_view/options.h"

#include "appearance/voxel_format.h"
#include "core/volume_size.h"
#include "lookup/brick_texels.h"

namespace vo {

/// A volume in memory, as a texture would hold it.
struct LoadedVolume
{
    VoxelSize size;
    VoxelFormat format;
    TexelFormat texel = TexelFormat::intensity;
    MemoryBlock voxels;
    std::array<double, 3> spacing{1, 1, 1};
    /// The values of the file at which the table begins and ends: 0 and 1 of the texture.
    float low = 0;
    float high = 1;

    BrickTexels texels() const { return {size, format, texel, voxels.bytes(), nullptr}; }
};

/// Reads a whole volume; its values are spread over its type's range, from -dataRange, or from what the file
/// has. `color`: four channels stay so, otherwise they become luminance and alpha. `path` begins messages.
Result<LoadedVolume> loadVolume(const std::string& path, VolumeFile& file, const Options& options,
                                bool color);

} // namespace vo
