#include <algorithm>
#include <fstream>

#include "scratch_folder.h"
#include "volume_truth.h"

namespace vo {
namespace {

constexpr ChannelType kTypes[] = {ChannelType::uint8, ChannelType::int8, ChannelType::uint16,
                                  ChannelType::int16, ChannelType::float32};

/// The bytes of a volume as a machine of the given order would have written them.
std::vector<std::byte> inOrder(std::vector<std::byte> bytes, ChannelType type, ByteOrder order)
{
    const auto step = bytesPerChannel(type);
    if (order != nativeByteOrder())
        for (auto channel = bytes.begin(); channel != bytes.end(); channel += step)
            std::reverse(channel, channel + step);
    return bytes;
}

void writeFile(const std::string& path, std::int64_t headerLength, std::span<const std::byte> bytes)
{
    std::ofstream file(path, std::ios::binary);
    file << std::string(static_cast<std::size_t>(headerLength), 'h');
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

class RawTest : public testing::Test
{
protected:
    std::vector<std::string> writeSlices(const VolumeTruth& truth, std::int64_t headerLength, ByteOrder order)
    {
        const auto bytes = inOrder(truth.whole(), truth.info().type, order);
        const auto slices = static_cast<std::size_t>(truth.info().size[2]);
        const std::size_t length = bytes.size() / slices;
        std::vector<std::string> paths;
        for (std::size_t z = 0; z < slices; ++z) {
            paths.push_back(folder_ / ("slice." + std::to_string(z)));
            writeFile(paths.back(), headerLength, std::span(bytes).subspan(z * length, length));
        }
        return paths;
    }

    ScratchFolder folder_;
    std::string path_ = folder_ / "a.raw";
};

TEST_F(RawTest, everyTypeAndByteOrderIsRead)
{
    for (const ChannelType type : kTypes)
        for (const int channels : {1, 2, 4})
            for (const ByteOrder order : {ByteOrder::littleEndian, ByteOrder::bigEndian})
                for (const std::int64_t header : {0, 77}) {
                    const VolumeTruth truth({{11, 7, 5}, channels, type});
                    writeFile(path_, header, inOrder(truth.whole(), type, order));
                    auto volume = openRawVolume(path_, {truth.info(), header, order});
                    ASSERT_TRUE(volume) << volume.failure().text;
                    expectReadsAs(*volume, truth);

                    auto slices =
                        openRawSlices(writeSlices(truth, header, order), {truth.info(), header, order});
                    ASSERT_TRUE(slices) << slices.failure().text;
                    expectReadsAs(*slices, truth);
                }
}

TEST_F(RawTest, bigEndianShortIsReadByValue)
{
    std::ofstream(path_, std::ios::binary) << std::string("\x12\x34\xff\xfe", 4);
    auto volume = openRawVolume(path_, {{{2, 1, 1}, 1, ChannelType::int16}, 0, ByteOrder::bigEndian});
    ASSERT_TRUE(volume);
    std::int16_t values[2];
    ASSERT_TRUE(volume->readBrick({{0, 0, 0}, {2, 1, 1}}, std::as_writable_bytes(std::span(values))));
    EXPECT_EQ(values[0], 0x1234);
    EXPECT_EQ(values[1], -2);
}

TEST_F(RawTest, brickTouchesOnlyItsSlicesRowsAndBytes)
{
    const VolumeTruth truth({{16, 12, 8}, 1, ChannelType::uint16});
    auto volume = openRawSlices(writeSlices(truth, 5, nativeByteOrder()), {truth.info(), 5});
    ASSERT_TRUE(volume);
    readBrick(*volume, {{3, 4, 5}, {6, 7, 2}});
    EXPECT_EQ(volume->counters().slices, 2);
    EXPECT_EQ(volume->counters().rows, 14);
    EXPECT_EQ(volume->counters().bytes, 14 * 6 * 2);
}

TEST_F(RawTest, longerFileIsRead)
{
    const VolumeTruth truth({{4, 3, 2}, 1, ChannelType::uint8});
    auto bytes = truth.whole();
    bytes.resize(bytes.size() + 100);
    writeFile(path_, 0, bytes);
    auto volume = openRawVolume(path_, {truth.info()});
    ASSERT_TRUE(volume);
    expectReadsAs(*volume, truth);
    EXPECT_EQ(volume->description().notes,
              std::vector<std::string>{"100 bytes after the voxels are left over"});
}

TEST_F(RawTest, bytesLeftOverAreCountedOverAllSlices)
{
    const VolumeTruth truth({{4, 3, 3}, 1, ChannelType::uint16});
    const auto paths = writeSlices(truth, 9, nativeByteOrder());
    auto exact = openRawSlices(paths, {truth.info(), 9});
    ASSERT_TRUE(exact);
    EXPECT_TRUE(exact->description().notes.empty());
    std::filesystem::resize_file(paths[0], 9 + 24 + 5);
    std::filesystem::resize_file(paths[2], 9 + 24 + 2);
    auto longer = openRawSlices(paths, {truth.info(), 9});
    ASSERT_TRUE(longer);
    expectReadsAs(*longer, truth);
    EXPECT_EQ(longer->description().notes,
              std::vector<std::string>{"7 bytes after the voxels in 2 of 3 files are left over"});
}

TEST_F(RawTest, shortFileSaysWhatIsMissing)
{
    writeFile(path_, 10, std::vector<std::byte>(23));
    const auto volume = openRawVolume(path_, {{{4, 3, 2}, 1, ChannelType::uint8}, 10});
    ASSERT_FALSE(volume);
    expectSays(volume.failure().text,
               {"a.raw: expected a header of 10 bytes and 24 bytes of voxels, found 33 bytes"});

    const VolumeTruth truth({{4, 3, 3}, 1, ChannelType::uint8});
    const auto paths = writeSlices(truth, 0, nativeByteOrder());
    std::filesystem::resize_file(paths[1], 11);
    const auto slices = openRawSlices(paths, {truth.info()});
    ASSERT_FALSE(slices);
    expectSays(slices.failure().text, {"slice.1: expected", "12 bytes of voxels, found 11 bytes"});
}

TEST_F(RawTest, fileThatShrinksAfterOpeningFailsInReading)
{
    const VolumeTruth truth({{4, 3, 2}, 1, ChannelType::uint8});
    writeFile(path_, 0, truth.whole());
    auto volume = openRawVolume(path_, {truth.info()});
    ASSERT_TRUE(volume);
    std::filesystem::resize_file(path_, 13);
    std::vector<std::byte> out(24);
    const auto read = volume->readBrick({{0, 0, 0}, {4, 3, 2}}, out);
    ASSERT_FALSE(read);
    expectSays(read.failure().text, {"a.raw: cut off"});
}

TEST_F(RawTest, wrongCountsAndSizesFail)
{
    const VolumeTruth truth({{4, 3, 3}, 1, ChannelType::uint8});
    auto paths = writeSlices(truth, 0, nativeByteOrder());
    paths.pop_back();
    const auto two = openRawSlices(paths, {truth.info()});
    ASSERT_FALSE(two);
    expectSays(two.failure().text, {"expected 3 files, one a slice, found 2"});
    EXPECT_FALSE(openRawSlices({}, {truth.info()}));

    for (const auto& size : {std::array<std::int64_t, 3>{0, 1, 1},
                             {1, -1, 1},
                             {1, 1, 2147483648},
                             {2147483647, 2147483647, 2147483647}}) {
        const auto volume = openRawVolume(paths[0], {{size, 1, ChannelType::uint8}});
        ASSERT_FALSE(volume);
        expectSays(volume.failure().text, {"slice.0: expected", "found"});
    }
    EXPECT_FALSE(openRawVolume(paths[0], {{{1, 1, 1}, 5, ChannelType::uint8}}));
    EXPECT_FALSE(openRawVolume(paths[0], {{{1, 1, 1}, 0, ChannelType::uint8}}));
    EXPECT_FALSE(openRawVolume(paths[0], {{{1, 1, 1}, 1, ChannelType::uint8}, -1}));
    EXPECT_FALSE(openRawVolume(paths[0], {{{1, 1, 1}, 1, ChannelType::uint8}, INT64_MAX}));
    EXPECT_FALSE(openRawVolume(folder_ / "none", {{{1, 1, 1}, 1, ChannelType::uint8}}));
}

} // namespace
} // namespace vo
