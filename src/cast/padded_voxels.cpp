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

float mix(float low, float high, float weight)
{
    return low + (high - low) * weight;
}

} // namespace

bool isUsable(const VoxelTexture& texture)
{
    if (texture.components < 1 || texture.components > 4) return false;
    std::uint64_t count = static_cast<std::uint64_t>(texture.components) * bytesOf(texture.kind);
    for (const int axis : {0, 1, 2}) {
        if (texture.size[axis] < 1) return false;
        const auto size = static_cast<std::uint64_t>(texture.size[axis]);
        if (count > std::numeric_limits<std::uint64_t>::max() / size) return false;
        count *= size;
    }
    return texture.texels.size() >= count;
}

/// Where a sample lies: the first number of the cell of eight, and the weights of the others.
struct PaddedVoxels::Corner
{
    std::ptrdiff_t offset;
    std::array<float, 3> weight;
};

PaddedVoxels::PaddedVoxels(const VoxelTexture& texture, int threads)
    : size_(texture.size), kind_(texture.kind), nearest_(texture.nearest), repeats_(texture.repeats)
{
    // The mean of several components is no whole number.
    if (texture.components > 2) kind_ = TexelKind::float32;
    unit_ = kind_ == TexelKind::uint8 ? 1.0f / 255.0f : kind_ == TexelKind::uint16 ? 1.0f / 65535.0f : 1.0f;
    row_ = size_.x + 2 * kPadding;
    slice_ = row_ * (size_.y + 2 * kPadding);
    const auto count = static_cast<std::size_t>(slice_) * static_cast<std::size_t>(size_.z + 2 * kPadding);
    memory_.resize(count * bytesOf(kind_));
    switch (texture.kind) {
    case TexelKind::uint8: fill<std::uint8_t>(texture, threads); break;
    case TexelKind::uint16: fill<std::uint16_t>(texture, threads); break;
    case TexelKind::float32: fill<float>(texture, threads); break;
    }
    if (texture.components != 1 || repeats_ != std::array{false, false, false}) return;
    switch (kind_) {
    case TexelKind::uint8: findRanges<std::uint8_t>(threads); break;
    case TexelKind::uint16: findRanges<std::uint16_t>(threads); break;
    case TexelKind::float32: findRanges<float>(threads); break;
    }
}

glm::vec3 PaddedVoxels::cellOf(const glm::vec3& place) const
{
    const glm::vec3 size(size_.x, size_.y, size_.z);
    const glm::vec3 inside = glm::clamp(place, 0.0f, 1.0f) * size;
    return inside + (nearest_ ? 0.0f : -0.5f) + static_cast<float>(kPadding);
}

/// The voxels at the far faces of a block are those of its last cells, too.
template <class T>
void PaddedVoxels::findRanges(int threads)
{
    constexpr int kEdge = 1 << kBlockShift;
    const glm::ivec3 padded = glm::ivec3(size_.x, size_.y, size_.z) + 2 * kPadding;
    blockCount_ = (padded + kEdge - 1) / kEdge;
    const auto inSlice = static_cast<std::size_t>(blockCount_.x) * static_cast<std::size_t>(blockCount_.y);
    ranges_.resize(inSlice * static_cast<std::size_t>(blockCount_.z));
    const T* const numbers = reinterpret_cast<const T*>(memory_.data());
    parallelFor(static_cast<std::size_t>(blockCount_.z), threads, [&](std::size_t blockZ) {
        for (std::size_t i = 0; i < inSlice; ++i) {
            const auto across = static_cast<std::size_t>(blockCount_.x);
            const glm::ivec3 first = glm::ivec3(i % across, i / across, blockZ) * kEdge;
            const glm::ivec3 last = glm::min(first + kEdge, padded - 1);
            T low = std::numeric_limits<T>::max(), high = std::numeric_limits<T>::lowest();
            for (int z = first.z; z <= last.z; ++z)
                for (int y = first.y; y <= last.y; ++y) {
                    const T* const row = numbers + z * slice_ + y * row_;
                    for (int x = first.x; x <= last.x; ++x) {
                        low = std::min(low, row[x]);
                        high = std::max(high, row[x]);
                    }
                }
            ranges_[blockZ * inSlice + i] = {static_cast<float>(low) * unit_,
                                             static_cast<float>(high) * unit_};
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
        std::byte* to = memory_.data() + z * static_cast<std::size_t>(slice_) * bytesOf(kind_);
        const int fromZ = sourceOf(static_cast<int>(z), size_.z, repeats_[2]);
        for (int y = 0; y < size_.y + 2 * kPadding; ++y) {
            const int fromY = sourceOf(y, size_.y, repeats_[1]);
            const std::size_t row = (static_cast<std::size_t>(fromZ) * static_cast<std::size_t>(size_.y) +
                                     static_cast<std::size_t>(fromY)) *
                                    static_cast<std::size_t>(size_.x);
            for (int x = 0; x < size_.x + 2 * kPadding; ++x) {
                const std::size_t texel =
                    (row + static_cast<std::size_t>(sourceOf(x, size_.x, repeats_[0]))) * components;
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
                to += bytesOf(kind_);
            }
        }
    };
    parallelFor(static_cast<std::size_t>(size_.z + 2 * kPadding), threads, fillSlice);
}

PaddedVoxels::Corner PaddedVoxels::cornerAt(const BatchVectors& place, std::size_t i) const
{
    Corner corner{};
    const std::ptrdiff_t pitch[3] = {1, row_, slice_};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto size = static_cast<float>(size_[static_cast<int>(axis)]);
        float p = place[axis][i];
        if (repeats_[axis]) p -= std::floor(p);
        // Not-a-number becomes 0.
        p = std::min(std::max(0.0f, p), 1.0f) * size;
        p = nearest_ ? std::min(std::floor(p), size - 1.0f) : p - 0.5f;
        p += kPadding;
        const auto cell = static_cast<std::ptrdiff_t>(p);
        corner.weight[axis] = p - static_cast<float>(cell);
        corner.offset += cell * pitch[axis];
    }
    return corner;
}

template <class T>
void PaddedVoxels::valuesOf(int count, const BatchVectors& place, BatchFloats& value) const
{
    const T* const numbers = reinterpret_cast<const T*>(memory_.data());
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const Corner corner = cornerAt(place, i);
        const T* const at = numbers + corner.offset;
        const auto along = [&](std::ptrdiff_t row) {
            return mix(static_cast<float>(at[row]), static_cast<float>(at[row + 1]), corner.weight[0]);
        };
        const float low = mix(along(0), along(row_), corner.weight[1]);
        const float high = mix(along(slice_), along(slice_ + row_), corner.weight[1]);
        value[i] = mix(low, high, corner.weight[2]) * unit_;
    }
}

template <class T>
void PaddedVoxels::changesOf(int count, const BatchVectors& place, BatchVectors& change) const
{
    const T* const numbers = reinterpret_cast<const T*>(memory_.data());
    const float half = 0.5f * unit_;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const Corner corner = cornerAt(place, i);
        const T* const at = numbers + corner.offset;
        const auto [wx, wy, wz] = corner.weight;
        const auto number = [&](std::ptrdiff_t offset) { return static_cast<float>(at[offset]); };
        const auto along = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
            const std::ptrdiff_t row = y * row_ + z * slice_;
            return mix(number(row), number(row + 1), wx);
        };
        const auto changeAlong = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
            const std::ptrdiff_t row = y * row_ + z * slice_;
            return mix(number(row + 1) - number(row - 1), number(row + 2) - number(row), wx);
        };
        const float v00 = along(0, 0), v10 = along(1, 0), v01 = along(0, 1), v11 = along(1, 1);
        const auto across = [&](std::ptrdiff_t z, float first, float second) {
            return mix(second - along(-1, z), along(2, z) - first, wy);
        };
        const auto through = [&](std::ptrdiff_t y, float first, float second) {
            return mix(second - along(y, -1), along(y, 2) - first, wz);
        };
        const float dx = mix(mix(changeAlong(0, 0), changeAlong(1, 0), wy),
                             mix(changeAlong(0, 1), changeAlong(1, 1), wy), wz);
        const float dy = mix(across(0, v00, v10), across(1, v01, v11), wz);
        const float dz = mix(through(0, v00, v01), through(1, v10, v11), wy);
        change[0][i] = dx * half;
        change[1][i] = dy * half;
        change[2][i] = dz * half;
    }
}

void PaddedVoxels::values(int count, const BatchVectors& place, BatchFloats& value) const
{
    switch (kind_) {
    case TexelKind::uint8: return valuesOf<std::uint8_t>(count, place, value);
    case TexelKind::uint16: return valuesOf<std::uint16_t>(count, place, value);
    case TexelKind::float32: return valuesOf<float>(count, place, value);
    }
}

void PaddedVoxels::changes(int count, const BatchVectors& place, BatchVectors& change) const
{
    switch (kind_) {
    case TexelKind::uint8: return changesOf<std::uint8_t>(count, place, change);
    case TexelKind::uint16: return changesOf<std::uint16_t>(count, place, change);
    case TexelKind::float32: return changesOf<float>(count, place, change);
    }
}

} // namespace vo
