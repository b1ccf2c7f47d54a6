#include "volume_io.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <future>
#include <string_view>
#include <system_error>
#include <thread>

#include "deflate_stream.h"
#include "input_file.h"
#include "printable_text.h"
#include "volume_reader.h"

namespace vo {
namespace {

constexpr std::int64_t kLargestSize = 0x7fffffff;

/// The part of `region` that lies in the volume; empty sizes (0) where there is none.
Region clipped(const Region& region, const std::array<std::int64_t, 3>& volume)
{
    Region inside;
    for (int axis = 0; axis < 3; ++axis) {
        // Origins further out than any volume reaches are pulled in, so that the sum below cannot overflow.
        const std::int64_t origin = std::clamp(region.origin[axis], -2 * kLargestSize, 2 * kLargestSize);
        const std::int64_t low = std::max<std::int64_t>(origin, 0);
        const std::int64_t high = std::min(origin + region.size[axis], volume[axis]);
        inside.origin[axis] = low;
        inside.size[axis] = std::max<std::int64_t>(high - low, 0);
    }
    return inside;
}

/// The first bytes as they would be typed, for messages about files of an unknown kind.
std::string readable(std::span<const std::byte> bytes)
{
    if (bytes.empty()) return "an empty file";
    return '"' + printable(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())) + '"';
}

enum class FileKind { tiff, nrrd, nifti, metaImage, dicom, png, jpeg, unknown };

/// The first bytes of a file, and those of what it decompresses to where it is a gzip file.
struct FileStart
{
    std::vector<std::byte> bytes, unpacked;
};

bool holds(std::span<const std::byte> bytes, std::size_t offset, std::string_view text)
{
    return bytes.size() >= offset + text.size() &&
           std::memcmp(bytes.data() + offset, text.data(), text.size()) == 0;
}

bool beginsLikeTiff(std::span<const std::byte> bytes)
{
    using namespace std::string_view_literals;
    for (const auto magic : {"II\x2a\0"sv, "MM\0\x2a"sv, "II\x2b\0"sv, "MM\0\x2b"sv})
        if (holds(bytes, 0, magic)) return true;
    return false;
}

bool beginsLikeNifti(std::span<const std::byte> bytes)
{
    for (const char* magic : {"n+1", "ni1"})
        if (holds(bytes, 344, magic)) return true;
    for (const char* magic : {"n+2", "ni2"})
        if (holds(bytes, 4, magic)) return true;
    return false;
}

/// Whether the first line is a field of the MetaImage header.
bool beginsLikeMetaImage(std::span<const std::byte> bytes)
{
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    const auto line = text.substr(first, text.find('\n', first) - first);
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return false;
    for (const char* key : {"ObjectType", "NDims", "Comment", "ID", "Name", "DimSize", "BinaryData"})
        if (line.starts_with(key) && line.find_first_not_of(" \t", std::strlen(key)) == equals) return true;
    return false;
}

FileKind kindByContent(const FileStart& start)
{
    using namespace std::string_view_literals;
    if (beginsLikeTiff(start.bytes)) return FileKind::tiff;
    if (holds(start.bytes, 0, "\x89PNG\r\n\x1a\n"sv)) return FileKind::png;
    if (holds(start.bytes, 0, "\xff\xd8\xff"sv)) return FileKind::jpeg;
    if (holds(start.bytes, 0, "NRRD000"sv)) return FileKind::nrrd;
    if (beginsLikeNifti(start.unpacked.empty() ? start.bytes : start.unpacked)) return FileKind::nifti;
    if (holds(start.bytes, 128, "DICM"sv)) return FileKind::dicom;
    if (beginsLikeMetaImage(start.bytes)) return FileKind::metaImage;
    return FileKind::unknown;
}

/// For files whose content says nothing: damaged ones, and those of a NIfTI pair that hold the voxels.
FileKind kindByEnding(const std::string& path)
{
    std::string lower = path;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const std::pair<const char*, FileKind> endings[] = {
        {".nii", FileKind::nifti},     {".nii.gz", FileKind::nifti},  {".hdr", FileKind::nifti},
        {".hdr.gz", FileKind::nifti},  {".img", FileKind::nifti},     {".img.gz", FileKind::nifti},
        {".mhd", FileKind::metaImage}, {".mha", FileKind::metaImage}, {".dcm", FileKind::dicom},
        {".ima", FileKind::dicom},
    };
    for (const auto& [ending, kind] : endings)
        if (lower.ends_with(ending)) return kind;
    return FileKind::unknown;
}

Result<FileStart> startOf(const InputFile& file)
{
    constexpr std::size_t kEnough = 544; // as long as the longest header, NIfTI-2's
    FileStart start;
    start.bytes.resize(static_cast<std::size_t>(std::min<std::int64_t>(file.size(), kEnough)));
    if (auto read = file.readAt(0, start.bytes); !read) return read.failure();
    if (!beginsLikeGzip(start.bytes)) return start;
    start.unpacked.resize(kEnough);
    DeflateStream stream(file, 0);
    const auto count = stream.readSome(start.unpacked);
    start.unpacked.resize(count ? static_cast<std::size_t>(*count) : 0);
    return start;
}

/// Slices of `inside`, of `bytes` bytes, for one thread each.
std::vector<Region> slabsOf(const Region& inside, std::int64_t bytes)
{
    constexpr std::int64_t kWorthAThread = 1 << 20;
    constexpr std::int64_t kMostThreads = 16;
    const std::int64_t threads =
        std::clamp<std::int64_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
    const std::int64_t count =
        std::clamp<std::int64_t>(std::min(threads, bytes / kWorthAThread), 1, inside.size[2]);
    std::vector<Region> slabs;
    for (std::int64_t i = 0; i < count; ++i) {
        Region slab = inside;
        const std::int64_t from = inside.size[2] * i / count, to = inside.size[2] * (i + 1) / count;
        slab.origin[2] += from;
        slab.size[2] = to - from;
        slabs.push_back(slab);
    }
    return slabs;
}

/// Reads the first slab here and the others in threads; the failure is that of the first slab that has one.
Result<void> readSlabs(VolumeReader& reader, const std::vector<std::unique_ptr<VolumeReader>>& others,
                       const std::vector<Region>& slabs, const BrickView& brick)
{
    std::vector<std::future<Result<void>>> pending;
    for (std::size_t i = 1; i < slabs.size(); ++i) {
        const auto read = [&, i] { return others[i - 1]->read(slabs[i], brick); };
        try {
            pending.push_back(std::async(std::launch::async, read));
        } catch (const std::system_error&) { // no more threads
            pending.push_back(std::async(std::launch::deferred, read));
        }
    }
    Result<void> result = reader.read(slabs[0], brick);
    for (auto& slab : pending)
        if (auto read = slab.get(); result && !read) result = read;
    return result;
}

ReadCounters sum(const ReadCounters& a, const ReadCounters& b)
{
    return {a.slices + b.slices, a.rows + b.rows, a.bytes + b.bytes};
}

} // namespace

int bytesPerChannel(ChannelType type)
{
    switch (type) {
    case ChannelType::uint8:
    case ChannelType::int8: return 1;
    case ChannelType::uint16:
    case ChannelType::int16: return 2;
    case ChannelType::float32: return 4;
    }
    return 0;
}

const char* channelTypeName(ChannelType type)
{
    switch (type) {
    case ChannelType::uint8: return "uint8";
    case ChannelType::int8: return "int8";
    case ChannelType::uint16: return "uint16";
    case ChannelType::int16: return "int16";
    case ChannelType::float32: return "float32";
    }
    return "unknown";
}

std::string sizeText(const std::array<std::int64_t, 3>& size)
{
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

Result<std::int64_t> volumeBytes(const std::array<std::int64_t, 3>& voxels, int bytesPerVoxel)
{
    std::int64_t bytes = bytesPerVoxel;
    for (const std::int64_t size : voxels) {
        if (size < 1 || size > kLargestSize)
            return Failure{"expected sizes from 1 to 2147483647 voxels, found " + sizeText(voxels)};
        if (__builtin_mul_overflow(bytes, size, &bytes))
            return Failure{"expected a volume of less than 2^63 bytes, found " + sizeText(voxels) +
                           " voxels of " + std::to_string(bytesPerVoxel) + " bytes"};
    }
    return bytes;
}

VolumeFile::VolumeFile(std::unique_ptr<VolumeReader> reader) : reader_(std::move(reader)) {}
VolumeFile::VolumeFile(VolumeFile&&) noexcept = default;
VolumeFile& VolumeFile::operator=(VolumeFile&&) noexcept = default;
VolumeFile::~VolumeFile() = default;

const VolumeInfo& VolumeFile::info() const
{
    return reader_->info();
}

const VolumeDescription& VolumeFile::description() const
{
    return reader_->description();
}

const ReadCounters& VolumeFile::counters() const
{
    return counters_;
}

Result<void> VolumeFile::readBrick(const Region& region, std::span<std::byte> out)
{
    const int bytesPerVoxel = info().bytesPerVoxel();
    const auto bytes = volumeBytes(region.size, bytesPerVoxel);
    if (!bytes) return Failure{"brick: " + bytes.failure().text};
    if (out.size() != static_cast<std::size_t>(*bytes))
        return Failure{"brick: expected memory of " + std::to_string(*bytes) + " bytes for " +
                       sizeText(region.size) + " voxels, found " + std::to_string(out.size())};

    const Region inside = clipped(region, info().size);
    if (inside.size != region.size) std::fill(out.begin(), out.end(), std::byte{0});
    if (std::ranges::find(inside.size, 0) != inside.size.end()) return {};
    const BrickView brick(region, bytesPerVoxel, out);
    auto slabs = slabsOf(inside, *bytes);
    while (others_.size() + 1 < slabs.size()) {
        auto other = reader_->another();
        if (!other) {
            slabs = {inside};
            break;
        }
        others_.push_back(std::move(other));
    }
    const auto read = readSlabs(*reader_, others_, slabs, brick);
    counters_ = reader_->counters();
    for (const auto& other : others_)
        counters_ = sum(counters_, other->counters());
    return read;
}

Result<VolumeFile> openVolume(const std::string& path)
{
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return openDicomFolder(path);
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    const auto start = startOf(*file);
    if (!start) return start.failure();
    FileKind kind = kindByContent(*start);
    if (kind == FileKind::unknown && file->size() > 0) kind = kindByEnding(path);
    switch (kind) {
    case FileKind::tiff: return openTiffVolume(path);
    case FileKind::nrrd: return openNrrdVolume(path);
    case FileKind::nifti: return openNiftiVolume(path);
    case FileKind::metaImage: return openMetaImageVolume(path);
    case FileKind::dicom: return openDicomFile(path);
    case FileKind::png: return openPngVolume(path);
    case FileKind::jpeg: return openJpegVolume(path);
    case FileKind::unknown: break;
    }
    return Failure{path + ": expected a volume (TIFF, NRRD, NIfTI, MetaImage, DICOM, PNG or JPEG), found " +
                   readable(std::span(start->bytes).first(std::min<std::size_t>(start->bytes.size(), 4)))};
}

} // namespace vo
