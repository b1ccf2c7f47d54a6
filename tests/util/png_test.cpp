#include "volume_io/volume_io.h"

#include <fstream>
#include <gtest/gtest.h>

#include <filesystem>
#include <sys/stat.h>

#include "scratch_folder.h"

namespace vo {
namespace {

std::vector<std::uint8_t> gradient(int width, int height, int channels)
{
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < width * height * channels; ++i)
        bytes.push_back(static_cast<std::uint8_t>(i * 7 + i / 256));
    return bytes;
}

TEST(Png, whatWasWrittenIsReadBack)
{
    ScratchFolder folder;
    for (const int channels : {3, 4}) {
        const auto bytes = gradient(37, 11, channels);
        ASSERT_TRUE(writePng(folder / "a.png", 37, 11, channels, bytes));
        const auto picture = readPng(folder / "a.png");
        ASSERT_TRUE(picture) << picture.failure().text;
        EXPECT_EQ(picture->width, 37);
        EXPECT_EQ(picture->height, 11);
        EXPECT_EQ(picture->channels, channels);
        EXPECT_EQ(picture->bytes, bytes);
    }
}

TEST(Png, bottomFirstRowsArriveTopFirst)
{
    ScratchFolder folder;
    const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 5, 6};
    ASSERT_TRUE(writePng(folder / "a.png", 1, 2, 3, bytes, RowOrder::bottomFirst));
    const auto picture = readPng(folder / "a.png");
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->bytes, (std::vector<std::uint8_t>{4, 5, 6, 1, 2, 3}));
}

TEST(Png, greyOfSixteenBitsKeepsEveryBit)
{
    ScratchFolder folder;
    const std::vector<std::uint16_t> values{0, 1, 255, 256, 0x1234, 65535};
    ASSERT_TRUE(writeGreyPng(folder / "d.png", 3, 2, values, RowOrder::bottomFirst));
    auto volume = openVolume(folder / "d.png");
    ASSERT_TRUE(volume) << volume.failure().text;
    ASSERT_EQ(volume->info(), (VolumeInfo{{3, 2, 1}, 1, ChannelType::uint16}));
    std::vector<std::uint16_t> found(6);
    ASSERT_TRUE(volume->readBrick({{0, 0, 0}, {3, 2, 1}}, std::as_writable_bytes(std::span(found))));
    EXPECT_EQ(found, (std::vector<std::uint16_t>{256, 0x1234, 65535, 0, 1, 255}));
    EXPECT_FALSE(writeGreyPng(folder / "e.png", 3, 3, values));
    EXPECT_EQ(folder.fileCount(), 1);
}

TEST(Png, wrongShapeFailsAndWritesNothing)
{
    ScratchFolder folder;
    const std::vector<std::uint8_t> bytes(12);
    for (const auto& [width, height, channels] :
         {std::array{0, 1, 3}, std::array{-2, -2, 3}, std::array{2, 2, 2}, std::array{2, 2, 4},
          std::array{0x7fffffff, 0x7fffffff, 4}}) {
        const auto written = writePng(folder / "a.png", width, height, channels, bytes);
        ASSERT_FALSE(written);
        EXPECT_NE(written.failure().text.find("a.png: expected"), std::string::npos)
            << written.failure().text;
    }
    EXPECT_TRUE(folder.isEmpty());
}

TEST(Png, unwritablePlaceFailsAndLeavesNothing)
{
    ScratchFolder folder;
    const std::vector<std::uint8_t> bytes(12);
    EXPECT_FALSE(writePng(folder / "no/such/folder/a.png", 2, 2, 3, bytes));
    EXPECT_FALSE(writePng(folder / "", 2, 2, 3, bytes));
    EXPECT_FALSE(writePng("", 2, 2, 3, bytes));
    EXPECT_TRUE(folder.isEmpty());
    // A pipe stands for devices: a broken writer may replace this one without harm.
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FALSE(writePng(pipe, 2, 2, 3, bytes));
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(Png, fullDiskLeavesTheOldPicture)
{
    ScratchFolder folder;
    const auto old = gradient(2, 2, 3);
    ASSERT_TRUE(writePng(folder / "a.png", 2, 2, 3, old));
    {
        const SmallFilesOnly limit(1000);
        const auto written = writePng(folder / "a.png", 300, 300, 3, noise(300 * 300 * 3));
        ASSERT_FALSE(written);
        EXPECT_NE(written.failure().text.find("cannot write"), std::string::npos) << written.failure().text;
    }
    EXPECT_EQ(folder.fileCount(), 1);
    EXPECT_EQ(readPng(folder / "a.png")->bytes, old);
}

/// Gives up before the third row.
bool givesUpLater()
{
    static int asked = 0;
    return ++asked > 2;
}

TEST(Png, whoGivesUpLeavesTheOldPicture)
{
    ScratchFolder folder;
    const auto old = gradient(2, 2, 3);
    ASSERT_TRUE(writePng(folder / "a.png", 2, 2, 3, old, RowOrder::topFirst, [] { return false; }));
    const auto written =
        writePng(folder / "a.png", 300, 300, 3, noise(300 * 300 * 3), RowOrder::topFirst, givesUpLater);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.failure().text, (folder / "a.png") + ": cannot write the picture: interrupted");
    EXPECT_EQ(folder.fileCount(), 1);
    EXPECT_EQ(readPng(folder / "a.png")->bytes, old);
}

TEST(Png, junkMissingAndTruncatedFail)
{
    ScratchFolder folder;
    std::ofstream(folder / "junk.png") << "this is no picture at all";
    EXPECT_FALSE(readPng(folder / "junk.png"));
    EXPECT_FALSE(readPng(folder / "missing.png"));
    ASSERT_TRUE(writePng(folder / "cut.png", 64, 64, 3, noise(64 * 64 * 3)));
    std::filesystem::resize_file(folder / "cut.png", 5000);
    const auto cut = readPng(folder / "cut.png");
    ASSERT_FALSE(cut);
    EXPECT_NE(cut.failure().text.find("cut.png"), std::string::npos);
}

} // namespace
} // namespace vo
