#include "volume_view/brightness_alpha.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace {

/// What becomes of red, green, blue and an alpha of 1.
template <typename Value>
std::array<Value, 4> withAlpha(vo::ChannelType type, Value red, Value green, Value blue)
{
    std::array<Value, 8> voxels{0, 0, 0, 1, red, green, blue, 1};
    vo::setBrightnessAlpha(type, std::as_writable_bytes(std::span(voxels)));
    EXPECT_EQ(voxels[3], Value(0)) << "black";
    return {voxels[4], voxels[5], voxels[6], voxels[7]};
}

template <typename Value>
void expectLargest(vo::ChannelType type)
{
    using Limits = std::numeric_limits<Value>;
    const Value low = Limits::lowest(), high = Limits::max();
    EXPECT_EQ(withAlpha<Value>(type, 90, 5, 7), (std::array<Value, 4>{90, 5, 7, 90}));
    EXPECT_EQ(withAlpha<Value>(type, 3, high, 7), (std::array<Value, 4>{3, high, 7, high}));
    EXPECT_EQ(withAlpha<Value>(type, low, 5, 60), (std::array<Value, 4>{low, 5, 60, 60}));
    EXPECT_EQ(withAlpha<Value>(type, low, low, low), (std::array<Value, 4>{low, low, low, low}));
}

TEST(BrightnessAlpha, isTheLargestColourInEveryType)
{
    expectLargest<std::uint8_t>(vo::ChannelType::uint8);
    expectLargest<std::int8_t>(vo::ChannelType::int8);
    expectLargest<std::uint16_t>(vo::ChannelType::uint16);
    expectLargest<std::int16_t>(vo::ChannelType::int16);
    expectLargest<float>(vo::ChannelType::float32);
}

TEST(BrightnessAlpha, whatIsNotANumberIsNotBrighter)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(withAlpha(vo::ChannelType::float32, nan, 0.25f, 0.5f)[3], 0.5f);
    EXPECT_EQ(withAlpha(vo::ChannelType::float32, 0.5f, nan, nan)[3], 0.5f);
    EXPECT_TRUE(std::isnan(withAlpha(vo::ChannelType::float32, nan, nan, nan)[3]));
}

} // namespace
