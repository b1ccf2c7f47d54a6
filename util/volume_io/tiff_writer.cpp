#include "volume_io.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "file_beside.h"
#include "memory_block.h"
#include "tiff_handle.h"
#include "volume_reader.h"

namespace vo {
namespace {

// Small enough that a brick of a compressed file decodes little beside its own rows.
constexpr std::int64_t kStripBytes = 16384;
constexpr std::int64_t kMostPages = 1048576; // libtiff follows no more
// Where classic TIFF ends, less a reserve for the directory that is being written.
constexpr std::int64_t kClassicLimit = (std::int64_t(1) << 32) - (1 << 20);

std::int64_t rowsPerStrip(const VolumeInfo& info)
{
    const std::int64_t rowBytes = info.size[0] * info.bytesPerVoxel();
    return std::clamp<std::int64_t>(kStripBytes / rowBytes, 1, info.size[1]);
}

/// An upper bound of the file's size without compression.
double fileBytes(const VolumeInfo& info, std::int64_t voxelBytes)
{
    const double strips = double(info.size[1] / rowsPerStrip(info) + 1) * double(info.size[2]);
    return double(voxelBytes) + 512.0 * double(info.size[2]) + 16.0 * strips;
}

Result<void> checkRoom(const std::string& path, double bytes)
{
    std::error_code error;
    const auto folder = std::filesystem::absolute(path, error).parent_path();
    const auto space = std::filesystem::space(folder, error);
    if (error || bytes <= double(space.available)) return {};
    return Failure{path + ": cannot write: expected " + std::to_string(std::uint64_t(bytes)) +
                   " bytes free on the disk, found " + std::to_string(space.available)};
}

std::uint16_t sampleFormat(ChannelType type)
{
    switch (type) {
    case ChannelType::uint8:
    case ChannelType::uint16: return SAMPLEFORMAT_UINT;
    case ChannelType::int8:
    case ChannelType::int16: return SAMPLEFORMAT_INT;
    case ChannelType::float32: return SAMPLEFORMAT_IEEEFP;
    }
    return SAMPLEFORMAT_UINT;
}

/// Describes the page that is about to be written.
void setPageFields(TIFF* tiff, const VolumeInfo& info, Compression compression, std::int64_t z)
{
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(info.size[0]));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(info.size[1]));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8 * bytesPerChannel(info.type));
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, info.channels);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, sampleFormat(info.type));
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, info.channels == 4 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
    if (info.channels != 1) {
        const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha);
    }
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(rowsPerStrip(info)));
    if (compression == Compression::deflate) {
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
        TIFFSetField(tiff, TIFFTAG_PREDICTOR,
                     info.type == ChannelType::float32 ? PREDICTOR_FLOATINGPOINT : PREDICTOR_HORIZONTAL);
    } else {
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    }
    TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_PAGE);
    // Tells a reader how many pages there should be, where the tag's 16 bits can.
    if (info.size[2] <= 0xffff)
        TIFFSetField(tiff, TIFFTAG_PAGENUMBER, static_cast<int>(z), static_cast<int>(info.size[2]));
}

} // namespace

struct TiffStackWriter::State
{
    std::string path;
    VolumeInfo info;
    Compression compression = Compression::none;
    FileBeside file;
    TiffHandle tiff;           // goes before the file that it writes to
    MemoryBlock row;           // libtiff's predictors work in the caller's memory
    std::int64_t y = 0, z = 0; // the row to come

    Result<void> writeRow(std::span<const std::byte> bytes);
};

Result<void> TiffStackWriter::State::writeRow(std::span<const std::byte> bytes)
{
    if (z == info.size[2])
        return Failure{path + ": expected " + std::to_string(info.size[2]) + " slices, found more rows"};
    if (y == 0) setPageFields(tiff.get(), info, compression, z);
    std::ranges::copy(bytes, row.bytes().begin());
    bool good = TIFFWriteScanline(tiff.get(), row.bytes().data(), static_cast<std::uint32_t>(y)) == 1;
    if (good && ++y == info.size[1]) {
        good = TIFFWriteDirectory(tiff.get()) == 1;
        y = 0;
        ++z;
    }
    if (!good || tiff.sawError()) return Failure{path + ": cannot write" + tiff.takeComplaint()};
    return {};
}

Result<TiffStackWriter> TiffStackWriter::create(const std::string& path, const VolumeInfo& info,
                                                const TiffOptions& options)
{
    if (info.channels != 1 && info.channels != 2 && info.channels != 4)
        return Failure{path + ": cannot write: expected 1, 2 or 4 channels, found " +
                       std::to_string(info.channels)};
    const auto voxelBytes = volumeBytes(info.size, info.bytesPerVoxel());
    if (!voxelBytes) return Failure{path + ": cannot write: " + voxelBytes.failure().text};
    if (info.size[2] > kMostPages)
        return Failure{path + ": cannot write: expected at most " + std::to_string(kMostPages) +
                       " slices, found " + std::to_string(info.size[2])};
    const double bytes = fileBytes(info, *voxelBytes);
    const bool big = options.kind == TiffKind::big ||
                     (options.kind == TiffKind::automatic && bytes > double(kClassicLimit));
    if (options.compression == Compression::none)
        if (auto checked = checkRoom(path, bytes); !checked) return checked.failure();

    auto file = FileBeside::create(path);
    if (!file) return file.failure();
    auto tiff = TiffHandle::write(file->temporaryPath(), path, big);
    if (!tiff) return tiff.failure();
    auto row = MemoryBlock::allocate(path, info.size[0] * info.bytesPerVoxel());
    if (!row) return row.failure();
    return TiffStackWriter(std::unique_ptr<State>(
        new State{path, info, options.compression, std::move(*file), std::move(*tiff), std::move(*row)}));
}

TiffStackWriter::TiffStackWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
TiffStackWriter::TiffStackWriter(TiffStackWriter&&) noexcept = default;
TiffStackWriter& TiffStackWriter::operator=(TiffStackWriter&&) noexcept = default;
TiffStackWriter::~TiffStackWriter() = default;

Result<void> TiffStackWriter::appendRows(std::span<const std::byte> rows)
{
    const std::size_t rowBytes = state_->row.bytes().size();
    if (rows.size() % rowBytes != 0)
        return Failure{state_->path + ": expected whole rows of " + std::to_string(rowBytes) +
                       " bytes, found " + std::to_string(rows.size()) + " bytes"};
    for (; !rows.empty(); rows = rows.subspan(rowBytes))
        if (auto written = state_->writeRow(rows.first(rowBytes)); !written) return written;
    return {};
}

Result<void> TiffStackWriter::finish()
{
    const VolumeInfo& info = state_->info;
    if (state_->z != info.size[2])
        return Failure{state_->path + ": expected " + std::to_string(info.size[2]) + " slices of " +
                       std::to_string(info.size[1]) + " rows, found " + std::to_string(state_->z) +
                       " slices and " + std::to_string(state_->y) + " rows"};
    if (auto closed = state_->tiff.closeWritten(); !closed) return closed;
    return state_->file.commit();
}

Result<void> writeTiffStack(const std::string& path, const VolumeInfo& info,
                            std::span<const std::byte> voxels, const TiffOptions& options)
{
    const auto bytes = volumeBytes(info.size, info.bytesPerVoxel());
    if (!bytes || voxels.size() != static_cast<std::size_t>(*bytes))
        return Failure{path + ": cannot write: " +
                       (bytes ? "expected " + std::to_string(*bytes) + " bytes of voxels, found " +
                                    std::to_string(voxels.size())
                              : bytes.failure().text)};
    auto writer = TiffStackWriter::create(path, info, options);
    if (!writer) return writer.failure();
    if (auto written = writer->appendRows(voxels); !written) return written;
    return writer->finish();
}

} // namespace vo
