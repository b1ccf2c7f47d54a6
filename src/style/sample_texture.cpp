#include "style/style.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

} // namespace

void sampleTexture(const VoxelTexture& texture, int count, const BatchVectors& place,
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

} // namespace vo
