#include "x3d/voxel_files.h"

#include "volume_io/volume_io.h"

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

/// From numbers of one type to those of another of the same size, smallest to 0, largest to `full`. What is
/// no number becomes 0.
template <class From, class To>
void scaleToRange(std::vector<std::byte>& bytes, double full)
{
    const std::size_t count = bytes.size() / sizeof(From);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(numberAt<From>(bytes, i));
        if (!std::isfinite(number)) continue;
        low = std::min(low, number);
        high = std::max(high, number);
    }
    const double scale = high > low ? full / (high - low) : 0.0;
    const double half = std::is_integral_v<To> ? 0.5 : 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(numberAt<From>(bytes, i));
        const double scaled = std::isfinite(number) ? (number - low) * scale : 0.0;
        putNumber(bytes, i, static_cast<To>(scaled + half));
    }
}

void toValues(VoxelTexture& texture, ChannelType type)
{
    switch (type) {
    case ChannelType::uint8: break;
    case ChannelType::uint16: texture.kind = TexelKind::uint16; break;
    case ChannelType::int8: scaleToRange<std::int8_t, std::uint8_t>(texture.texels, 255.0); break;
    case ChannelType::int16:
        scaleToRange<std::int16_t, std::uint16_t>(texture.texels, 65535.0);
        texture.kind = TexelKind::uint16;
        break;
    case ChannelType::float32:
        scaleToRange<float, float>(texture.texels, 1.0);
        texture.kind = TexelKind::float32;
    }
}

template <class From>
std::vector<std::byte> wholeNumbers(const std::vector<std::byte>& bytes)
{
    const std::size_t count = bytes.size() / sizeof(From);
    std::vector<std::byte> numbers(count * sizeof(std::uint16_t));
    for (std::size_t i = 0; i < count; ++i) {
        const double number = std::round(static_cast<double>(numberAt<From>(bytes, i)));
        putNumber(numbers, i,
                  static_cast<std::uint16_t>(number >= 0.0 ? std::min(number, 65535.0) : 65535.0));
    }
    return numbers;
}

/// Numbers that no segment can have become the largest, which no style is for.
void toIdentifiers(VoxelTexture& texture, ChannelType type)
{
    auto& texels = texture.texels;
    switch (type) {
    case ChannelType::uint8: texels = wholeNumbers<std::uint8_t>(texels); break;
    case ChannelType::int8: texels = wholeNumbers<std::int8_t>(texels); break;
    case ChannelType::uint16: break;
    case ChannelType::int16: texels = wholeNumbers<std::int16_t>(texels); break;
    case ChannelType::float32: texels = wholeNumbers<float>(texels);
    }
    texture.kind = TexelKind::uint16;
}

std::string sizeText(const std::array<std::int64_t, 3>& size)
{
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

TextureResult readOpened(VolumeFile& file, const std::string& path, TexelUse use)
{
    const VolumeInfo& info = file.info();
    const auto bytes = volumeBytes(info.size, info.bytesPerVoxel());
    if (!bytes) return {nullptr, path + ": " + bytes.failure().text};
    const auto most = mostTextureBytes();
    if (static_cast<std::uint64_t>(*bytes) > most)
        return {nullptr, path + ": expected a volume of at most " + std::to_string(most) +
                             " bytes, half of the memory, found " + sizeText(info.size) + " voxels, " +
                             std::to_string(*bytes) + " bytes"};
    auto texture = std::make_shared<VoxelTexture>();
    texture->texels.resize(static_cast<std::size_t>(*bytes));
    if (const auto read = file.readBrick({{0, 0, 0}, info.size}, texture->texels); !read)
        return {nullptr, read.failure().text};
    texture->size = {static_cast<int>(info.size[0]), static_cast<int>(info.size[1]),
                     static_cast<int>(info.size[2])};
    texture->components = file.description().alphaAdded ? 3 : info.channels;
    if (texture->components != info.channels)
        dropChannels(texture->texels, static_cast<std::size_t>(info.channels), 3,
                     static_cast<std::size_t>(bytesPerChannel(info.type)));
    if (use == TexelUse::identifiers)
        toIdentifiers(*texture, info.type);
    else
        toValues(*texture, info.type);
    return {std::move(texture), ""};
}

} // namespace

std::uint64_t mostTextureBytes()
{
    const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || bytes <= 0) return std::uint64_t(1) << 32;
    return static_cast<std::uint64_t>(pages) / 2 * static_cast<std::uint64_t>(bytes);
}

TextureResult readVoxelFile(const std::string& path, TexelUse use)
{
    try {
        auto file = openVolume(path);
        if (!file) return {nullptr, file.failure().text};
        return readOpened(*file, path, use);
    } catch (const std::bad_alloc&) {
        return {nullptr, path + ": not enough memory for its voxels"};
    }
}

} // namespace vo
