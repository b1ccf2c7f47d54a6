// The subset of IFL, and the guide's loaders over it.

#include <ifl/iflFile.h>
#include <vo/Enums.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../util/scratch_folder.h"
#include "../util/volume_truth.h"
#include "volume_io/volume_io.h"

// tests/contract/ifl_loader.cpp
int myGetVolumeSizesIfl(char* fileName, int& xSize, int& ySize, int& zSize,
                        voExternalFormatType& diskDataFormat, voDataType& dataType);
int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize);

namespace {

using vo::ChannelType;
using vo::ScratchFolder;
using vo::VolumeTruth;

constexpr ChannelType kTypes[] = {ChannelType::uint8, ChannelType::int8, ChannelType::uint16,
                                  ChannelType::int16, ChannelType::float32};
constexpr iflDataType kIflTypes[] = {iflUChar, iflChar, iflUShort, iflShort, iflFloat};
constexpr voDataType kVoTypes[] = {voDataTypeScope::UNSIGNED_BYTE, voDataTypeScope::BYTE,
                                   voDataTypeScope::UNSIGNED_SHORT, voDataTypeScope::SHORT,
                                   voDataTypeScope::FLOAT};

using File = std::unique_ptr<iflFile>;

/// Writes a TIFF page stack and opens it.
File opened(const ScratchFolder& folder, const vo::VolumeInfo& info, std::span<const std::byte> voxels)
{
    const std::string path = folder / "a.tif";
    const auto written = vo::writeTiffStack(path, info, voxels);
    EXPECT_TRUE(written);
    iflStatus status = -1;
    File file(iflFile::open(path.c_str(), O_RDONLY, &status));
    EXPECT_EQ(status, iflOKAY);
    return file;
}

template <class T>
File openedValues(const ScratchFolder& folder, ChannelType type, const std::vector<T>& values)
{
    return opened(folder, {{static_cast<std::int64_t>(values.size()), 1, 1}, 1, type},
                  std::as_bytes(std::span(values)));
}

std::string textOf(iflStatus status)
{
    char text[300];
    return iflStatusToString(status, text, sizeof text);
}

/// Every brick of a grid that does not divide the volume is what the file holds, zeros outside.
void expectBricksOfTheGuidesLoader(std::string path, const VolumeTruth& truth, voDataType type,
                                   voExternalFormatType format)
{
    int x, y, z;
    voExternalFormatType diskFormat;
    voDataType dataType;
    ASSERT_EQ(myGetVolumeSizesIfl(path.data(), x, y, z, diskFormat, dataType), 0);
    EXPECT_EQ((std::array<std::int64_t, 3>{x, y, z}), truth.info().size);
    EXPECT_EQ(diskFormat, format);
    EXPECT_EQ(dataType, type);
    for (int origin = 0; origin < 16; origin += 8) {
        const vo::Region region{{origin, origin / 2, origin / 4}, {8, 7, 5}};
        const std::vector<std::byte> expected = truth.brick(region);
        std::vector<std::byte> brick(expected.size(), std::byte{77});
        ASSERT_EQ(myReadBrickIfl(path.data(), brick.data(), origin, origin / 2, origin / 4, 8, 7, 5, x, y, z),
                  0);
        EXPECT_EQ(brick, expected);
    }
}

TEST(IflTest, guidesLoadersReadExactVoxelsOfEveryTypeAndChannelCount)
{
    ScratchFolder folder;
    for (std::size_t i = 0; i < std::size(kTypes); ++i)
        for (const int channels : {1, 2, 4}) {
            SCOPED_TRACE(std::string(vo::channelTypeName(kTypes[i])) + " x " + std::to_string(channels));
            const VolumeTruth truth({{13, 9, 6}, channels, kTypes[i]});
            ASSERT_TRUE(vo::writeTiffStack(folder / "a.tif", truth.info(), truth.whole()));
            expectBricksOfTheGuidesLoader(folder / "a.tif", truth, kVoTypes[i],
                                          channels == 1   ? voExternalFormatTypeScope::LUMINANCE
                                          : channels == 2 ? voExternalFormatTypeScope::LUMINANCE_ALPHA
                                                          : voExternalFormatTypeScope::RGBA);
        }
}

TEST(IflTest, otherFormatsThanTiffAreReadToo)
{
    ScratchFolder folder;
    const VolumeTruth truth({{13, 9, 6}, 1, ChannelType::int16});
    const std::vector<std::byte> voxels = truth.whole();
    std::ofstream nrrd(folder / "a.nrrd", std::ios::binary);
    nrrd << "NRRD0004\ntype: short\ndimension: 3\nsizes: 13 9 6\nencoding: raw\nendian: little\n\n";
    nrrd.write(reinterpret_cast<const char*>(voxels.data()), static_cast<std::streamsize>(voxels.size()));
    nrrd.close();
    expectBricksOfTheGuidesLoader(folder / "a.nrrd", truth, voDataTypeScope::SHORT,
                                  voExternalFormatTypeScope::LUMINANCE);
}

TEST(IflTest, guidesLoadersAnswerOneForAFileThatIsNotThere)
{
    ScratchFolder folder;
    std::string path = folder / "absent.tif";
    int x = 7, y = 7, z = 7;
    voExternalFormatType format = voExternalFormatTypeScope::RGBA;
    voDataType type = voDataTypeScope::SHORT;
    testing::internal::CaptureStderr();
    EXPECT_EQ(myGetVolumeSizesIfl(path.data(), x, y, z, format, type), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("absent.tif"), std::string::npos);
    char voxel = 5;
    EXPECT_EQ(myReadBrickIfl(path.data(), &voxel, 0, 0, 0, 1, 1, 1, 1, 1, 1), 1);
    EXPECT_EQ(x, 7);
}

TEST(IflTest, fileTellsItsShapeAlsoWhenItIsClosed)
{
    ScratchFolder folder;
    for (std::size_t i = 0; i < std::size(kTypes); ++i) {
        const VolumeTruth truth({{5, 4, 3}, 2, kTypes[i]});
        const File file = opened(folder, truth.info(), truth.whole());
        ASSERT_TRUE(file);
        EXPECT_EQ(file->close(), iflOKAY);
        EXPECT_EQ(file->close(), iflOKAY);
        iflSize size;
        file->getDimensions(size);
        EXPECT_TRUE(size == iflSize(5, 4, 3, 2));
        EXPECT_EQ(file->getDataType(), kIflTypes[i]);
        EXPECT_EQ(file->getNumChannels(), 2);
        EXPECT_EQ(file->getColorModel(), iflLuminanceAlpha);
        char voxel;
        EXPECT_EQ(file->getTile(0, 0, 0, 1, 1, 1, &voxel), iflBADPARAM);
        EXPECT_NE(textOf(iflBADPARAM).find("closed"), std::string::npos);
    }
}

TEST(IflTest, closedFilesThatNobodyDeletesAreNoLeak)
{
    // The pattern of the loaders; fails where the sanitizers look for leaks.
    ScratchFolder folder;
    const VolumeTruth truth({{2, 2, 2}, 1, ChannelType::uint8});
    iflFile* file = opened(folder, truth.info(), truth.whole()).release();
    ASSERT_NE(file, nullptr);
    EXPECT_EQ(file->close(), iflOKAY);
    file = nullptr;
}

TEST(IflTest, tileWithoutConfigHasTheFilesType)
{
    ScratchFolder folder;
    const VolumeTruth truth({{6, 5, 4}, 4, ChannelType::int16});
    const File file = opened(folder, truth.info(), truth.whole());
    const vo::Region region{{1, 2, 1}, {4, 2, 3}};
    const std::vector<std::byte> expected = truth.brick(region);
    std::vector<std::byte> tile(expected.size());
    ASSERT_EQ(file->getTile(1, 2, 1, 4, 2, 3, tile.data()), iflOKAY);
    EXPECT_EQ(tile, expected);
}

TEST(IflTest, pixelsOutsideAreZero)
{
    ScratchFolder folder;
    const VolumeTruth truth({{3, 3, 3}, 1, ChannelType::uint16});
    const File file = opened(folder, truth.info(), truth.whole());
    const std::vector<std::byte> expected = truth.brick({{-1, -1, 1}, {5, 5, 5}});
    std::vector<std::byte> tile(expected.size(), std::byte{9});
    ASSERT_EQ(file->getTile(-1, -1, 1, 5, 5, 5, tile.data()), iflOKAY);
    EXPECT_EQ(tile, expected);
    EXPECT_EQ(tile.front(), std::byte{0});
}

TEST(IflTest, channelsComeSideBySideByRowsOrByImages)
{
    ScratchFolder folder;
    // Two channels of 2 x 2 x 2 pixels: pixel i is (i, 100 + i).
    std::vector<std::uint8_t> voxels;
    for (std::uint8_t i = 0; i < 8; ++i)
        voxels.insert(voxels.end(), {i, static_cast<std::uint8_t>(100 + i)});
    const File file = opened(folder, {{2, 2, 2}, 2, ChannelType::uint8}, std::as_bytes(std::span(voxels)));
    std::vector<std::uint8_t> tile(16);
    std::vector<std::uint16_t> wide(16);

    const iflConfig rows(iflUChar, iflSequential);
    ASSERT_EQ(file->getTile(0, 0, 0, 2, 2, 2, tile.data(), &rows), iflOKAY);
    EXPECT_EQ(tile,
              (std::vector<std::uint8_t>{0, 1, 100, 101, 2, 3, 102, 103, 4, 5, 104, 105, 6, 7, 106, 107}));
    const iflConfig images(iflUChar, iflSeparate);
    ASSERT_EQ(file->getTile(0, 0, 0, 2, 2, 2, tile.data(), &images), iflOKAY);
    EXPECT_EQ(tile,
              (std::vector<std::uint8_t>{0, 1, 2, 3, 100, 101, 102, 103, 4, 5, 6, 7, 104, 105, 106, 107}));
    const iflConfig wideRows(iflUShort, iflSequential);
    ASSERT_EQ(file->getTile(0, 0, 0, 2, 2, 2, wide.data(), &wideRows), iflOKAY);
    EXPECT_EQ(wide,
              (std::vector<std::uint16_t>{0, 1, 100, 101, 2, 3, 102, 103, 4, 5, 104, 105, 6, 7, 106, 107}));
}

template <class T>
void expectConverted(iflFile& file, iflDataType type, const std::vector<T>& expected)
{
    SCOPED_TRACE(type);
    std::vector<T> tile(expected.size(), T{55});
    const iflConfig config(type, iflInterleaved);
    ASSERT_EQ(file.getTile(0, 0, 0, static_cast<int>(expected.size()), 1, 1, tile.data(), &config), iflOKAY);
    EXPECT_EQ(tile, expected);
}

TEST(IflTest, otherTypesAreRoundedAndClampedNotScaled)
{
    ScratchFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const File file = openedValues<float>(folder, ChannelType::float32,
                                          {-5e9f, -1.5f, 0.4f, 1.5f, 254.6f, 7e4f, 5e9f, nan});
    expectConverted<std::uint8_t>(*file, iflUChar, {0, 0, 0, 2, 255, 255, 255, 0});
    expectConverted<std::int8_t>(*file, iflChar, {-128, -2, 0, 2, 127, 127, 127, 0});
    expectConverted<std::uint16_t>(*file, iflUShort, {0, 0, 0, 2, 255, 65535, 65535, 0});
    expectConverted<std::int16_t>(*file, iflShort, {-32768, -2, 0, 2, 255, 32767, 32767, 0});
    expectConverted<std::uint32_t>(*file, iflUInt, {0, 0, 0, 2, 255, 70000, 4294967295u, 0});
    expectConverted<std::int32_t>(*file, iflInt, {-2147483647 - 1, -2, 0, 2, 255, 70000, 2147483647, 0});

    const File shorts = openedValues<std::int16_t>(folder, ChannelType::int16, {-300, 0, 300});
    expectConverted<float>(*shorts, iflFloat, {-300, 0, 300});
    expectConverted<double>(*shorts, iflDouble, {-300, 0, 300});
    expectConverted<std::uint8_t>(*shorts, iflUChar, {0, 0, 255});
}

TEST(IflTest, failuresSayWhatIsWrong)
{
    ScratchFolder folder;
    iflStatus status = iflOKAY;
    EXPECT_EQ(iflFile::open((folder / "none.tif").c_str(), O_RDONLY, &status), nullptr);
    EXPECT_EQ(status, iflOPENFAILED);
    EXPECT_NE(textOf(status).find("none.tif"), std::string::npos);
    EXPECT_EQ(iflFile::open((folder / "none.tif").c_str()), nullptr);
    EXPECT_EQ(iflFile::open(nullptr, O_RDONLY, &status), nullptr);
    EXPECT_EQ(status, iflBADPARAM);
    std::ofstream(folder / "text.tif") << "no volume";
    EXPECT_EQ(iflFile::open((folder / "text.tif").c_str(), O_RDWR, &status), nullptr);
    EXPECT_EQ(status, iflUNSUPPORTED);
    EXPECT_EQ(iflFile::open((folder / "text.tif").c_str(), O_RDONLY, &status), nullptr);
    EXPECT_EQ(status, iflOPENFAILED);

    const VolumeTruth truth({{3, 3, 3}, 1, ChannelType::uint8});
    const File file = opened(folder, truth.info(), truth.whole());
    char voxels[27];
    EXPECT_EQ(file->getTile(0, 0, 0, 3, 3, 3, nullptr), iflBADPARAM);
    EXPECT_EQ(file->getTile(0, 0, 0, 3, 0, 3, voxels), iflBADPARAM);
    EXPECT_EQ(file->getTile(0, 0, 0, 3, -1, 3, voxels), iflBADPARAM);
    EXPECT_EQ(file->getTile(0, 0, 0, 2147483647, 2147483647, 2147483647, voxels), iflBADPARAM);
    const iflConfig bits(iflBit, iflInterleaved), noOrder(iflUChar, static_cast<iflOrder>(0));
    EXPECT_EQ(file->getTile(0, 0, 0, 3, 3, 3, voxels, &bits), iflUNSUPPORTED);
    EXPECT_EQ(file->getTile(0, 0, 0, 3, 3, 3, voxels, &noOrder), iflUNSUPPORTED);
}

TEST(IflTest, fileThatShrinksWhileItIsOpenIsAReadFailure)
{
    ScratchFolder folder;
    const VolumeTruth truth({{64, 64, 16}, 1, ChannelType::uint16});
    const File file = opened(folder, truth.info(), truth.whole());
    std::filesystem::resize_file(folder / "a.tif", 3000);
    std::vector<std::byte> tile(truth.whole().size());
    EXPECT_EQ(file->getTile(0, 0, 0, 64, 64, 16, tile.data()), iflREADFAILED);
    EXPECT_NE(textOf(iflREADFAILED).find("a.tif"), std::string::npos);
}

TEST(IflTest, statusTextFitsItsBuffer)
{
    char text[8] = "1234567";
    EXPECT_EQ(iflStatusToString(iflOKAY, text, 5), text);
    EXPECT_STREQ(text, "no e");
    EXPECT_STREQ(iflStatusToString(iflOKAY, text, 0), "no e");
    EXPECT_EQ(iflStatusToString(iflOKAY, nullptr, 9), nullptr);
    EXPECT_EQ(textOf(12345), "unknown status");
}

} // namespace
