#pragma once

#include <tiffio.h>
#include <zlib.h>

#include "volume_truth.h"

namespace vo {

/// A TIFF as some other program would write it, through libtiff alone.
struct ForeignTiff
{
    const char* mode = "w"; // b: big-endian, l: little-endian, 8: BigTIFF
    std::uint32_t width = 37, height = 23, pages = 5;
    std::uint32_t depth = 1; // above 1: SGI's 3D TIFF, in one page
    int channels = 1;
    ChannelType type = ChannelType::uint8;
    int compression = COMPRESSION_NONE;
    int predictor = 1;
    std::uint32_t rowsPerStrip = 4;
    std::uint32_t tile = 0; // side of tiles; 0: strips
    std::uint32_t tileDepth = 1;
    bool planar = false;
    int photometric = -1;
    int fillOrder = FILLORDER_MSB2LSB;
    bool thumbnails = false;       // a reduced copy after each page
    bool stripsRunThrough = false; // SGI's 3D TIFF whose strips do not stop at a slice's end
    int announcedPages = 0;

    VolumeInfo info() const
    {
        return {{width, height, depth > 1 ? depth : pages}, channels == 3 ? 4 : channels, type};
    }
    void write(const std::string& path) const;

private:
    void setFields(TIFF* tiff, std::uint32_t page) const;
    void writePage(TIFF* tiff, std::uint32_t page) const;
    std::vector<std::byte> packed(const std::vector<std::byte>& bytes) const;
    std::vector<std::byte> block(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t columns,
                                 std::int64_t rows, std::int64_t slices, int plane) const;
};

inline void ForeignTiff::write(const std::string& path) const
{
    // What libtiff warns of in writing (old codec numbers) is wanted; in reading it must be the reader that
    // is silent.
    const TIFFErrorHandler warnings = TIFFSetWarningHandler(nullptr);
    TIFF* tiff = TIFFOpen(path.c_str(), mode);
    ASSERT_NE(tiff, nullptr);
    for (std::uint32_t page = 0; page < (depth > 1 ? 1 : pages); ++page) {
        setFields(tiff, page);
        writePage(tiff, page);
        TIFFWriteDirectory(tiff);
        if (!thumbnails) continue;
        ForeignTiff small = *this;
        small.width = small.height = 3;
        small.setFields(tiff, page);
        TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
        small.writePage(tiff, page);
        TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
    TIFFSetWarningHandler(warnings);
}

inline void ForeignTiff::setFields(TIFF* tiff, std::uint32_t page) const
{
    const bool isSigned = type == ChannelType::int8 || type == ChannelType::int16;
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    if (depth > 1) TIFFSetField(tiff, TIFFTAG_IMAGEDEPTH, depth);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8 * bytesPerChannel(type));
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, channels);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
                 type == ChannelType::float32 ? SAMPLEFORMAT_IEEEFP
                 : isSigned                   ? SAMPLEFORMAT_INT
                                              : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
                 photometric >= 0 ? photometric
                 : channels >= 3  ? PHOTOMETRIC_RGB
                                  : PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
    if (predictor > 1) TIFFSetField(tiff, TIFFTAG_PREDICTOR, predictor);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, planar ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_FILLORDER, fillOrder);
    if (announcedPages > 0) TIFFSetField(tiff, TIFFTAG_PAGENUMBER, static_cast<int>(page), announcedPages);
    if (tile > 0) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, tile);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, tile);
        if (tileDepth > 1) TIFFSetField(tiff, TIFFTAG_TILEDEPTH, tileDepth);
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rowsPerStrip);
    }
}

inline std::vector<std::byte> ForeignTiff::block(std::int64_t x, std::int64_t y, std::int64_t z,
                                                 std::int64_t columns, std::int64_t rows, std::int64_t slices,
                                                 int plane) const
{
    // Three channels are the first three of the four that the reader makes of them.
    const VolumeTruth truth(info());
    const int step = bytesPerChannel(type);
    const int from = planar ? plane : 0;
    const int to = planar ? plane + 1 : channels;
    std::vector<std::byte> bytes(static_cast<std::size_t>(columns * rows * slices * (to - from) * step));
    std::byte* out = bytes.data();
    for (std::int64_t k = 0; k < slices; ++k)
        for (std::int64_t j = 0; j < rows; ++j)
            for (std::int64_t i = 0; i < columns; ++i)
                for (int channel = from; channel < to; ++channel, out += step)
                    if (truth.contains(x + i, (y + j) % height, z + k + (y + j) / height))
                        truth.put(x + i, (y + j) % height, z + k + (y + j) / height, channel, out);
    return bytes;
}

/// What libtiff cannot write, a tile of several slices: deflated, or as it is.
inline std::vector<std::byte> ForeignTiff::packed(const std::vector<std::byte>& bytes) const
{
    if (compression == COMPRESSION_NONE) return bytes;
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::byte> out(size);
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
             static_cast<uLong>(bytes.size()));
    out.resize(size);
    return out;
}

inline void ForeignTiff::writePage(TIFF* tiff, std::uint32_t page) const
{
    const auto rows = std::min(rowsPerStrip, stripsRunThrough ? height * depth : height);
    const std::uint32_t blocksHigh = tile > 0           ? (height + tile - 1) / tile
                                     : stripsRunThrough ? (height * depth + rows - 1) / rows
                                                        : (height + rows - 1) / rows;
    std::uint32_t index = 0;
    for (int plane = 0; plane < (planar ? channels : 1); ++plane)
        for (std::uint32_t layer = 0; layer < (stripsRunThrough ? 1 : depth); layer += tileDepth)
            for (std::uint32_t down = 0; down < blocksHigh; ++down) {
                const std::uint32_t z = page + layer;
                if (tile == 0) {
                    const auto y = down * rows;
                    const auto count = std::min(rows, (stripsRunThrough ? height * depth : height) - y);
                    auto bytes = block(0, y, z, width, count, 1, plane);
                    ASSERT_GT(TIFFWriteEncodedStrip(tiff, index++, bytes.data(), tmsize_t(bytes.size())), 0);
                    continue;
                }
                for (std::uint32_t x = 0; x < width; x += tile) {
                    auto bytes = block(x, down * tile, z, tile, tile, tileDepth, plane);
                    if (tileDepth > 1) bytes = packed(bytes);
                    ASSERT_GT(tileDepth > 1
                                  ? TIFFWriteRawTile(tiff, index++, bytes.data(), tmsize_t(bytes.size()))
                                  : TIFFWriteEncodedTile(tiff, index++, bytes.data(), tmsize_t(bytes.size())),
                              0);
                }
            }
}

} // namespace vo
