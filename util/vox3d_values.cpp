#include "vox3d_values.h"

#include "machine_memory.h"
#include "utility.h"
#include "volume_io/memory_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <vector>

namespace vo {
namespace {

constexpr std::size_t kBins = 4096;
constexpr std::int64_t kBytesAtOnce = 64 << 20;

/// The voxels of a file, some slices at a time, or all of them: then they are read once and stay.
class Slices
{
public:
    static Result<Slices> of(const std::string& path, VolumeFile& file)
    {
        const auto& size = file.info().size;
        const auto sliceBytes = volumeBytes({size[0], size[1], 1}, file.info().bytesPerVoxel());
        if (!sliceBytes) return Failure{path + ": " + sliceBytes.failure().text};
        const std::int64_t most = std::max(kBytesAtOnce, machineMemory() / 4);
        const std::int64_t atOnce = size[2] <= most / *sliceBytes
                                        ? size[2]
                                        : std::clamp<std::int64_t>(kBytesAtOnce / *sliceBytes, 1, size[2]);
        auto block = MemoryBlock::allocate(path, atOnce * *sliceBytes);
        if (!block) return block.failure();
        return Slices(file, *sliceBytes, atOnce, std::move(*block));
    }

    /// Lets a function have all voxels.
    Result<void> each(const std::function<void(std::span<const std::byte>)>& take)
    {
        const auto& size = file_->info().size;
        for (std::int64_t z = 0; z < size[2]; z += atOnce_) {
            const std::int64_t count = std::min(atOnce_, size[2] - z);
            const auto slices = block_.bytes().first(static_cast<std::size_t>(count * sliceBytes_));
            if (!isRead_)
                if (auto read = file_->readBrick({{0, 0, z}, {size[0], size[1], count}}, slices); !read)
                    return read;
            isRead_ = count == size[2];
            take(slices);
        }
        return {};
    }

    /// What it holds, if that is the whole volume.
    MemoryBlock takeWhole() { return isRead_ ? std::move(block_) : MemoryBlock(); }

private:
    Slices(VolumeFile& file, std::int64_t sliceBytes, std::int64_t atOnce, MemoryBlock block)
        : file_(&file), sliceBytes_(sliceBytes), atOnce_(atOnce), block_(std::move(block))
    {
    }

    VolumeFile* file_;
    std::int64_t sliceBytes_, atOnce_;
    MemoryBlock block_;
    bool isRead_ = false;
};

/// The first channel of voxels, one after the other.
template <class Take>
void eachValue(const VolumeInfo& info, std::span<const std::byte> voxels, const Take& take)
{
    const auto step = static_cast<std::size_t>(info.bytesPerVoxel());
    const auto each = [&](auto number) {
        for (std::size_t at = 0; at + step <= voxels.size(); at += step) {
            std::memcpy(&number, voxels.data() + at, sizeof number);
            take(static_cast<double>(number));
        }
    };
    switch (info.type) {
    case ChannelType::uint8: each(std::uint8_t()); break;
    case ChannelType::int8: each(std::int8_t()); break;
    case ChannelType::uint16: each(std::uint16_t()); break;
    case ChannelType::int16: each(std::int16_t()); break;
    case ChannelType::float32: each(float()); break;
    }
}

/// Numbers of floats that others than those may expect.
struct OddNumbers
{
    std::int64_t none = 0, infinite = 0, fractions = 0;
    double firstFraction = 0;

    void take(ChannelType type, std::span<const std::byte> voxels)
    {
        if (type != ChannelType::float32) return;
        for (std::size_t at = 0; at + sizeof(float) <= voxels.size(); at += sizeof(float)) {
            float number = 0;
            std::memcpy(&number, voxels.data() + at, sizeof number);
            none += std::isnan(number) ? 1 : 0;
            infinite += std::isinf(number) ? 1 : 0;
            if (number == std::floor(number)) continue;
            if (fractions++ == 0) firstFraction = static_cast<double>(number);
        }
    }
};

/// How many voxels have values in each part of the range.
using Histogram = std::vector<double>;

/// The bin above which the two sides differ most (Otsu): the variance between them is greatest.
std::size_t bestDivision(const Histogram& counts)
{
    double all = 0, sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        all += counts[i];
        sum += counts[i] * static_cast<double>(i);
    }
    double below = 0, belowSum = 0, best = -1;
    std::size_t division = counts.size() / 2;
    for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
        below += counts[i];
        belowSum += counts[i] * static_cast<double>(i);
        if (below <= 0 || below >= all) continue;
        const double apart = belowSum / below - (sum - belowSum) / (all - below);
        const double between = below * (all - below) * apart * apart;
        if (between <= best) continue;
        best = between;
        division = i;
    }
    return division;
}

std::size_t binBelow(const Histogram& counts, double part)
{
    double all = 0, below = 0;
    for (const double count : counts)
        all += count;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        below += counts[i];
        if (below >= part * all) return i;
    }
    return counts.size() - 1;
}

/// Into what is around and what is of interest.
Result<void> divide(const VolumeInfo& info, Slices& slices, VolumeValues& values)
{
    Histogram counts(kBins, 0.0);
    const double scale = static_cast<double>(kBins) / (values.seen.high - values.seen.low);
    const auto read = slices.each([&](std::span<const std::byte> voxels) {
        eachValue(info, voxels, [&](double value) {
            const double bin = (value - values.seen.low) * scale;
            if (bin >= 0) counts[static_cast<std::size_t>(std::min(bin, kBins - 1.0))] += 1;
        });
    });
    if (!read) return read;
    const double width = (values.seen.high - values.seen.low) / static_cast<double>(kBins);
    const auto valueOf = [&](std::size_t bin) {
        return values.seen.low + (static_cast<double>(bin) + 1) * width;
    };
    values.threshold = valueOf(bestDivision(counts));
    values.high = std::max(valueOf(binBelow(counts, 0.998)), values.threshold + width);
    return {};
}

/// All but the threshold, and what lies above it.
Result<void> lookAtRange(const char* program, const std::string& path, VolumeFile& file, Slices& slices,
                         VolumeValues& values)
{
    for (const std::string& note : file.description().notes)
        warn(program, path + ": " + note);
    const VolumeInfo& info = file.info();
    values.size = info.size;
    values.type = info.type;
    values.spacing = file.description().spacing;
    values.channels = info.channels;
    values.alphaAdded = file.description().alphaAdded;
    values.isOriented = file.description().orientation.known;
    OddNumbers odd;
    auto read = slices.each([&](std::span<const std::byte> voxels) {
        growRange(values.seen, info.type, voxels.data(),
                  voxels.size() / static_cast<std::size_t>(bytesPerChannel(info.type)));
        odd.take(info.type, voxels);
    });
    if (!read) return read;
    if (values.seen.low > values.seen.high)
        return Failure{path + ": expected numbers, found only " + std::to_string(odd.none) +
                       " that are none (NaN) and " + std::to_string(odd.infinite) + " infinite ones"};
    values.fractions = odd.fractions;
    values.firstFraction = odd.firstFraction;
    const bool isUnsigned = info.type == ChannelType::uint8 || info.type == ChannelType::uint16;
    values.scene = isUnsigned ? fullRange(info.type) : values.seen;
    return {};
}

} // namespace

Result<VolumeValues> lookAtVolume(const char* program, const std::string& path)
{
    auto file = openVolume(path);
    if (!file) return file.failure();
    auto slices = Slices::of(path, *file);
    if (!slices) return slices.failure();
    VolumeValues values;
    if (auto looked = lookAtRange(program, path, *file, *slices, values); !looked) return looked.failure();
    if (values.seen.low < values.seen.high) {
        if (auto divided = divide(file->info(), *slices, values); !divided) return divided.failure();
    } else {
        // A body in what is 0 around it.
        const bool isNothing = values.seen.low == 0;
        values.threshold = values.seen.low - (isNothing ? 0 : 1);
        values.high = values.threshold + 1;
    }
    values.voxels = slices->takeWhole();
    return values;
}

Result<LabelValues> lookAtLabels(const char* program, const std::string& path, int most)
{
    auto file = openVolume(path);
    if (!file) return file.failure();
    auto slices = Slices::of(path, *file);
    if (!slices) return slices.failure();
    LabelValues labels;
    if (auto looked = lookAtRange(program, path, *file, *slices, labels.values); !looked)
        return looked.failure();
    const ValueRange& seen = labels.values.seen;
    if (labels.values.fractions > 0 || seen.low < 0 || seen.high > most) return labels;
    labels.isThere.resize(static_cast<std::size_t>(seen.high) + 1, 0);
    const auto read = slices->each([&](std::span<const std::byte> voxels) {
        eachValue(file->info(), voxels, [&](double value) {
            if (value >= 0) labels.isThere[static_cast<std::size_t>(value)] = 1;
        });
    });
    if (!read) return read.failure();
    labels.values.voxels = slices->takeWhole();
    return labels;
}

} // namespace vo
