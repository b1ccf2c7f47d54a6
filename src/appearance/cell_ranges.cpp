#include "appearance/cell_ranges.h"

#include "appearance/convert_voxels.h"
#include "core/parallel.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

namespace vo {

namespace {

/// The voxels of a brick that a cell counts along one axis: [first, last].
struct Layers
{
    int first;
    int last;
};

Layers layersOf(int cell, int side, int origin, int size)
{
    return {std::max(cell * side - 1 - origin, 0), std::min((cell + 1) * side - origin, size - 1)};
}

/// From the first cell that a brick meets, or is beside, to before the end.
struct CellSpan
{
    int first;
    int end;
};

CellSpan cellsOf(const CellGrid& grid, int origin, int size)
{
    const int beside = grid.besideBrick ? 1 : 0;
    return {std::max(origin - beside, 0) / grid.side, (origin + size + beside + grid.side - 1) / grid.side};
}

class RangeFinder
{
public:
    RangeFinder(std::span<const std::byte> voxels, VoxelFormat format, const VoxelSize& size,
                const VoxelOrigin& origin, VoxelComponent component, int side, CellRanges& result)
        : voxels_(voxels), format_(format), size_(size), origin_(origin),
          component_(static_cast<std::size_t>(component)), side_(side), result_(result)
    {
    }

    /// A row of cells along x.
    void findRow(int cellY, int cellZ)
    {
        switch (channelCount(format_.channels) == 1 ? format_.type : VoxelType::uint32_8888) {
        case VoxelType::uint8: return findRowOf<std::uint8_t>(cellY, cellZ);
        case VoxelType::int8: return findRowOf<std::int8_t>(cellY, cellZ);
        case VoxelType::uint16: return findRowOf<std::uint16_t>(cellY, cellZ);
        case VoxelType::int16: return findRowOf<std::int16_t>(cellY, cellZ);
        case VoxelType::float32: return findRowOf<float>(cellY, cellZ);
        case VoxelType::uint32:
        case VoxelType::int32:
        case VoxelType::uint8_332:
        case VoxelType::uint16_4444:
        case VoxelType::uint16_5551:
        case VoxelType::uint32_8888:
        case VoxelType::uint32_1010102: return findDecodedRow(cellY, cellZ);
        }
    }

private:
    const std::byte* row(int y, int z) const
    {
        const std::size_t number =
            static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(y);
        return voxels_.data() + number * static_cast<std::size_t>(size_.x) * voxelBytes(format_);
    }

    /// Lowest and highest across y and z for each x, `valuesOf(y, z)` being a row of voxels.
    template <typename T, typename Rows>
    void fold(int cellY, int cellZ, const Rows& valuesOf, std::vector<T>& low, std::vector<T>& high) const
    {
        const Layers y = layersOf(cellY, side_, origin_.y, size_.y);
        const Layers z = layersOf(cellZ, side_, origin_.z, size_.z);
        const auto n = static_cast<std::size_t>(size_.x);
        const T* start = valuesOf(y.first, z.first);
        low.assign(start, start + n);
        high.assign(start, start + n);
        for (int k = z.first; k <= z.last; ++k)
            for (int j = y.first; j <= y.last; ++j) {
                const T* values = valuesOf(j, k);
                T* const lows = low.data();
                T* const highs = high.data();
                for (std::size_t i = 0; i < n; ++i) {
                    lows[i] = std::min(lows[i], values[i]);
                    highs[i] = std::max(highs[i], values[i]);
                }
            }
    }

    /// Across x too; afterwards the first entries stand for cells.
    template <typename T>
    void foldAlong(std::vector<T>& low, std::vector<T>& high) const
    {
        std::vector<T> lows, highs;
        for (int cell = 0; cell < result_.count.x; ++cell) {
            const Layers x = layersOf(result_.first.x + cell, side_, origin_.x, size_.x);
            lows.push_back(*std::min_element(low.begin() + x.first, low.begin() + x.last + 1));
            highs.push_back(*std::max_element(high.begin() + x.first, high.begin() + x.last + 1));
        }
        low = std::move(lows);
        high = std::move(highs);
    }

    template <typename T>
    void findRowOf(int cellY, int cellZ) const
    {
        if (reinterpret_cast<std::uintptr_t>(voxels_.data()) % alignof(T) != 0)
            return findDecodedRow(cellY, cellZ);
        std::vector<T> low, high;
        fold(
            cellY, cellZ, [&](int y, int z) { return reinterpret_cast<const T*>(row(y, z)); }, low, high);
        foldAlong(low, high);
        // Decoding keeps order.
        std::vector<float> lows(4 * low.size()), highs(4 * high.size());
        decodeVoxels(std::as_bytes(std::span(low)), format_, low.size(), lows.data());
        decodeVoxels(std::as_bytes(std::span(high)), format_, high.size(), highs.data());
        ValueRange* ranges = rangesOf(cellY, cellZ);
        for (std::size_t i = 0; i < low.size(); ++i)
            ranges[i] = {lows[4 * i + component_], highs[4 * i + component_]};
    }

    void findDecodedRow(int cellY, int cellZ) const
    {
        const auto n = static_cast<std::size_t>(size_.x);
        std::vector<float> rgba(4 * n), values(n), low, high;
        fold(
            cellY, cellZ,
            [&](int y, int z) -> const float* {
                decodeVoxels({row(y, z), n * voxelBytes(format_)}, format_, n, rgba.data());
                for (std::size_t i = 0; i < n; ++i)
                    values[i] = rgba[4 * i + component_];
                return values.data();
            },
            low, high);
        foldAlong(low, high);
        ValueRange* ranges = rangesOf(cellY, cellZ);
        for (std::size_t i = 0; i < low.size(); ++i)
            ranges[i] = {low[i], high[i]};
    }

    ValueRange* rangesOf(int cellY, int cellZ) const
    {
        const auto number =
            static_cast<std::size_t>(cellZ - result_.first.z) * static_cast<std::size_t>(result_.count.y) +
            static_cast<std::size_t>(cellY - result_.first.y);
        return result_.ranges.data() + number * static_cast<std::size_t>(result_.count.x);
    }

    std::span<const std::byte> voxels_;
    VoxelFormat format_;
    VoxelSize size_;
    VoxelOrigin origin_;
    std::size_t component_;
    int side_;
    CellRanges& result_;
};

} // namespace

CellRanges cellRanges(std::span<const std::byte> voxels, VoxelFormat format, const VoxelSize& size,
                      const VoxelOrigin& origin, VoxelComponent component, const CellGrid& grid)
{
    assert(voxels.size() / voxelBytes(format) >= size.count());
    assert(origin.x >= 0 && origin.y >= 0 && origin.z >= 0);
    const CellSpan x = cellsOf(grid, origin.x, size.x), y = cellsOf(grid, origin.y, size.y),
                   z = cellsOf(grid, origin.z, size.z);
    CellRanges result;
    result.first = {x.first, y.first, z.first};
    result.count = {x.end - x.first, y.end - y.first, z.end - z.first};
    result.ranges.resize(result.count.count());
    const auto rows = static_cast<std::size_t>(result.count.y);
    parallelFor(rows * static_cast<std::size_t>(result.count.z), 0, [&](std::size_t i) {
        RangeFinder(voxels, format, size, origin, component, grid.side, result)
            .findRow(result.first.y + static_cast<int>(i % rows),
                     result.first.z + static_cast<int>(i / rows));
    });
    return result;
}

} // namespace vo
