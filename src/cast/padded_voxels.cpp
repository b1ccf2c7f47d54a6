#include "cast/padded_voxels.h"

#include "core/parallel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

namespace vo {

namespace {

int sourceOf(int padded, int size, bool repeats)
{
    const int texel = padded - PaddedVoxels::kPadding;
    if (repeats) return ((texel % size) + size) % size;
    return std::clamp(texel, 0, size - 1);
}

template <class T>
T texelNumber(const std::byte* texels, std::size_t index)
{
    T number;
    std::memcpy(&number, texels + index * sizeof(T), sizeof(T));
    // What is not finite would spoil its neighbours too.
    if constexpr (std::is_same_v<T, float>) return std::isfinite(number) ? number : 0.0f;
    return number;
}

} // namespace

PaddedVoxels::PaddedVoxels(const VoxelTexture& texture, int threads)
{
    grid_.size = texture.size;
    grid_.nearest = texture.nearest;
    grid_.repeats = texture.repeats;
    // The mean of several components is no whole number.
    grid_.kind = texture.components > 2 ? TexelKind::float32 : texture.kind;
    grid_.unit = grid_.kind == TexelKind::uint8    ? 1.0f / 255.0f
                 : grid_.kind == TexelKind::uint16 ? 1.0f / 65535.0f
                                                   : 1.0f;
    grid_.row = grid_.size.x + 2 * kPadding;
    grid_.slice = grid_.row * (grid_.size.y + 2 * kPadding);
    const auto count =
        static_cast<std::size_t>(grid_.slice) * static_cast<std::size_t>(grid_.size.z + 2 * kPadding);
    memory_.resize(count * bytesOf(grid_.kind));
    grid_.numbers = memory_.data();
    grid_.far = memory_.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    switch (texture.kind) {
    case TexelKind::uint8: fill<std::uint8_t>(texture, threads); break;
    case TexelKind::uint16: fill<std::uint16_t>(texture, threads); break;
    case TexelKind::float32: fill<float>(texture, threads); break;
    }
    if (grid_.repeats != std::array{false, false, false}) return;
    switch (texture.kind) {
    case TexelKind::uint8: findRangesOf<std::uint8_t>(texture, threads); break;
    case TexelKind::uint16: findRangesOf<std::uint16_t>(texture, threads); break;
    case TexelKind::float32: findRangesOf<float>(texture, threads); break;
    }
}

template <class T>
void PaddedVoxels::findRangesOf(const VoxelTexture& texture, int threads)
{
    const auto paddedAt = [this](int x, int y, int z) { return z * grid_.slice + y * grid_.row + x; };
    if (texture.components == 1) {
        const T* const numbers = reinterpret_cast<const T*>(memory_.data());
        findRanges<T>(
            grid_.unit, [&](int x, int y, int z) { return numbers[paddedAt(x, y, z)]; }, threads);
    } else if (texture.components == 3) {
        const float* const means = reinterpret_cast<const float*>(memory_.data());
        findRanges<float>(
            1.0f, [&](int x, int y, int z) { return means[paddedAt(x, y, z)]; }, threads);
    } else {
        const auto alpha = [&](int x, int y, int z) {
            const auto inside = [](int at, int size) {
                return static_cast<std::size_t>(sourceOf(at, size, false));
            };
            const std::size_t texel =
                (inside(z, grid_.size.z) * static_cast<std::size_t>(grid_.size.y) + inside(y, grid_.size.y)) *
                    static_cast<std::size_t>(grid_.size.x) +
                inside(x, grid_.size.x);
            const auto components = static_cast<std::size_t>(texture.components);
            return texelNumber<T>(texture.texels.data(), texel * components + components - 1);
        };
        // Whatever the unit, 0 stays 0; of alphas no more is asked.
        findRanges<T>(1.0f, alpha, threads);
    }
}

glm::vec3 PaddedVoxels::cellOf(const glm::vec3& place) const
{
    const glm::vec3 size(grid_.size.x, grid_.size.y, grid_.size.z);
    const glm::vec3 inside = glm::clamp(place, 0.0f, 1.0f) * size;
    return inside + (grid_.nearest ? 0.0f : -0.5f) + static_cast<float>(kPadding);
}

/// The voxels at the far faces of a block are those of its last cells, too.
template <class T, class NumberAt>
void PaddedVoxels::findRanges(float unit, const NumberAt& numberAt, int threads)
{
    constexpr int kEdge = 1 << kBlockShift;
    const glm::ivec3 padded = glm::ivec3(grid_.size.x, grid_.size.y, grid_.size.z) + 2 * kPadding;
    blocks_.count = (padded + kEdge - 1) / kEdge;
    const auto inSlice =
        static_cast<std::size_t>(blocks_.count.x) * static_cast<std::size_t>(blocks_.count.y);
    blocks_.ranges.resize(inSlice * static_cast<std::size_t>(blocks_.count.z));
    parallelFor(static_cast<std::size_t>(blocks_.count.z), threads, [&](std::size_t blockZ) {
        for (std::size_t i = 0; i < inSlice; ++i) {
            const auto across = static_cast<std::size_t>(blocks_.count.x);
            const glm::ivec3 first = glm::ivec3(i % across, i / across, blockZ) * kEdge;
            const glm::ivec3 last = glm::min(first + kEdge, padded - 1);
            T low = std::numeric_limits<T>::max(), high = std::numeric_limits<T>::lowest();
            for (int z = first.z; z <= last.z; ++z)
                for (int y = first.y; y <= last.y; ++y)
                    for (int x = first.x; x <= last.x; ++x) {
                        const T number = numberAt(x, y, z);
                        low = std::min(low, number);
                        high = std::max(high, number);
                    }
            blocks_.ranges[blockZ * inSlice + i] = {static_cast<float>(low) * unit,
                                                    static_cast<float>(high) * unit};
        }
    });
}

template <class T>
void PaddedVoxels::fill(const VoxelTexture& texture, int threads)
{
    const auto components = static_cast<std::size_t>(texture.components);
    const float mean =
        (std::is_same_v<T, float> ? 1.0f : 1.0f / static_cast<float>(std::numeric_limits<T>::max())) / 3.0f;
    const auto fillSlice = [&](std::size_t z) {
        std::byte* to = memory_.data() + z * static_cast<std::size_t>(grid_.slice) * bytesOf(grid_.kind);
        const int fromZ = sourceOf(static_cast<int>(z), grid_.size.z, grid_.repeats[2]);
        for (int y = 0; y < grid_.size.y + 2 * kPadding; ++y) {
            const int fromY = sourceOf(y, grid_.size.y, grid_.repeats[1]);
            const std::size_t row =
                (static_cast<std::size_t>(fromZ) * static_cast<std::size_t>(grid_.size.y) +
                 static_cast<std::size_t>(fromY)) *
                static_cast<std::size_t>(grid_.size.x);
            for (int x = 0; x < grid_.size.x + 2 * kPadding; ++x) {
                const std::size_t texel =
                    (row + static_cast<std::size_t>(sourceOf(x, grid_.size.x, grid_.repeats[0]))) *
                    components;
                const auto number = [&](std::size_t c) {
                    return texelNumber<T>(texture.texels.data(), texel + c);
                };
                if (components > 2) {
                    const float brightness = (static_cast<float>(number(0)) + static_cast<float>(number(1)) +
                                              static_cast<float>(number(2))) *
                                             mean;
                    std::memcpy(to, &brightness, sizeof brightness);
                } else {
                    const T one = number(0);
                    std::memcpy(to, &one, sizeof one);
                }
                to += bytesOf(grid_.kind);
            }
        }
    };
    parallelFor(static_cast<std::size_t>(grid_.size.z + 2 * kPadding), threads, fillSlice);
}

} // namespace vo
