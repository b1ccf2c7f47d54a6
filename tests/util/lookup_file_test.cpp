#include "volume_view/lookup_file.h"

#include <fstream>
#include <gtest/gtest.h>

#include "scratch_folder.h"
#include "volume_truth.h"

namespace vo {
namespace {

class LookupFileTest : public testing::Test
{
protected:
    Result<LookupFile> read(const std::string& text)
    {
        std::ofstream(path_, std::ios::binary) << text;
        return readLookupFile(path_);
    }
    LookupFile table(const std::string& text)
    {
        const auto result = read(text);
        EXPECT_TRUE(result) << result.failure().text;
        return result ? *result : LookupFile();
    }
    void expectFails(const std::string& text, std::initializer_list<const char*> parts)
    {
        const auto result = read(text);
        ASSERT_FALSE(result) << text;
        expectSays(result.failure().text, parts);
    }

    ScratchFolder folder_;
    std::string path_ = folder_ / "a.lut";
};

TEST_F(LookupFileTest, twoColumnsAreLuminanceAndAlpha)
{
    const LookupFile ramp = table("0 255\n255 0\n");
    EXPECT_FALSE(ramp.isColor);
    for (int i = 0; i < 256; ++i) {
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(ramp.rgba[std::size_t(4 * i + channel)], i / 255.0, 1e-6);
        EXPECT_NEAR(ramp.rgba[std::size_t(4 * i + 3)], 1 - i / 255.0, 1e-6);
    }
}

TEST_F(LookupFileTest, fourColumnsAreRedGreenBlueAlpha)
{
    const LookupFile colors = table("0.1 0.2 0.3 0.4\n0.5 0.6 0.7 1.0\n");
    EXPECT_TRUE(colors.isColor);
    const float expected[] = {0.1f, 0.2f, 0.3f, 0.4f};
    const float last[] = {0.5f, 0.6f, 0.7f, 1.0f};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        EXPECT_FLOAT_EQ(colors.rgba[channel], expected[channel]);
        EXPECT_FLOAT_EQ(colors.rgba[255 * 4 + channel], last[channel]);
    }
}

TEST_F(LookupFileTest, entriesOfA256LineTableStayAsTheyAre)
{
    std::string text;
    for (int i = 0; i < 256; ++i)
        text += std::to_string(255 - i) + " " + std::to_string(i * 37 % 256) + "\n";
    const LookupFile same = table(text);
    for (int i = 0; i < 256; ++i) {
        EXPECT_FLOAT_EQ(same.rgba[std::size_t(4 * i)], float(255 - i) / 255.0f);
        EXPECT_FLOAT_EQ(same.rgba[std::size_t(4 * i + 3)], float(i * 37 % 256) / 255.0f);
    }
}

TEST_F(LookupFileTest, fewAndManyEntriesAreInterpolated)
{
    const LookupFile three = table("0.0 0.0\n1.0 1.0\n0.0 0.0\n");
    EXPECT_NEAR(three.rgba[4 * 51], 0.4, 1e-6);
    EXPECT_NEAR(three.rgba[4 * 204], 0.4, 1e-6);
    std::string text;
    for (int i = 0; i < 4096; ++i)
        text += std::to_string(i / 4095.0) + " 1.0\n";
    const LookupFile many = table(text);
    for (int i = 0; i < 256; ++i)
        EXPECT_NEAR(many.rgba[std::size_t(4 * i)], i / 255.0, 1e-6);
}

TEST_F(LookupFileTest, commentsBlanksAndForeignLineEndsArePassedOver)
{
    const LookupFile ramp = table("# a ramp\r\n\r\n  0\t0 # first\r\n   # nothing\n255 255");
    EXPECT_EQ(ramp.rgba[4 * 255], 1.0f);
    EXPECT_EQ(ramp.rgba[3], 0.0f);
}

TEST_F(LookupFileTest, byteOrderMarkIsPassedOver)
{
    EXPECT_EQ(table("\xef\xbb\xbf"
                    "0 0\n255 255\n")
                  .rgba[4 * 255],
              1.0f);
    expectFails("0 0\n\xef\xbb\xbf"
                "255 255\n",
                {"line 2: expected a number"});
}

TEST_F(LookupFileTest, badLinesAreNamed)
{
    expectFails("0 0\n# x\n12 abc\n", {"a.lut: line 3: expected a number, found \"abc\""});
    expectFails("0 0\n1 2 3\n", {"a.lut: line 2: expected 2 numbers", "found 3"});
    expectFails("0\n", {"line 1: expected 2 numbers", "found 1"});
    expectFails("0 0\n1 2 3 4\n", {"line 2: expected 2 numbers as on the lines before, found 4"});
    expectFails("0 0\n0 256\n", {"line 2: expected a whole number from 0 to 255, found \"256\""});
    expectFails("0 0\n0 -1\n", {"line 2: expected a whole number from 0 to 255, found \"-1\""});
    expectFails("0.0 1.5\n",
                {"line 1: expected a number with a decimal point from 0.0 to 1.0, found \"1.5\""});
    expectFails("0.0 -0.5\n", {"line 1: ", "\"-0.5\""});
    expectFails("0 0\n0 0.5\n", {"line 2: expected whole numbers as before, found \"0.5\""});
    expectFails("0.0 1.0\n\n0.5 1\n",
                {"line 3: expected numbers with a decimal point as before, found \"1\""});
    expectFails("0 nan\n", {"line 1: expected a number"});
    expectFails("0 inf\n", {"line 1: expected a number"});
    expectFails("0 1e1\n", {"line 1: expected a number"});
    expectFails("0 0x10\n", {"line 1: expected a number"});
    expectFails("0 1.0.0\n", {"line 1: expected a number"});
    expectFails("0 99999999999999999999999999\n", {"line 1: expected a whole number from 0 to 255"});
    expectFails(std::string("\x7f\x45\x4c\x46\0\x01\xff\n", 8), {"line 1: expected"});
    expectFails("0 " + std::string(100000, 'y'), {"line 1: expected a number, found \"yyyy", "...\""});
}

TEST_F(LookupFileTest, tooFewAndTooManyEntriesFail)
{
    expectFails("", {"a.lut: expected a lookup table of 2 to 4096 entries, found 0"});
    expectFails("0 0\n", {"found 1"});
    std::string text;
    for (int i = 0; i < 4097; ++i)
        text += "1 1\n";
    expectFails(text, {"a.lut: line 4097: expected at most 4096 entries"});
}

TEST_F(LookupFileTest, tablesThatShipAreReadAndBeginClear)
{
    for (const auto& [name, isColor] : {std::pair{"grey", false}, std::pair{"bone", true},
                                        std::pair{"brain", true}, std::pair{"spectrum", true}}) {
        const auto result = readLookupFile(std::string(VOLUMIZER_SOURCE_DIR "/data/tables/") + name + ".lut");
        ASSERT_TRUE(result) << result.failure().text;
        EXPECT_EQ(result->isColor, isColor);
        EXPECT_EQ(result->rgba[3], 0.0f);
        EXPECT_GT(result->rgba[4 * 255 + 3], 0.0f);
    }
}

TEST_F(LookupFileTest, missingFolderAndDeviceAreTold)
{
    expectSays(readLookupFile(folder_ / "none.lut").failure().text, {"none.lut: cannot open: No such file"});
    expectSays(readLookupFile(folder_ / "").failure().text, {"found a folder"});
    expectSays(readLookupFile("/dev/zero").failure().text, {"/dev/zero: ", "found a device"});
}

} // namespace
} // namespace vo
