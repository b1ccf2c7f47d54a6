// Slice atlases: pictures whose parts are the slices of a volume.

#include <gtest/gtest.h>

#include "../util/jpeg_file.h"
#include "../util/scratch_folder.h"
#include "view_scene.h"
#include "volume_io/volume_io.h"
#include "x3d/check_textures.h"

#include <cstring>
#include <fstream>
#include <optional>
#include <sys/stat.h>

namespace vo {
namespace {

constexpr int kWidth = 3, kHeight = 4, kSlices = 5, kAcross = 2, kDown = 3;

/// No two voxels, nor two channels of one, have the same number; 0 is none of them.
int numberOf(int x, int y, int z, int channel)
{
    return 1 + channel + 4 * (x + kWidth * (y + kHeight * z));
}

/// The number of a pixel of the atlas, as the node is documented: slice 0 at the top left, the next at its
/// right, rows of a slice from the top; 0 where no slice is.
int atlasNumber(int x, int y, int channel)
{
    const int slice = y / kHeight * kAcross + x / kWidth;
    return slice < kSlices ? numberOf(x % kWidth, y % kHeight, slice, channel) : 0;
}

std::vector<std::uint8_t> atlasPixels(int channels)
{
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < kHeight * kDown; ++y)
        for (int x = 0; x < kWidth * kAcross; ++x)
            for (int channel = 0; channel < channels; ++channel)
                bytes.push_back(static_cast<std::uint8_t>(atlasNumber(x, y, channel)));
    return bytes;
}

void writeAtlas(const std::string& path, int channels)
{
    ASSERT_TRUE(writePng(path, kWidth * kAcross, kHeight * kDown, channels, atlasPixels(channels)));
}

std::string atlas(const std::string& attributes, const std::string& field = "voxels",
                  const std::string& url = "a.png")
{
    return "<ImageTextureAtlas containerField='" + field + "' url='\"" + url + "\"' " + attributes + "/>";
}

const std::string kCounts = "numberOfSlices='5' slicesOverX='2' slicesOverY='3'";

template <class Number = std::uint8_t>
Number texelAt(const VoxelTexture& texture, int x, int y, int z, int channel)
{
    const int at = ((z * texture.size.y + y) * texture.size.x + x) * texture.components + channel;
    Number number;
    std::memcpy(&number, texture.texels.data() + static_cast<std::size_t>(at) * sizeof number, sizeof number);
    return number;
}

template <class Number = std::uint8_t>
void expectNumbers(const VoxelTexture& texture, int channels, int scale = 1)
{
    ASSERT_EQ(texture.size, (VoxelSize{kWidth, kHeight, kSlices}));
    ASSERT_EQ(texture.components, channels);
    ASSERT_EQ(texture.texels.size(),
              sizeof(Number) * static_cast<std::size_t>(kWidth * kHeight * kSlices * channels));
    for (int z = 0; z < kSlices; ++z)
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                for (int channel = 0; channel < channels; ++channel)
                    EXPECT_EQ(int(texelAt<Number>(texture, x, y, z, channel)),
                              scale * numberOf(x, y, z, channel))
                        << x << ' ' << y << ' ' << z << ' ' << channel;
}

TEST(SliceAtlas, slicesRowsAndChannelsKeepTheirOrder)
{
    for (const int channels : {3, 4}) {
        const ScratchFolder folder;
        writeAtlas(folder / "a.png", channels);
        const ViewedScene s("<VolumeData>" + atlas(kCounts) + "</VolumeData>", "4.0", folder / "");
        EXPECT_EQ(s.messages(), "");
        expectNumbers(*s.drawn.volumes.at(0).voxels, channels);
    }
}

TEST(SliceAtlas, sixteenBitsStay)
{
    const ScratchFolder folder;
    std::vector<std::uint16_t> values;
    for (int y = 0; y < kHeight * kDown; ++y)
        for (int x = 0; x < kWidth * kAcross; ++x)
            values.push_back(static_cast<std::uint16_t>(257 * atlasNumber(x, y, 0)));
    ASSERT_TRUE(writeGreyPng(folder / "a.png", kWidth * kAcross, kHeight * kDown, values));
    const ViewedScene s("<VolumeData>" + atlas(kCounts) + "</VolumeData>", "3.3", folder / "");
    EXPECT_EQ(s.drawn.volumes.at(0).voxels->kind, TexelKind::uint16);
    expectNumbers<std::uint16_t>(*s.drawn.volumes[0].voxels, 1, 257);
}

TEST(SliceAtlas, firstRowOfTheFirstSliceIsAtTheLowCornerOfAllAxes)
{
    const ScratchFolder folder;
    writeAtlas(folder / "a.png", 3);
    const ViewedScene s("<VolumeData dimensions='3 4 5'>" + atlas(kCounts) + "</VolumeData>", "4.0",
                        folder / "");
    const StyledVolume& volume = s.drawn.volumes.at(0);
    const auto red = [&](glm::vec3 local) {
        BatchVectors place;
        for (int axis = 0; axis < 3; ++axis)
            place[static_cast<std::size_t>(axis)].fill(local[axis] / volume.dimensions[axis] + 0.5f);
        std::array<BatchFloats, 4> texels{};
        sampleTexture(*volume.voxels, 3, place, texels);
        return texels[0][0] * 255.0f;
    };
    EXPECT_NEAR(red({-1, -1.5f, -2}), numberOf(0, 0, 0, 0), 1e-3);
    EXPECT_NEAR(red({1, -1.5f, -2}), numberOf(2, 0, 0, 0), 1e-3);
    EXPECT_NEAR(red({-1, 1.5f, -2}), numberOf(0, 3, 0, 0), 1e-3);
    EXPECT_NEAR(red({-1, -1.5f, 2}), numberOf(0, 0, 4, 0), 1e-3);
}

TEST(SliceAtlas, flippedPicturesHaveTheirFirstSliceAtTheBottom)
{
    const ScratchFolder folder;
    std::vector<std::uint8_t> turned;
    for (int y = kHeight * kDown - 1; y >= 0; --y)
        for (int x = 0; x < kWidth * kAcross; ++x)
            for (int channel = 0; channel < 3; ++channel)
                turned.push_back(static_cast<std::uint8_t>(atlasNumber(x, y, channel)));
    ASSERT_TRUE(writePng(folder / "a.png", kWidth * kAcross, kHeight * kDown, 3, turned));
    const ViewedScene s("<VolumeData>" + atlas(kCounts + " flipY='true'") + "</VolumeData>", "4.0",
                        folder / "");
    expectNumbers(*s.drawn.volumes.at(0).voxels, 3);
}

TEST(SliceAtlas, jpegPicturesAreAtlasesToo)
{
    const ScratchFolder folder;
    // Each slice is a block of JPEG, all of one value.
    writeJpeg(folder / "a.jpg", 16, 24, 1,
              [](int x, int y, int) { return static_cast<std::uint8_t>(20 + 40 * (y / 8 * 2 + x / 8)); });
    const ViewedScene s("<VolumeData>" + atlas(kCounts, "voxels", "a.jpg") + "</VolumeData>", "4.0",
                        folder / "");
    const VoxelTexture& voxels = *s.drawn.volumes.at(0).voxels;
    EXPECT_EQ(voxels.size, (VoxelSize{8, 8, 5}));
    for (int z = 0; z < 5; ++z)
        EXPECT_NEAR(int(texelAt(voxels, 3, 6, z, 0)), 20 + 40 * z, 2) << z;
}

TEST(SliceAtlas, standsWhereverTexturesOfThreeDimensionsDo)
{
    const ScratchFolder folder;
    writeAtlas(folder / "a.png", 3);
    const std::string cartoon =
        "<CartoonVolumeStyle>" + atlas(kCounts, "surfaceNormals") + "</CartoonVolumeStyle>";
    const ViewedScene s("<SegmentedVolumeData segmentEnabled='true false'>" + atlas(kCounts) +
                            atlas(kCounts, "segmentIdentifiers") + cartoon + "</SegmentedVolumeData>" +
                            "<IsoSurfaceVolumeData surfaceValues='0.5'>" + atlas(kCounts) +
                            atlas(kCounts, "gradients") + "</IsoSurfaceVolumeData>" + "<VolumeData>" +
                            atlas(kCounts) + "<BlendedVolumeStyle>" + atlas(kCounts) +
                            "</BlendedVolumeStyle></VolumeData>" + "<VolumeData>" + atlas(kCounts) +
                            "<OpacityMapVolumeStyle>" + atlas(kCounts, "transferFunction") +
                            "</OpacityMapVolumeStyle></VolumeData>",
                        "4.0", folder / "");
    EXPECT_EQ(s.messages(), "");
    ASSERT_EQ(s.drawn.volumes.size(), 4u);
    const Segments& segments = *s.drawn.volumes[0].segments;
    EXPECT_EQ(segments.identifiers->kind, TexelKind::uint16);
    expectNumbers<std::uint16_t>(*segments.identifiers, 3);
    EXPECT_TRUE(s.drawn.volumes[1].surfaces->gradients);
    const ViewedScene old("<SegmentedVolumeData>" + atlas(kCounts, "segmentedVoxels") +
                              "</SegmentedVolumeData>",
                          "3.0", folder / "");
    EXPECT_EQ(old.messages(), "");
    expectNumbers<std::uint16_t>(*old.drawn.volumes.at(0).segments->identifiers, 3);
}

/// What is drawn and what a check says: both name the line of the atlas.
void expectRefused(const std::string& attributes, const std::string& reason, int height = kHeight * kDown)
{
    const ScratchFolder folder;
    ASSERT_TRUE(writePng(folder / "a.png", kWidth * kAcross, height, 3,
                         std::vector<std::uint8_t>(static_cast<std::size_t>(kWidth * kAcross * height * 3))));
    const std::string nodes = "<VolumeData>\n" + atlas(attributes) + "</VolumeData>";
    const ViewedScene s(nodes, "4.0", folder / "");
    EXPECT_TRUE(s.drawn.volumes.empty()) << attributes;
    std::string messages = s.messages();
    if (const auto at = messages.find(folder / ""); at != messages.npos)
        messages.erase(at, (folder / "").size());
    EXPECT_EQ(messages, "s.x3d:3: error: ImageTextureAtlas: " + reason + "\n");
    Scene checked;
    ASSERT_TRUE(readScene(checked, folder / "s.x3d"));
    checkTextures(checked);
    ASSERT_EQ(checked.messages.size(), 1u) << attributes;
    EXPECT_EQ(messageLine(checked.messages[0]), messageLine(s.scene.messages.at(0)));
}

TEST(SliceAtlas, countsAndSizesThatDoNotFitAreToldOf)
{
    expectRefused("slicesOverX='2' slicesOverY='3'", "expected numberOfSlices of at least 1, found 0");
    expectRefused("numberOfSlices='5' slicesOverY='3'", "expected slicesOverX of at least 1, found 0");
    expectRefused("numberOfSlices='5' slicesOverX='2'", "expected slicesOverY of at least 1, found 0");
    expectRefused("numberOfSlices='7' slicesOverX='2' slicesOverY='3'",
                  "expected numberOfSlices of at most slicesOverX * slicesOverY = 6, found 7");
    expectRefused(kCounts, "a.png: expected a picture of 2 x 3 slices of one size, found 6 x 11 pixels", 11);
    expectRefused("numberOfSlices='5' slicesOverX='4' slicesOverY='3'",
                  "a.png: expected a picture of 4 x 3 slices of one size, found 6 x 12 pixels");
    expectRefused("numberOfSlices='2147483647' slicesOverX='2147483647' slicesOverY='2147483647'",
                  "a.png: expected a picture of 2147483647 x 2147483647 slices of one size, found 6 x 12 "
                  "pixels");
}

TEST(SliceAtlas, aCountThatIsRefusedIsToldOfOnce)
{
    const ScratchFolder folder;
    writeAtlas(folder / "a.png", 3);
    const ViewedScene s("<VolumeData>\n" + atlas("numberOfSlices='-1' slicesOverX='2' slicesOverY='3'") +
                            "</VolumeData>",
                        "4.0", folder / "");
    EXPECT_EQ(s.messages(),
              "s.x3d:3: error: ImageTextureAtlas.numberOfSlices: expected numbers in [0,inf), found -1\n");
    Scene checked;
    ASSERT_TRUE(readScene(checked, folder / "s.x3d"));
    checkView(checked);
    checkTextures(checked);
    EXPECT_EQ(checked.messages.size(), 1u);
    const ViewedScene image(
        "<VolumeData>\n<PixelTexture3D containerField='voxels' image='5 1 1 1 0'/></VolumeData>");
    EXPECT_EQ(image.messages(),
              "s.x3d:3: error: PixelTexture3D.image: expected 0 to 4 components, found 5\n");
}

TEST(SliceAtlas, filesOfManySlicesAreNoPictures)
{
    const ScratchFolder folder;
    ASSERT_TRUE(
        writeTiffStack(folder / "a.tif", {{2, 2, 3}, 1, ChannelType::uint8}, std::vector<std::byte>(12)));
    const ViewedScene s("<VolumeData>" +
                            atlas("numberOfSlices='1' slicesOverX='1' slicesOverY='1'", "voxels", "a.tif") +
                            "</VolumeData>",
                        "4.0", folder / "");
    EXPECT_NE(s.messages().find("a.tif: expected a picture, found 3 slices"), std::string::npos)
        << s.messages();
}

TEST(SliceAtlas, checkTellsOfPicturesThatAreOneSlice)
{
    const ScratchFolder folder;
    writeAtlas(folder / "a.png", 3);
    const ViewedScene s("<VolumeData><ImageTexture3D url='\"a.png\"'/></VolumeData>\n<VolumeData>" +
                            atlas(kCounts) + "</VolumeData>",
                        "4.0", folder / "");
    EXPECT_EQ(s.drawn.volumes.at(0).voxels->size, (VoxelSize{kWidth * kAcross, kHeight * kDown, 1}));
    EXPECT_EQ(s.messages(), "");
    Scene checked;
    ASSERT_TRUE(readScene(checked, folder / "s.x3d"));
    checkTextures(checked);
    ASSERT_EQ(checked.messages.size(), 1u);
    EXPECT_EQ(messageLine(checked.messages[0]),
              (folder / "s.x3d") + ":2: warning: ImageTexture3D: " + (folder / "a.png") +
                  ": a picture is one slice; ImageTextureAtlas takes one of many slices");
}

TEST(SliceAtlas, checkDoesNotWaitForPipes)
{
    const ScratchFolder folder;
    ASSERT_EQ(mkfifo((folder / "a.png").c_str(), 0600), 0);
    std::ofstream(folder / "s.x3d") << "<X3D><Scene><VolumeData><ImageTexture3D containerField='voxels' "
                                       "url='\"a.png\"'/></VolumeData></Scene></X3D>";
    Scene checked;
    ASSERT_TRUE(readScene(checked, folder / "s.x3d"));
    checkTextures(checked);
    for (const SceneMessage& message : checked.messages)
        EXPECT_EQ(messageLine(message).find("a picture is one slice"), std::string::npos);
}

} // namespace
} // namespace vo
