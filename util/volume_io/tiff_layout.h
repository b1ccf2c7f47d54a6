#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tiff_handle.h"
#include "volume_io.h"

namespace vo {

/// How the voxels of one TIFF directory lie in the file: in blocks, which are strips or tiles.
struct TiffLayout
{
    std::int64_t width = 0;
    std::int64_t height = 0;
    std::int64_t depth = 1; // above 1 in SGI's 3D TIFF only
    int channels = 1;       // in the file, 1 to 4
    ChannelType type = ChannelType::uint8;

    bool planar = false; // each channel in blocks of its own
    std::int64_t blockWidth = 0;
    std::int64_t blockHeight = 0;
    std::int64_t blockDepth = 1;
    bool tiled = false; // tiles are stored whole at the edges, strips are cut off
    bool deflated = false;
    bool reversedBits = false; // lowest bit first in each byte
    bool encoded = false;      // needs libtiff; otherwise rows are read where they lie
    bool swapped = false;      // not this machine's byte order; libtiff swaps what it decodes

    std::int64_t blocksAcross() const { return (width + blockWidth - 1) / blockWidth; }
    std::int64_t blocksDown() const { return (height + blockHeight - 1) / blockHeight; }
    std::int64_t blockLayers() const { return (depth + blockDepth - 1) / blockDepth; }
    int planes() const { return planar ? channels : 1; }
    int channelsPerBlock() const { return planar ? 1 : channels; }
    std::int64_t blockCount() const { return blocksAcross() * blocksDown() * blockLayers() * planes(); }
    std::int64_t pixelBytes() const { return std::int64_t(channelsPerBlock()) * bytesPerChannel(type); }
    std::int64_t blockRowBytes() const { return blockWidth * pixelBytes(); }
    /// Rows stored in a block of the given row of blocks.
    std::int64_t rowsInBlock(std::int64_t blockRow) const
    {
        return tiled ? blockHeight : std::min(blockHeight, height - blockRow * blockHeight);
    }
    std::int64_t blockIndex(std::int64_t across, std::int64_t down, std::int64_t layer, int plane) const
    {
        return ((plane * blockLayers() + layer) * blocksDown() + down) * blocksAcross() + across;
    }
};

/// Where a block lies in the file.
struct TiffBlock
{
    std::int64_t offset = 0;
    std::int64_t bytes = 0;
};

/// Layout of libtiff's current directory. `where` begins each message ("file.tif: page 3"). A failure for
/// what the project does not read.
Result<TiffLayout> currentLayout(TiffHandle& tiff, const std::string& where);

/// All strips of the current directory, also those that libtiff ignores because they lie beyond the first
/// slice.
Result<std::vector<TiffBlock>> allStrips(const TiffHandle& tiff, const std::string& where);

} // namespace vo
