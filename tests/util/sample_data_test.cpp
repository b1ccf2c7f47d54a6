// What ships in data/, the committed fixtures, and larger data where there is some.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <zlib.h>

#include "volume_truth.h"

namespace vo {
namespace {

const std::string kSource = VOLUMIZER_SOURCE_DIR "/";

std::vector<std::byte> whole(VolumeFile& volume)
{
    return readBrick(volume, {{0, 0, 0}, volume.info().size});
}

unsigned long checksum(const std::vector<std::byte>& bytes)
{
    return crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

TEST(SampleVolumes, headHoldsTheVoxelsOfItsSourceInTheirOrder)
{
    auto volume = openVolume(kSource + "data/volumes/head.tif");
    ASSERT_TRUE(volume) << volume.failure().text;
    ASSERT_EQ(volume->info(), (VolumeInfo{{181, 217, 181}, 1, ChannelType::uint8}));
    // Of the voxels of ch2.nii.gz, whose own header says that its axes point right, front and up.
    EXPECT_EQ(checksum(whole(*volume)), 0xc3822357u);
}

TEST(SampleVolumes, skullHoldsTheVoxelsOfItsSourceTurnedHalfRound)
{
    auto volume = openVolume(kSource + "data/volumes/skull.tif");
    ASSERT_TRUE(volume) << volume.failure().text;
    ASSERT_EQ(volume->info(), (VolumeInfo{{64, 64, 64}, 1, ChannelType::float32}));
    auto bytes = whole(*volume);
    std::vector<float> values(bytes.size() / 4);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    EXPECT_NEAR(*std::ranges::max_element(values), 5.4288, 1e-4);
    for (std::size_t slice = 0; slice < 64; ++slice)
        std::reverse(values.begin() + std::ptrdiff_t(slice * 4096),
                     values.begin() + std::ptrdiff_t((slice + 1) * 4096));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    EXPECT_EQ(checksum(bytes), 0xe6f0281au);
}

TEST(SampleVolumes, stayUnderFiveMegabytes)
{
    for (const char* name : {"head.tif", "skull.tif"})
        EXPECT_LT(std::filesystem::file_size(kSource + "data/volumes/" + name), 5'000'000u);
}

TEST(Fixtures, imageJStackOfAnotherByteOrderIsRead)
{
    auto volume = openVolume(kSource + "tests/util/fixtures/blobs_skeleton.tif");
    ASSERT_TRUE(volume) << volume.failure().text;
    ASSERT_EQ(volume->info(), (VolumeInfo{{32, 32, 30}, 1, ChannelType::uint8}));
    const auto bytes = whole(*volume);
    EXPECT_EQ(std::ranges::count(bytes, std::byte{0}) + std::ranges::count(bytes, std::byte{255}),
              32 * 32 * 30);
    EXPECT_GT(std::ranges::count(bytes, std::byte{255}), 0);
}

TEST(Fixtures, planarDoublesAreRefused)
{
    expectSays(failureOfReading(kSource + "tests/util/fixtures/planar_float64_rgb.tif"),
               {"page 0", "64-bit float"});
}

TEST(LargerData, rawSlicesOfAHeadAreRead)
{
    const char* root = std::getenv("VOLUMIZER_TEST_DATA");
    const std::string folder = std::string(root ? root : "") + "/snapshot/vtkdata/headsq/";
    if (!root || !std::filesystem::exists(folder)) GTEST_SKIP() << "VOLUMIZER_TEST_DATA has no " << folder;
    std::vector<std::string> paths;
    for (int z = 1; z <= 93; ++z)
        paths.push_back(folder + "quarter." + std::to_string(z));
    auto volume = openRawSlices(paths, {{{64, 64, 93}, 1, ChannelType::int16}, 0, ByteOrder::littleEndian});
    ASSERT_TRUE(volume) << volume.failure().text;
    const auto bytes = whole(*volume);
    std::vector<std::int16_t> values(bytes.size() / 2);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    EXPECT_EQ(std::ranges::min(values), 0);
    EXPECT_EQ(std::ranges::max(values), 3926);
}

} // namespace
} // namespace vo
