#include "volume_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "volume_rows.h"

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
    const auto see = [&](const char* what, const auto& each) {
        return readRows({program, what, path, "interrupted"}, volume,
                        [&](std::span<const std::byte> voxels) -> Result<void> {
                            seeValues(info, voxels, each);
                            return {};
                        });
    };
    auto seen = see("range of slice", note);
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
    seen = see("histogram of slice", count);
    if (!seen) return seen.failure();
    return channels;
}

} // namespace vo
