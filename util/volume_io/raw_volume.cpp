#include "volume_io.h"

#include <optional>

#include "byte_order.h"
#include "input_file.h"
#include "volume_reader.h"

namespace vo {
namespace {

/// Where each slice of a raw volume lies.
struct RawPlaces
{
    std::vector<std::string> paths; // one for all slices, or one each
    std::int64_t firstByte = 0;     // of the first slice in its file
    std::int64_t bytesPerSlice = 0;

    const std::string& path(std::int64_t z) const
    {
        return paths.size() == 1 ? paths[0] : paths[std::size_t(z)];
    }
    std::int64_t byte(std::int64_t z) const
    {
        return firstByte + (paths.size() == 1 ? z * bytesPerSlice : 0);
    }
};

class RawReader final : public VolumeReader
{
public:
    RawReader(const RawLayout& layout, RawPlaces places)
        : places_(std::move(places)), swapped_(layout.byteOrder != nativeByteOrder())
    {
        info_ = layout.info;
        description_.format = "raw";
    }

    Result<void> read(const Region& inside, const BrickView& brick) override
    {
        const std::int64_t end = inside.origin[2] + inside.size[2];
        for (std::int64_t z = inside.origin[2]; z < end; ++z) {
            if (auto opened = openSlice(z); !opened) return opened;
            if (auto read = readSlice(z, inside, brick); !read) return read;
            ++counters_.slices;
        }
        return {};
    }

private:
    Result<void> openSlice(std::int64_t z)
    {
        if (file_ && file_->path() == places_.path(z)) return {};
        auto file = InputFile::open(places_.path(z));
        if (!file) return file.failure();
        file_.emplace(std::move(*file));
        return {};
    }

    Result<void> readSlice(std::int64_t z, const Region& inside, const BrickView& brick)
    {
        const bool wholeRows = inside.size[0] == info_.size[0] && brick.width() == info_.size[0];
        const std::int64_t rowsAtOnce = wholeRows ? inside.size[1] : 1;
        const std::int64_t bytes = rowsAtOnce * inside.size[0] * info_.bytesPerVoxel();
        const std::int64_t end = inside.origin[1] + inside.size[1];
        for (std::int64_t y = inside.origin[1]; y < end; y += rowsAtOnce) {
            const std::int64_t voxel = y * info_.size[0] + inside.origin[0];
            const std::span<std::byte> out(brick.voxel(inside.origin[0], y, z),
                                           static_cast<std::size_t>(bytes));
            if (auto read = file_->readAt(places_.byte(z) + voxel * info_.bytesPerVoxel(), out); !read)
                return read;
            if (swapped_) swapBytes(out, bytesPerChannel(info_.type));
            counters_.rows += rowsAtOnce;
            counters_.bytes += bytes;
        }
        return {};
    }

    RawPlaces places_;
    bool swapped_;
    std::optional<InputFile> file_; // the one read last
};

/// Bytes of the whole volume, once the layout has been found possible.
Result<std::int64_t> checkedBytes(const std::string& path, const RawLayout& layout)
{
    const int channels = layout.info.channels;
    if (channels != 1 && channels != 2 && channels != 4)
        return Failure{path + ": expected 1, 2 or 4 channels, found " + std::to_string(channels)};
    if (layout.headerLength < 0)
        return Failure{path + ": expected a header of 0 or more bytes, found " +
                       std::to_string(layout.headerLength)};
    auto bytes = volumeBytes(layout.info.size, layout.info.bytesPerVoxel());
    if (!bytes) return Failure{path + ": " + bytes.failure().text};
    return bytes;
}

Result<void> checkFileSize(const std::string& path, const RawLayout& layout, std::int64_t bytes)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    // Compared so that neither side can overflow.
    if (file->size() < layout.headerLength || file->size() - layout.headerLength < bytes)
        return Failure{path + ": expected a header of " + std::to_string(layout.headerLength) +
                       " bytes and " + std::to_string(bytes) + " bytes of voxels, found " +
                       std::to_string(file->size()) + " bytes"};
    return {};
}

} // namespace

Result<VolumeFile> openRawVolume(const std::string& path, const RawLayout& layout)
{
    const auto bytes = checkedBytes(path, layout);
    if (!bytes) return bytes.failure();
    if (auto checked = checkFileSize(path, layout, *bytes); !checked) return checked.failure();
    return VolumeFile(std::make_unique<RawReader>(
        layout, RawPlaces{{path}, layout.headerLength, *bytes / layout.info.size[2]}));
}

Result<VolumeFile> openRawSlices(const std::vector<std::string>& paths, const RawLayout& layout)
{
    const std::string first = paths.empty() ? "raw slices" : paths.front();
    const auto bytes = checkedBytes(first, layout);
    if (!bytes) return bytes.failure();
    if (paths.size() != static_cast<std::uint64_t>(layout.info.size[2]))
        return Failure{first + ": expected " + std::to_string(layout.info.size[2]) +
                       " files, one a slice, found " + std::to_string(paths.size())};
    const std::int64_t bytesPerSlice = *bytes / layout.info.size[2];
    for (const std::string& path : paths)
        if (auto checked = checkFileSize(path, layout, bytesPerSlice); !checked) return checked.failure();
    return VolumeFile(
        std::make_unique<RawReader>(layout, RawPlaces{paths, layout.headerLength, bytesPerSlice}));
}

} // namespace vo
