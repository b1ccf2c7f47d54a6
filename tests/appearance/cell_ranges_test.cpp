#include "appearance/cell_ranges.h"

#include "appearance/convert_voxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

namespace {

using vo::Channels;
using vo::VoxelFormat;
using vo::VoxelOrigin;
using vo::VoxelSize;
using vo::VoxelType;

constexpr VoxelSize kSize{21, 10, 17};
constexpr VoxelOrigin kOrigin{5, 8, 15};

std::vector<std::byte> randomVoxels(VoxelFormat format)
{
    std::mt19937 random(3);
    std::vector<std::byte> voxels(kSize.count() * vo::voxelBytes(format));
    if (format.type == VoxelType::float32) {
        std::uniform_real_distribution<float> anything(-3.0f, 3.0f);
        for (std::size_t i = 0; i < voxels.size(); i += sizeof(float)) {
            const float value = anything(random);
            std::memcpy(voxels.data() + i, &value, sizeof value);
        }
        return voxels;
    }
    for (std::byte& byte : voxels)
        byte = static_cast<std::byte>(random() & 255u);
    return voxels;
}

/// Voxel by voxel: those within one voxel of the cell.
vo::ValueRange rangeOf(const std::vector<float>& rgba, const std::array<int, 3>& cell, std::size_t component)
{
    vo::ValueRange range;
    for (int z = 0; z < kSize.z; ++z)
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const std::array<int, 3> at = {kOrigin.x + x, kOrigin.y + y, kOrigin.z + z};
                bool counts = true;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    counts = counts && at[axis] >= cell[axis] * vo::kCellSide - 1 &&
                             at[axis] <= (cell[axis] + 1) * vo::kCellSide;
                if (!counts) continue;
                const float value =
                    rgba[4 * static_cast<std::size_t>((z * kSize.y + y) * kSize.x + x) + component];
                range.low = std::min(range.low, value);
                range.high = std::max(range.high, value);
            }
    return range;
}

void expectRanges(std::span<const std::byte> voxels, VoxelFormat format, vo::VoxelComponent component)
{
    std::vector<float> rgba(4 * kSize.count());
    vo::decodeVoxels(voxels, format, kSize.count(), rgba.data());
    const vo::CellRanges cells = vo::cellRanges(voxels, format, kSize, kOrigin, component);
    EXPECT_EQ(cells.first, (VoxelOrigin{1, 2, 3}));
    ASSERT_EQ(cells.count, (VoxelSize{6, 3, 5}));
    ASSERT_EQ(cells.ranges.size(), 90u);
    for (int z = 0; z < 5; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 6; ++x) {
                const vo::ValueRange expected =
                    rangeOf(rgba, {1 + x, 2 + y, 3 + z}, static_cast<std::size_t>(component));
                const vo::ValueRange& found = cells.ranges[static_cast<std::size_t>((z * 3 + y) * 6 + x)];
                EXPECT_EQ(found.low, expected.low) << x << " " << y << " " << z;
                EXPECT_EQ(found.high, expected.high) << x << " " << y << " " << z;
            }
}

TEST(CellRanges, areThoseOfTheCellAndOneVoxelAroundInAnyFormat)
{
    for (const VoxelFormat format :
         {VoxelFormat{Channels::luminance, VoxelType::uint8},
          VoxelFormat{Channels::luminance, VoxelType::int8},
          VoxelFormat{Channels::luminance, VoxelType::uint16},
          VoxelFormat{Channels::intensity, VoxelType::int16},
          VoxelFormat{Channels::luminance, VoxelType::float32},
          VoxelFormat{Channels::luminance, VoxelType::uint32},
          VoxelFormat{Channels::luminanceAlpha, VoxelType::uint8},
          VoxelFormat{Channels::abgr, VoxelType::uint8}, VoxelFormat{Channels::rgba, VoxelType::uint16_5551}})
        for (const auto component : {vo::VoxelComponent::red, vo::VoxelComponent::alpha}) {
            SCOPED_TRACE(testing::Message()
                         << static_cast<int>(format.channels) << " " << static_cast<int>(format.type));
            expectRanges(randomVoxels(format), format, component);
        }
}

TEST(CellRanges, voxelsMayLieAtAnyAddress)
{
    const VoxelFormat format{Channels::luminance, VoxelType::uint16};
    std::vector<std::byte> voxels = randomVoxels(format);
    voxels.insert(voxels.begin(), std::byte{0});
    expectRanges(std::span(voxels).subspan(1), format, vo::VoxelComponent::red);
}

} // namespace
