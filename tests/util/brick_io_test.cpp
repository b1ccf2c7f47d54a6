#include "brick_io.h"

#include <fstream>

#include "scratch_folder.h"
#include "volume_truth.h"

namespace vo {
namespace {

class BrickIoTest : public testing::Test
{
protected:
    void write(const VolumeTruth& truth)
    {
        ASSERT_TRUE(writeTiffStack(path_, truth.info(), truth.whole(), {Compression::deflate}));
    }
    char* name() { return path_.data(); }

    /// Calls a loader that must fail with one line that holds `parts`.
    template <class Call>
    void expectFails(Call call, std::initializer_list<const char*> parts)
    {
        testing::internal::CaptureStderr();
        EXPECT_EQ(call(), 1);
        std::string text = testing::internal::GetCapturedStderr();
        ASSERT_TRUE(text.ends_with('\n'));
        text.pop_back();
        EXPECT_TRUE(text.starts_with("brick_io_test: ")) << text;
        expectSays(text, parts);
    }

    ScratchFolder folder_;
    std::string path_ = folder_ / "a.tif";
    int x_ = -1, y_ = -1, z_ = -1;
    voExternalFormatType format_ = voExternalFormatTypeScope::DEFAULT;
    voDataType type_ = voDataTypeScope::DEFAULT;
};

TEST_F(BrickIoTest, sizesFormatAndTypeComeFromTheFile)
{
    const std::tuple<int, ChannelType, voExternalFormatType, voDataType> kinds[] = {
        {1, ChannelType::uint8, voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE},
        {2, ChannelType::int8, voExternalFormatTypeScope::LUMINANCE_ALPHA, voDataTypeScope::BYTE},
        {4, ChannelType::uint16, voExternalFormatTypeScope::RGBA, voDataTypeScope::UNSIGNED_SHORT},
        {1, ChannelType::int16, voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::SHORT},
        {4, ChannelType::float32, voExternalFormatTypeScope::RGBA, voDataTypeScope::FLOAT},
    };
    int width = 5;
    for (const auto& [channels, channelType, format, type] : kinds) {
        write(VolumeTruth({{++width, 4, 3}, channels, channelType}));
        ASSERT_EQ(myGetVolumeSizesIfl(name(), x_, y_, z_, format_, type_), 0);
        EXPECT_EQ(x_, width);
        EXPECT_EQ(y_, 4);
        EXPECT_EQ(z_, 3);
        EXPECT_EQ(format_, format);
        EXPECT_EQ(type_, type);
    }
}

TEST_F(BrickIoTest, brickIsReadAndZeroFilled)
{
    const VolumeTruth truth({{9, 8, 7}, 1, ChannelType::int16});
    write(truth);
    std::vector<std::byte> brick(4 * 4 * 4 * 2, std::byte{1});
    ASSERT_EQ(myReadBrickIfl(name(), brick.data(), 7, -1, 5, 4, 4, 4, 9, 8, 7), 0);
    EXPECT_TRUE(brick == truth.brick({{7, -1, 5}, {4, 4, 4}}));
    std::vector<std::byte> same(brick.size());
    ASSERT_EQ(myReadBrickIfl(name(), same.data(), 7, -1, 5, 4, 4, 4), 0);
    EXPECT_TRUE(same == brick);
}

TEST_F(BrickIoTest, alphaThatTheFileHasNotIsTold)
{
    for (const int channels : {3, 4}) {
        std::ofstream(folder_ / "c.nrrd", std::ios::binary)
            << "NRRD0004\ntype: uchar\ndimension: 4\nsizes: " << channels
            << " 2 1 1\nkinds: vector space space space\nencoding: raw\n\n"
            << std::string(std::size_t(2 * channels), 'v');
        std::string path = folder_ / "c.nrrd";
        bool added = channels == 4;
        ASSERT_EQ(myGetVolumeAlphaAdded(path.data(), added), 0);
        EXPECT_EQ(added, channels == 3);
    }
    bool untouched = true;
    char none[] = "none.nrrd";
    testing::internal::CaptureStderr();
    EXPECT_EQ(myGetVolumeAlphaAdded(none, untouched), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(untouched);
}

TEST_F(BrickIoTest, otherFormatsAndTheirSpacingAreRead)
{
    const VolumeTruth truth({{4, 3, 2}, 1, ChannelType::uint8});
    const auto bytes = truth.whole();
    path_ = folder_ / "a.nrrd";
    std::ofstream(path_, std::ios::binary)
        << "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 4 3 2 2\nspacings: 0.5 1.5 4 nan\n"
        << "encoding: raw\n\n"
        << std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())
        << std::string(24, 'x');
    double x = 0, y = 0, z = 0;
    testing::internal::CaptureStderr();
    ASSERT_EQ(myGetVolumeSpacing(name(), x, y, z), 0);
    EXPECT_EQ(x, 0.5);
    EXPECT_EQ(y, 1.5);
    EXPECT_EQ(z, 4);
    std::vector<std::byte> brick(24);
    ASSERT_EQ(myReadBrickIfl(name(), brick.data(), 0, 0, 0, 4, 3, 2), 0);
    EXPECT_TRUE(brick == bytes);
    // What the file says about itself is printed once.
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "brick_io_test: " + path_ + ": the first of 2 volumes is read\n");

    path_ = folder_ / "a.tif";
    write(truth);
    ASSERT_EQ(myGetVolumeSpacing(name(), x, y, z), 0);
    EXPECT_EQ(x, 1);
    path_ = folder_ / "none";
    expectFails([&] { return myGetVolumeSpacing(name(), x, y, z); }, {"none: cannot open"});
    expectFails([&] { return myGetVolumeSpacing(nullptr, x, y, z); }, {"found NULL"});
    EXPECT_EQ(y, 1);
}

TEST_F(BrickIoTest, fileReplacedBetweenBricksIsReadAnew)
{
    write(VolumeTruth({{4, 4, 4}, 1, ChannelType::uint8}));
    std::vector<std::byte> brick(64);
    ASSERT_EQ(myReadBrickIfl(name(), brick.data(), 0, 0, 0, 4, 4, 4), 0);
    const VolumeTruth other({{6, 4, 4}, 1, ChannelType::uint8});
    write(other);
    ASSERT_EQ(myReadBrickIfl(name(), brick.data(), 1, 0, 0, 4, 4, 4, 6, 4, 4), 0);
    EXPECT_TRUE(brick == other.brick({{1, 0, 0}, {4, 4, 4}}));
}

TEST_F(BrickIoTest, manyFilesTakeTurns)
{
    for (int turn = 0; turn < 2; ++turn)
        for (int file = 0; file < 7; ++file) {
            const VolumeTruth truth({{file + 1, 2, 2}, 1, ChannelType::uint8});
            path_ = folder_ / std::to_string(file);
            if (turn == 0) write(truth);
            std::vector<std::byte> brick(static_cast<std::size_t>(file + 1) * 4);
            ASSERT_EQ(myReadBrickIfl(name(), brick.data(), 0, 0, 0, file + 1, 2, 2, file + 1, 2, 2), 0);
            EXPECT_TRUE(brick == truth.whole());
        }
}

TEST_F(BrickIoTest, fileStaysOpenFromBrickToBrick)
{
    const VolumeTruth truth({{4, 4, 4}, 1, ChannelType::uint8});
    write(truth);
    std::vector<std::byte> brick(16);
    ASSERT_EQ(myReadBrickIfl(name(), brick.data(), 0, 0, 0, 4, 4, 1), 0);
    // The first bytes are needed on opening alone: were the file opened again, it would fail.
    const auto changed = std::filesystem::last_write_time(path_);
    std::fstream(path_, std::ios::in | std::ios::out | std::ios::binary) << "junk";
    std::filesystem::last_write_time(path_, changed);
    ASSERT_FALSE(openVolume(path_));
    for (int z = 0; z < 4; ++z) {
        ASSERT_EQ(myReadBrickIfl(name(), brick.data(), 0, 0, z, 4, 4, 1), 0);
        EXPECT_TRUE(brick == truth.brick({{0, 0, z}, {4, 4, 1}}));
    }
}

TEST_F(BrickIoTest, failuresPrintOneLineAndReturnOne)
{
    std::vector<std::byte> brick(64);
    expectFails([&] { return myGetVolumeSizesIfl(name(), x_, y_, z_, format_, type_); },
                {"a.tif: cannot open"});
    EXPECT_EQ(x_, -1);
    expectFails([&] { return myReadBrickIfl(name(), brick.data(), 0, 0, 0, 4, 4, 4); },
                {"a.tif: cannot open"});
    expectFails([&] { return myGetVolumeSizesIfl(nullptr, x_, y_, z_, format_, type_); }, {"found NULL"});
    std::string none;
    expectFails([&] { return myGetVolumeSizesIfl(none.data(), x_, y_, z_, format_, type_); }, {"found ''"});

    write(VolumeTruth({{4, 4, 4}, 1, ChannelType::uint8}));
    expectFails([&] { return myReadBrickIfl(name(), nullptr, 0, 0, 0, 4, 4, 4); }, {"a.tif: ", "found NULL"});
    expectFails([&] { return myReadBrickIfl(name(), brick.data(), 0, 0, 0, 4, 0, 4); },
                {"a.tif: ", "4 x 0 x 4"});
    expectFails([&] { return myReadBrickIfl(name(), brick.data(), 0, 0, 0, 4, 4, 4, 4, 4, 5); },
                {"a.tif: expected a volume of 4 x 4 x 5 voxels, found 4 x 4 x 4"});
}

class BrickRawTest : public BrickIoTest
{
protected:
    /// Writes slices with a header of 9 bytes and fills names_.
    void writeSlices(const VolumeTruth& truth)
    {
        const auto bytes = truth.whole();
        const auto length = bytes.size() / static_cast<std::size_t>(truth.info().size[2]);
        for (std::int64_t z = 0; z < truth.info().size[2]; ++z) {
            paths_.push_back(folder_ / ("slice" + std::to_string(z)));
            FILE* file = std::fopen(paths_.back().c_str(), "wb");
            std::fputs("headerxyz", file);
            std::fwrite(bytes.data() + static_cast<std::size_t>(z) * length, 1, length, file);
            std::fclose(file);
        }
        for (std::string& path : paths_)
            names_.push_back(path.data());
    }

    std::vector<std::string> paths_;
    std::vector<char*> names_;
};

TEST_F(BrickRawTest, brickOfEveryVoxelSizeIsRead)
{
    for (const auto& [channels, type] :
         {std::pair{1, ChannelType::uint8}, std::pair{2, ChannelType::uint8},
          std::pair{4, ChannelType::uint8}, std::pair{1, ChannelType::float32},
          std::pair{4, ChannelType::int16}, std::pair{4, ChannelType::float32}}) {
        paths_.clear();
        names_.clear();
        const VolumeTruth truth({{5, 4, 3}, channels, type});
        writeSlices(truth);
        const int bytesPerVoxel = truth.info().bytesPerVoxel();
        std::vector<std::byte> brick(static_cast<std::size_t>(4 * 4 * 4 * bytesPerVoxel), std::byte{1});
        ASSERT_EQ(myReadBrickRaw(names_.data(), brick.data(), 2, 1, 1, 4, 4, 4, 5, 4, 3, 9, bytesPerVoxel),
                  0);
        EXPECT_TRUE(brick == truth.brick({{2, 1, 1}, {4, 4, 4}}));
    }
}

TEST_F(BrickRawTest, byteOrderIsSwitched)
{
    std::string path = folder_ / "big";
    FILE* file = std::fopen(path.c_str(), "wb");
    std::fputs("\x12\x34\x56\x78", file);
    std::fclose(file);
    char* names[] = {path.data()};
    std::uint16_t values[2] = {};
    ASSERT_EQ(myReadBrickRaw(names, values, 0, 0, 0, 2, 1, 1, 2, 1, 1, 0, 2, 2, 1), 0);
    EXPECT_EQ(values[0], 0x1234);
    EXPECT_EQ(values[1], 0x5678);
    ASSERT_EQ(myReadBrickRaw(names, values, 0, 0, 0, 2, 1, 1, 2, 1, 1, 0, 2, 2, 0), 0);
    EXPECT_EQ(values[0], 0x3412);
    ASSERT_EQ(myReadBrickRaw(names, values, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 4, 2, 1), 0);
    EXPECT_EQ(values[1], 0x5678);
    std::uint32_t value = 0;
    ASSERT_EQ(myReadBrickRaw(names, &value, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 4, 4, 1), 0);
    EXPECT_EQ(value, 0x12345678u);
}

TEST_F(BrickRawTest, failuresPrintOneLineAndReturnOne)
{
    writeSlices(VolumeTruth({{5, 4, 3}, 1, ChannelType::uint8}));
    std::vector<std::byte> brick(60);
    const auto read = [&](int z, int header, int bytesPerVoxel) {
        return myReadBrickRaw(names_.data(), brick.data(), 0, 0, 0, 5, 4, 3, 5, 4, z, header, bytesPerVoxel);
    };
    expectFails([&] { return read(3, 10, 1); }, {"slice0: expected a header of 10 bytes and 20", "found 29"});
    expectFails([&] { return read(3, -1, 1); }, {"slice0: expected a header"});
    expectFails([&] { return read(0, 9, 1); }, {"expected sizes from 1"});
    expectFails([&] { return read(3, 9, 3); }, {"voxels of 3 bytes"});
    expectFails([&] { return read(3, 9, 0); }, {"voxels of 0 bytes"});
    std::filesystem::remove(paths_[1]);
    expectFails([&] { return read(3, 9, 1); }, {"slice1: cannot open"});
    names_[2] = nullptr;
    expectFails([&] { return read(3, 9, 1); }, {"raw slice 2, found NULL"});
}

} // namespace
} // namespace vo
