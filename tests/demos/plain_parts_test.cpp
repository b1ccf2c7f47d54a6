#include "frame_times.h"
#include "volume_view/lookup_ramp.h"
#include "volume_view/picture.h"

#include "volume_io/volume_io.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace {

TEST(FrameTimes, medianIsTheValueInTheMiddle)
{
    EXPECT_EQ(vo::median({}), 0);
    EXPECT_EQ(vo::median({3}), 3);
    EXPECT_EQ(vo::median({9, 1, 2}), 2);
    EXPECT_EQ(vo::median({4, 1, 100, 2}), 3);
}

TEST(FrameTimes, lineGivesMediansInMilliseconds)
{
    const std::string line =
        vo::describeFrameTimes({{.whole = 0.004, .polygonize = 0.001, .upload = 0, .draw = 0.003},
                                {.whole = 0.006, .polygonize = 0.002, .upload = 0, .draw = 0.004}});
    EXPECT_EQ(line, "2 frames, median 5.00 ms: polygonize 1.50 ms, upload 0.00 ms, draw 3.50 ms");
}

TEST(LookupRamp, risesOverItsWidthInDataValues)
{
    const auto entries = vo::rampEntries({.center = 100, .width = 40, .opacity = 0.5}, 0, 255, 256, 2);
    ASSERT_EQ(entries.size(), 512u);
    EXPECT_EQ(entries[2 * 80], 0);
    EXPECT_FLOAT_EQ(entries[2 * 90], 0.25f);
    EXPECT_FLOAT_EQ(entries[2 * 100], 0.5f);
    EXPECT_FLOAT_EQ(entries[2 * 120], 1);
    EXPECT_EQ(entries[2 * 255], 1);
    EXPECT_FLOAT_EQ(entries[2 * 90 + 1], 0.125f) << "alpha";
    EXPECT_FLOAT_EQ(entries[2 * 255 + 1], 0.5f);
}

TEST(LookupRamp, dataRangeShiftsTheEntries)
{
    const auto entries = vo::rampEntries({.center = 1000, .width = 2000, .opacity = 1}, -1000, 3000, 5, 4);
    ASSERT_EQ(entries.size(), 20u);
    for (int i = 0; i < 4; ++i) { // at -1000, 0, 1000, 2000, 3000
        EXPECT_EQ(entries[std::size_t(i)], 0);
        EXPECT_EQ(entries[std::size_t(4 + i)], 0);
        EXPECT_FLOAT_EQ(entries[std::size_t(8 + i)], 0.5f);
        EXPECT_FLOAT_EQ(entries[std::size_t(12 + i)], 1);
        EXPECT_FLOAT_EQ(entries[std::size_t(16 + i)], 1);
    }
}

TEST(LookupRamp, sliceOpacityLetsOneEthThroughATenth)
{
    for (const double period : {0.25, 1.0, 3.0}) {
        const double slices = 20 / period;
        EXPECT_NEAR(std::pow(1 - vo::sliceOpacity(period, 200), slices), std::exp(-1), 1e-12);
    }
}

TEST(Picture, floatsAreClampedAndRounded)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto colors = vo::roundedColors(std::vector<float>{-1, 0.5f, 2, 0.1f, //
                                                             0.0019f, 0.002f, nan, 1});
    EXPECT_EQ(colors, (std::vector<std::uint8_t>{0, 128, 255, 0, 1, 0}));
}

TEST(Picture, topRowOfTheFramebufferIsTheFirstOfThePicture)
{
    const auto path = std::filesystem::path(testing::TempDir()) / "plain_parts_test.png";
    const std::vector<float> pixels{1, 0, 0, 0.5f, /* bottom */ 0, 0, 1, 0 /* top */};
    ASSERT_TRUE(vo::writePicture(path, 1, 2, pixels));
    const auto picture = vo::readPng(path);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->channels, 3);
    EXPECT_EQ(picture->bytes, (std::vector<std::uint8_t>{0, 0, 255, 255, 0, 0}));
    std::filesystem::remove(path);
}

} // namespace
