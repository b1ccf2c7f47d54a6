#include "style/style.h"

#include "core/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "style/sample_texture.cpp"
#include <hwy/foreach_target.h>

#include "core/gather-inl.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace {

/// The two texels between which places lie on one axis, in steps to the next texel of all, and the weight of
/// the second.
struct TexelsAround
{
    Ints low, high;
    Floats weight;
};

HWY_INLINE Ints insideOf(Ints texel, Ints size, bool repeats)
{
    const Ints zero = hn::Zero(kInts);
    if (!repeats) return hn::Min(hn::Max(texel, zero), size - hn::Set(kInts, 1));
    // Places were taken to 0 to 1: no texel is farther than one size away.
    texel = texel + hn::IfThenElseZero(texel < zero, size);
    return hn::IfThenElse(texel < size, texel, texel - size);
}

HWY_INLINE TexelsAround texelsAround(const VoxelTexture& texture, std::size_t axis, Floats place)
{
    const int size = texture.size[static_cast<int>(axis)];
    const bool repeats = texture.repeats[axis];
    const Floats least = hn::Set(kFloats, -1.0f);
    if (repeats) place = place - hn::Floor(place);
    // Not-a-number becomes -1.
    place = hn::IfThenElse(place > least, place, least);
    const Floats texel = hn::Min(place, hn::Set(kFloats, 2.0f)) * hn::Set(kFloats, static_cast<float>(size));
    const Floats from = texture.nearest ? texel : texel - hn::Set(kFloats, 0.5f);
    const Floats below = hn::Floor(from);
    const Ints low = toLower(below), sizes = hn::Set(kInts, size);
    const Ints inside = insideOf(low, sizes, repeats);
    if (texture.nearest) return {inside, inside, hn::Zero(kFloats)};
    return {inside, insideOf(low + hn::Set(kInts, 1), sizes, repeats), from - below};
}

/// The texels of a texture, kChannels numbers of type T each.
template <class T, int kChannels>
class TexelReader
{
public:
    explicit TexelReader(const VoxelTexture& texture)
        : texels_(reinterpret_cast<const std::int32_t*>(texture.texels.data())),
          last_(hn::Set(kInts, static_cast<std::int32_t>(texture.texels.size() - sizeof(std::int32_t))))
    {
    }

    HWY_INLINE void read(Ints texel, Floats (&channels)[kChannels]) const
    {
        constexpr int kBytes = kChannels * static_cast<int>(sizeof(T));
        const Ints offset = texel * hn::Set(kInts, kBytes);
        constexpr int kInWord = 4 / static_cast<int>(sizeof(T));
        for (int first = 0; first < kChannels; first += kInWord) {
            const Ints word = wordAt(offset + hn::Set(kInts, first * static_cast<int>(sizeof(T))));
            if constexpr (std::is_same_v<T, float>) {
                channels[first] = hn::BitCast(kFloats, word);
            } else {
                channels[first] = number<0>(word);
                if (first + 1 < kChannels) channels[first + 1] = number<1>(word);
                if constexpr (kInWord == 4) {
                    if (first + 2 < kChannels) channels[first + 2] = number<2>(word);
                    if (first + 3 < kChannels) channels[first + 3] = number<3>(word);
                }
            }
        }
    }

private:
    /// Four bytes, of which those past the last texel are 0.
    HWY_INLINE Ints wordAt(Ints offset) const
    {
        if constexpr (std::is_same_v<T, float>) return gatherAtByte(texels_, offset);
        const Ints inside = hn::Min(offset, last_);
        const auto bits = hn::BitCast(kUints, hn::ShiftLeft<3>(offset - inside));
        return hn::BitCast(kInts, hn::Shr(hn::BitCast(kUints, gatherAtByte(texels_, inside)), bits));
    }

    template <int kPlace>
    static HWY_INLINE Floats number(Ints word)
    {
        constexpr int kBits = 8 * static_cast<int>(sizeof(T));
        constexpr int kMask =
            static_cast<int>(std::numeric_limits<std::uint32_t>::max() >> (32 - kBits % 32));
        return hn::ConvertTo(kFloats, hn::And(hn::ShiftRight<kPlace * kBits>(word), hn::Set(kInts, kMask)));
    }

    const std::int32_t* texels_;
    Ints last_;
};

template <class T, int kChannels>
void sampleKind(const VoxelTexture& texture, int count, const BatchVectors& place, float unit,
                std::array<BatchFloats, 4>& components)
{
    const TexelReader<T, kChannels> reader(texture);
    const Ints row = hn::Set(kInts, texture.size.x), slice = hn::Set(kInts, texture.size.x * texture.size.y);
    for (int i = 0; i < count; i += kLanes) {
        const auto first = static_cast<std::size_t>(i);
        TexelsAround at[3];
        for (std::size_t axis = 0; axis < 3; ++axis)
            at[axis] = texelsAround(texture, axis, hn::LoadU(kFloats, place[axis].data() + first));
        const auto along = [&](Ints from, Floats(&channels)[kChannels]) {
            Floats high[kChannels];
            reader.read(from + at[0].low, channels);
            reader.read(from + at[0].high, high);
            for (int c = 0; c < kChannels; ++c)
                channels[c] = between(channels[c], high[c], at[0].weight);
        };
        const auto across = [&](Ints from, Floats(&channels)[kChannels]) {
            Floats high[kChannels];
            along(from + at[1].low * row, channels);
            along(from + at[1].high * row, high);
            for (int c = 0; c < kChannels; ++c)
                channels[c] = between(channels[c], high[c], at[1].weight);
        };
        Floats low[kChannels], high[kChannels];
        across(at[2].low * slice, low);
        across(at[2].high * slice, high);
        for (std::size_t c = 0; c < kChannels; ++c)
            hn::StoreU(between(low[c], high[c], at[2].weight) * hn::Set(kFloats, unit), kFloats,
                       components[c].data() + first);
    }
}

template <class T>
void sampleChannels(const VoxelTexture& texture, int count, const BatchVectors& place, float unit,
                    std::array<BatchFloats, 4>& components)
{
    switch (texture.components) {
    case 1: return sampleKind<T, 1>(texture, count, place, unit, components);
    case 2: return sampleKind<T, 2>(texture, count, place, unit, components);
    case 3: return sampleKind<T, 3>(texture, count, place, unit, components);
    default: return sampleKind<T, 4>(texture, count, place, unit, components);
    }
}

} // namespace

void sampleTextureOfTarget(const VoxelTexture& texture, int count, const BatchVectors& place,
                           std::array<BatchFloats, 4>& components)
{
    switch (texture.kind) {
    case TexelKind::uint8:
        return sampleChannels<std::uint8_t>(texture, count, place, 1.0f / 255.0f, components);
    case TexelKind::uint16:
        return sampleChannels<std::uint16_t>(texture, count, place, 1.0f / 65535.0f, components);
    case TexelKind::float32: return sampleChannels<float>(texture, count, place, 1.0f, components);
    }
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

namespace {

/// The two texels between which a place lies on one axis, and the weight of the second.
struct Neighbours
{
    std::size_t low, high;
    float weight;
};

std::size_t insideOf(long texel, long size, bool repeats)
{
    if (repeats) texel = ((texel % size) + size) % size;
    return static_cast<std::size_t>(std::clamp(texel, 0L, size - 1));
}

Neighbours neighboursOf(float place, int size, bool repeats, bool nearest)
{
    if (repeats) place -= std::floor(place);
    const float texel = std::clamp(place, -1.0f, 2.0f) * static_cast<float>(size);
    if (nearest) {
        const std::size_t only = insideOf(static_cast<long>(std::floor(texel)), size, repeats);
        return {only, only, 0.0f};
    }
    const float below = std::floor(texel - 0.5f);
    const auto low = static_cast<long>(below);
    return {insideOf(low, size, repeats), insideOf(low + 1, size, repeats), texel - 0.5f - below};
}

template <class T>
float componentOf(const std::byte* texel, std::size_t component)
{
    T value;
    std::memcpy(&value, texel + component * sizeof(T), sizeof(T));
    return static_cast<float>(value);
}

template <class T>
void sampleAll(const VoxelTexture& texture, int count, const BatchVectors& place, float unit,
               std::array<BatchFloats, 4>& components)
{
    const auto channels = static_cast<std::size_t>(texture.components);
    const std::size_t bytes = channels * sizeof(T);
    const std::size_t row = bytes * static_cast<std::size_t>(texture.size.x);
    const std::size_t slice = row * static_cast<std::size_t>(texture.size.y);
    const std::byte* texels = texture.texels.data();
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const Neighbours x = neighboursOf(place[0][i], texture.size.x, texture.repeats[0], texture.nearest);
        const Neighbours y = neighboursOf(place[1][i], texture.size.y, texture.repeats[1], texture.nearest);
        const Neighbours z = neighboursOf(place[2][i], texture.size.z, texture.repeats[2], texture.nearest);
        for (std::size_t c = 0; c < channels; ++c) {
            const auto along = [&](std::size_t atY, std::size_t atZ) {
                const std::byte* from = texels + atZ * slice + atY * row;
                const float low = componentOf<T>(from + x.low * bytes, c);
                return low + (componentOf<T>(from + x.high * bytes, c) - low) * x.weight;
            };
            const auto across = [&](std::size_t atZ) {
                const float low = along(y.low, atZ);
                return low + (along(y.high, atZ) - low) * y.weight;
            };
            const float low = across(z.low);
            components[c][i] = (low + (across(z.high) - low) * z.weight) * unit;
        }
    }
}

/// Textures of fewer bytes than a word, or more than offsets of 31 bits reach.
void sampleOneByOne(const VoxelTexture& texture, int count, const BatchVectors& place,
                    std::array<BatchFloats, 4>& components)
{
    switch (texture.kind) {
    case TexelKind::uint8: sampleAll<std::uint8_t>(texture, count, place, 1.0f / 255.0f, components); break;
    case TexelKind::uint16:
        sampleAll<std::uint16_t>(texture, count, place, 1.0f / 65535.0f, components);
        break;
    case TexelKind::float32: sampleAll<float>(texture, count, place, 1.0f, components); break;
    }
}

} // namespace

HWY_EXPORT(sampleTextureOfTarget);

void sampleTexture(const VoxelTexture& texture, int count, const BatchVectors& place,
                   std::array<BatchFloats, 4>& components)
{
    constexpr std::size_t kFarthest = std::numeric_limits<std::int32_t>::max();
    if (texture.texels.size() < sizeof(std::int32_t) || texture.texels.size() > kFarthest)
        sampleOneByOne(texture, count, place, components);
    else
        HWY_DYNAMIC_DISPATCH(sampleTextureOfTarget)(texture, count, place, components);
}

} // namespace vo
#endif
