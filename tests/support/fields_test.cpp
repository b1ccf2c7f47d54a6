#include "support/fields.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace vo::test;
using vo::VoxelSize;

TEST(Fields, rampIsLinearInTheVoxelCentres)
{
    const Field ramp = rampField({4, 5, 6}, {0.1, 0.01, 0.001}, 0.2);
    EXPECT_FLOAT_EQ(ramp.at(3, 2, 1), static_cast<float>(0.2 + 0.35 + 0.025 + 0.0015));
    const Field along = axisRampField({4, 5, 6}, 1);
    EXPECT_EQ(along.at(2, 0, 3), 0.0f);
    EXPECT_EQ(along.at(2, 4, 3), 1.0f);
    EXPECT_EQ(along.at(1, 2, 5), 0.5f);
}

TEST(Fields, ballIsOneInTheMiddleAndEmptyAtItsRim)
{
    const Field ball = ballField({33, 33, 33});
    EXPECT_EQ(ball.at(16, 16, 16), 1.0f);
    EXPECT_EQ(ball.at(0, 16, 16), 0.0f);
    EXPECT_GT(ball.at(10, 16, 16), ball.at(8, 16, 16));
    EXPECT_FLOAT_EQ(ball.at(10, 16, 16), ball.at(16, 16, 22));
}

TEST(Fields, cubesFallOffFromTheCentre)
{
    const Field cubes = cubesField({48, 48, 48}, 16);
    EXPECT_EQ(cubes.at(0, 0, 0), 0.0f);
    EXPECT_EQ(cubes.at(24, 24, 24), 1.0f);
    EXPECT_LT(cubes.at(8, 8, 8), 1.0f);
    EXPECT_GT(cubes.at(8, 8, 8), 0.0f);
    EXPECT_EQ(cubes.at(24, 24, 19), 0.0f); // between two cubes
}

TEST(Fields, noiseIsTheSameForTheSameSeed)
{
    EXPECT_EQ(noiseField({8, 8, 8}, 1).values, noiseField({8, 8, 8}, 1).values);
    EXPECT_NE(noiseField({8, 8, 8}, 1).values, noiseField({8, 8, 8}, 2).values);
}

TEST(Fields, letterStandsUprightOnThreeFaces)
{
    const Field letters = letterFField({40, 40, 40});
    // Inside the upper bar to the right of the stem, where an F has ink and its mirror images have none.
    EXPECT_FLOAT_EQ(letters.at(0, 28, 31), 1.0f);
    EXPECT_FLOAT_EQ(letters.at(28, 0, 31), 2.0f / 3.0f);
    EXPECT_FLOAT_EQ(letters.at(28, 31, 0), 1.0f / 3.0f);
    EXPECT_EQ(letters.at(0, 28, 8), 0.0f); // upside down
    EXPECT_EQ(letters.at(28, 0, 8), 0.0f);
    EXPECT_EQ(letters.at(28, 8, 0), 0.0f);
    EXPECT_EQ(letters.at(0, 35, 31), 0.0f); // beyond the bar
    EXPECT_EQ(letters.at(39, 28, 31), 0.0f);
    EXPECT_EQ(letters.at(28, 39, 31), 0.0f);
    EXPECT_EQ(letters.at(28, 31, 39), 0.0f);
}

TEST(Fields, emptyBorderClearsTheOutermostLayersOnly)
{
    const Field bordered = withEmptyBorder(constantField({6, 7, 8}, 0.5), 2);
    EXPECT_EQ(std::count(bordered.values.begin(), bordered.values.end(), 0.5f), 2 * 3 * 4);
    EXPECT_EQ(bordered.at(2, 2, 2), 0.5f);
    EXPECT_EQ(bordered.at(1, 3, 3), 0.0f);
    EXPECT_EQ(bordered.at(3, 3, 6), 0.0f);
}

TEST(Fields, channelsLieSideBySide)
{
    const Field both = combined({constantField({2, 2, 2}, 0.25), axisRampField({2, 2, 2}, 0)});
    EXPECT_EQ(both.channels, 2);
    EXPECT_EQ(both.at(1, 0, 1, 0), 0.25f);
    EXPECT_EQ(both.at(1, 0, 1, 1), 1.0f);
    EXPECT_EQ(both.at(0, 1, 1, 1), 0.0f);
}

TEST(Fields, quantisedFieldsAreWhatIntegersHold)
{
    const Field field = quantised(fieldOf({5, 1, 1}, [](const glm::dvec3& p) { return p.x / 3.0 - 0.5; }));
    const std::vector<std::uint8_t> bytes = toBytes(field);
    EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 0, 85, 170, 255}));
    for (std::size_t i = 0; i < bytes.size(); ++i)
        EXPECT_EQ(field.values[i], static_cast<float>(bytes[i]) / 255.0f);
    EXPECT_EQ(toShorts(field), (std::vector<std::uint16_t>{0, 0, 21845, 43690, 65535}));
}

} // namespace
