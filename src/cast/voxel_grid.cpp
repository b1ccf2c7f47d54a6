#include "cast/voxel_grid.h"

#include "appearance/convert_voxels.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <type_traits>

namespace vo {

namespace {

/// Gathers count bytes (of pairs of bytes), or numbers (of all others), in 31 bits.
constexpr std::uint64_t kMostOffsets = std::uint64_t{1} << 31;
/// Bytes that are read past the last cell, and count for nothing.
constexpr std::size_t kPastTheEnd = 16;
/// Clip boxes come from floats.
constexpr double kTolerance = 1e-4;

bool isWhole(float value)
{
    return std::isfinite(value) && value == std::round(value) && std::abs(value) < 1e9f;
}

bool answersOneChannel(const BrickTexels& texels)
{
    return !texels.classified &&
           (texels.texel == TexelFormat::intensity || texels.texel == TexelFormat::luminance);
}

/// Red, green, blue and alpha of a row of voxels as a texture answers.
void decodeTexels(const BrickTexels& texels, std::size_t first, std::size_t count, float* rgba)
{
    const std::size_t bytes = voxelBytes(texels.format);
    decodeVoxels(texels.voxels.subspan(first * bytes, count * bytes), texels.format, count, rgba);
    if (texels.classified) return applyTable(*texels.classified, rgba, count);
    if (clampsTexels(texels.format.type))
        for (std::size_t i = 0; i < 4 * count; ++i)
            rgba[i] = std::clamp(rgba[i], 0.0f, 1.0f);
    for (std::size_t i = 0; i < count; ++i, rgba += 4) {
        if (texels.texel == TexelFormat::luminanceAlpha) rgba[1] = rgba[2] = rgba[0];
        if (texels.texel == TexelFormat::rgb) rgba[3] = 1.0f;
    }
}

/// A row of a brick as the grid stores voxels of type T.
template <class T>
void readRow(const BrickTexels& texels, int channels, std::size_t first, std::size_t count, T* row)
{
    if constexpr (std::is_floating_point_v<T>) {
        if (channels == 4) return decodeTexels(texels, first, count, row);
        std::array<float, 4 * 256> rgba;
        for (std::size_t start = 0; start < count; start += 256) {
            const std::size_t part = std::min<std::size_t>(256, count - start);
            decodeTexels(texels, first + start, part, rgba.data());
            for (std::size_t i = 0; i < part; ++i)
                row[start + i] = rgba[4 * i];
        }
    } else {
        const auto copy = [&](auto tag) {
            using Stored = decltype(tag);
            const std::byte* from = texels.voxels.data() + first * sizeof(Stored);
            for (std::size_t i = 0; i < count; ++i) {
                Stored value;
                std::memcpy(&value, from + i * sizeof(Stored), sizeof(Stored));
                row[i] = static_cast<T>(std::max(value, Stored{0}));
            }
        };
        switch (texels.format.type) {
        case VoxelType::uint8: return copy(std::uint8_t{});
        case VoxelType::int8: return copy(std::int8_t{});
        case VoxelType::uint16: return copy(std::uint16_t{});
        case VoxelType::int16: return copy(std::int16_t{});
        default: assert(!"other types are stored as floats");
        }
    }
}

/// What a cell keeps of a voxel and its neighbour in +y.
std::uint16_t cellOf(std::uint8_t voxel, std::uint8_t above)
{
    return static_cast<std::uint16_t>(voxel | above << 8);
}

std::uint32_t cellOf(std::uint16_t voxel, std::uint16_t above)
{
    return voxel | static_cast<std::uint32_t>(above) << 16;
}

float cellOf(float voxel, float)
{
    return voxel;
}

template <class T>
using CellOf = decltype(cellOf(T{}, T{}));

/// True when the boxes fill the box around them, none over another.
bool fillABox(std::span<const Box> boxes, const Box& around)
{
    std::array<std::vector<double>, 3> faces;
    for (int axis = 0; axis < 3; ++axis) {
        auto& own = faces[static_cast<std::size_t>(axis)];
        for (const Box& box : boxes)
            own.push_back(box.lower[axis]);
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        own.push_back(around.upper[axis]);
    }
    const std::size_t cells = (faces[0].size() - 1) * (faces[1].size() - 1) * (faces[2].size() - 1);
    if (cells != boxes.size()) return false;
    std::vector<bool> seen(cells);
    for (const Box& box : boxes) {
        std::size_t cell = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto& own = faces[static_cast<std::size_t>(axis)];
            const auto at = std::lower_bound(own.begin(), own.end(), box.lower[axis]) - own.begin();
            if (own[static_cast<std::size_t>(at) + 1] != box.upper[axis]) return false;
            cell = cell * (own.size() - 1) + static_cast<std::size_t>(at);
        }
        if (seen[cell]) return false;
        seen[cell] = true;
    }
    return true;
}

} // namespace

VoxelGrid::VoxelGrid(std::span<const CastBrick> bricks, std::span<const Box> clipBoxes, int threads,
                     std::string& refusal)
{
    assert(!bricks.empty() && bricks.size() == clipBoxes.size());
    refusal.clear();
    if (!place(bricks, clipBoxes, refusal) || !chooseKind(bricks.front(), refusal)) return;
    bool agree = false;
    switch (view_.kind) {
    case GridKind::bytes: agree = fill<std::uint8_t>(bricks, threads); break;
    case GridKind::shorts: agree = fill<std::uint16_t>(bricks, threads); break;
    case GridKind::floats: agree = fill<float>(bricks, threads); break;
    }
    if (!agree) {
        refusal = "bricks disagree where they overlap";
        memory_ = {};
    }
}

glm::dvec3 VoxelGrid::shift() const
{
    glm::dvec3 shift(0.5 - lower_.x, 0.5 - lower_.y, 0.5 - lower_.z);
    // Planes at the faces of thin bricks belong to the upper one, whatever rounding says.
    if (view_.thinAxis >= 0) shift[view_.thinAxis] += 0.5 + kTolerance;
    return shift;
}

/// Finds the box that the bricks cover, and whether the samples in it are the same in one grid.
bool VoxelGrid::place(std::span<const CastBrick> bricks, std::span<const Box> clipBoxes, std::string& refusal)
{
    constexpr int kMost = std::numeric_limits<int>::max();
    std::array<int, 3> lower{kMost, kMost, kMost}, upper{-kMost, -kMost, -kMost};
    Box around = clipBoxes.front();
    const CastBrick& first = bricks.front();
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        const CastBrick& brick = bricks[i];
        if (brick.texels.format != first.texels.format || brick.texels.texel != first.texels.texel ||
            brick.thinAxis != first.thinAxis ||
            (brick.texels.classified == nullptr) != (first.texels.classified == nullptr)) {
            refusal = "bricks of several formats";
            return false;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const float origin = brick.origin[axis];
            if (!isWhole(origin) || brick.size[axis] != static_cast<float>(brick.texels.size[axis])) {
                refusal = "bricks that do not lie on whole voxels";
                return false;
            }
            lower[a] = std::min(lower[a], static_cast<int>(origin));
            upper[a] = std::max(upper[a], static_cast<int>(origin) + brick.texels.size[axis]);
        }
        around = {glm::min(around.lower, clipBoxes[i].lower), glm::max(around.upper, clipBoxes[i].upper)};
    }
    if (!fillABox(clipBoxes, around)) {
        refusal = "bricks that do not fill a box";
        return false;
    }
    for (std::size_t i = 0; i < bricks.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double origin = bricks[i].origin[axis];
            const double end = origin + bricks[i].texels.size[axis];
            const double margin = axis == first.thinAxis ? 0.0 : 0.5;
            const bool below = origin == lower[a] || clipBoxes[i].lower[axis] >= origin + margin - kTolerance;
            const bool above = end == upper[a] || clipBoxes[i].upper[axis] <= end - margin + kTolerance;
            if (!below || !above) {
                refusal = "bricks without overlap";
                return false;
            }
        }
    lower_ = {lower[0], lower[1], lower[2]};
    size_ = {upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]};
    view_.thinAxis = first.thinAxis;
    return true;
}

bool VoxelGrid::chooseKind(const CastBrick& brick, std::string& refusal)
{
    const BrickTexels& texels = brick.texels;
    const std::uint64_t rowPitch = static_cast<std::uint64_t>(size_.x) + 2;
    const std::uint64_t rows = static_cast<std::uint64_t>(size_.y) + 2;
    const std::uint64_t slices = static_cast<std::uint64_t>(size_.z) + 2;
    if (rowPitch * rows >= kMostOffsets || slices >= kMostOffsets || rowPitch >= 65536 || rows >= 65536 ||
        slices >= 65536 || rowPitch * rows * slices >= kMostOffsets) {
        refusal = "a volume of " + std::to_string(size_.x) + " x " + std::to_string(size_.y) + " x " +
                  std::to_string(size_.z) + " voxels";
        return false;
    }
    const std::uint64_t cells = rowPitch * rows * slices;
    view_.channels = answersOneChannel(texels) ? 1 : 4;
    const bool alone = view_.channels == 1 && channelCount(texels.format.channels) == 1;
    const VoxelType type = texels.format.type;
    const bool small = type == VoxelType::uint8 || type == VoxelType::int8;
    if (alone && small && 2 * cells < kMostOffsets) {
        view_.kind = GridKind::bytes;
        view_.rawUnit = kByteRaw * (type == VoxelType::uint8 ? 255.0f : 127.0f);
    } else if (alone && (small || type == VoxelType::uint16 || type == VoxelType::int16)) {
        view_.kind = GridKind::shorts;
        view_.rawUnit = type == VoxelType::uint8    ? 255.0f
                        : type == VoxelType::int8   ? 127.0f
                        : type == VoxelType::uint16 ? 65535.0f
                                                    : 32767.0f;
    } else {
        view_.kind = GridKind::floats;
        if (cells * static_cast<std::uint64_t>(view_.channels) >= kMostOffsets) {
            refusal = "a volume of " + std::to_string(cells) + " voxels of this format";
            return false;
        }
    }
    view_.rowPitch = static_cast<std::uint32_t>(rowPitch);
    view_.slicePitch = static_cast<std::uint32_t>(rowPitch * rows);
    view_.lastCell = static_cast<std::uint32_t>(cells - 1 - view_.slicePitch - view_.rowPitch - 1);
    blockCount_ = glm::ivec3(size_.x, size_.y, size_.z) / kBlockCells + 1;
    return true;
}

/// False when bricks disagree about a voxel.
template <class T>
bool VoxelGrid::fill(std::span<const CastBrick> bricks, int threads)
{
    const auto channels = static_cast<std::size_t>(view_.channels);
    const auto width = static_cast<std::size_t>(size_.x) * channels;
    const auto pitch = static_cast<std::size_t>(view_.rowPitch) * channels;
    const auto slice = static_cast<std::size_t>(view_.slicePitch) * channels;
    const std::size_t used = slice * (static_cast<std::size_t>(size_.z) + 2) * sizeof(CellOf<T>);
    memory_.resize(used + kPastTheEnd);
    std::memset(memory_.data() + used, 0, kPastTheEnd);
    view_.cells = memory_.data();
    auto* cells = reinterpret_cast<CellOf<T>*>(memory_.data());
    std::atomic<bool> agree = true;

    const auto rowsOf = [&](const CastBrick& brick, int z, const auto& take) {
        const int inside = z - (static_cast<int>(brick.origin.z) - lower_.z);
        if (inside < 0 || inside >= brick.texels.size.z) return;
        const auto count = static_cast<std::size_t>(brick.texels.size.x);
        std::vector<T> row(count * channels);
        for (int y = 0; y < brick.texels.size.y; ++y) {
            const auto first =
                (static_cast<std::size_t>(inside) * static_cast<std::size_t>(brick.texels.size.y) +
                 static_cast<std::size_t>(y)) *
                count;
            readRow(brick.texels, view_.channels, first, count, row.data());
            const auto to =
                static_cast<std::size_t>(static_cast<int>(brick.origin.y) - lower_.y + y) * width +
                static_cast<std::size_t>(static_cast<int>(brick.origin.x) - lower_.x) * channels;
            take(to, row);
        }
    };
    const auto fillSlice = [&](std::size_t z) {
        std::vector<T> layer(width * static_cast<std::size_t>(size_.y));
        for (const CastBrick& brick : bricks)
            rowsOf(brick, static_cast<int>(z), [&](std::size_t to, const std::vector<T>& row) {
                std::copy(row.begin(), row.end(), layer.begin() + static_cast<std::ptrdiff_t>(to));
            });
        if (bricks.size() > 1)
            for (const CastBrick& brick : bricks)
                rowsOf(brick, static_cast<int>(z), [&](std::size_t to, const std::vector<T>& row) {
                    if (std::memcmp(row.data(), layer.data() + to, row.size() * sizeof(T)) != 0)
                        agree = false;
                });
        for (int y = -1; y <= size_.y; ++y) {
            const T* row = layer.data() + static_cast<std::size_t>(std::clamp(y, 0, size_.y - 1)) * width;
            const T* above =
                layer.data() + static_cast<std::size_t>(std::clamp(y + 1, 0, size_.y - 1)) * width;
            CellOf<T>* out = cells + (z + 1) * slice + static_cast<std::size_t>(y + 1) * pitch;
            for (std::size_t c = 0; c < channels; ++c) {
                out[c] = cellOf(row[c], above[c]);
                out[pitch - channels + c] = cellOf(row[width - channels + c], above[width - channels + c]);
            }
            for (std::size_t x = 0; x < width; ++x)
                out[x + channels] = cellOf(row[x], above[x]);
        }
    };
    parallelFor(static_cast<std::size_t>(size_.z), threads, fillSlice);
    if (!agree) return false;
    const std::size_t sliceBytes = slice * sizeof(CellOf<T>);
    std::memcpy(cells, cells + slice, sliceBytes);
    const auto last = static_cast<std::size_t>(size_.z);
    std::memcpy(cells + (last + 1) * slice, cells + last * slice, sliceBytes);
    findRanges<T>(threads);
    return true;
}

/// Bytes may alias anything: without the promise that they do not, this loop is not done with SIMD.
template <class T>
void widen(const T* __restrict values, std::size_t count, T* __restrict lowest, T* __restrict highest)
{
    for (std::size_t i = 0; i < count; ++i) {
        lowest[i] = std::min(lowest[i], values[i]);
        highest[i] = std::max(highest[i], values[i]);
    }
}

/// A block's samples mix the voxels of its cells and of the next ones in each direction.
template <class T>
void VoxelGrid::findRanges(int threads)
{
    const auto channels = static_cast<std::size_t>(view_.channels);
    // Cells of integers hold two rows, side by side: each number of a row is then one of a pair.
    constexpr std::size_t kRows = std::is_floating_point_v<T> ? 1 : 2;
    const auto pitch = static_cast<std::size_t>(view_.rowPitch) * channels * kRows;
    const auto slice = static_cast<std::size_t>(view_.slicePitch) * channels * kRows;
    const auto* voxels = reinterpret_cast<const T*>(memory_.data());
    const glm::ivec3 last = glm::ivec3(size_.x, size_.y, size_.z) + 1;
    ranges_.assign(static_cast<std::size_t>(blockCount_.x) * static_cast<std::size_t>(blockCount_.y) *
                       static_cast<std::size_t>(blockCount_.z) * channels * 2,
                   0.0f);
    const float scale = view_.kind == GridKind::bytes ? kByteRaw : 1.0f;

    const auto rangeOfRow = [&](int by, int bz, std::vector<T>& low, std::vector<T>& high) {
        std::fill(low.begin(), low.end(), std::numeric_limits<T>::max());
        std::fill(high.begin(), high.end(), std::numeric_limits<T>::lowest());
        const int reach = std::is_floating_point_v<T> ? 0 : 1;
        const int firstY = by * kBlockCells, lastY = std::min(firstY + kBlockCells - reach, last.y - reach);
        const int firstZ = bz * kBlockCells, lastZ = std::min(firstZ + kBlockCells, last.z);
        for (int z = firstZ; z <= lastZ; ++z)
            for (int y = firstY; y <= lastY; ++y) {
                const T* row =
                    voxels + static_cast<std::size_t>(z) * slice + static_cast<std::size_t>(y) * pitch;
                widen(row, low.size(), low.data(), high.data());
            }
    };
    parallelFor(static_cast<std::size_t>(blockCount_.z), threads, [&](std::size_t bz) {
        std::vector<T> low(pitch), high(pitch);
        for (int by = 0; by < blockCount_.y; ++by) {
            rangeOfRow(by, static_cast<int>(bz), low, high);
            for (int bx = 0; bx < blockCount_.x; ++bx) {
                const std::size_t first = static_cast<std::size_t>(bx * kBlockCells) * channels * kRows;
                const std::size_t end =
                    static_cast<std::size_t>(std::min(bx * kBlockCells + kBlockCells, last.x) + 1) *
                    channels * kRows;
                float* out = ranges_.data() +
                             ((bz * static_cast<std::size_t>(blockCount_.y) + static_cast<std::size_t>(by)) *
                                  static_cast<std::size_t>(blockCount_.x) +
                              static_cast<std::size_t>(bx)) *
                                 channels * 2;
                for (std::size_t c = 0; c < channels; ++c) {
                    T lowest = low[first + c], highest = high[first + c];
                    const std::size_t step = channels == 1 ? 1 : channels;
                    for (std::size_t x = first + c; x < end; x += step) {
                        lowest = std::min(lowest, low[x]);
                        highest = std::max(highest, high[x]);
                    }
                    // Interpolation in floats may leave the range by a rounding error.
                    const float slack = view_.kind == GridKind::bytes ? 0.0f : 1e-6f;
                    const float a = static_cast<float>(lowest) * scale,
                                b = static_cast<float>(highest) * scale;
                    const float size = std::max(std::abs(a), std::abs(b));
                    out[2 * c] = a - slack * size;
                    out[2 * c + 1] = b + slack * size;
                }
            }
        }
    });
}

} // namespace vo
