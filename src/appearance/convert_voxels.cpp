#include "appearance/convert_voxels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace vo {

namespace {

/// Voxels that are worked on at a time; what is between reading and writing then stays in the first cache.
constexpr std::size_t kBlock = 512;

/// Calls function(T{}) with the number type of one channel; not for packed types.
template <class Function>
void withChannelType(VoxelType type, Function function)
{
    switch (type) {
    case VoxelType::uint8: return function(std::uint8_t{});
    case VoxelType::int8: return function(std::int8_t{});
    case VoxelType::uint16: return function(std::uint16_t{});
    case VoxelType::int16: return function(std::int16_t{});
    case VoxelType::uint32: return function(std::uint32_t{});
    case VoxelType::int32: return function(std::int32_t{});
    case VoxelType::float32: return function(float{});
    case VoxelType::uint8_332:
    case VoxelType::uint16_4444:
    case VoxelType::uint16_5551:
    case VoxelType::uint32_8888:
    case VoxelType::uint32_1010102: break;
    }
    assert(!"packed types hold no separate channels");
}

/// Numbers of 32 bits need more than a float's 24 on the way.
template <class T>
using Precise = std::conditional_t<sizeof(T) == 4, double, float>;

template <class T>
float toUnit(T value)
{
    if constexpr (std::is_floating_point_v<T>) {
        return value;
    } else {
        using P = Precise<T>;
        const P unit = static_cast<P>(value) / static_cast<P>(std::numeric_limits<T>::max());
        return static_cast<float>(std::max(unit, P{-1}));
    }
}

template <class T>
T fromUnit(float unit)
{
    if constexpr (std::is_floating_point_v<T>) {
        return unit;
    } else {
        using P = Precise<T>;
        const P lowest = std::is_signed_v<T> ? P{-1} : P{0};
        // Written so that a NaN becomes the lowest value.
        const P inside = unit > static_cast<float>(lowest) ? std::min(static_cast<P>(unit), P{1}) : lowest;
        const P scaled = inside * static_cast<P>(std::numeric_limits<T>::max());
        return static_cast<T>(scaled + std::copysign(P{0.5}, scaled));
    }
}

/// Exactly the value for grey: the error of the sum in double precision is far below half a step of any T.
template <class T>
T luminanceOf(T red, T green, T blue)
{
    const double luminance = 0.30 * static_cast<double>(red) + 0.59 * static_cast<double>(green) +
                             0.11 * static_cast<double>(blue);
    if constexpr (std::is_floating_point_v<T>)
        return static_cast<T>(luminance);
    else
        return static_cast<T>(luminance + std::copysign(0.5, luminance));
}

/// Stored channels to (red, green, blue, alpha).
template <class T>
void expandChannels(const T* stored, Channels channels, std::size_t count, T* rgba)
{
    switch (channels) {
    case Channels::intensity:
    case Channels::luminance:
        for (std::size_t i = 0; i < count; ++i, rgba += 4)
            std::fill_n(rgba, 4, stored[i]);
        return;
    case Channels::luminanceAlpha:
        for (std::size_t i = 0; i < count; ++i, rgba += 4, stored += 2) {
            std::fill_n(rgba, 3, stored[0]);
            rgba[3] = stored[1];
        }
        return;
    case Channels::rgba: std::copy_n(stored, 4 * count, rgba); return;
    case Channels::abgr:
        for (std::size_t i = 0; i < 4 * count; i += 4)
            std::reverse_copy(stored + i, stored + i + 4, rgba + i);
        return;
    }
}

/// (red, green, blue, alpha) to stored channels.
template <class T>
void collapseChannels(const T* rgba, Channels channels, std::size_t count, T* stored)
{
    switch (channels) {
    case Channels::intensity:
    case Channels::luminance:
        for (std::size_t i = 0; i < count; ++i, rgba += 4)
            stored[i] = luminanceOf(rgba[0], rgba[1], rgba[2]);
        return;
    case Channels::luminanceAlpha:
        for (std::size_t i = 0; i < count; ++i, rgba += 4, stored += 2) {
            stored[0] = luminanceOf(rgba[0], rgba[1], rgba[2]);
            stored[1] = rgba[3];
        }
        return;
    case Channels::rgba: std::copy_n(rgba, 4 * count, stored); return;
    case Channels::abgr:
        for (std::size_t i = 0; i < 4 * count; i += 4)
            std::reverse_copy(rgba + i, rgba + i + 4, stored + i);
        return;
    }
}

/// Bits of the channels of a packed voxel; the first lies in the highest bits, as OpenGL's packed types have
/// it.
struct PackedLayout
{
    std::size_t bytes;
    std::array<int, 4> bits;
};

PackedLayout packedLayout(VoxelType type)
{
    switch (type) {
    case VoxelType::uint8_332: return {1, {3, 3, 2, 0}};
    case VoxelType::uint16_4444: return {2, {4, 4, 4, 4}};
    case VoxelType::uint16_5551: return {2, {5, 5, 5, 1}};
    case VoxelType::uint32_8888: return {4, {8, 8, 8, 8}};
    case VoxelType::uint32_1010102: return {4, {10, 10, 10, 2}};
    case VoxelType::uint8:
    case VoxelType::int8:
    case VoxelType::uint16:
    case VoxelType::int16:
    case VoxelType::uint32:
    case VoxelType::int32:
    case VoxelType::float32: break;
    }
    assert(!"not a packed type");
    return {0, {}};
}

std::uint32_t loadWord(const std::byte* from, std::size_t bytes)
{
    if (bytes == 1) return std::to_integer<std::uint32_t>(*from);
    if (bytes == 2) {
        std::uint16_t word;
        std::memcpy(&word, from, sizeof word);
        return word;
    }
    std::uint32_t word;
    std::memcpy(&word, from, sizeof word);
    return word;
}

void storeWord(std::uint32_t value, std::byte* to, std::size_t bytes)
{
    const auto byte = static_cast<std::uint8_t>(value);
    const auto half = static_cast<std::uint16_t>(value);
    if (bytes == 1)
        std::memcpy(to, &byte, sizeof byte);
    else if (bytes == 2)
        std::memcpy(to, &half, sizeof half);
    else
        std::memcpy(to, &value, sizeof value);
}

void decodePacked(const std::byte* voxels, VoxelFormat format, std::size_t count, float* rgba)
{
    const PackedLayout layout = packedLayout(format.type);
    for (std::size_t i = 0; i < count; ++i, rgba += 4) {
        const std::uint32_t word = loadWord(voxels + i * layout.bytes, layout.bytes);
        std::array<float, 4> stored{1.0f, 1.0f, 1.0f, 1.0f}; // 3_3_2 is opaque
        int shift = static_cast<int>(8 * layout.bytes);
        for (std::size_t c = 0; c < 4 && layout.bits[c] > 0; ++c) {
            shift -= layout.bits[c];
            const std::uint32_t largest = (1u << layout.bits[c]) - 1u;
            stored[c] = static_cast<float>(word >> shift & largest) / static_cast<float>(largest);
        }
        expandChannels(stored.data(), format.channels, 1, rgba);
    }
}

void encodePacked(const float* rgba, std::size_t count, VoxelFormat format, std::byte* voxels)
{
    const PackedLayout layout = packedLayout(format.type);
    for (std::size_t i = 0; i < count; ++i, rgba += 4) {
        std::array<float, 4> stored;
        collapseChannels(rgba, format.channels, 1, stored.data());
        std::uint32_t word = 0;
        for (std::size_t c = 0; c < 4 && layout.bits[c] > 0; ++c) {
            const std::uint32_t largest = (1u << layout.bits[c]) - 1u;
            const float inside = stored[c] > 0.0f ? std::min(stored[c], 1.0f) : 0.0f;
            word = word << layout.bits[c] |
                   static_cast<std::uint32_t>(inside * static_cast<float>(largest) + 0.5f);
        }
        storeWord(word, voxels + i * layout.bytes, layout.bytes);
    }
}

template <class T>
void decodeChannels(const std::byte* voxels, Channels channels, std::size_t count, float* rgba)
{
    std::array<T, 4 * kBlock> stored;
    std::array<float, 4 * kBlock> units;
    const std::size_t values = count * static_cast<std::size_t>(channelCount(channels));
    std::memcpy(stored.data(), voxels, values * sizeof(T));
    std::transform(stored.begin(), stored.begin() + static_cast<std::ptrdiff_t>(values), units.begin(),
                   toUnit<T>);
    expandChannels(units.data(), channels, count, rgba);
}

template <class T>
void encodeChannels(const float* rgba, std::size_t count, Channels channels, std::byte* voxels)
{
    std::array<T, 4 * kBlock> stored;
    std::array<float, 4 * kBlock> units;
    const std::size_t values = count * static_cast<std::size_t>(channelCount(channels));
    collapseChannels(rgba, channels, count, units.data());
    std::transform(units.begin(), units.begin() + static_cast<std::ptrdiff_t>(values), stored.begin(),
                   fromUnit<T>);
    std::memcpy(voxels, stored.data(), values * sizeof(T));
}

void decodeBlock(const std::byte* voxels, VoxelFormat format, std::size_t count, float* rgba)
{
    if (isPacked(format.type)) return decodePacked(voxels, format, count, rgba);
    withChannelType(format.type,
                    [&](auto tag) { decodeChannels<decltype(tag)>(voxels, format.channels, count, rgba); });
}

void encodeBlock(const float* rgba, std::size_t count, VoxelFormat format, std::byte* voxels)
{
    if (isPacked(format.type)) return encodePacked(rgba, count, format, voxels);
    withChannelType(format.type,
                    [&](auto tag) { encodeChannels<decltype(tag)>(rgba, count, format.channels, voxels); });
}

/// Channels rearranged without leaving their type.
template <class T>
void rearrangeBlock(const std::byte* source, Channels from, std::byte* target, Channels to, std::size_t count)
{
    std::array<T, 4 * kBlock> stored;
    std::array<T, 4 * kBlock> rgba;
    std::memcpy(stored.data(), source, count * static_cast<std::size_t>(channelCount(from)) * sizeof(T));
    expandChannels(stored.data(), from, count, rgba.data());
    collapseChannels(rgba.data(), to, count, stored.data());
    std::memcpy(target, stored.data(), count * static_cast<std::size_t>(channelCount(to)) * sizeof(T));
}

void convertBlock(const std::byte* source, VoxelFormat from, std::byte* target, VoxelFormat to,
                  std::size_t count)
{
    if (from.type == to.type && !isPacked(from.type)) {
        withChannelType(from.type, [&](auto tag) {
            rearrangeBlock<decltype(tag)>(source, from.channels, target, to.channels, count);
        });
        return;
    }
    std::array<float, 4 * kBlock> rgba;
    decodeBlock(source, from, count, rgba.data());
    encodeBlock(rgba.data(), count, to, target);
}

template <class T>
void stretchChannels(std::byte* values, std::size_t count, double low, double high)
{
    const double largest =
        std::is_floating_point_v<T> ? 1.0 : static_cast<double>(std::numeric_limits<T>::max());
    const double rounding = std::is_floating_point_v<T> ? 0.0 : 0.5;
    const double width = high - low;
    for (std::size_t i = 0; i < count; ++i) {
        T value;
        std::memcpy(&value, values + i * sizeof(T), sizeof(T));
        const double place = (static_cast<double>(value) - low) / width;
        const double inside = place > 0.0 ? std::min(place, 1.0) : 0.0; // 0 for NaN too
        value = static_cast<T>(inside * largest + rounding);
        std::memcpy(values + i * sizeof(T), &value, sizeof(T));
    }
}

} // namespace

void decodeVoxels(std::span<const std::byte> voxels, VoxelFormat format, std::size_t count, float* rgba)
{
    assert(isValid(format) && voxels.size() / voxelBytes(format) >= count);
    for (std::size_t start = 0; start < count; start += kBlock)
        decodeBlock(voxels.data() + start * voxelBytes(format), format, std::min(kBlock, count - start),
                    rgba + 4 * start);
}

void encodeVoxels(const float* rgba, std::size_t count, VoxelFormat format, std::span<std::byte> voxels)
{
    assert(isValid(format) && voxels.size() / voxelBytes(format) >= count);
    for (std::size_t start = 0; start < count; start += kBlock)
        encodeBlock(rgba + 4 * start, std::min(kBlock, count - start), format,
                    voxels.data() + start * voxelBytes(format));
}

void convertVoxels(const std::byte* source, VoxelFormat sourceFormat, std::byte* target,
                   VoxelFormat targetFormat, std::size_t count)
{
    assert(isValid(sourceFormat) && isValid(targetFormat));
    const std::size_t sourceBytes = voxelBytes(sourceFormat);
    const std::size_t targetBytes = voxelBytes(targetFormat);
    if (sourceFormat == targetFormat) {
        if (source != target) std::memcpy(target, source, count * sourceBytes);
        return;
    }
    // In place, voxels that grow are written from the last block on, so that none is overwritten before it is
    // read.
    const bool backwards = targetBytes > sourceBytes;
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    for (std::size_t i = 0; i < blocks; ++i) {
        const std::size_t start = (backwards ? blocks - 1 - i : i) * kBlock;
        convertBlock(source + start * sourceBytes, sourceFormat, target + start * targetBytes, targetFormat,
                     std::min(kBlock, count - start));
    }
}

void stretchRange(std::span<std::byte> voxels, VoxelFormat format, double low, double high)
{
    assert(!isPacked(format.type));
    if (!(high > low)) return;
    withChannelType(format.type, [&](auto tag) {
        stretchChannels<decltype(tag)>(voxels.data(), voxels.size() / sizeof(tag), low, high);
    });
}

} // namespace vo
