#include "support/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace vo::test;

/// `count` pixels of one row, all opaque and of one grey.
Picture greyReference(int count, double grey)
{
    Picture picture;
    picture.width = count;
    picture.height = 1;
    for (int i = 0; i < count; ++i)
        picture.rgba.insert(picture.rgba.end(), {grey, grey, grey, 1.0});
    picture.unmasked.assign(static_cast<std::size_t>(count), 1);
    return picture;
}

std::vector<float> greyPicture(int count, float grey)
{
    return std::vector<float>(4 * static_cast<std::size_t>(count), grey);
}

TEST(Compare, equalPicturesAreInfinitelyClose)
{
    const Comparison result = compare(greyPicture(10, 0.5f), greyReference(10, 0.5));
    EXPECT_TRUE(std::isinf(result.psnrMasked) && result.psnrMasked > 0);
    EXPECT_TRUE(std::isinf(result.psnrAll) && result.psnrAll > 0);
    EXPECT_EQ(result.largestAll, 0.0);
    EXPECT_EQ(result.fractionOff, 0.0);
}

TEST(Compare, aHundredthEverywhereIs40Decibels)
{
    const Comparison result = compare(greyPicture(10, 0.51f), greyReference(10, 0.5));
    EXPECT_NEAR(result.psnrMasked, 40.0, 1e-4);
    EXPECT_NEAR(result.psnrAll, 40.0, 1e-4);
    EXPECT_NEAR(result.largestAll, 0.01, 1e-6);
    EXPECT_EQ(result.fractionOff, 1.0);
}

TEST(Compare, oneChannelOfThreeCountsAThird)
{
    std::vector<float> picture = greyPicture(10, 0.5f);
    for (std::size_t i = 0; i < picture.size(); i += 4)
        picture[i + 1] = 0.6f;
    EXPECT_NEAR(compare(picture, greyReference(10, 0.5)).psnrAll, 20.0 + 10.0 * std::log10(3.0), 1e-4);
}

TEST(Compare, alphaOfThePictureIsNotRead)
{
    std::vector<float> picture = greyPicture(10, 0.5f);
    for (std::size_t i = 0; i < picture.size(); i += 4)
        picture[i + 3] = 7.0f;
    EXPECT_EQ(compare(picture, greyReference(10, 0.5)).largestAll, 0.0);
}

TEST(Compare, pixelsOfLittleOpacityLeaveThePsnrAlone)
{
    Picture reference = greyReference(10, 0.0);
    for (std::size_t i = 3; i < reference.rgba.size(); i += 4)
        reference.rgba[i] = 0.99 / 255.0;
    reference.rgba[3] = 1.01 / 255.0;
    std::vector<float> picture = greyPicture(10, 0.2f);
    picture[0] = picture[1] = picture[2] = 0.1f;
    const Comparison result = compare(picture, reference);
    EXPECT_EQ(result.opaquePixels, 1u);
    EXPECT_NEAR(result.psnrAll, 20.0, 1e-4);
    EXPECT_NEAR(result.largestAll, 0.2, 1e-6); // counted here all the same
    EXPECT_EQ(result.fractionOff, 1.0);
}

TEST(Compare, maskedPixelsCountInAllOnly)
{
    Picture reference = greyReference(10, 0.5);
    reference.unmasked[4] = 0;
    std::vector<float> picture = greyPicture(10, 0.51f);
    picture[4 * 4] = 1.0f;
    const Comparison result = compare(picture, reference);
    EXPECT_EQ(result.maskedPixels, 1u);
    EXPECT_NEAR(result.psnrMasked, 40.0, 1e-4);
    EXPECT_LT(result.psnrAll, 22.0);
    EXPECT_NEAR(result.largestMasked, 0.01, 1e-6);
    EXPECT_NEAR(result.largestAll, 0.5, 1e-6);
}

TEST(Compare, offMeansMoreThanOneStepOfABytePicture)
{
    std::vector<float> picture = greyPicture(10, 0.5f);
    picture[0] += 0.9f / 255.0f;
    picture[5] -= 1.1f / 255.0f;
    EXPECT_NEAR(compare(picture, greyReference(10, 0.5)).fractionOff, 0.1, 1e-12);
}

TEST(Compare, picturesThatAreNotNumbersFail)
{
    std::vector<float> picture = greyPicture(10, 0.5f);
    picture[0] = std::numeric_limits<float>::quiet_NaN();
    const Comparison result = compare(picture, greyReference(10, 0.5));
    EXPECT_FALSE(result.psnrMasked >= 0.0);
    EXPECT_TRUE(std::isinf(result.largestMasked));
    EXPECT_NEAR(result.fractionOff, 0.1, 1e-12);
}

TEST(Compare, anEmptyReferencePassesNothing)
{
    Picture reference = greyReference(10, 0.0);
    for (std::size_t i = 3; i < reference.rgba.size(); i += 4)
        reference.rgba[i] = 0.0;
    EXPECT_FALSE(compare(greyPicture(10, 0.0f), reference).psnrMasked >= 0.0);
}

TEST(CompareDrawn, countsThePixelsThatTheSecondShows)
{
    std::vector<float> first = greyPicture(10, 0.0f);
    std::vector<float> second = greyPicture(10, 0.0f);
    second[4] = 0.1f;
    const Comparison result = compareDrawn(first, second);
    EXPECT_EQ(result.opaquePixels, 1u);
    EXPECT_NEAR(result.fractionOff, 0.1, 1e-12);
    EXPECT_NEAR(result.psnrAll, 20.0 + 10.0 * std::log10(3.0), 1e-4);
}

TEST(Comparison, summaryIsOneLine)
{
    const std::string line = compare(greyPicture(10, 0.51f), greyReference(10, 0.5)).summary();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_NE(line.find("40.00 dB masked"), std::string::npos) << line;
    EXPECT_NE(line.find("100.000% off"), std::string::npos) << line;
}

TEST(FromBytes, spansZeroToOne)
{
    const std::vector<std::uint8_t> bytes{0, 51, 255, 255};
    EXPECT_EQ(fromBytes(bytes), (std::vector<float>{0.0f, 0.2f, 1.0f, 1.0f}));
}

} // namespace
