#include "x3d/voxel_files.h"

#include "volume_io/volume_io.h"
#include "x3d/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <unistd.h>

namespace vo {
namespace {

template <class T>
T numberAt(const std::vector<std::byte>& bytes, std::size_t i)
{
    T number;
    std::memcpy(&number, bytes.data() + i * sizeof(T), sizeof(T));
    return number;
}

template <class T>
void putNumber(std::vector<std::byte>& bytes, std::size_t i, T number)
{
    std::memcpy(bytes.data() + i * sizeof(T), &number, sizeof(T));
}

/// Keeps the first `kept` of `channels` numbers of each texel.
void dropChannels(std::vector<std::byte>& bytes, std::size_t channels, std::size_t kept,
                  std::size_t bytesEach)
{
    const std::size_t texels = bytes.size() / (channels * bytesEach);
    for (std::size_t i = 1; i < texels; ++i)
        std::memmove(bytes.data() + i * kept * bytesEach, bytes.data() + i * channels * bytesEach,
                     kept * bytesEach);
    bytes.resize(texels * kept * bytesEach);
}

/// What numbers there are.
struct NumberRange
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::size_t finite = 0, infinite = 0, none = 0;
};

/// From numbers of one type to those of another of the same size, smallest to 0, largest to `full`. What is
/// no number becomes 0, as the smallest, and infinite ones as the nearest that is finite.
template <class From, class To>
NumberRange scaleToRange(std::vector<std::byte>& bytes, double full)
{
    const std::size_t count = bytes.size() / sizeof(From);
    NumberRange range;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(numberAt<From>(bytes, i));
        ++(std::isfinite(number) ? range.finite : std::isnan(number) ? range.none : range.infinite);
        if (!std::isfinite(number)) continue;
        range.low = std::min(range.low, number);
        range.high = std::max(range.high, number);
    }
    const double scale = range.high > range.low ? full / (range.high - range.low) : 0.0;
    const double half = std::is_integral_v<To> ? 0.5 : 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(numberAt<From>(bytes, i));
        const double held = std::isnan(number) ? range.low : std::clamp(number, range.low, range.high);
        putNumber(bytes, i, static_cast<To>((held - range.low) * scale + half));
    }
    return range;
}

NumberRange toValues(VoxelTexture& texture, ChannelType type)
{
    switch (type) {
    case ChannelType::uint8:
    case ChannelType::uint16: break;
    case ChannelType::int8: return scaleToRange<std::int8_t, std::uint8_t>(texture.texels, 255.0);
    case ChannelType::int16: return scaleToRange<std::int16_t, std::uint16_t>(texture.texels, 65535.0);
    case ChannelType::float32: return scaleToRange<float, float>(texture.texels, 1.0);
    }
    return {};
}

TexelKind kindOf(ChannelType type, TexelUse use)
{
    if (use == TexelUse::identifiers) return TexelKind::uint16;
    switch (type) {
    case ChannelType::uint8:
    case ChannelType::int8: break;
    case ChannelType::uint16:
    case ChannelType::int16: return TexelKind::uint16;
    case ChannelType::float32: return TexelKind::float32;
    }
    return TexelKind::uint8;
}

/// `fractions` counts those that were none.
template <class From>
std::vector<std::byte> wholeNumbers(const std::vector<std::byte>& bytes, std::size_t& fractions)
{
    const std::size_t count = bytes.size() / sizeof(From);
    std::vector<std::byte> numbers(count * sizeof(std::uint16_t));
    for (std::size_t i = 0; i < count; ++i) {
        const auto found = static_cast<double>(numberAt<From>(bytes, i));
        const double number = std::round(found);
        fractions += number != found ? 1 : 0; // also what is no number
        putNumber(numbers, i,
                  static_cast<std::uint16_t>(number >= 0.0 ? std::min(number, 65535.0) : 65535.0));
    }
    return numbers;
}

/// Numbers that no segment can have become the largest, which no style is for. The answer: how many were no
/// whole numbers.
std::size_t toIdentifiers(std::vector<std::byte>& texels, ChannelType type)
{
    std::size_t fractions = 0;
    switch (type) {
    case ChannelType::uint8: texels = wholeNumbers<std::uint8_t>(texels, fractions); break;
    case ChannelType::int8: texels = wholeNumbers<std::int8_t>(texels, fractions); break;
    case ChannelType::uint16: break;
    case ChannelType::int16: texels = wholeNumbers<std::int16_t>(texels, fractions); break;
    case ChannelType::float32: texels = wholeNumbers<float>(texels, fractions);
    }
    return fractions;
}

/// What the result says of numbers that are none, infinite, or all the same; no texture where no other is.
void tellOfNumbers(const NumberRange& range, const std::string& path, TextureResult& result)
{
    if (range.none + range.infinite == 0) {
        if (range.finite > 0 && range.low == range.high)
            result.note = path + ": expected numbers that differ, found " + numberText(range.low) +
                          " alone: taken as 0";
        return;
    }
    const std::string found = std::to_string(range.none) + " that are none (NaN) and " +
                              std::to_string(range.infinite) + " infinite ones";
    if (range.finite == 0)
        result = {nullptr, path + ": expected numbers, found only " + found};
    else
        result.note = path + ": expected numbers, found " + found + " among " +
                      std::to_string(range.finite + range.none + range.infinite) +
                      ": NaN and -infinity count as the smallest, infinity as the largest";
}

void convert(TexelUse use, ChannelType type, const std::string& path, TextureResult& result)
{
    if (use == TexelUse::values) {
        tellOfNumbers(toValues(*result.texture, type), path, result);
        return;
    }
    if (const std::size_t fractions = toIdentifiers(result.texture->texels, type); fractions > 0)
        result.note = path + ": expected whole numbers of segments, found " + std::to_string(fractions) +
                      " others: rounded";
}

std::shared_ptr<VoxelTexture> textureWithoutTexels(const ReadVoxels& voxels, TexelUse use)
{
    auto texture = std::make_shared<VoxelTexture>();
    texture->size = {static_cast<int>(voxels.size[0]), static_cast<int>(voxels.size[1]),
                     static_cast<int>(voxels.size[2])};
    texture->components = voxels.components;
    texture->kind = kindOf(voxels.type, use);
    return texture;
}

TextureResult readOpened(VolumeFile& file, const std::string& path, TexelUse use, VoxelReading reading)
{
    const VolumeInfo& info = file.info();
    const auto bytes = volumeBytes(info.size, info.bytesPerVoxel());
    if (!bytes) return {nullptr, path + ": " + bytes.failure().text};
    const auto most = mostTextureBytes();
    if (static_cast<std::uint64_t>(*bytes) > most)
        return {nullptr, path + ": expected a volume of at most " + std::to_string(most) +
                             " bytes, half of the memory, found " + sizeText(info.size) + " voxels, " +
                             std::to_string(*bytes) + " bytes"};
    ReadVoxels voxels{
        info.size, info.channels, file.description().alphaAdded ? 3 : info.channels, info.type, {}, 0};
    if (reading == VoxelReading::sizesAlone) return {textureWithoutTexels(voxels, use), ""};
    voxels.bytes.resize(static_cast<std::size_t>(*bytes));
    if (const auto read = file.readBrick({{0, 0, 0}, info.size}, voxels.bytes); !read)
        return {nullptr, read.failure().text};
    return textureOf(std::move(voxels), path, use);
}

} // namespace

TextureResult textureOf(ReadVoxels voxels, const std::string& path, TexelUse use)
{
    TextureResult result{textureWithoutTexels(voxels, use), ""};
    result.texture->texels = std::move(voxels.bytes);
    if (voxels.components != voxels.channels)
        dropChannels(result.texture->texels, static_cast<std::size_t>(voxels.channels),
                     static_cast<std::size_t>(voxels.components),
                     static_cast<std::size_t>(bytesPerChannel(voxels.type)));
    convert(use, voxels.type, path, result);
    return result;
}

std::uint64_t mostTextureBytes()
{
    const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || bytes <= 0) return std::uint64_t(1) << 32;
    return static_cast<std::uint64_t>(pages) / 2 * static_cast<std::uint64_t>(bytes);
}

TextureResult readVoxelFile(const std::string& path, TexelUse use, VoxelReading reading)
{
    try {
        auto file = openVolume(path);
        if (!file) return {nullptr, file.failure().text};
        return readOpened(*file, path, use, reading);
    } catch (const std::bad_alloc&) {
        return {nullptr, path + ": not enough memory for its voxels"};
    }
}

} // namespace vo
