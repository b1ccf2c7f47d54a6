#include "volume_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "utility.h"

namespace vo {
namespace {

template <class Number, class See>
void seeEach(std::span<const std::byte> bytes, std::size_t channels, const See& see)
{
    std::size_t channel = 0;
    for (std::size_t i = 0; i + sizeof(Number) <= bytes.size(); i += sizeof(Number)) {
        Number value;
        std::memcpy(&value, &bytes[i], sizeof value);
        see(channel, static_cast<double>(value));
        if (++channel == channels) channel = 0;
    }
}

/// Calls see(channel, value) for every value of these voxels.
template <class See>
void seeValues(const VolumeInfo& info, std::span<const std::byte> bytes, const See& see)
{
    const auto channels = static_cast<std::size_t>(info.channels);
    switch (info.type) {
    case ChannelType::uint8: return seeEach<std::uint8_t>(bytes, channels, see);
    case ChannelType::int8: return seeEach<std::int8_t>(bytes, channels, see);
    case ChannelType::uint16: return seeEach<std::uint16_t>(bytes, channels, see);
    case ChannelType::int16: return seeEach<std::int16_t>(bytes, channels, see);
    case ChannelType::float32: return seeEach<float>(bytes, channels, see);
    }
}

/// Calls see(voxels) for all voxels, some rows at a time.
template <class See>
Result<void> seeVoxels(const char* program, const char* what, const std::string& path, VolumeFile& volume,
                       const See& see)
{
    constexpr std::int64_t kBytesAtOnce = 4 << 20;
    const auto& size = volume.info().size;
    const std::int64_t rowBytes = size[0] * volume.info().bytesPerVoxel();
    const std::int64_t rowsAtOnce = std::clamp<std::int64_t>(kBytesAtOnce / rowBytes, 1, size[1]);
    std::vector<std::byte> rows;
    for (std::int64_t z = 0; z < size[2]; ++z) {
        for (std::int64_t y = 0; y < size[1]; y += rowsAtOnce) {
            if (interrupted()) return Failure{path + ": interrupted"};
            const std::int64_t count = std::min(rowsAtOnce, size[1] - y);
            rows.resize(static_cast<std::size_t>(count * rowBytes));
            if (auto read = volume.readBrick({{0, y, z}, {size[0], count, 1}}, rows); !read) return read;
            see(std::span<const std::byte>(rows));
        }
        showProgress(program, what, z + 1, size[2]);
    }
    return {};
}

/// Parts of the range, and the width of one.
void prepareHistogram(ChannelStatistics& channel, ChannelType type, std::size_t bins)
{
    if (channel.low > channel.high) return;
    const double values = channel.high - channel.low + 1;
    const bool isEach = type != ChannelType::float32 && values <= double(bins);
    channel.histogram.assign(isEach                       ? static_cast<std::size_t>(values)
                             : channel.low < channel.high ? bins
                                                          : 1,
                             0);
}

} // namespace

Result<std::vector<ChannelStatistics>> statisticsOf(const char* program, const std::string& path,
                                                    VolumeFile& volume, std::size_t bins)
{
    const VolumeInfo& info = volume.info();
    std::vector<ChannelStatistics> channels(static_cast<std::size_t>(info.channels));
    std::vector<std::int64_t> counts(channels.size(), 0);
    const auto note = [&](std::size_t i, double value) {
        ChannelStatistics& channel = channels[i];
        if (std::isnan(value)) {
            ++channel.notANumber;
        } else if (std::isinf(value)) {
            ++channel.infinite;
        } else {
            const bool first = counts[i]++ == 0;
            channel.low = first ? value : std::min(channel.low, value);
            channel.high = first ? value : std::max(channel.high, value);
            channel.mean += value;
        }
    };
    auto seen = seeVoxels(program, "range of slice", path, volume,
                          [&](std::span<const std::byte> voxels) { seeValues(info, voxels, note); });
    if (!seen) return seen.failure();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (counts[i] > 0) channels[i].mean /= double(counts[i]);
        prepareHistogram(channels[i], info.type, bins);
    }

    const auto count = [&](std::size_t i, double value) {
        ChannelStatistics& channel = channels[i];
        if (!std::isfinite(value)) return;
        const double range = channel.high - channel.low;
        const auto parts = channel.histogram.size();
        // Integers have a part of width 1 each, or share the range as floats do.
        const bool isEach = info.type != ChannelType::float32 && range + 1 == double(parts);
        const double part = isEach ? value - channel.low : (value - channel.low) / range * double(parts);
        ++channel.histogram[range > 0 ? std::min(static_cast<std::size_t>(part), parts - 1) : 0];
    };
    seen = seeVoxels(program, "histogram of slice", path, volume,
                     [&](std::span<const std::byte> voxels) { seeValues(info, voxels, count); });
    if (!seen) return seen.failure();
    return channels;
}

} // namespace vo
