#include "foreign_tiff.h"

#include <fstream>

#include "scratch_folder.h"

namespace vo {
namespace {

/// Like the truth of the file's own channels, with full alpha where the file has three.
class WithFullAlpha
{
public:
    static std::vector<std::byte> whole(const ForeignTiff& tiff)
    {
        auto bytes = VolumeTruth(tiff.info()).whole();
        const std::size_t step = static_cast<std::size_t>(bytesPerChannel(tiff.type));
        for (std::size_t i = 3 * step; i < bytes.size(); i += 4 * step)
            putFull(tiff.type, bytes.data() + i);
        return bytes;
    }

private:
    static void putFull(ChannelType type, std::byte* out)
    {
        const std::uint8_t unsignedByte = 255;
        const std::int8_t signedByte = 127;
        const std::uint16_t unsignedShort = 65535;
        const std::int16_t signedShort = 32767;
        const float one = 1;
        if (type == ChannelType::uint8) std::memcpy(out, &unsignedByte, 1);
        if (type == ChannelType::int8) std::memcpy(out, &signedByte, 1);
        if (type == ChannelType::uint16) std::memcpy(out, &unsignedShort, 2);
        if (type == ChannelType::int16) std::memcpy(out, &signedShort, 2);
        if (type == ChannelType::float32) std::memcpy(out, &one, 4);
    }
};

constexpr ChannelType kTypes[] = {ChannelType::uint8, ChannelType::int8, ChannelType::uint16,
                                  ChannelType::int16, ChannelType::float32};

/// A little-endian TIFF of one 4 x 4 page, made byte by byte: its directory lies before its voxels, as
/// libtiff never writes it, and holds a tag that nobody knows.
std::string directoryFirst(std::uint16_t stripBytes)
{
    std::string bytes("II*\0\x08\0\0\0", 8);
    const auto put = [&bytes](std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i)
            bytes += static_cast<char>(value >> (8 * i) & 255);
    };
    const std::array<std::array<std::uint16_t, 2>, 8> shorts{
        {{256, 4}, {257, 4}, {258, 8}, {262, 1}, {273, 110}, {278, 4}, {279, stripBytes}, {65000, 7}}};
    put(shorts.size(), 2);
    for (const auto& [tag, value] : shorts) {
        put(tag, 2);
        put(TIFF_SHORT, 2);
        put(1, 4);
        put(value, 4);
    }
    put(0, 4);
    return bytes + std::string(16, 'v');
}

class ForeignTiffTest : public testing::Test
{
protected:
    void expectRoundTrip(const ForeignTiff& tiff)
    {
        tiff.write(path_);
        auto volume = openVolume(path_);
        ASSERT_TRUE(volume) << volume.failure().text;
        expectReadsAs(*volume, VolumeTruth(tiff.info()));
    }

    void rewriteBytes(std::streamoff offset, const std::string& bytes)
    {
        std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(offset);
        file << bytes;
    }

    ScratchFolder folder_;
    std::string path_ = folder_ / "a.tif";
};

TEST_F(ForeignTiffTest, stripsOfEveryKindAreRead)
{
    for (const ChannelType type : kTypes)
        for (const char* mode : {"wl", "wb", "w8b"})
            for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE,
                                          COMPRESSION_DEFLATE, COMPRESSION_PACKBITS})
                for (const bool planar : {false, true}) {
                    SCOPED_TRACE(std::string(mode) + " " + channelTypeName(type) + " compression " +
                                 std::to_string(compression) + (planar ? " planar" : ""));
                    ForeignTiff tiff;
                    tiff.mode = mode;
                    tiff.type = type;
                    tiff.channels = planar ? 4 : 1;
                    tiff.compression = compression;
                    tiff.planar = planar;
                    expectRoundTrip(tiff);
                }
}

TEST_F(ForeignTiffTest, tilesOfEveryKindAreRead)
{
    for (const ChannelType type : kTypes)
        for (const char* mode : {"wl", "wb", "w8"})
            for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE})
                for (const bool planar : {false, true}) {
                    SCOPED_TRACE(std::string(mode) + " " + channelTypeName(type) + " compression " +
                                 std::to_string(compression) + (planar ? " planar" : ""));
                    ForeignTiff tiff;
                    tiff.mode = mode;
                    tiff.type = type;
                    tiff.channels = 2;
                    tiff.compression = compression;
                    tiff.planar = planar;
                    tiff.tile = 16;
                    expectRoundTrip(tiff);
                }
}

TEST_F(ForeignTiffTest, predictorsAreUndone)
{
    for (const auto& [type, predictor] : {std::pair{ChannelType::uint8, 2}, std::pair{ChannelType::int16, 2},
                                          std::pair{ChannelType::float32, 3}})
        for (const char* mode : {"wl", "wb"})
            for (const int compression : {COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
                SCOPED_TRACE(std::string(mode) + " " + channelTypeName(type) + " compression " +
                             std::to_string(compression));
                // libtiff 4.5 itself writes these with their bytes swapped twice.
                if (type == ChannelType::float32 && std::string(mode) == "wb") continue;
                ForeignTiff tiff;
                tiff.mode = mode;
                tiff.type = type;
                tiff.predictor = predictor;
                tiff.compression = compression;
                expectRoundTrip(tiff);
            }
}

TEST_F(ForeignTiffTest, oneStripAPageAndOneRowAStripAreRead)
{
    for (const std::uint32_t rows : {1u, 23u, 1000u, 0xffffffffu})
        for (const int compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE}) {
            ForeignTiff tiff;
            tiff.rowsPerStrip = rows;
            tiff.compression = compression;
            expectRoundTrip(tiff);
        }
}

TEST_F(ForeignTiffTest, bitsInReverseOrderAreRead)
{
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE}) {
        ForeignTiff tiff;
        tiff.fillOrder = FILLORDER_LSB2MSB;
        tiff.compression = compression;
        tiff.type = ChannelType::uint16;
        expectRoundTrip(tiff);
    }
}

TEST_F(ForeignTiffTest, threeChannelsGainFullAlpha)
{
    for (const ChannelType type : kTypes)
        for (const bool planar : {false, true})
            for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW}) {
                ForeignTiff tiff;
                tiff.channels = 3;
                tiff.type = type;
                tiff.planar = planar;
                tiff.compression = compression;
                tiff.write(path_);
                auto volume = openVolume(path_);
                ASSERT_TRUE(volume) << volume.failure().text;
                EXPECT_EQ(volume->info().channels, 4);
                EXPECT_TRUE(readBrick(*volume, {{0, 0, 0}, volume->info().size}) ==
                            WithFullAlpha::whole(tiff));
                EXPECT_TRUE(volume->description().alphaAdded);
            }
}

TEST_F(ForeignTiffTest, alphaOfOnePageIsAlphaOfTheFile)
{
    for (const int first : {3, 4}) {
        TIFF* tiff = TIFFOpen(path_.c_str(), "w");
        ASSERT_TRUE(tiff);
        for (const int channels : {first, 7 - first}) {
            TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 1);
            TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
            TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
            TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, channels);
            TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
            TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
            std::array<std::uint8_t, 4> pixel{1, 2, 3, 4};
            TIFFWriteScanline(tiff, pixel.data(), 0, 0);
            TIFFWriteDirectory(tiff);
        }
        TIFFClose(tiff);
        const auto volume = openVolume(path_);
        ASSERT_TRUE(volume) << volume.failure().text;
        EXPECT_EQ(volume->info().size[2], 2);
        EXPECT_FALSE(volume->description().alphaAdded);
    }
}

TEST_F(ForeignTiffTest, reducedCopiesArePassedOver)
{
    ForeignTiff tiff;
    tiff.thumbnails = true;
    expectRoundTrip(tiff);
}

TEST_F(ForeignTiffTest, stripsOfSgiVolumesAreRead)
{
    for (const ChannelType type : kTypes)
        for (const char* mode : {"wl", "wb", "w8b"})
            for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE})
                for (const std::uint32_t rows : {4u, 23u}) {
                    SCOPED_TRACE(std::string(mode) + " " + channelTypeName(type) + " compression " +
                                 std::to_string(compression));
                    ForeignTiff tiff;
                    tiff.mode = mode;
                    tiff.type = type;
                    tiff.compression = compression;
                    tiff.channels = 4;
                    tiff.depth = 6;
                    tiff.rowsPerStrip = rows;
                    expectRoundTrip(tiff);
                }
}

TEST_F(ForeignTiffTest, sgiStripsThatRunThroughSlicesAreRead)
{
    for (const std::uint32_t rows : {9u, 1000u})
        for (const int compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE}) {
            ForeignTiff tiff;
            tiff.depth = 6;
            tiff.rowsPerStrip = rows;
            tiff.compression = compression;
            tiff.stripsRunThrough = true;
            expectRoundTrip(tiff);
        }
}

TEST_F(ForeignTiffTest, flatTilesOfSgiVolumesAreRead)
{
    for (const char* mode : {"wl", "wb"})
        for (const int compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE})
            for (const bool planar : {false, true}) {
                ForeignTiff tiff;
                tiff.mode = mode;
                tiff.type = ChannelType::int16;
                tiff.compression = compression;
                tiff.channels = 2;
                tiff.planar = planar;
                tiff.depth = 10;
                tiff.tile = 16;
                expectRoundTrip(tiff);
            }
}

TEST_F(ForeignTiffTest, thickTilesOfSgiVolumesAreRead)
{
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE}) {
        ForeignTiff tiff;
        tiff.compression = compression;
        tiff.depth = 10;
        tiff.tile = 16;
        tiff.tileDepth = 4;
        expectRoundTrip(tiff);
    }
}

TEST_F(ForeignTiffTest, sgiBrickTouchesOnlyItsRows)
{
    ForeignTiff tiff;
    tiff.depth = 10;
    tiff.write(path_);
    auto volume = openVolume(path_);
    ASSERT_TRUE(volume);
    readBrick(*volume, {{3, 4, 5}, {10, 6, 2}});
    EXPECT_EQ(volume->counters().slices, 2);
    EXPECT_EQ(volume->counters().rows, 12);
    EXPECT_EQ(volume->counters().bytes, 120);
}

TEST_F(ForeignTiffTest, sgiVolumeThatLacksStripsSaysHowMany)
{
    ForeignTiff tiff;
    tiff.depth = 6;
    tiff.write(path_);
    // One strip table entry holds the count of strips; the depth is what the file claims in excess.
    TIFF* handle = TIFFOpen(path_.c_str(), "r+");
    TIFFSetField(handle, TIFFTAG_IMAGEDEPTH, 7u);
    TIFFRewriteDirectory(handle);
    TIFFClose(handle);
    expectSays(failureOfReading(path_), {"a.tif: expected 42 strips", "7 slices", "found"});
}

TEST_F(ForeignTiffTest, pageOfAnotherSizeIsNamed)
{
    ForeignTiff tiff;
    tiff.pages = 3;
    tiff.write(path_);
    tiff.width = 36;
    tiff.mode = "a";
    tiff.write(path_);
    expectSays(failureOfReading(path_), {"a.tif: page 3: expected", "37 x 23", "found 36 x 23"});
}

TEST_F(ForeignTiffTest, pageOfAnotherTypeIsNamed)
{
    ForeignTiff tiff;
    tiff.pages = 2;
    tiff.write(path_);
    tiff.type = ChannelType::int8;
    tiff.mode = "a";
    tiff.write(path_);
    expectSays(failureOfReading(path_), {"a.tif: page 2: expected", "uint8", "found", "int8"});
}

TEST_F(ForeignTiffTest, whatIsNotReadIsRefusedByName)
{
    ForeignTiff tiff;
    tiff.photometric = PHOTOMETRIC_MINISWHITE;
    tiff.write(path_);
    expectSays(failureOfReading(path_), {"a.tif: page 0: expected grey", "MinIsWhite"});

    tiff = {};
    tiff.compression = COMPRESSION_ZSTD;
    tiff.write(path_);
    expectSays(failureOfReading(path_),
               {"expected no compression, LZW, deflate or PackBits", "scheme 50000"});

    tiff = {};
    tiff.channels = 5;
    tiff.write(path_);
    expectSays(failureOfReading(path_), {"expected 1 to 4 channels, found 5"});
}

TEST_F(ForeignTiffTest, otherNumberTypesAreRefused)
{
    for (const auto& [bits, format, name] : {std::tuple{1, SAMPLEFORMAT_UINT, "1-bit unsigned"},
                                             std::tuple{32, SAMPLEFORMAT_INT, "32-bit signed"},
                                             std::tuple{64, SAMPLEFORMAT_IEEEFP, "64-bit float"},
                                             std::tuple{16, SAMPLEFORMAT_IEEEFP, "16-bit float"}}) {
        TIFF* tiff = TIFFOpen(path_.c_str(), "w");
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 8);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, format);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        std::vector<std::byte> row(64);
        TIFFWriteScanline(tiff, row.data(), 0);
        TIFFClose(tiff);
        expectSays(failureOfReading(path_), {"expected 8- or 16-bit integers or 32-bit floats, found", name});
    }
}

TEST_F(ForeignTiffTest, announcedPagesThatAreMissingAreCounted)
{
    ForeignTiff tiff;
    tiff.announcedPages = 9;
    tiff.write(path_);
    expectSays(failureOfReading(path_), {"a.tif: expected 9 pages", "found 5"});
}

TEST_F(ForeignTiffTest, everyTruncationIsNoticed)
{
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE})
        for (const char* mode : {"w", "w8"})
            for (const std::uint32_t depth : {1u, 5u}) {
                ForeignTiff tiff;
                tiff.mode = mode;
                tiff.compression = compression;
                tiff.depth = depth;
                tiff.write(path_);
                const auto size = std::filesystem::file_size(path_);
                std::filesystem::copy_file(path_, folder_ / "whole.tif",
                                           std::filesystem::copy_options::overwrite_existing);
                for (std::uintmax_t left = 0; left < size; left += 61) {
                    std::filesystem::copy_file(folder_ / "whole.tif", path_,
                                               std::filesystem::copy_options::overwrite_existing);
                    std::filesystem::resize_file(path_, left);
                    expectSays(failureOfReading(path_), {"a.tif: "});
                    EXPECT_FALSE(failureOfReading(path_).empty()) << "cut to " << left << " of " << size;
                }
            }
}

TEST_F(ForeignTiffTest, voxelsThatAreCutOffAreMissedOnOpening)
{
    const std::string bytes = directoryFirst(16);
    std::ofstream(path_, std::ios::binary) << bytes;
    EXPECT_EQ(failureOfReading(path_), "");
    std::filesystem::resize_file(path_, bytes.size() - 1);
    const auto volume = openVolume(path_);
    ASSERT_FALSE(volume);
    expectSays(volume.failure().text, {"a.tif: page 0: cut off or damaged: expected strip 0 of 16 bytes"});
}

TEST_F(ForeignTiffTest, truncatedStackSaysWhichPageIsMissing)
{
    ForeignTiff tiff;
    tiff.write(path_);
    std::filesystem::resize_file(path_, std::filesystem::file_size(path_) * 3 / 5);
    const std::string text = failureOfReading(path_);
    expectSays(text, {"a.tif: ", "cut off", "page"});
    EXPECT_EQ(text.find("a.tif"), text.rfind("a.tif")) << text;
}

TEST_F(ForeignTiffTest, directoryWithoutEntriesHasNoPages)
{
    std::ofstream(path_, std::ios::binary) << std::string("II\x2a\0\x08\0\0\0\0\0\0\0\0\0", 14);
    expectSays(failureOfReading(path_), {"a.tif: expected at least one page, found none"});
}

TEST_F(ForeignTiffTest, damagedDeflateDataNeverReadsAsSuccess)
{
    ForeignTiff tiff;
    tiff.pages = 1;
    tiff.compression = COMPRESSION_ADOBE_DEFLATE;
    tiff.rowsPerStrip = 23;
    tiff.write(path_);
    TIFF* handle = TIFFOpen(path_.c_str(), "r");
    const auto offset = static_cast<std::streamoff>(TIFFGetStrileOffset(handle, 0));
    const auto bytes = static_cast<std::streamoff>(TIFFGetStrileByteCount(handle, 0));
    TIFFClose(handle);
    ASSERT_EQ(failureOfReading(path_), "");
    std::ifstream original(path_, std::ios::binary);
    for (std::streamoff i = 0; i < bytes; ++i) {
        char byte = 0;
        original.seekg(offset + i);
        original.get(byte);
        rewriteBytes(offset + i, std::string(1, static_cast<char>(byte ^ 0x10)));
        EXPECT_NE(failureOfReading(path_), "") << "byte " << i << " of " << bytes;
        rewriteBytes(offset + i, std::string(1, byte));
    }
    EXPECT_EQ(failureOfReading(path_), "");
}

TEST_F(ForeignTiffTest, damagedHeadersNeverCrash)
{
    for (const char* mode : {"wl", "w8b"})
        for (const std::uint32_t depth : {1u, 3u}) {
            ForeignTiff tiff;
            tiff.mode = mode;
            tiff.width = 5;
            tiff.height = 4;
            tiff.pages = 2;
            tiff.depth = depth;
            tiff.compression = COMPRESSION_LZW;
            tiff.write(path_);
            std::ifstream file(path_, std::ios::binary);
            const std::string original{std::istreambuf_iterator<char>(file), {}};
            for (std::size_t i = 0; i < original.size(); ++i)
                for (const char flip : {'\x01', '\x80', '\xff'}) {
                    rewriteBytes(static_cast<std::streamoff>(i),
                                 std::string(1, static_cast<char>(original[i] ^ flip)));
                    auto volume = openVolume(path_);
                    if (volume) {
                        std::vector<std::byte> out(std::size_t(64 * volume->info().bytesPerVoxel()));
                        const auto read = volume->readBrick({{-1, -1, -1}, {4, 4, 4}}, out);
                        (void)static_cast<bool>(read);
                    }
                    rewriteBytes(static_cast<std::streamoff>(i), original.substr(i, 1));
                }
        }
}

TEST_F(ForeignTiffTest, hugeSizesInASmallFileFailBeforeMemoryIsAsked)
{
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE}) {
        TIFF* tiff = TIFFOpen(path_.c_str(), "w");
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 2000000000u);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 2000000000u);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2000000000u);
        std::vector<std::byte> bytes(1000);
        TIFFWriteRawStrip(tiff, 0, bytes.data(), 1000);
        TIFFClose(tiff);
        const auto volume = openVolume(path_);
        ASSERT_FALSE(volume);
        expectSays(volume.failure().text, {"a.tif: page 0: ", "damaged: expected", "strip 0"});
    }
}

TEST_F(ForeignTiffTest, junkEmptyMissingAndFolderAreTold)
{
    std::ofstream(path_) << "this is no TIFF";
    expectSays(failureOfReading(path_), {"a.tif: expected a volume (TIFF", "found \"this\""});
    std::ofstream{path_}.close();
    expectSays(failureOfReading(path_), {"a.tif: expected a volume (TIFF", "an empty file"});
    std::ofstream(path_) << std::string("II*\0", 4) << "junk";
    expectSays(failureOfReading(path_), {"a.tif: "});
    expectSays(failureOfReading(folder_ / "none.tif"), {"none.tif: cannot open: No such file"});
    expectSays(failureOfReading(folder_ / ""), {": expected a folder with DICOM pictures, found none in"});
}

TEST_F(ForeignTiffTest, libtiffPrintsNothing)
{
    ForeignTiff tiff;
    tiff.compression = COMPRESSION_ADOBE_DEFLATE;
    tiff.write(path_);
    std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 3);
    std::ofstream(folder_ / "unknownTag.tif", std::ios::binary) << directoryFirst(16);
    testing::internal::CaptureStderr();
    EXPECT_NE(failureOfReading(path_), "");
    EXPECT_EQ(failureOfReading(folder_ / "unknownTag.tif"), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace vo
