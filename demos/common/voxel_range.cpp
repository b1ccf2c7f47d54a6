#include "voxel_range.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vo {
namespace {

/// A row of `count` voxels that starts `first` voxels into the brick.
template <typename Value>
void growByRow(ValueRange& range, const void* voxels, std::size_t first, std::size_t count)
{
    growRange(range, static_cast<const Value*>(voxels) + first, count);
}

using GrowByRow = void (*)(ValueRange&, const void*, std::size_t, std::size_t);

/// Null for packed types.
GrowByRow rowFunction(voDataType type)
{
    switch (type) {
    case voDataTypeScope::UNSIGNED_BYTE: return growByRow<std::uint8_t>;
    case voDataTypeScope::BYTE: return growByRow<std::int8_t>;
    case voDataTypeScope::UNSIGNED_SHORT: return growByRow<std::uint16_t>;
    case voDataTypeScope::SHORT: return growByRow<std::int16_t>;
    case voDataTypeScope::UNSIGNED_INT: return growByRow<std::uint32_t>;
    case voDataTypeScope::INT: return growByRow<std::int32_t>;
    case voDataTypeScope::FLOAT: return growByRow<float>;
    default: return nullptr;
    }
}

} // namespace

void growRange(ValueRange& range, voDataType type, const void* values, std::size_t first, std::size_t count)
{
    if (const GrowByRow growByRow = rowFunction(type)) growByRow(range, values, first, count);
}

void growRange(ValueRange& range, const voBrick& brick, int xVolumeSize, int yVolumeSize, int zVolumeSize)
{
    const GrowByRow growByRow = rowFunction(brick.getDataType());
    if (!growByRow) return;
    int xOrigin = 0, yOrigin = 0, zOrigin = 0, xSize = 0, ySize = 0, zSize = 0;
    brick.getBrickSizes(xOrigin, yOrigin, zOrigin, xSize, ySize, zSize);
    const int xEnd = std::min(xSize, xVolumeSize - xOrigin);
    const int yEnd = std::min(ySize, yVolumeSize - yOrigin);
    const int zEnd = std::min(zSize, zVolumeSize - zOrigin);
    for (int z = 0; z < zEnd; ++z) {
        for (int y = 0; y < yEnd && xEnd > 0; ++y) {
            const std::size_t first =
                (std::size_t(z) * std::size_t(ySize) + std::size_t(y)) * std::size_t(xSize);
            growByRow(range, brick.getDataPtr(), first, std::size_t(xEnd));
        }
    }
}

std::vector<double> channelValues(voDataType type, const void* channels, std::size_t count)
{
    std::vector<double> values(count);
    const auto read = [&]<typename Value>(Value) {
        std::copy_n(static_cast<const Value*>(channels), count, values.begin());
    };
    switch (type) {
    case voDataTypeScope::UNSIGNED_BYTE: read(std::uint8_t()); break;
    case voDataTypeScope::BYTE: read(std::int8_t()); break;
    case voDataTypeScope::UNSIGNED_SHORT: read(std::uint16_t()); break;
    case voDataTypeScope::SHORT: read(std::int16_t()); break;
    case voDataTypeScope::UNSIGNED_INT: read(std::uint32_t()); break;
    case voDataTypeScope::INT: read(std::int32_t()); break;
    case voDataTypeScope::FLOAT: read(float()); break;
    default: break;
    }
    return values;
}

ValueRange fullRange(voDataType type)
{
    switch (type) {
    case voDataTypeScope::UNSIGNED_BYTE: return {0, 255};
    case voDataTypeScope::BYTE: return {-128, 127};
    case voDataTypeScope::UNSIGNED_SHORT: return {0, 65535};
    case voDataTypeScope::SHORT: return {-32768, 32767};
    case voDataTypeScope::UNSIGNED_INT: return {0, 4294967295.0};
    case voDataTypeScope::INT: return {-2147483648.0, 2147483647.0};
    default: return {0, 1};
    }
}

} // namespace vo
