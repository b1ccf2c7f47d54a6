#include "vorender_volume.h"

#include "utility.h"
#include "volume_view/brightness_alpha.h"
#include "volume_view/defaults.h"

#include "appearance/convert_voxels.h"
#include "core/parallel.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace vo {
namespace {

VoxelType voxelTypeOf(ChannelType type)
{
    switch (type) {
    case ChannelType::uint8: return VoxelType::uint8;
    case ChannelType::int8: return VoxelType::int8;
    case ChannelType::uint16: return VoxelType::uint16;
    case ChannelType::int16: return VoxelType::int16;
    case ChannelType::float32: return VoxelType::float32;
    }
    return VoxelType::uint8;
}

Channels channelsOf(int channels)
{
    return channels == 1 ? Channels::luminance : channels == 2 ? Channels::luminanceAlpha : Channels::rgba;
}

TexelFormat texelOf(Channels channels)
{
    switch (channels) {
    case Channels::intensity:
    case Channels::luminance: return TexelFormat::intensity;
    case Channels::luminanceAlpha: return TexelFormat::luminanceAlpha;
    case Channels::rgba:
    case Channels::abgr: break;
    }
    return TexelFormat::rgba;
}

/// Reads some slices at a time, so that a user sees how far it is and may interrupt.
Result<void> readSlices(const std::string& path, VolumeFile& file, std::span<std::byte> out)
{
    constexpr std::int64_t kBytesAtOnce = 64 << 20;
    const auto& size = file.info().size;
    const std::int64_t sliceBytes = size[0] * size[1] * file.info().bytesPerVoxel();
    const std::int64_t atOnce = std::clamp<std::int64_t>(kBytesAtOnce / sliceBytes, 1, size[2]);
    for (std::int64_t z = 0; z < size[2]; z += atOnce) {
        if (interrupted()) return Failure{path + ": interrupted while reading"};
        const std::int64_t count = std::min(atOnce, size[2] - z);
        const auto slices = out.subspan(std::size_t(z * sliceBytes), std::size_t(count * sliceBytes));
        if (auto read = file.readBrick({{0, 0, z}, {size[0], size[1], count}}, slices); !read) return read;
        if (atOnce < size[2]) showProgress("vorender", "slice", z + count, size[2]);
    }
    return {};
}

/// Parts of `count` things for as many threads as there are, and some more.
struct Parts
{
    explicit Parts(std::size_t all) : all_(all), count_(std::clamp<std::size_t>(all >> 18, 1, 64)) {}
    std::size_t count() const { return count_; }
    std::size_t begin(std::size_t part) const { return all_ / count_ * part + std::min(part, all_ % count_); }
    std::size_t size(std::size_t part) const { return begin(part + 1) - begin(part); }

private:
    std::size_t all_, count_;
};

ValueRange rangeOf(ChannelType type, std::span<const std::byte> values)
{
    const auto bytes = static_cast<std::size_t>(bytesPerChannel(type));
    const Parts parts(values.size() / bytes);
    std::vector<ValueRange> ranges(parts.count());
    parallelFor(parts.count(), 0, [&](std::size_t part) {
        growRange(ranges[part], type, values.data() + parts.begin(part) * bytes, parts.size(part));
    });
    ValueRange all;
    for (const ValueRange& range : ranges)
        growRange(all, range);
    return all;
}

/// Spreads [low, high] over what a texture shows as 0 to 1.
void stretch(const LoadedVolume& volume)
{
    const bool same = (volume.format.type == VoxelType::uint8 && volume.low == 0 && volume.high == 255) ||
                      (volume.format.type == VoxelType::uint16 && volume.low == 0 && volume.high == 65535);
    if (same) return;
    const std::size_t voxelSize = voxelBytes(volume.format);
    const std::span<std::byte> voxels = volume.voxels.bytes().first(volume.size.count() * voxelSize);
    const Parts parts(volume.size.count());
    parallelFor(parts.count(), 0, [&](std::size_t part) {
        stretchRange(voxels.subspan(parts.begin(part) * voxelSize, parts.size(part) * voxelSize),
                     volume.format, double(volume.low), double(volume.high));
    });
}

void setBrightnessAlpha(const LoadedVolume& volume, ChannelType type)
{
    const std::size_t voxelSize = voxelBytes(volume.format);
    const Parts parts(volume.size.count());
    parallelFor(parts.count(), 0, [&](std::size_t part) {
        setBrightnessAlpha(
            type, volume.voxels.bytes().subspan(parts.begin(part) * voxelSize, parts.size(part) * voxelSize));
    });
}

/// The values that the table begins and ends at, from the voxels as the file has them.
ValueRange chosenRange(const std::string& path, const VolumeInfo& info, std::span<const std::byte> voxels,
                       const Options& options)
{
    const bool isByte = bytesPerChannel(info.type) == 1;
    ValueRange seen;
    if (info.channels == 1 && !isByte && !options.dataRange) seen = rangeOf(info.type, voxels);
    if (seen.low == seen.high) {
        char text[80];
        std::snprintf(text, sizeof text, ": all voxels are %g; nothing to tell apart", seen.low);
        warn("vorender", path + text);
    }
    return dataRange(options, seen, fullRange(info.type), isByte);
}

} // namespace

Result<LoadedVolume> loadVolume(const std::string& path, VolumeFile& file, const Options& options, bool color)
{
    const VolumeInfo& info = file.info();
    const auto bytes = volumeBytes(info.size, info.bytesPerVoxel());
    if (!bytes) return Failure{path + ": " + bytes.failure().text};
    auto block = MemoryBlock::allocate(path, *bytes);
    if (!block) return block.failure();
    if (auto read = readSlices(path, file, block->bytes()); !read) return read.failure();

    LoadedVolume volume;
    volume.size = {int(info.size[0]), int(info.size[1]), int(info.size[2])};
    volume.spacing = file.description().spacing;
    volume.format = {channelsOf(info.channels), voxelTypeOf(info.type)};
    const ValueRange range = chosenRange(path, info, block->bytes(), options);
    volume.low = static_cast<float>(range.low);
    volume.high = static_cast<float>(range.high);
    volume.voxels = std::move(*block);
    if (file.description().alphaAdded && !options.mip && !hasTable(options))
        setBrightnessAlpha(volume, info.type);
    if (info.channels == 4 && !color) {
        const VoxelFormat grey{Channels::luminanceAlpha, volume.format.type};
        std::byte* voxels = volume.voxels.bytes().data();
        convertVoxels(voxels, volume.format, voxels, grey, volume.size.count());
        volume.format = grey;
    }
    volume.texel = texelOf(volume.format.channels);
    stretch(volume);
    return volume;
}

} // namespace vo
