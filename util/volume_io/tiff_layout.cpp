#include "tiff_layout.h"

#include <algorithm>
#include <optional>

#include "byte_order.h"
#include "volume_reader.h"

namespace vo {
namespace {

constexpr std::uint32_t kLargestSize = 0x7fffffff;

std::uint16_t shortField(TIFF* tiff, std::uint32_t tag, std::uint16_t otherwise)
{
    std::uint16_t value = otherwise;
    return TIFFGetFieldDefaulted(tiff, tag, &value) ? value : otherwise;
}

std::uint32_t longField(TIFF* tiff, std::uint32_t tag, std::uint32_t otherwise)
{
    std::uint32_t value = otherwise;
    return TIFFGetField(tiff, tag, &value) ? value : otherwise;
}

std::optional<ChannelType> channelType(std::uint16_t bits, std::uint16_t format)
{
    const bool isUnsigned = format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID;
    if (bits == 8 && isUnsigned) return ChannelType::uint8;
    if (bits == 8 && format == SAMPLEFORMAT_INT) return ChannelType::int8;
    if (bits == 16 && isUnsigned) return ChannelType::uint16;
    if (bits == 16 && format == SAMPLEFORMAT_INT) return ChannelType::int16;
    if (bits == 32 && format == SAMPLEFORMAT_IEEEFP) return ChannelType::float32;
    return std::nullopt;
}

std::string formatName(std::uint16_t bits, std::uint16_t format)
{
    const char* kind = format == SAMPLEFORMAT_INT             ? "signed"
                       : format == SAMPLEFORMAT_IEEEFP        ? "float"
                       : format == SAMPLEFORMAT_COMPLEXINT    ? "complex integer"
                       : format == SAMPLEFORMAT_COMPLEXIEEEFP ? "complex float"
                                                              : "unsigned";
    return std::to_string(bits) + "-bit " + kind;
}

std::string photometricName(std::uint16_t photometric)
{
    switch (photometric) {
    case PHOTOMETRIC_MINISWHITE: return "white as zero (MinIsWhite)";
    case PHOTOMETRIC_PALETTE: return "a palette";
    case PHOTOMETRIC_MASK: return "a mask";
    case PHOTOMETRIC_SEPARATED: return "ink (CMYK)";
    case PHOTOMETRIC_YCBCR: return "YCbCr";
    case PHOTOMETRIC_CIELAB: return "CIE Lab";
    }
    return "photometric interpretation " + std::to_string(photometric);
}

Result<void> readVoxelKind(TIFF* tiff, const std::string& where, TiffLayout& layout)
{
    const auto bits = shortField(tiff, TIFFTAG_BITSPERSAMPLE, 1);
    const auto format = shortField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    const auto type = channelType(bits, format);
    if (!type)
        return Failure{where + ": expected 8- or 16-bit integers or 32-bit floats, found " +
                       formatName(bits, format)};
    layout.type = *type;

    layout.channels = shortField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    if (layout.channels < 1 || layout.channels > 4)
        return Failure{where + ": expected 1 to 4 channels, found " + std::to_string(layout.channels)};

    const auto photometric = shortField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    if (photometric != PHOTOMETRIC_MINISBLACK && photometric != PHOTOMETRIC_RGB)
        return Failure{where + ": expected grey (MinIsBlack) or RGB values, found " +
                       photometricName(photometric)};
    layout.planar = layout.channels > 1 &&
                    shortField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE;
    return {};
}

Result<void> readBlockShape(TIFF* tiff, const std::string& where, TiffLayout& layout)
{
    layout.tiled = TIFFIsTiled(tiff) != 0;
    std::uint32_t width = static_cast<std::uint32_t>(layout.width);
    std::uint32_t height = 0;
    std::uint32_t depth = 1;
    if (layout.tiled) {
        width = longField(tiff, TIFFTAG_TILEWIDTH, 0);
        height = longField(tiff, TIFFTAG_TILELENGTH, 0);
        depth = longField(tiff, TIFFTAG_TILEDEPTH, 1);
    } else {
        height = std::min(longField(tiff, TIFFTAG_ROWSPERSTRIP, kLargestSize), kLargestSize);
    }
    if (width < 1 || height < 1 || depth < 1 || width > kLargestSize || height > kLargestSize ||
        depth > kLargestSize)
        return Failure{where + ": expected strips or tiles of 1 to 2147483647 voxels a side, found " +
                       sizeText({width, height, depth})};
    layout.blockWidth = width;
    layout.blockHeight = height;
    layout.blockDepth = depth;
    if (!layout.tiled) return {};
    const auto bytes = volumeBytes({width, height, depth}, static_cast<int>(layout.pixelBytes()));
    return bytes ? Result<void>() : Failure{where + ": tile size: " + bytes.failure().text};
}

Result<void> readCompression(TIFF* tiff, const std::string& where, TiffLayout& layout)
{
    const auto compression = shortField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    switch (compression) {
    case COMPRESSION_NONE:
    case COMPRESSION_LZW:
    case COMPRESSION_ADOBE_DEFLATE:
    case COMPRESSION_DEFLATE:
    case COMPRESSION_PACKBITS: break;
    default:
        return Failure{where +
                       ": expected no compression, LZW, deflate or PackBits, found compression scheme " +
                       std::to_string(compression)};
    }
    layout.reversedBits = shortField(tiff, TIFFTAG_FILLORDER, FILLORDER_MSB2LSB) == FILLORDER_LSB2MSB;
    layout.encoded = compression != COMPRESSION_NONE || layout.reversedBits;
    layout.deflated = compression == COMPRESSION_ADOBE_DEFLATE || compression == COMPRESSION_DEFLATE;
    layout.swapped = TIFFIsByteSwapped(tiff) != 0;
    return {};
}

/// Reads numbers in the byte order of a TIFF file, which libtiff has found to be one.
class DirectoryBytes
{
public:
    explicit DirectoryBytes(const TiffHandle& tiff)
        : file_(tiff.file()), swapped_(TIFFIsByteSwapped(tiff.get()) != 0),
          big_(TIFFIsBigTIFF(tiff.get()) != 0)
    {
    }

    bool big() const { return big_; }
    std::int64_t fileSize() const { return file_.size(); }

    /// `count` unsigned numbers of `width` bytes each, from `offset` on.
    Result<std::vector<std::uint64_t>> numbers(std::int64_t offset, std::int64_t count, int width) const
    {
        if (offset < 0 || count < 0 || count > file_.size() / width)
            return Failure{file_.path() + ": expected " + std::to_string(count) + " numbers at byte " +
                           std::to_string(offset) + ", found a file of " + std::to_string(file_.size()) +
                           " bytes"};
        std::vector<std::byte> bytes(static_cast<std::size_t>(count * width));
        if (auto read = file_.readAt(offset, bytes); !read) return read.failure();
        const bool littleEndian = (nativeByteOrder() == ByteOrder::littleEndian) != swapped_;
        std::vector<std::uint64_t> values(static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < values.size(); ++i)
            for (int k = 0; k < width; ++k) {
                const int place = littleEndian ? width - 1 - k : k;
                values[i] = values[i] << 8 | std::to_integer<std::uint64_t>(
                                                 bytes[i * std::size_t(width) + std::size_t(place)]);
            }
        return values;
    }

private:
    const InputFile& file_;
    bool swapped_;
    bool big_;
};

int bytesOfFieldType(std::uint64_t type)
{
    return type == TIFF_SHORT ? 2 : type == TIFF_LONG ? 4 : type == TIFF_LONG8 ? 8 : 0;
}

/// Values of an array of unsigned integers in the directory at `directory`; none if the tag is not there.
Result<std::vector<std::uint64_t>> directoryArray(const DirectoryBytes& bytes, std::int64_t directory,
                                                  std::uint64_t tag)
{
    const int countWidth = bytes.big() ? 8 : 2;
    const int wordWidth = bytes.big() ? 8 : 4; // of an entry's count and value
    const int entryLength = 4 + 2 * wordWidth;
    const auto entries = bytes.numbers(directory, 1, countWidth);
    if (!entries) return entries.failure();
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>((*entries)[0], 65535); ++i) {
        const std::int64_t entry = directory + countWidth + static_cast<std::int64_t>(i) * entryLength;
        const auto kind = bytes.numbers(entry, 2, 2);
        if (!kind) return kind.failure();
        if ((*kind)[0] != tag) continue;
        const auto count = bytes.numbers(entry + 4, 1, wordWidth);
        if (!count) return count.failure();
        const int width = bytesOfFieldType((*kind)[1]);
        const auto length = static_cast<std::int64_t>(std::min<std::uint64_t>((*count)[0], INT64_MAX));
        if (width == 0 || length > bytes.fileSize() / width) return std::vector<std::uint64_t>();
        if (length * width <= wordWidth) return bytes.numbers(entry + 4 + wordWidth, length, width);
        const auto place = bytes.numbers(entry + 4 + wordWidth, 1, wordWidth);
        if (!place) return place.failure();
        return bytes.numbers(static_cast<std::int64_t>((*place)[0]), length, width);
    }
    return std::vector<std::uint64_t>();
}

} // namespace

Result<TiffLayout> currentLayout(TiffHandle& tiff, const std::string& where)
{
    TIFF* handle = tiff.get();
    const std::uint32_t width = longField(handle, TIFFTAG_IMAGEWIDTH, 0);
    const std::uint32_t height = longField(handle, TIFFTAG_IMAGELENGTH, 0);
    const std::uint32_t depth = longField(handle, TIFFTAG_IMAGEDEPTH, 1);
    if (width < 1 || height < 1 || depth < 1 || width > kLargestSize || height > kLargestSize ||
        depth > kLargestSize)
        return Failure{where + ": expected sizes from 1 to 2147483647, found " +
                       sizeText({width, height, depth})};

    TiffLayout layout;
    layout.width = width;
    layout.height = height;
    layout.depth = depth;
    if (auto read = readVoxelKind(handle, where, layout); !read) return read.failure();
    // Bounds every product of sizes, block counts included.
    const auto bytes = volumeBytes({width, height, depth}, layout.channels * bytesPerChannel(layout.type));
    if (!bytes) return Failure{where + ": " + bytes.failure().text};
    if (auto read = readBlockShape(handle, where, layout); !read) return read.failure();
    if (auto read = readCompression(handle, where, layout); !read) return read.failure();
    return layout;
}

Result<std::vector<TiffBlock>> allStrips(const TiffHandle& tiff, const std::string& where)
{
    const DirectoryBytes bytes(tiff);
    const auto directory = static_cast<std::int64_t>(TIFFCurrentDirOffset(tiff.get()));
    const auto offsets = directoryArray(bytes, directory, TIFFTAG_STRIPOFFSETS);
    if (!offsets) return offsets.failure();
    const auto counts = directoryArray(bytes, directory, TIFFTAG_STRIPBYTECOUNTS);
    if (!counts) return counts.failure();
    if (offsets->size() != counts->size())
        return Failure{where + ": expected as many strip lengths as strips, found " +
                       std::to_string(counts->size()) + " and " + std::to_string(offsets->size())};
    std::vector<TiffBlock> strips;
    for (std::size_t i = 0; i < offsets->size(); ++i)
        strips.push_back({static_cast<std::int64_t>((*offsets)[i]), static_cast<std::int64_t>((*counts)[i])});
    return strips;
}

} // namespace vo
