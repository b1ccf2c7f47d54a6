#include "volume_io.h"

#include <algorithm>
#include <cstring>

#include "input_file.h"
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
    std::string text = "\"";
    for (const std::byte byte : bytes) {
        const char letter = static_cast<char>(byte);
        text += letter >= ' ' && letter <= '~' ? letter : '.';
    }
    text += '"';
    return text;
}

bool beginsLikeTiff(std::span<const std::byte, 4> bytes)
{
    for (const char* magic : {"II\x2a\0", "MM\0\x2a", "II\x2b\0", "MM\0\x2b"})
        if (std::memcmp(bytes.data(), magic, 4) == 0) return true;
    return false;
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

const ReadCounters& VolumeFile::counters() const
{
    return reader_->counters();
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
    return reader_->read(inside, BrickView(region, bytesPerVoxel, out));
}

Result<VolumeFile> openVolume(const std::string& path)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    std::array<std::byte, 4> magic{};
    const auto count = static_cast<std::size_t>(std::min<std::int64_t>(file->size(), magic.size()));
    if (auto read = file->readAt(0, std::span(magic).first(count)); !read) return read.failure();
    if (!beginsLikeTiff(magic))
        return Failure{path +
                       ": expected a TIFF volume (II or MM and 42 or 43 in its first 4 bytes), found " +
                       readable(std::span(magic).first(count))};
    return openTiffVolume(path);
}

} // namespace vo
