#include "scratch_folder.h"
#include "volume_truth.h"

namespace vo {
namespace {

constexpr ChannelType kTypes[] = {ChannelType::uint8, ChannelType::int8, ChannelType::uint16,
                                  ChannelType::int16, ChannelType::float32};

TEST(TiffStack, everyTypeChannelCountAndCompressionRoundTrips)
{
    ScratchFolder folder;
    for (const ChannelType type : kTypes)
        for (const int channels : {1, 2, 4})
            for (const Compression compression : {Compression::none, Compression::deflate})
                for (const TiffKind kind : {TiffKind::automatic, TiffKind::big}) {
                    SCOPED_TRACE(std::string(channelTypeName(type)) + " x " + std::to_string(channels));
                    const VolumeTruth truth({{19, 13, 7}, channels, type});
                    ASSERT_TRUE(
                        writeTiffStack(folder / "a.tif", truth.info(), truth.whole(), {compression, kind}));
                    auto volume = openVolume(folder / "a.tif");
                    ASSERT_TRUE(volume) << volume.failure().text;
                    expectReadsAs(*volume, truth);
                }
}

TEST(TiffStack, oneVoxelAndThinVolumesRoundTrip)
{
    ScratchFolder folder;
    for (const auto& size :
         {std::array<std::int64_t, 3>{1, 1, 1}, {1, 1, 40}, {1, 50, 1}, {60, 1, 1}, {70000, 2, 2}}) {
        const VolumeTruth truth({size, 1, ChannelType::uint16});
        ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole()));
        auto volume = openVolume(folder / "a.tif");
        ASSERT_TRUE(volume) << volume.failure().text;
        expectReadsAs(*volume, truth);
    }
}

TEST(TiffStack, brickTouchesOnlyItsSlicesRowsAndBytes)
{
    ScratchFolder folder;
    const VolumeTruth truth({{64, 48, 32}, 1, ChannelType::uint16});
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole()));
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    EXPECT_EQ(volume->counters().rows, 0);
    readBrick(*volume, {{10, 20, 5}, {16, 8, 4}});
    EXPECT_EQ(volume->counters().slices, 4);
    EXPECT_EQ(volume->counters().rows, 4 * 8);
    EXPECT_EQ(volume->counters().bytes, 4 * 8 * 16 * 2);
}

TEST(TiffStack, compressedBrickDecodesOnlyTheStripsItMeets)
{
    ScratchFolder folder;
    // 4096 bytes a row: 4 rows a strip.
    const VolumeTruth truth({{4096, 64, 3}, 1, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole(), {Compression::deflate}));
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    readBrick(*volume, {{10, 31, 1}, {16, 2, 1}});
    EXPECT_EQ(volume->counters().slices, 1);
    EXPECT_EQ(volume->counters().rows, 8);
}

TEST(TiffStack, smallBricksDecodeSharedStripsOnce)
{
    ScratchFolder folder;
    const VolumeTruth truth({{100, 90, 20}, 1, ChannelType::uint16}); // 81 rows a strip
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole(), {Compression::deflate}));
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    for (int turn = 0; turn < 2; ++turn)
        for (std::int64_t z = 0; z < 20; z += 5)
            for (std::int64_t y = 0; y < 90; y += 30)
                for (std::int64_t x = 0; x < 100; x += 25) {
                    const Region region{{x, y, z}, {25, 30, 5}};
                    ASSERT_TRUE(readBrick(*volume, region) == truth.brick(region));
                }
    EXPECT_EQ(volume->counters().rows, 90 * 20);
}

TEST(TiffStack, decodedStripsAreForgottenInTheEnd)
{
    ScratchFolder folder;
    const VolumeInfo info{{2048, 1024, 80}, 1, ChannelType::uint8}; // 160 MiB
    {
        auto writer = TiffStackWriter::create(folder / "a.tif", info, {Compression::deflate});
        ASSERT_TRUE(writer);
        std::vector<std::byte> slice(2048 * 1024);
        for (int z = 0; z < 80; ++z) {
            slice[0] = std::byte(z);
            ASSERT_TRUE(writer->appendRows(slice));
        }
        ASSERT_TRUE(writer->finish());
    }
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    const auto decodedFor = [&](std::int64_t z) {
        const std::int64_t before = volume->counters().rows;
        const auto bytes = readBrick(*volume, {{0, 0, z}, {2048, 1024, 1}});
        EXPECT_EQ(bytes[0], std::byte(z));
        return volume->counters().rows - before;
    };
    for (std::int64_t z = 0; z < 80; ++z)
        EXPECT_EQ(decodedFor(z), 1024);
    EXPECT_EQ(decodedFor(79), 0);
    EXPECT_EQ(decodedFor(0), 1024);
}

TEST(TiffStack, manyBricksOfOneFileMakeTheVolume)
{
    ScratchFolder folder;
    const VolumeTruth truth({{30, 20, 10}, 4, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole(), {Compression::deflate}));
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    for (std::int64_t z = 0; z < 10; z += 4)
        for (std::int64_t y = 0; y < 20; y += 8)
            for (std::int64_t x = 0; x < 30; x += 16) {
                const Region region{{x, y, z}, {16, 8, 4}};
                EXPECT_TRUE(readBrick(*volume, region) == truth.brick(region));
            }
}

TEST(TiffStack, thousandsOfSlicesRoundTrip)
{
    ScratchFolder folder;
    const VolumeTruth truth({{2, 2, 5000}, 1, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole()));
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume) << volume.failure().text;
    expectReadsAs(*volume, truth);
}

TEST(VolumeBytes, areCountedWithoutOverflow)
{
    EXPECT_EQ(*volumeBytes({2147483647, 2147483647, 1}, 2), 2 * 2147483647ll * 2147483647ll);
    EXPECT_FALSE(volumeBytes({2147483647, 2147483647, 1}, 4));
    EXPECT_FALSE(volumeBytes({2147483647, 2147483647, 2147483647}, 1));
    EXPECT_FALSE(volumeBytes({2147483648, 1, 1}, 1));
    EXPECT_FALSE(volumeBytes({1, 0, 1}, 1));
    EXPECT_FALSE(volumeBytes({1, 1, -1}, 1));
}

TEST(TiffStack, brickMemoryOfTheWrongSizeFails)
{
    ScratchFolder folder;
    const VolumeTruth truth({{4, 4, 4}, 1, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole()));
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    std::vector<std::byte> bytes(63);
    EXPECT_FALSE(volume->readBrick({{0, 0, 0}, {4, 4, 4}}, bytes));
    EXPECT_FALSE(volume->readBrick({{0, 0, 0}, {0, 4, 4}}, bytes));
    EXPECT_FALSE(volume->readBrick({{0, 0, 0}, {-1, 4, 4}}, bytes));
    EXPECT_FALSE(volume->readBrick({{0, 0, 0}, {2147483647, 2147483647, 2147483647}}, bytes));
}

TEST(TiffStackWriter, impossibleVolumesFailAndLeaveNothing)
{
    ScratchFolder folder;
    const std::vector<std::byte> none;
    for (const auto& size : {std::array<std::int64_t, 3>{0, 1, 1},
                             {1, -1, 1},
                             {1, 1, 2147483648},
                             {1, 1, 1 << 21},
                             {2147483647, 2147483647, 2147483647},
                             {2147483647, 2147483647, 1}}) {
        const auto writer = TiffStackWriter::create(folder / "a.tif", {size, 1, ChannelType::uint8});
        ASSERT_FALSE(writer);
        expectSays(writer.failure().text, {"a.tif: cannot write: expected", "found"});
    }
    EXPECT_FALSE(TiffStackWriter::create(folder / "a.tif", {{1, 1, 1}, 3, ChannelType::uint8}));
    EXPECT_FALSE(writeTiffStack(folder / "a.tif", {{1, 1, 1}, 1, ChannelType::uint8}, none));
    EXPECT_FALSE(writeTiffStack(folder / "no/a.tif", {{1, 1, 1}, 1, ChannelType::uint8}, {none.data(), 0}));
    EXPECT_TRUE(folder.isEmpty());
}

TEST(TiffStackWriter, missingAndSurplusRowsFailAndLeaveNothing)
{
    ScratchFolder folder;
    const std::vector<std::byte> bytes(100);
    {
        auto writer = TiffStackWriter::create(folder / "a.tif", {{5, 4, 3}, 1, ChannelType::uint8});
        ASSERT_TRUE(writer);
        EXPECT_FALSE(writer->appendRows(std::span(bytes).first(7)));
        EXPECT_TRUE(writer->appendRows(std::span(bytes).first(55)));
        const auto early = writer->finish();
        ASSERT_FALSE(early);
        expectSays(early.failure().text, {"expected 3 slices of 4 rows", "found 2 slices and 3 rows"});
        EXPECT_TRUE(writer->appendRows(std::span(bytes).first(5)));
        EXPECT_FALSE(writer->appendRows(std::span(bytes).first(5)));
        EXPECT_EQ(folder.fileCount(), 1);
    }
    EXPECT_TRUE(folder.isEmpty());
}

TEST(TiffStackWriter, fullDiskFailsAndLeavesTheOldFile)
{
    ScratchFolder folder;
    const VolumeTruth small({{3, 3, 3}, 1, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", small.info(), small.whole()));
    const VolumeInfo large{{50, 50, 50}, 1, ChannelType::uint8};
    const auto voxels = noise(50 * 50 * 50);
    for (const Compression compression : {Compression::none, Compression::deflate})
        for (const rlim_t limit : {rlim_t{100}, rlim_t{5000}, rlim_t{60000}}) {
            const SmallFilesOnly full(limit);
            const auto written =
                writeTiffStack(folder / "a.tif", large, std::as_bytes(std::span(voxels)), {compression});
            ASSERT_FALSE(written);
            expectSays(written.failure().text, {"a.tif: cannot write"});
        }
    EXPECT_EQ(folder.fileCount(), 1);
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    expectReadsAs(*volume, small);
}

TEST(TiffStackWriter, linkIsFollowedToTheFileItNames)
{
    ScratchFolder folder;
    const VolumeTruth truth({{3, 3, 3}, 1, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder / "a.tif", truth.info(), truth.whole()));
    std::filesystem::create_symlink("a.tif", folder / "link.tif");
    const VolumeTruth other({{5, 3, 3}, 1, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder / "link.tif", other.info(), other.whole()));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.tif"));
    EXPECT_EQ(openVolume(folder / "a.tif")->info(), other.info());
}

} // namespace
} // namespace vo
