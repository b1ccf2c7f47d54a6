#include "voxel_range.h"

#include <vo/AppearanceActions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace {

/// The range of the voxels of one brick of 4 x 3 x 2 voxels in a volume of these sizes.
template <typename Value>
vo::ValueRange rangeOf(voDataType type, std::vector<Value> voxels, int xVolume = 4, int yVolume = 3,
                       int zVolume = 2)
{
    voBrick brick(voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE, type);
    brick.setBrickSizes(0, 0, 0, 4, 3, 2);
    brick.setDataPtr(voxels.data());
    vo::ValueRange range;
    vo::growRange(range, brick, xVolume, yVolume, zVolume);
    return range;
}

TEST(VoxelRange, spansTheValuesOfEachType)
{
    std::vector<short> shorts(24, 5);
    shorts[0] = -300;
    shorts[23] = 4000;
    const auto range = rangeOf(voDataTypeScope::SHORT, shorts);
    EXPECT_EQ(range.low, -300);
    EXPECT_EQ(range.high, 4000);

    std::vector<unsigned short> unsignedShorts(24, 40000);
    unsignedShorts[7] = 65535;
    EXPECT_EQ(rangeOf(voDataTypeScope::UNSIGNED_SHORT, unsignedShorts).low, 40000);
    EXPECT_EQ(rangeOf(voDataTypeScope::UNSIGNED_SHORT, unsignedShorts).high, 65535);
    EXPECT_EQ(rangeOf(voDataTypeScope::BYTE, std::vector<signed char>(24, -7)).high, -7);
    EXPECT_EQ(rangeOf(voDataTypeScope::INT, std::vector<int>(24, -70000)).low, -70000);
}

TEST(VoxelRange, passesOverWhatIsNoNumber)
{
    std::vector<float> floats(24, 0.5f);
    floats[0] = std::numeric_limits<float>::quiet_NaN();
    floats[1] = std::numeric_limits<float>::infinity();
    floats[2] = -1.5f;
    const auto range = rangeOf(voDataTypeScope::FLOAT, floats);
    EXPECT_EQ(range.low, -1.5);
    EXPECT_EQ(range.high, 0.5);
    const auto nothing =
        rangeOf(voDataTypeScope::FLOAT, std::vector<float>(24, std::numeric_limits<float>::quiet_NaN()));
    EXPECT_GT(nothing.low, nothing.high);
}

TEST(VoxelRange, passesOverVoxelsOutsideTheVolume)
{
    std::vector<unsigned char> voxels(24, 0);
    for (int y = 0; y < 2; ++y)
        std::fill_n(voxels.begin() + 4 * y, 3, static_cast<unsigned char>(100 + y));
    const auto range = rangeOf(voDataTypeScope::UNSIGNED_BYTE, voxels, 3, 2, 1);
    EXPECT_EQ(range.low, 100);
    EXPECT_EQ(range.high, 101);
}

} // namespace
