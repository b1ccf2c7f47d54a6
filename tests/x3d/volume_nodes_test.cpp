// Voxels, segments and surfaces of volume nodes; texture nodes and files.

#include <gtest/gtest.h>

#include "../util/scratch_folder.h"
#include "view_scene.h"
#include "volume_io/volume_io.h"
#include "x3d/plane_spacing.h"
#include "x3d/voxel_files.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vo {
namespace {

/// A file whose bytes are those of numbers.
template <class Number>
void writeNrrd(const std::string& path, const std::string& type, const std::string& sizes,
               const std::vector<Number>& numbers, const std::string& more = "")
{
    std::ofstream file(path, std::ios::binary);
    file << "NRRD0004\ntype: " << type << "\ndimension: " << 1 + std::count(sizes.begin(), sizes.end(), ' ')
         << "\nsizes: " << sizes << "\nendian: little\nencoding: raw\n"
         << more << "\n";
    file.write(reinterpret_cast<const char*>(numbers.data()),
               static_cast<std::streamsize>(numbers.size() * sizeof(Number)));
}

template <class Number = std::uint8_t>
std::vector<Number> texelsOf(const VoxelTexture& texture)
{
    std::vector<Number> numbers(texture.texels.size() / sizeof(Number));
    std::memcpy(numbers.data(), texture.texels.data(), texture.texels.size());
    return numbers;
}

/// A volume with the file v.nrrd.
const std::string kFileVolume = "<VolumeData>\n<ImageTexture3D url='\"v.nrrd\"'/></VolumeData>";

std::string pixels(const std::string& image, const std::string& field = "voxels",
                   const std::string& below = "")
{
    return "<PixelTexture3D containerField='" + field + "' image='" + image + "'>" + below +
           "</PixelTexture3D>";
}

std::string opacityMap(const std::string& function)
{
    return "<OpacityMapVolumeStyle><PixelTexture containerField='transferFunction' image='" + function +
           "'/></OpacityMapVolumeStyle>";
}

/// The value at local coordinates.
float valueAt(const StyledVolume& volume, const glm::vec3& local)
{
    BatchVectors place;
    for (int axis = 0; axis < 3; ++axis)
        place[static_cast<std::size_t>(axis)].fill(local[axis] / volume.dimensions[axis] + 0.5f);
    std::array<BatchFloats, 4> texels{};
    sampleTexture(*volume.voxels, 1, place, texels);
    return texels[0][0];
}

/// The chain that a voxel of segmented volumes has, as engines find it.
int chainAt(const StyledVolume& volume, std::size_t voxel)
{
    const Segments& segments = *volume.segments;
    const VoxelTexture& numbers = *segments.identifiers;
    const std::size_t at =
        voxel * static_cast<std::size_t>(numbers.components) + static_cast<std::size_t>(segments.component);
    const float texel = numbers.kind == TexelKind::uint16
                            ? static_cast<float>(texelsOf<std::uint16_t>(numbers)[at]) / 65535.0f
                            : static_cast<float>(texelsOf(numbers)[at]) / 255.0f;
    const auto id = static_cast<std::size_t>(std::lround(texel * segments.scale));
    return id < segments.chainOf.size() ? segments.chainOf[id] : segments.beyond;
}

TEST(VolumeNodes, firstVoxelIsAtTheLowCornerOfAllAxes)
{
    const ViewedScene s("<VolumeData dimensions='2 4 6'>" + pixels("1 2 2 2 10 20 30 40 50 60 70 80") +
                        "</VolumeData>");
    const StyledVolume& volume = s.drawn.volumes.at(0);
    EXPECT_EQ(volume.dimensions, glm::vec3(2, 4, 6));
    const float unit = 255.0f;
    EXPECT_NEAR(valueAt(volume, {-1, -2, -3}) * unit, 10, 1e-3);
    EXPECT_NEAR(valueAt(volume, {1, -2, -3}) * unit, 20, 1e-3);
    EXPECT_NEAR(valueAt(volume, {-1, 2, -3}) * unit, 30, 1e-3);
    EXPECT_NEAR(valueAt(volume, {-1, -2, 3}) * unit, 50, 1e-3);
    EXPECT_NEAR(valueAt(volume, {1, 2, 3}) * unit, 80, 1e-3);
    EXPECT_NEAR(valueAt(volume, {0, -2, -3}) * unit, 15, 1e-3);
}

TEST(VolumeNodes, pixelsHaveTheirFirstComponentInTheHighestByte)
{
    const auto texels = [](const std::string& image) {
        const ViewedScene s("<VolumeData>" + pixels(image) + "</VolumeData>");
        return texelsOf(*s.drawn.volumes.at(0).voxels);
    };
    using Bytes = std::vector<std::uint8_t>;
    EXPECT_EQ(texels("1 1 1 2 0x12 0x134"), (Bytes{0x12, 0x34}));
    EXPECT_EQ(texels("2 1 1 1 0x1234"), (Bytes{0x12, 0x34}));
    EXPECT_EQ(texels("3 1 1 1 0x123456"), (Bytes{0x12, 0x34, 0x56}));
    EXPECT_EQ(texels("4 2 1 1 0xF2345678 -1"), (Bytes{0xF2, 0x34, 0x56, 0x78, 0xFF, 0xFF, 0xFF, 0xFF}));
}

TEST(VolumeNodes, unitLengthIsTheShortestEdgeOfAVoxel)
{
    const ViewedScene s("<Transform scale='2 3 5'><VolumeData dimensions='2 3 1'>" +
                        pixels("1 4 2 1 0 0 0 0 0 0 0 0") + "</VolumeData></Transform>");
    EXPECT_DOUBLE_EQ(s.drawn.volumes.at(0).unitLength, 0.5);
}

TEST(VolumeNodes, spacingGoesByTheViewAndTheRequest)
{
    ViewedScene s("<Viewpoint position='0 0 3'/><VolumeData>" + pixels("1 2 1 1 0 0") + "</VolumeData>");
    const auto wanted = [&s](double sampling) {
        return planeSpacing(s.drawn, s.drawn.volumes.at(0), sampling).distance;
    };
    EXPECT_DOUBLE_EQ(s.drawn.volumes.at(0).spacing, wanted(1.0));
    ViewRequest request;
    request.sampling = 0.25;
    s.draw(request);
    EXPECT_DOUBLE_EQ(s.drawn.volumes.at(0).spacing, wanted(0.25));
    EXPECT_LT(wanted(0.25), wanted(1.0));
    request.camera = ViewCamera{};
    request.camera->clipFromEye[0][0] = 9.0;
    s.draw(request);
    EXPECT_DOUBLE_EQ(s.drawn.volumes.at(0).spacing, wanted(0.25));
}

TEST(VolumeNodes, volumesWithoutExtentAreToldOf)
{
    const ViewedScene s(
        "<VolumeData dimensions='1 0 1'>" + pixels("1 1 1 1 0") + "</VolumeData>\n<VolumeData/>", "3.0");
    EXPECT_TRUE(s.drawn.volumes.empty());
    EXPECT_EQ(s.messages(),
              "s.x3d:2: warning: VolumeData.dimensions: expected numbers above 0, found 0: not drawn\n"
              "s.x3d:3: warning: VolumeData has no voxels: not drawn\n");
}

TEST(VolumeNodes, mipLevelsOf2005AreNotNeeded)
{
    const ViewedScene s(
        "<VolumeData>" + pixels("1 2 2 2 1 2 3 4 5 6 7 8") + pixels("1 1 1 1 9") + "</VolumeData>", "3.0");
    EXPECT_EQ(s.drawn.volumes.at(0).voxels->texels.size(), 8u);
    EXPECT_EQ(s.messages(), "");
}

TEST(VolumeNodes, texturesRepeatAndFilterAsTheirPropertiesSay)
{
    const auto textureOf = [](const std::string& attributes, const std::string& properties) {
        const ViewedScene s("<VolumeData><PixelTexture3D image='1 1 1 1 0' " + attributes + ">" + properties +
                            "</PixelTexture3D></VolumeData>");
        return s.drawn.volumes.at(0).voxels;
    };
    EXPECT_EQ(textureOf("", "")->repeats, (std::array{false, false, false}));
    EXPECT_FALSE(textureOf("", "")->nearest);
    EXPECT_EQ(textureOf("repeatS='true' repeatR='true'", "")->repeats, (std::array{true, false, true}));
    const auto own =
        textureOf("repeatS='true'", "<TextureProperties boundaryModeS='CLAMP_TO_EDGE' boundaryModeR='CLAMP' "
                                    "magnificationFilter='NEAREST_PIXEL'/>");
    EXPECT_EQ(own->repeats, (std::array{false, true, false}));
    EXPECT_TRUE(own->nearest);
    const ViewedScene mirrored(
        "<VolumeData>" +
        pixels("1 1 1 1 9", "voxels", "<TextureProperties boundaryModeT='MIRRORED_REPEAT'/>") +
        "</VolumeData>");
    EXPECT_EQ(mirrored.messages(),
              "s.x3d:2: warning: boundaryModeT MIRRORED_REPEAT is not drawn: the value at the edge stays\n");
}

TEST(VolumeNodes, composedTexturesAreSlices)
{
    const ViewedScene s(
        "<VolumeData><ComposedTexture3D><PixelTexture image='2 1 1 1 2'/><PixelTexture image='2 1 1 3 4'/>"
        "</ComposedTexture3D></VolumeData>");
    const VoxelTexture& texture = *s.drawn.volumes.at(0).voxels;
    EXPECT_EQ(texture.size, (VoxelSize{2, 1, 2}));
    EXPECT_EQ(texelsOf(texture), (std::vector<std::uint8_t>{1, 2, 3, 4}));
    const ViewedScene wrong("<VolumeData>\n<ComposedTexture3D><PixelTexture image='2 1 1 1 2'/>"
                            "<PixelTexture image='1 1 1 3'/></ComposedTexture3D></VolumeData>");
    EXPECT_TRUE(wrong.drawn.volumes.empty());
    EXPECT_EQ(wrong.messages(),
              "s.x3d:3: error: ComposedTexture3D: expected slices of one size, type and number of "
              "components, found several\n");
}

TEST(VolumeNodes, filesKeepWhatIsUnsigned)
{
    const ScratchFolder folder;
    writeNrrd<std::uint8_t>(folder / "v.nrrd", "uchar", "2 1 2", {1, 2, 3, 255});
    const ViewedScene bytes(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(texelsOf(*bytes.drawn.volumes.at(0).voxels), (std::vector<std::uint8_t>{1, 2, 3, 255}));
    EXPECT_EQ(bytes.drawn.volumes[0].voxels->size, (VoxelSize{2, 1, 2}));
    writeNrrd<std::uint16_t>(folder / "v.nrrd", "ushort", "2 1 2", {1, 2, 3, 65535});
    const ViewedScene words(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(texelsOf<std::uint16_t>(*words.drawn.volumes.at(0).voxels),
              (std::vector<std::uint16_t>{1, 2, 3, 65535}));
    EXPECT_EQ(words.messages(), "");
}

TEST(VolumeNodes, filesOfOtherTypesAreScaledByTheirRange)
{
    const ScratchFolder folder;
    writeNrrd<std::int16_t>(folder / "v.nrrd", "short", "3 1 1", {-1000, 0, 3000});
    const ViewedScene words(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(texelsOf<std::uint16_t>(*words.drawn.volumes.at(0).voxels),
              (std::vector<std::uint16_t>{0, 16384, 65535}));
    writeNrrd<std::int8_t>(folder / "v.nrrd", "signed char", "3 1 1", {-128, 0, 127});
    const ViewedScene bytes(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(texelsOf(*bytes.drawn.volumes.at(0).voxels), (std::vector<std::uint8_t>{0, 128, 255}));
    const float nan = std::nanf("");
    writeNrrd<float>(folder / "v.nrrd", "float", "4 1 1", {-2, 0, nan, 6});
    const ViewedScene floats(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(floats.drawn.volumes.at(0).voxels->kind, TexelKind::float32);
    EXPECT_EQ(texelsOf<float>(*floats.drawn.volumes[0].voxels), (std::vector<float>{0, 0.25f, 0, 1}));
    writeNrrd<float>(folder / "v.nrrd", "float", "2 1 1", {7, 7});
    const ViewedScene same(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(texelsOf<float>(*same.drawn.volumes.at(0).voxels), (std::vector<float>{0, 0}));
}

TEST(VolumeNodes, numbersThatAreNoneAreToldOf)
{
    const ScratchFolder folder;
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    writeNrrd<float>(folder / "v.nrrd", "float", "6 1 1", {-2, nan, infinity, -infinity, 6, nan});
    const ViewedScene some(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(texelsOf<float>(*some.drawn.volumes.at(0).voxels), (std::vector<float>{0, 0, 1, 0, 1, 0}));
    EXPECT_EQ(some.messages(),
              "s.x3d:3: warning: ImageTexture3D: " + (folder / "v.nrrd") +
                  ": expected numbers, found 2 that are none (NaN) and 2 infinite ones among 6: "
                  "NaN and -infinity count as the smallest, infinity as the largest\n");
    writeNrrd<float>(folder / "v.nrrd", "float", "2 1 1", {nan, infinity});
    const ViewedScene none(kFileVolume, "4.0", folder / "");
    EXPECT_TRUE(none.drawn.volumes.empty());
    EXPECT_EQ(none.messages(),
              "s.x3d:3: error: ImageTexture3D: " + (folder / "v.nrrd") +
                  ": expected numbers, found only 1 that are none (NaN) and 1 infinite ones\n");
}

TEST(VolumeNodes, numbersOfSegmentsThatAreNoneAreToldOf)
{
    const ScratchFolder folder;
    writeNrrd<float>(folder / "v.nrrd", "float", "4 1 1", {0, 1.25f, 2, 2.75f});
    const ViewedScene s(
        "<SegmentedVolumeData><PixelTexture3D containerField='voxels' image='1 4 1 1 1 2 3 4'/>"
        "<ImageTexture3D containerField='segmentIdentifiers' url='\"v.nrrd\"'/>"
        "</SegmentedVolumeData>",
        "4.0", folder / "");
    EXPECT_EQ(texelsOf<std::uint16_t>(*s.drawn.volumes.at(0).segments->identifiers),
              (std::vector<std::uint16_t>{0, 1, 2, 3}));
    EXPECT_EQ(s.messages(), "s.x3d:2: warning: ImageTexture3D: " + (folder / "v.nrrd") +
                                ": expected whole numbers of segments, found 2 others: rounded\n");
}

TEST(VolumeNodes, threeChannelsOfAFileStayThree)
{
    const ScratchFolder folder;
    writeNrrd<std::uint8_t>(folder / "v.nrrd", "uchar", "3 2 1 1", {1, 2, 3, 4, 5, 6},
                            "kinds: RGB-color space space space\n");
    const ViewedScene s(kFileVolume, "4.0", folder / "");
    EXPECT_EQ(s.drawn.volumes.at(0).voxels->components, 3);
    EXPECT_EQ(texelsOf(*s.drawn.volumes[0].voxels), (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
}

TEST(VolumeNodes, voxelsThatAProgramHasReadAreNotReadAgain)
{
    const ScratchFolder folder;
    writeNrrd<std::int16_t>(folder / "v.nrrd", "short", "2 1 1", {1, 2});
    ViewedScene s("<VolumeData><ImageTexture3D DEF='F' url='\"v.nrrd\"'/></VolumeData>", "4.0", folder / "");
    Node& file = *s.scene.names.at("F");
    const auto read = [&](ChannelType type, int channels, int components, std::vector<std::uint8_t> bytes) {
        ReadVoxels voxels{{2, 1, 1}, channels, components, type, {}, file.revision()};
        for (const std::uint8_t byte : bytes)
            voxels.bytes.push_back(std::byte{byte});
        s.scene.readVoxels[&file] = std::make_shared<ReadVoxels>(std::move(voxels));
    };
    const auto texels = [&] {
        SceneView view(s.scene);
        return texelsOf(*view.styledScene({}).volumes.at(0).voxels);
    };
    using Bytes = std::vector<std::uint8_t>;
    const Bytes ofFile{0, 0, 255, 255};
    read(ChannelType::uint8, 4, 3, {1, 2, 3, 0, 4, 5, 6, 0});
    EXPECT_EQ(texels(), (Bytes{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(texels(), ofFile) << "of another view";
    read(ChannelType::int8, 1, 1, {0x80, 0x7f});
    EXPECT_EQ(texels(), (Bytes{0, 255}));
    read(ChannelType::uint8, 1, 1, {7, 8});
    file.put(file.field("url")->slot, std::vector<std::string>{"v.nrrd"});
    EXPECT_EQ(texels(), ofFile) << "of another url";
    EXPECT_EQ(s.messages(), "");
}

TEST(VolumeNodes, filesThatAreNotThereAreToldOfOnce)
{
    const ScratchFolder folder;
    ViewedScene s(kFileVolume, "4.0", folder / "");
    s.draw();
    EXPECT_TRUE(s.drawn.volumes.empty());
    EXPECT_EQ(s.messages(), "s.x3d:3: error: ImageTexture3D: \"v.nrrd\": no such file\n");
    std::ofstream(folder / "v.nrrd")
        << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\nabc";
    const ViewedScene cut(kFileVolume, "4.0", folder / "");
    EXPECT_TRUE(cut.drawn.volumes.empty());
    EXPECT_NE(cut.messages().find("s.x3d:3: error: ImageTexture3D: "), std::string::npos);
}

TEST(VolumeNodes, filesLargerThanHalfTheMemoryAreRefused)
{
    const ScratchFolder folder;
    const std::uint64_t slices = mostTextureBytes() / (std::uint64_t(1) << 20) + 1;
    const std::string sizes = "1024 1024 " + std::to_string(slices);
    writeNrrd<std::uint8_t>(folder / "v.nrrd", "uchar", sizes, {});
    std::error_code error;
    std::filesystem::resize_file(folder / "v.nrrd", (slices + 1) << 20, error);
    if (error) GTEST_SKIP() << "the file system has no files with holes of this size: " << error.message();
    const ViewedScene s(kFileVolume, "4.0", folder / "");
    EXPECT_TRUE(s.drawn.volumes.empty());
    EXPECT_NE(s.messages().find(" bytes, half of the memory, found 1024 x 1024 x " + std::to_string(slices)),
              std::string::npos)
        << s.messages();
}

TEST(VolumeNodes, partsOfTexturesThatChangeAreLetGo)
{
    ViewedScene s(
        "<SegmentedVolumeData><PixelTexture3D DEF='P' containerField='segmentedVoxels' image='2 1 1 1 0'/>"
        "</SegmentedVolumeData>",
        "3.0");
    const std::weak_ptr<const VoxelTexture> first = s.drawn.volumes.at(0).voxels;
    Node& node = *s.scene.names.at("P");
    for (const std::int32_t value : {0x100, 0x200}) {
        node.put(node.field("image")->slot, std::vector<std::int32_t>{2, 1, 1, 1, value});
        s.draw();
        EXPECT_EQ(texelsOf(*s.drawn.volumes.at(0).voxels),
                  (std::vector<std::uint8_t>{std::uint8_t(value >> 8)}));
    }
    EXPECT_TRUE(first.expired());
}

TEST(VolumeNodes, theFirstUrlThatCanBeReadIsTaken)
{
    const ScratchFolder folder;
    writeNrrd<std::uint8_t>(folder / "v.nrrd", "uchar", "1 1 1", {9});
    const ViewedScene s(
        "<VolumeData><ImageTexture3D url='\"http://example.org/a.nrrd\" \"none.nrrd\" \"v.nrrd\"'/>"
        "</VolumeData>",
        "4.0", folder / "");
    EXPECT_EQ(s.drawn.volumes.size(), 1u);
    EXPECT_EQ(s.messages(), "");
}

TEST(VolumeNodes, picturesHaveTheirBottomRowFirst)
{
    const ScratchFolder folder;
    // The top row is red and green, the bottom row blue and white.
    const std::vector<std::uint8_t> rgb{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
    ASSERT_TRUE(writePng(folder / "p.png", 2, 2, 3, rgb));
    const ViewedScene s(
        "<VolumeData><ComposedTexture3D><ImageTexture url='\"p.png\"'/></ComposedTexture3D></VolumeData>",
        "4.0", folder / "");
    EXPECT_EQ(texelsOf(*s.drawn.volumes.at(0).voxels),
              (std::vector<std::uint8_t>{0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255, 0}));
}

TEST(VolumeNodes, pictureInImageTexture3DIsOneSliceInTheFilesOrder)
{
    const ScratchFolder folder;
    const std::vector<std::uint8_t> rgb{255, 0, 0, 0, 0, 255};
    ASSERT_TRUE(writePng(folder / "p.png", 1, 2, 3, rgb));
    const ViewedScene s("<VolumeData><ImageTexture3D url='\"p.png\"'/></VolumeData>", "4.0", folder / "");
    EXPECT_EQ(texelsOf(*s.drawn.volumes.at(0).voxels), rgb);
    EXPECT_EQ(s.drawn.volumes[0].voxels->size, (VoxelSize{1, 2, 1}));
}

const std::string kEdge = "<EdgeEnhancementVolumeStyle/>";

TEST(VolumeNodes, segmentsOfIsoAreTheRedOfTheirIdentifiers)
{
    const ViewedScene s("<SegmentedVolumeData segmentEnabled='true false'>" + pixels("1 4 1 1 0 0 0 0") +
                        pixels("3 4 1 1 0x000102 0x010000 0x020000 0x030000", "segmentIdentifiers") + kEdge +
                        kEdge + "<BoundaryEnhancementVolumeStyle enabled='false'/></SegmentedVolumeData>");
    const StyledVolume& volume = s.drawn.volumes.at(0);
    ASSERT_TRUE(volume.segments);
    EXPECT_EQ(volume.segments->component, 0);
    const int first = chainAt(volume, 0), third = chainAt(volume, 3);
    ASSERT_GE(first, 0);
    EXPECT_EQ(volume.chains.at(static_cast<std::size_t>(first)).size(), 1u);
    EXPECT_EQ(chainAt(volume, 1), -1);
    EXPECT_EQ(chainAt(volume, 2), -1);
    EXPECT_EQ(third, volume.segments->beyond);
    EXPECT_NE(third, first);
}

/// A volume of two voxels, whose second style is clear; its identifiers, if any, in line 3.
std::string twoStyles(const std::string& attributes, const std::string& identifiers)
{
    return "<SegmentedVolumeData" + attributes + ">" + pixels("1 2 1 1 9 9") + "\n" + identifiers +
           opacityMap("1 1 4 0xFF000080") + opacityMap("1 1 4 0") + "</SegmentedVolumeData>";
}

/// Red and half opaque, as the first of twoStyles() makes every voxel.
void expectFirstStyle(const ViewedScene& s)
{
    const StyledVolume& volume = s.drawn.volumes.at(0);
    EXPECT_FALSE(volume.segments);
    ASSERT_EQ(volume.chains.size(), 1u);
    ASSERT_EQ(volume.chains[0].size(), 1u);
    SampleBatch samples;
    samples.count = 1;
    volume.chains[0][0]->apply({}, samples);
    EXPECT_FLOAT_EQ(samples.Cv[0][0], 1.0f);
    EXPECT_FLOAT_EQ(samples.Cv[1][0], 0.0f);
    EXPECT_FLOAT_EQ(samples.Ov[0], 128 / 255.0f);
}

const std::string kShortIdentifiers = pixels("1 1 1 1 1", "segmentIdentifiers");

TEST(VolumeNodes, identifiersOfAnotherSizeAreIgnored)
{
    const ViewedScene s(twoStyles("", kShortIdentifiers));
    expectFirstStyle(s);
    EXPECT_EQ(s.messages(),
              "s.x3d:3: warning: PixelTexture3D: expected segmentIdentifiers of the voxels' size, 2 x 1 x 1, "
              "found 1 x 1 x 1: ignored, every voxel is of segment 0\n");
}

TEST(VolumeNodes, withoutIdentifiersEveryVoxelIsOfSegment0)
{
    const std::string told =
        "s.x3d:2: warning: SegmentedVolumeData has no segmentIdentifiers: every voxel is of segment 0\n";
    const ViewedScene s(twoStyles("", ""));
    expectFirstStyle(s);
    EXPECT_EQ(s.messages(), told);
    const ViewedScene second(twoStyles(" segmentEnabled='true false'", ""));
    expectFirstStyle(second);
    const ViewedScene off(twoStyles(" segmentEnabled='false true'", ""));
    EXPECT_TRUE(off.drawn.volumes.empty());
    EXPECT_EQ(off.messages(), told);
    const ViewedScene plain("<SegmentedVolumeData>" + pixels("1 2 1 1 9 9") + "</SegmentedVolumeData>");
    EXPECT_EQ(plain.drawn.volumes.at(0).chains.size(), 1u);
}

TEST(VolumeNodes, identifiersOfAnotherSizeAreNamedByTheirFile)
{
    const ScratchFolder folder;
    ASSERT_TRUE(
        writeTiffStack(folder / "a.tif", {{1, 3, 1}, 1, ChannelType::uint8}, std::vector<std::byte>(3)));
    const ViewedScene s("<SegmentedVolumeData>" + pixels("1 2 1 1 9 9") +
                            "\n<ImageTexture3D containerField='segmentIdentifiers' url='\"a.tif\"'/>"
                            "</SegmentedVolumeData>",
                        "4.0", folder / "");
    EXPECT_EQ(s.messages(),
              "s.x3d:3: warning: ImageTexture3D \"a.tif\": expected segmentIdentifiers of the "
              "voxels' size, 2 x 1 x 1, found 1 x 3 x 1: ignored, every voxel is of segment 0\n");
}

/// What is told of a volume of which nothing is seen, behind its line.
void expectEmpty(const std::string& nodes, const std::string& told, const std::string& version = "4.0")
{
    const ViewedScene s(nodes, version);
    EXPECT_EQ(s.messages(), told.empty() ? "" : "s.x3d:2: warning: " + told + ": nothing of it is seen\n")
        << nodes;
}

TEST(VolumeNodes, valuesThatNoSurfaceMeetsAreToldOf)
{
    const auto surfaces = [](const std::string& values, const std::string& image) {
        return "<IsoSurfaceVolumeData surfaceValues='" + values + "'>" + pixels(image) +
               "</IsoSurfaceVolumeData>";
    };
    // 51 and 102 of 255 are 0.2 and 0.4. What meets a value has voxels below it, and up to it.
    const std::string begin = "IsoSurfaceVolumeData: expected voxels below and above a surface's value (";
    expectEmpty(surfaces("0.5", "1 2 1 1 51 102"), begin + "0.5), found 0.2 to 0.4");
    expectEmpty(surfaces("0.5 0.1", "1 2 1 1 51 102"), begin + "0.1 0.5), found 0.2 to 0.4");
    expectEmpty(surfaces("0.2", "1 2 1 1 51 102"), begin + "0.2), found 0.2 to 0.4");
    expectEmpty(surfaces("0.2", "1 1 1 1 51"), begin + "0.2), found 0.2 alone");
    expectEmpty(surfaces("0.4", "1 2 1 1 51 102"), "");
    expectEmpty(surfaces("0.9 0.3", "1 2 1 1 51 102"), "");
    // Only the last of many voxels is above.
    std::string many = "1 1000 1 1";
    for (int i = 0; i < 999; ++i)
        many += " 51";
    expectEmpty(surfaces("0.3", many + " 102"), "");
    expectEmpty(surfaces("0.3", many + " 51"), begin + "0.3), found 0.2 alone");
}

TEST(VolumeNodes, stylesThatMakeAllClearAreToldOf)
{
    const auto mapped = [](const std::string& image, const std::string& function) {
        return "<VolumeData>" + pixels(image) + (function.empty() ? "" : opacityMap(function)) +
               "</VolumeData>";
    };
    const std::string begin = "VolumeData: expected values that its style shows, found voxels of ";
    // Of eight texels the last four are opaque, which begins to show in the middle of the fourth, at 7/16.
    const std::string late = "8 1 4 0 0 0 0 0xFF 0xFF 0xFF 0xFF";
    expectEmpty(mapped("1 2 1 1 0 51", late), begin + "0 to 0.2, which it makes clear");
    expectEmpty(mapped("1 2 1 1 51 51", late), begin + "0.2 alone, which it makes clear");
    expectEmpty(mapped("1 2 1 1 0 128", late), "");
    expectEmpty(mapped("1 2 1 1 0 0", ""), begin + "0 alone, which it makes clear");
    expectEmpty(mapped("1 2 1 1 0 1", ""), "");
    // Without a function the voxel's own opacity is what later styles change.
    const auto cartoon = [](const std::string& image) {
        return "<VolumeData>" + pixels(image) + "<CartoonVolumeStyle/></VolumeData>";
    };
    expectEmpty(cartoon("1 2 1 1 0 0"), begin + "0 alone, which it makes clear");
    expectEmpty(cartoon("1 2 1 1 0 9"), "");
}

TEST(VolumeNodes, opacitiesThatAreClearAreToldOf)
{
    const auto volume = [](const std::string& image, const std::string& style = "") {
        return "<VolumeData>" + pixels(image) + style + "</VolumeData>";
    };
    const std::string begin =
        "VolumeData: expected opacities that its style shows, found voxels of the opacity ";
    const std::string clear = begin + "0 alone, which it makes clear";
    const std::string table = opacityMap("1 1 3 0xFFFFFF");
    expectEmpty(volume("2 2 1 1 0xFF00 0xFF00"), clear);
    expectEmpty(volume("2 2 1 1 0xFF00 0xFF01"), "");
    expectEmpty(volume("2 2 1 1 0xFF00 0xFF00", table), ""); // whose opacity is that of the table alone
    expectEmpty(volume("3 2 1 1 0 0"), clear);
    expectEmpty(volume("3 2 1 1 0 1"), "");
    expectEmpty(volume("3 2 1 1 0 0x010000"), "");
    expectEmpty(volume("4 2 1 1 0xFFFFFF00 0xFFFFFF00"), clear);
    expectEmpty(volume("4 2 1 1 0xFFFFFF00 0xFFFFFF00", table), clear);
    expectEmpty(volume("4 2 1 1 0xFFFFFF00 0x00000001", table), "");
    expectEmpty(volume("4 2 1 1 0xFFFFFF00 0xFFFFFF00", "<CartoonVolumeStyle/>"), clear);
    const std::string inverse =
        begin + "1 alone, which it makes clear by 1 - opacity, as the proposal of 2005 has it";
    expectEmpty(volume("4 2 1 1 0x123456FF 0x123456FF"), inverse, "3.0");
    expectEmpty(volume("4 2 1 1 0x123456FF 0x123456FE"), "", "3.0");
    expectEmpty(volume("4 2 1 1 0xFFFFFF00 0xFFFFFF00"), "", "3.0");
    expectEmpty(volume("4 2 1 1 0x123456FF 0x123456FF", table), "", "3.0");
    expectEmpty(volume("3 1 1 1 0xFFFFFF"), inverse, "3.0");
    expectEmpty(volume("3 1 1 1 0xFFFEFF"), "", "3.0");
}

TEST(VolumeNodes, segmentsThatAreAllClearAreToldOf)
{
    const auto volume = [](const std::string& image) {
        return "<SegmentedVolumeData>" + pixels(image) + pixels("1 2 1 1 0 1", "segmentIdentifiers") + kEdge +
               "<CartoonVolumeStyle/></SegmentedVolumeData>";
    };
    const std::string begin = "SegmentedVolumeData: expected ";
    expectEmpty(
        volume("4 2 1 1 0xFF000000 0xFF000000"),
        begin + "opacities that its style shows, found voxels of the opacity 0 alone, which it makes clear");
    expectEmpty(volume("4 2 1 1 0xFF000000 0xFF000001"), "");
    expectEmpty(volume("1 2 1 1 0 0"),
                begin + "values that its style shows, found voxels of 0 alone, which it makes clear");
    expectEmpty(volume("1 2 1 1 0 1"), "");
}

TEST(VolumeNodes, segmentsOf2005AreTheLastComponent)
{
    const auto volumeOf = [](const std::string& image) {
        const ViewedScene s("<SegmentedVolumeData segmentEnabled='true false'>" +
                                pixels(image, "segmentedVoxels") + kEdge + "</SegmentedVolumeData>",
                            "3.0");
        EXPECT_EQ(s.messages(), "");
        return s.drawn.volumes.at(0);
    };
    using Bytes = std::vector<std::uint8_t>;
    const StyledVolume two = volumeOf("2 2 1 1 0x7000 0x7101");
    EXPECT_EQ(texelsOf(*two.voxels), (Bytes{0x70, 0x71}));
    EXPECT_GE(chainAt(two, 0), 0);
    EXPECT_EQ(chainAt(two, 1), -1);
    const StyledVolume three = volumeOf("3 2 1 1 0x708000 0x718101");
    EXPECT_EQ(texelsOf(*three.voxels), (Bytes{0x70, 0x80, 0x71, 0x81}));
    EXPECT_EQ(chainAt(three, 1), -1);
    const StyledVolume four = volumeOf("4 2 1 1 0x70809001 0x71819102");
    EXPECT_EQ(texelsOf(*four.voxels), (Bytes{0x70, 0x80, 0x90, 0x71, 0x81, 0x91}));
    EXPECT_EQ(chainAt(four, 0), -1);
    EXPECT_EQ(chainAt(four, 1), four.segments->beyond);
}

TEST(VolumeNodes, oneComponentOf2005IsNotDrawn)
{
    const ViewedScene s(
        "<SegmentedVolumeData>" + pixels("1 1 1 1 0", "segmentedVoxels") + "</SegmentedVolumeData>", "3.0");
    EXPECT_TRUE(s.drawn.volumes.empty());
    EXPECT_EQ(
        s.messages(),
        "s.x3d:2: warning: expected 2, 3 or 4 components in segmentedVoxels, found 1: nothing is drawn\n");
}

/// As many segments as ids; every odd one is off. A file of one type has them all in a row.
template <class Number>
void expectSegments(const std::string& type, int count)
{
    const ScratchFolder folder;
    std::vector<Number> ids;
    std::vector<std::uint8_t> values(static_cast<std::size_t>(count), 9);
    std::string enabled;
    for (int id = 0; id < count; ++id) {
        ids.push_back(static_cast<Number>(id));
        enabled += id % 2 ? "false " : "true ";
    }
    const std::string sizes = std::to_string(count) + " 1 1";
    writeNrrd(folder / "v.nrrd", "uchar", sizes, values);
    writeNrrd(folder / "i.nrrd", type, sizes, ids);
    const ViewedScene s(
        "<SegmentedVolumeData segmentEnabled='" + enabled +
            "'><ImageTexture3D url='\"v.nrrd\"'/><ImageTexture3D containerField='segmentIdentifiers' "
            "url='\"i.nrrd\"'/></SegmentedVolumeData>",
        "4.0", folder / "");
    EXPECT_EQ(s.messages(), "");
    ASSERT_TRUE(s.drawn.volumes.at(0).segments);
    for (int id = 0; id < count; ++id)
        EXPECT_EQ(chainAt(s.drawn.volumes[0], static_cast<std::size_t>(id)) < 0, id % 2 == 1) << id;
}

TEST(VolumeNodes, numbersOfSegmentsAreThoseOfTheFile)
{
    for (const int count : {3, 255})
        expectSegments<std::uint8_t>("uchar", count);
    for (const int count : {3, 255, 725}) {
        expectSegments<std::uint16_t>("ushort", count);
        expectSegments<std::int16_t>("short", count);
        expectSegments<float>("float", count);
    }
}

TEST(VolumeNodes, numbersOfSegmentsOf2005AreThoseOfTheFile)
{
    const ScratchFolder folder;
    writeNrrd<std::uint16_t>(folder / "v.nrrd", "ushort", "2 3 1 1", {100, 0, 200, 1, 300, 724});
    std::string enabled;
    for (int id = 0; id < 725; ++id)
        enabled += id == 724 ? "false " : "true ";
    const ViewedScene s("<SegmentedVolumeData segmentEnabled='" + enabled +
                            "'><ImageTexture3D url='\"v.nrrd\"'/></SegmentedVolumeData>",
                        "3.0", folder / "");
    const StyledVolume& volume = s.drawn.volumes.at(0);
    EXPECT_EQ(texelsOf<std::uint16_t>(*volume.voxels), (std::vector<std::uint16_t>{100, 200, 300}));
    EXPECT_GE(chainAt(volume, 1), 0);
    EXPECT_EQ(chainAt(volume, 2), -1);
}

std::string isoVolume(const std::string& attributes, const std::string& styles = "")
{
    return "<IsoSurfaceVolumeData " + attributes + ">" + pixels("1 3 1 1 51 153 204") + styles +
           "</IsoSurfaceVolumeData>";
}

TEST(VolumeNodes, surfacesAreThoseThatAreListed)
{
    const ViewedScene s(isoVolume(
        "surfaceValues='0.5 0.25 0.75' contourStepSize='0.1' surfaceTolerance='0.125'",
        "<OpacityMapVolumeStyle/><ComposedVolumeStyle>" + kEdge + kEdge + "</ComposedVolumeStyle>"));
    const IsoSurfaces& surfaces = *s.drawn.volumes.at(0).surfaces;
    EXPECT_EQ(surfaces.values, (std::vector<float>{0.25f, 0.5f, 0.75f}));
    EXPECT_EQ(surfaces.surfaceTolerance, 0.125f);
    ASSERT_EQ(surfaces.chains.size(), 3u);
    // Each is solid first.
    EXPECT_EQ(surfaces.chains[0].size(), 3u);
    EXPECT_EQ(surfaces.chains[1].size(), 2u);
    EXPECT_EQ(surfaces.chains[2].size(), 3u);
}

TEST(VolumeNodes, surfacesAreSolidBeforeTheirStyles)
{
    for (const char* const styles : {"", "<ShadedVolumeStyle lighting='true'/>"}) {
        const ViewedScene s(isoVolume("surfaceValues='0.25'", styles));
        SampleBatch samples{};
        samples.count = 1;
        samples.voxel[0].fill(0.25f);
        firstColor(1, samples);
        for (const auto& style : s.drawn.volumes.at(0).surfaces->chains.at(0))
            style->apply({}, samples);
        EXPECT_EQ(samples.Ov[0], 1.0f) << styles;
    }
}

TEST(VolumeNodes, stepsFillTheRangeOfTheVoxels)
{
    std::string styles, edges;
    for (int i = 0; i < 5; ++i) {
        edges += kEdge;
        styles += "<ComposedVolumeStyle>" + edges + "</ComposedVolumeStyle>";
    }
    const ViewedScene s(isoVolume("surfaceValues='0.5' contourStepSize='0.125'", styles));
    const IsoSurfaces& surfaces = *s.drawn.volumes.at(0).surfaces;
    // The voxels are from 0.2 to 0.8.
    EXPECT_EQ(surfaces.values, (std::vector<float>{0.25f, 0.375f, 0.5f, 0.625f, 0.75f}));
    std::vector<std::size_t> lengths;
    for (const StyleChain& chain : surfaces.chains)
        lengths.push_back(chain.size());
    EXPECT_EQ(lengths, (std::vector<std::size_t>{3, 4, 2, 5, 6}));
}

TEST(VolumeNodes, tinyStepsAreLimited)
{
    const ViewedScene s(isoVolume("surfaceValues='0.5' contourStepSize='1e-30'"));
    EXPECT_EQ(s.drawn.volumes.at(0).surfaces->values, std::vector<float>{0.5f});
    EXPECT_EQ(s.messages(),
              "s.x3d:2: warning: expected at most 256 surfaces by contourStepSize, found more: the "
              "step is left out\n");
}

TEST(VolumeNodes, surfacesWithoutValuesOrWithoutStylesThatAreOnAreNotDrawn)
{
    EXPECT_TRUE(ViewedScene(isoVolume("")).drawn.volumes.empty());
    EXPECT_TRUE(ViewedScene(isoVolume("surfaceValues='0.5'", "<OpacityMapVolumeStyle enabled='false'/>"))
                    .drawn.volumes.empty());
}

TEST(VolumeNodes, gradientsAreTheNormalsOfSurfaces)
{
    const ViewedScene s(isoVolume("surfaceValues='0.5'", pixels("3 3 1 1 0 0 0", "gradients")));
    EXPECT_TRUE(s.drawn.volumes.at(0).surfaces->gradients);
    EXPECT_EQ(s.messages(), "");
}

} // namespace
} // namespace vo
