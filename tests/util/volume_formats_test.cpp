// NRRD, NIfTI, MetaImage, DICOM and PNG: files made here byte by byte and read back.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <zlib.h>

#include "foreign_volumes.h"
#include "scratch_folder.h"

namespace vo {
namespace {

constexpr std::pair<ChannelType, int> kNiftiTypes[] = {{ChannelType::uint8, 2},
                                                       {ChannelType::int8, 256},
                                                       {ChannelType::uint16, 512},
                                                       {ChannelType::int16, 4},
                                                       {ChannelType::float32, 16}};

std::string gzipped(const std::string& bytes, int windowBits = 15 + 16)
{
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
    std::string out(compressBound(static_cast<uLong>(bytes.size())) + 100, '\0');
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

std::string vectorText(const std::array<double, 3>& v, const char* between)
{
    char text[120];
    std::snprintf(text, sizeof text, "%.17g%s%.17g%s%.17g", v[0], between, v[1], between, v[2]);
    return text;
}

class VolumeFormats : public testing::Test
{
protected:
    /// Writes bytes under this name; the path.
    std::string file(const std::string& name, const std::string& bytes)
    {
        writeFile(folder_ / name, bytes);
        return folder_ / name;
    }
    VolumeDescription description(const std::string& path)
    {
        const auto volume = openVolume(path);
        EXPECT_TRUE(volume) << volume.failure().text;
        return volume ? volume->description() : VolumeDescription();
    }

    ScratchFolder folder_;
    const VolumeTruth truth_{{{5, 4, 3}, 1, ChannelType::int16}};
    const std::array<double, 3> spacing_{0.5, 1.25, 3};
};

std::string sizesText(const std::array<std::int64_t, 3>& size)
{
    return std::to_string(size[0]) + " " + std::to_string(size[1]) + " " + std::to_string(size[2]);
}

NiftiFile niftiOf(const VolumeTruth& truth, const AxisOrder& order, const std::array<double, 3>& spacing)
{
    NiftiFile nifti;
    const auto size = order.sizeInFile(truth.info().size);
    nifti.dim.assign(size.begin(), size.end());
    for (const auto& [type, code] : kNiftiTypes)
        if (type == truth.info().type) nifti.datatype = code;
    nifti.bits = 8 * bytesPerChannel(truth.info().type);
    for (int i = 0; i < 3; ++i)
        nifti.steps[std::size_t(i)] = order.step(i, spacing);
    return nifti;
}

// --- NIfTI

TEST_F(VolumeFormats, niftiOfEveryTypeVersionAndByteOrderIsRead)
{
    for (const auto& [type, code] : kNiftiTypes)
        for (const int version : {1, 2})
            for (const bool big : {false, true}) {
                const VolumeTruth truth({{7, 5, 3}, 1, type});
                NiftiFile nifti = niftiOf(truth, {}, spacing_);
                nifti.version = version;
                nifti.bigEndian = big;
                const std::string bytes = nifti.header() + voxelsInFile(truth, {}, big);
                expectVoxels(file("a.nii", bytes), truth);
                expectVoxels(file("a.nii.gz", gzipped(bytes)), truth);
                EXPECT_EQ(description(folder_ / "a.nii").format, "NIfTI-" + std::to_string(version));
            }
}

TEST_F(VolumeFormats, everyAxisOrderOfNiftiArrivesAsRightFrontUp)
{
    for (const AxisOrder& order : allAxisOrders()) {
        const NiftiFile nifti = niftiOf(truth_, order, spacing_);
        const std::string path = file("a.nii", nifti.header() + voxelsInFile(truth_, order, false));
        expectVoxels(path, truth_);
        const auto about = description(path);
        EXPECT_TRUE(about.orientation.known);
        EXPECT_TRUE(about.spacingKnown);
        EXPECT_NEAR(about.orientation.obliqueDegrees, 0, 1e-6);
        for (std::size_t a = 0; a < 3; ++a) {
            EXPECT_NEAR(about.spacing[a], spacing_[a], 1e-6);
            EXPECT_EQ(about.orientation.fileAxes[std::size_t(order.fileAxis[a])],
                      (order.reversed[a] ? "LPI" : "RAS")[a]);
        }
    }
}

TEST_F(VolumeFormats, niftiQuaternionTurnsToo)
{
    // Half a turn about z: x to the left, y to the back; qfac -1: z down.
    NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    nifti.sform = 0;
    nifti.qform = 1;
    nifti.quaternion = {0, 0, 1};
    nifti.qfac = -1;
    nifti.pixdim = spacing_;
    const AxisOrder order{{0, 1, 2}, {true, true, true}};
    const auto path = file("a.nii", nifti.header() + voxelsInFile(truth_, order, false));
    expectVoxels(path, truth_);
    EXPECT_EQ(description(path).orientation.fileAxes, "LPI");
}

TEST_F(VolumeFormats, obliqueNiftiGoesToTheNearestAxesAndSaysHowFar)
{
    NiftiFile nifti = niftiOf(truth_, {}, {1, 1, 1});
    const double angle = 20 * std::acos(-1.0) / 180;
    nifti.steps = {
        {{-std::cos(angle), std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}};
    const AxisOrder order{{0, 1, 2}, {true, false, false}};
    const auto path = file("a.nii", nifti.header() + voxelsInFile(truth_, order, false));
    expectVoxels(path, truth_);
    const auto about = description(path);
    EXPECT_EQ(about.orientation.fileAxes, "LAS");
    EXPECT_NEAR(about.orientation.obliqueDegrees, 20, 1e-4);
    EXPECT_NEAR(about.orientation.direction[0][0], std::cos(angle), 1e-6);
    EXPECT_NEAR(about.orientation.direction[0][1], -std::sin(angle), 1e-6);
}

TEST_F(VolumeFormats, niftiWithoutTransformationKeepsTheOrderOfTheFile)
{
    NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    nifti.sform = 0;
    nifti.pixdim = {2, 3, 4};
    nifti.units = 3; // micrometres
    const auto path = file("a.nii", nifti.header() + voxelsInFile(truth_, {}, false));
    expectVoxels(path, truth_);
    const auto about = description(path);
    EXPECT_FALSE(about.orientation.known);
    EXPECT_NEAR(about.spacing[1], 0.003, 1e-9);
    nifti.sform = 1;
    nifti.steps = {}; // no transformation of space
    const auto flat = description(file("b.nii", nifti.header() + voxelsInFile(truth_, {}, false)));
    EXPECT_FALSE(flat.orientation.known);
    EXPECT_EQ(flat.notes.size(), 1u);
}

TEST_F(VolumeFormats, niftiScaleIsToldNotApplied)
{
    NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    nifti.slope = 0.25;
    nifti.intercept = -3;
    const auto path = file("a.nii", nifti.header() + voxelsInFile(truth_, {}, false));
    expectVoxels(path, truth_);
    EXPECT_EQ(description(path).slope, 0.25);
    EXPECT_EQ(description(path).intercept, -3);
    nifti.slope = 0; // none
    EXPECT_EQ(description(file("a.nii", nifti.header() + voxelsInFile(truth_, {}, false))).slope, 1);
}

TEST_F(VolumeFormats, niftiPairIsReadByEitherName)
{
    NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    nifti.pair = true;
    nifti.offset = 10;
    file("a.hdr", nifti.header());
    file("a.img", std::string(10, 'x') + voxelsInFile(truth_, {}, false));
    expectVoxels(folder_ / "a.hdr", truth_);
    expectVoxels(folder_ / "a.img", truth_);
    file("b.hdr.gz", gzipped(nifti.header()));
    file("b.img.gz", gzipped(std::string(10, 'x') + voxelsInFile(truth_, {}, false)));
    expectVoxels(folder_ / "b.hdr.gz", truth_);
    expectVoxels(folder_ / "b.img.gz", truth_);
    std::filesystem::remove(folder_ / "a.img");
    expectSays(failureOfReading(folder_ / "a.hdr"), {"a.img: cannot open"});
}

TEST_F(VolumeFormats, niftiColoursAndVectorsBecomeChannels)
{
    const VolumeTruth colour({{5, 4, 3}, 4, ChannelType::uint8});
    NiftiFile nifti = niftiOf(colour, {}, spacing_);
    nifti.datatype = 2304;
    nifti.bits = 32;
    expectVoxels(file("rgba.nii", nifti.header() + voxelsInFile(colour, {}, false)), colour);
    nifti.datatype = 2;
    nifti.bits = 8;
    nifti.dim = {5, 4, 3, 1, 4};
    expectVoxels(file("planes.nii", nifti.header() + voxelsInFile(colour, {}, false, 4, true)), colour);
    nifti.dim = {5, 4, 3, 4};
    nifti.intent = 1007; // a vector
    expectVoxels(file("fourth.nii", nifti.header() + voxelsInFile(colour, {}, false, 4, true)), colour);
    EXPECT_FALSE(description(folder_ / "fourth.nii").alphaAdded);

    for (const bool planar : {false, true}) {
        nifti.dim = planar ? std::vector<std::int64_t>{5, 4, 3, 1, 3} : std::vector<std::int64_t>{5, 4, 3};
        nifti.datatype = planar ? 2 : 128;
        auto volume =
            openVolume(file("rgb.nii", nifti.header() + voxelsInFile(colour, {}, false, 3, planar)));
        ASSERT_TRUE(volume) << volume.failure().text;
        auto expected = colour.whole();
        for (std::size_t i = 3; i < expected.size(); i += 4)
            expected[i] = std::byte{255};
        EXPECT_TRUE(readBrick(*volume, {{0, 0, 0}, {5, 4, 3}}) == expected);
        EXPECT_TRUE(volume->description().alphaAdded);
    }
}

TEST_F(VolumeFormats, ofSeveralNiftiVolumesTheFirstIsReadAndTheOthersAreTold)
{
    NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    nifti.dim = {5, 4, 3, 3};
    const auto path =
        file("a.nii", nifti.header() + voxelsInFile(truth_, {}, false) + std::string(2 * 120, 'x'));
    expectVoxels(path, truth_);
    const auto about = description(path);
    ASSERT_EQ(about.notes.size(), 1u);
    expectSays(about.notes[0], {"first of 3 volumes"});
}

template <class Number>
void expectFloats(const std::string& path, const std::vector<Number>& numbers, const char* type)
{
    auto volume = openVolume(path);
    ASSERT_TRUE(volume) << volume.failure().text;
    ASSERT_EQ(volume->info().type, ChannelType::float32);
    const auto bytes = readBrick(*volume, {{0, 0, 0}, volume->info().size});
    std::vector<float> found(bytes.size() / 4);
    std::memcpy(found.data(), bytes.data(), bytes.size());
    ASSERT_EQ(found.size(), numbers.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i], static_cast<float>(numbers[i]));
    ASSERT_FALSE(volume->description().notes.empty());
    expectSays(volume->description().notes.back(), {type, "converted to float32"});
}

template <class Number>
std::string bigEndianBytes(const std::vector<Number>& numbers)
{
    FileBytes bytes(true);
    for (const Number number : numbers)
        bytes.put(number);
    return bytes.text;
}

TEST_F(VolumeFormats, numbersThatVolumesDoNotHaveBecomeFloats)
{
    NiftiFile nifti;
    nifti.bigEndian = true;
    nifti.dim = {2, 1, 2};
    const auto test = [&](int code, const char* name, const auto& numbers) {
        nifti.datatype = code;
        expectFloats(file("a.nii", nifti.header() + bigEndianBytes(numbers)), numbers, name);
    };
    nifti.sform = 0;
    test(8, "int32", std::vector<std::int32_t>{-5, 0, 123456789, INT32_MIN});
    test(768, "uint32", std::vector<std::uint32_t>{5, 0, 123456789, UINT32_MAX});
    test(1024, "int64", std::vector<std::int64_t>{-5, 0, 1ll << 40, INT64_MIN});
    test(1280, "uint64", std::vector<std::uint64_t>{5, 0, 1ull << 40, UINT64_MAX});
    test(64, "float64", std::vector<double>{0.1, -1e30, 1 / 3.0, 2.5});
}

TEST_F(VolumeFormats, bricksOfRawFilesReadNoMoreThanTheyNeed)
{
    const VolumeTruth truth({{40, 30, 20}, 1, ChannelType::uint16});
    const NiftiFile nifti = niftiOf(truth, {}, spacing_);
    auto volume = openVolume(file("a.nii", nifti.header() + voxelsInFile(truth, {}, false)));
    ASSERT_TRUE(volume);
    EXPECT_EQ(volume->counters().bytes, 0);
    readBrick(*volume, {{1, 2, 3}, {4, 5, 6}});
    EXPECT_EQ(volume->counters().bytes, 4 * 5 * 6 * 2);
    EXPECT_EQ(volume->counters().slices, 6);
}

TEST_F(VolumeFormats, badNiftiHeadersAreTold)
{
    const auto fails = [&](const NiftiFile& nifti, std::initializer_list<const char*> parts) {
        expectSays(failureOfReading(file("a.nii", nifti.header() + voxelsInFile(truth_, {}, false))), parts);
    };
    const NiftiFile good = niftiOf(truth_, {}, spacing_);
    NiftiFile bad = good;
    bad.dim = {5, -4, 3};
    fails(bad, {"a.nii: expected sizes from 1", "found -4 in dimension 2"});
    bad = good;
    bad.datatype = 1792; // complex
    fails(bad, {"a.nii: expected integers", "found NIfTI data type 1792"});
    bad = good;
    bad.version = 2;
    bad.dim = {1 << 14, 1 << 14, 1 << 12}; // 2^40 voxels
    fails(bad, {"a.nii: cut off: expected 2199023255552 bytes"});
    bad.dim = {1ll << 40, 1, 1};
    fails(bad, {"a.nii: expected sizes from 1 to 2147483647, found 1099511627776"});
    bad.dim = {2147483647, 2147483647, 2147483647};
    fails(bad, {"a.nii: expected a volume of less than 2^63 bytes"});
    bad.dim = {1 << 14, 1 << 14, 1 << 12};
    expectSays(failureOfReading(file("a.nii.gz", gzipped(bad.header()))),
               {"a.nii.gz: expected 2199023255552 bytes of voxels", "which cannot hold them"});
    expectSays(failureOfReading(file("a.nii", "short")), {"a.nii: expected a NIfTI header"});
    const std::string whole = good.header() + voxelsInFile(truth_, {}, false);
    expectSays(failureOfReading(file("a.nii", whole.substr(0, whole.size() - 1))),
               {"a.nii: cut off: expected 120 bytes of voxels at byte 352, found a file of 471 bytes"});
    std::string packed = gzipped(whole);
    packed.resize(packed.size() - 9);
    expectSays(failureOfReading(file("a.nii.gz", packed)), {"a.nii.gz: cut off"});
    packed = gzipped(whole);
    packed[packed.size() - 6] ^= 1; // the checksum
    expectSays(failureOfReading(file("a.nii.gz", packed)), {"a.nii.gz: damaged", "data check"});
    // The same where the checksum lies far behind the voxels.
    const auto more = noise(200'000);
    packed = gzipped(whole + std::string(more.begin(), more.end()));
    EXPECT_EQ(failureOfReading(file("b.nii.gz", packed)), "");
    packed[packed.size() - 6] ^= 1;
    expectSays(failureOfReading(file("b.nii.gz", packed)), {"b.nii.gz: damaged", "data check"});
}

// --- NRRD

std::string nrrdHeader(const VolumeTruth& truth, const AxisOrder& order, const std::string& more,
                       const char* encoding = "raw", const char* sizes = nullptr)
{
    const char* names[] = {"uchar", "int8", "unsigned short", "short", "float"};
    return "NRRD0004\n# comment\ntype: " + std::string(names[int(truth.info().type)]) +
           "\ndimension: " + (sizes ? "4" : "3") +
           "\nsizes: " + (sizes ? sizes : sizesText(order.sizeInFile(truth.info().size)).c_str()) +
           "\nencoding: " + encoding + "\n" + more;
}

TEST_F(VolumeFormats, nrrdOfEveryTypeEncodingAndByteOrderIsRead)
{
    for (const ChannelType type : {ChannelType::uint8, ChannelType::int8, ChannelType::uint16,
                                   ChannelType::int16, ChannelType::float32})
        for (const bool big : {false, true}) {
            const VolumeTruth truth({{7, 5, 3}, 1, type});
            const std::string voxels = voxelsInFile(truth, {}, big);
            const std::string endian = std::string("endian: ") + (big ? "big" : "little") + "\n\n";
            std::string hex;
            for (std::size_t i = 0; i < voxels.size(); ++i) {
                char digits[8];
                std::snprintf(digits, sizeof digits, i % 5 ? "%02x" : "%02X\n",
                              unsigned(static_cast<unsigned char>(voxels[i])));
                hex += digits;
            }
            expectVoxels(file("a.nrrd", nrrdHeader(truth, {}, endian) + voxels), truth);
            expectVoxels(file("a.nrrd", nrrdHeader(truth, {}, endian, "gzip") + gzipped(voxels)), truth);
            expectVoxels(file("a.nrrd", nrrdHeader(truth, {}, endian, "hex") + hex), truth);
        }
}

TEST_F(VolumeFormats, nrrdSizesAreWholeAndAboveNothing)
{
    const std::pair<const char*, const char*> wrong[] = {
        {"sizes: -4 5 3", "expected whole numbers from 1 on, found \"-4\""},
        {"sizes: 4 0 3", "expected whole numbers from 1 on, found \"0\""},
        {"sizes: 4.5 5 3", "expected whole numbers from 1 on, found \"4.5\""},
        {"sizes: four 5 3", "expected whole numbers from 1 on, found \"four\""},
        {"Sizes:\t4 5 99999999999999999999",
         "expected whole numbers from 1 on, found \"99999999999999999999\""},
        {"sizes: 4000000000 4000000000 4000000000",
         "expected fewer than 2^63 numbers in all, found \"4000000000 4000000000 4000000000\""},
    };
    for (const auto& [sizes, said] : wrong)
        expectSays(failureOfReading(file("a.nrrd", std::string("NRRD0004\n# sizes: -1\ntype: uchar\n"
                                                               "dimension: 3\n") +
                                                       sizes + "\nencoding: raw\n\n" + std::string(60, '0'))),
                   {"a.nrrd:5: sizes: ", said});
    expectSays(failureOfReading(file("a.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nencoding: raw\n\n0")),
               {"a.nrrd: expected a line \"sizes: ...\" in the NRRD header, found none"});
}

TEST_F(VolumeFormats, nrrdTextIsRead)
{
    std::string text;
    const auto bytes = truth_.whole();
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        std::int16_t value = 0;
        std::memcpy(&value, &bytes[i], 2);
        text += std::to_string(value) + (i % 6 ? " " : ",\r\n");
    }
    expectVoxels(file("a.nrrd", nrrdHeader(truth_, {}, "\n", "ascii") + text), truth_);
    std::string windows;
    for (const char letter : nrrdHeader(truth_, {}, "\n", "ascii"))
        windows += letter == '\n' ? "\r\n" : std::string(1, letter);
    expectVoxels(file("a.nrrd", windows + text), truth_);
    expectSays(failureOfReading(file("a.nrrd", nrrdHeader(truth_, {}, "\n", "ascii") + text.substr(0, 100))),
               {"a.nrrd: cut off: expected 60 numbers, found"});
    text.replace(10, 3, " x ");
    expectSays(failureOfReading(file("a.nrrd", nrrdHeader(truth_, {}, "\n", "ascii") + text)),
               {"a.nrrd: expected a number of type int16 as voxel value", "found \"x\""});
}

TEST_F(VolumeFormats, everyAxisOrderOfNrrdArrivesAsRightFrontUp)
{
    const std::tuple<const char*, int, int> spaces[] = {{"right-anterior-superior", 1, 1},
                                                        {"left-anterior-superior", -1, 1},
                                                        {"left-posterior-superior", -1, -1}};
    for (const auto& [name, right, front] : spaces)
        for (const AxisOrder& order : allAxisOrders()) {
            std::string directions = "endian: little\nspace: " + std::string(name) + "\nspace directions:";
            for (int i = 0; i < 3; ++i) {
                auto step = order.step(i, spacing_);
                step[0] *= right;
                step[1] *= front;
                directions += " (" + vectorText(step, ",") + ")";
            }
            const auto path = file("a.nrrd", nrrdHeader(truth_, order, directions + "\n\n") +
                                                 voxelsInFile(truth_, order, false));
            expectVoxels(path, truth_);
            EXPECT_EQ(description(path).spacing, spacing_);
            EXPECT_TRUE(description(path).orientation.known);
        }
}

TEST_F(VolumeFormats, nrrdUnitsBecomeMillimetres)
{
    const std::string voxels = voxelsInFile(truth_, {}, false), little = "endian: little\n";
    const auto about = description(file(
        "a.nrrd", nrrdHeader(truth_, {},
                             little + "space: right-anterior-superior\nspace directions: (2,0,0) (0,3,0) "
                                      "(0,0,4)\nspace units: \"um\" \"um\" \"um\"\n\n") +
                      voxels));
    EXPECT_NEAR(about.spacing[2], 0.004, 1e-12);
    const auto plain = description(
        file("b.nrrd",
             nrrdHeader(truth_, {}, little + "spacings: 2 3 4\nunits: \"mm\" \"cm\" \"m\"\n\n") + voxels));
    EXPECT_EQ(plain.spacing, (std::array<double, 3>{2, 30, 4000}));
}

TEST_F(VolumeFormats, nrrdChannelsLeadOrEnd)
{
    const VolumeTruth colour({{5, 4, 3}, 4, ChannelType::uint8});
    const std::string side = voxelsInFile(colour, {}, false),
                      planes = voxelsInFile(colour, {}, false, 4, true);
    for (const char* more :
         {"\n", "kinds: RGBA-color domain domain domain\n\n", "kinds: vector space space space\n\n",
          "space: right-anterior-superior\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n\n"})
        expectVoxels(file("a.nrrd", nrrdHeader(colour, {}, more, "raw", "4 5 4 3") + side), colour);
    expectVoxels(
        file("a.nrrd",
             nrrdHeader(colour, {}, "kinds: domain domain domain vector\n\n", "raw", "5 4 3 4") + planes),
        colour);
    const VolumeTruth two({{5, 4, 3}, 2, ChannelType::uint8});
    expectVoxels(file("a.nrrd", nrrdHeader(two, {}, "\n", "raw", "2 5 4 3") + voxelsInFile(two, {}, false)),
                 two);
    // Of a series in time the first volume is read.
    const VolumeTruth one({{5, 4, 3}, 1, ChannelType::uint8});
    const auto path =
        file("a.nrrd", nrrdHeader(one, {}, "kinds: domain domain domain time\n\n", "raw", "5 4 3 2") +
                           voxelsInFile(one, {}, false) + std::string(60, 'x'));
    expectVoxels(path, one);
    ASSERT_EQ(description(path).notes.size(), 1u);
    expectSays(failureOfReading(file(
                   "a.nrrd", nrrdHeader(one, {}, "kinds: list domain domain domain\n\n", "raw", "5 5 4 3") +
                                 std::string(300, 'x'))),
               {"a.nrrd: expected 1 to 4 channels, found 5"});
}

TEST_F(VolumeFormats, detachedNrrdNamesOneFileOrOneForEachSlice)
{
    const std::string voxels = voxelsInFile(truth_, {}, true), big = "endian: big\n";
    std::filesystem::create_directory(folder_ / "data");
    file("data/all.raw", "line 1\nline 2\n???" + voxels);
    for (int z = 0; z < 3; ++z) {
        const std::string slice = voxels.substr(std::size_t(z) * 40, 40);
        file("slice." + std::to_string(5 - 2 * z), slice);
        file("s00" + std::to_string(z) + ".gz", gzipped("skip" + slice));
    }
    const auto read = [&](const std::string& more, const char* encoding = "raw") {
        expectVoxels(file("a.nhdr", nrrdHeader(truth_, {}, big + more, encoding)), truth_);
    };
    read("line skip: 2\nbyte skip: 3\ndata file: data/all.raw\n");
    read("byte skip: -1\ndatafile: data/all.raw\n");
    read("data file: slice.%d 5 1 -2\n");
    read("data file: slice.%d 5 1 -2 2\n");
    read("data file: LIST\nslice.5\nslice.3\nslice.1\n");
    read("data file: LIST 2\r\nslice.5\r\nslice.3\r\nslice.1\r\n");
    read("byte skip: 4\ndata file: s%03d.gz 0 2 1\n", "gzip");
    read("spacings: 1 2 3\ndata file: " + folder_ / "data/all.raw" + "\nbyte skip: -1\n");

    const auto fails = [&](const std::string& more, std::initializer_list<const char*> parts) {
        expectSays(failureOfReading(file("a.nhdr", nrrdHeader(truth_, {}, big + more))), parts);
    };
    fails("data file: slice.%d 5 3 -2\n", {"slice.5: cut off: expected 60 bytes"});
    fails("data file: slice.%d 1 7 1\n", {"a.nhdr: expected voxels that 7 data files share evenly"});
    fails("data file: none.raw\n", {"none.raw: cannot open"});
    fails("data file: slice.%d 1 5 0\n", {"a.nhdr: expected a range of 1 to"});
    fails("data file: slice.%d 0 999999999 1\n", {"a.nhdr: expected a range of 1 to"});
    fails("byte skip: 10\ndata file: slice.1\n", {"slice.1: cut off"});
    fails("line skip: 9\ndata file: data/all.raw\n", {"all.raw: cut off"});
}

TEST_F(VolumeFormats, badNrrdHeadersAreTold)
{
    const auto fails = [&](const std::string& bytes, std::initializer_list<const char*> parts) {
        expectSays(failureOfReading(file("a.nrrd", bytes)), parts);
    };
    const std::string voxels = voxelsInFile(truth_, {}, false), little = "endian: little\n\n";
    fails(nrrdHeader(truth_, {}, little) + voxels.substr(1), {"a.nrrd: cut off: expected 120 bytes"});
    fails(nrrdHeader(truth_, {}, "\n") + voxels, {"a.nrrd: expected a NRRD header", "endian"});
    fails(nrrdHeader(truth_, {}, "endian: little\n"), {"a.nrrd: expected an empty line before the voxels"});
    fails(
        "NRRD0004\ntype: block\nblock size: 3\ndimension: 3\nsizes: 1 1 1\nendian: big\nencoding: raw\n\nabc",
        {"a.nrrd: expected numbers, found the NRRD type \"block\""});
    fails("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 16384 16384 4096\nencoding: raw\n\nabc",
          {"a.nrrd: cut off: expected 1099511627776 bytes"});
    fails("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 16384 16384 4096\nencoding: gzip\n\nabc",
          {"a.nrrd: expected 1099511627776 bytes of voxels", "which cannot hold them"});
    fails("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 16384 16384 4096\nencoding: ascii\n\nabc",
          {"which cannot hold them"});
    fails("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 99999999999 99999999999 4096\nencoding: raw\n\nabc",
          {"a.nrrd:4: sizes: expected"});
    fails("NRRD0004\ntype: uchar\ndimension: 5\nsizes: 1 1 1 1 1\nencoding: raw\n\nabc",
          {"a.nrrd: expected 1 to 4 dimensions, found 5"});
}

// --- MetaImage

std::string metaHeader(const VolumeTruth& truth, const AxisOrder& order, const std::string& more)
{
    const char* names[] = {"MET_UCHAR", "MET_CHAR", "MET_USHORT", "MET_SHORT", "MET_FLOAT"};
    return "ObjectType = Image\nNDims = 3\nDimSize = " + sizesText(order.sizeInFile(truth.info().size)) +
           "\nElementType = " + names[int(truth.info().type)] + "\n" + more;
}

TEST_F(VolumeFormats, metaImageOfEveryTypeIsRead)
{
    for (const ChannelType type : {ChannelType::uint8, ChannelType::int8, ChannelType::uint16,
                                   ChannelType::int16, ChannelType::float32})
        for (const bool big : {false, true}) {
            const VolumeTruth truth({{7, 5, 3}, 2, type});
            const std::string voxels = voxelsInFile(truth, {}, big);
            const std::string order = std::string("BinaryDataByteOrderMSB = ") + (big ? "True" : "False") +
                                      "\nElementNumberOfChannels = 2\n";
            expectVoxels(file("a.mha", metaHeader(truth, {}, order + "ElementDataFile = LOCAL\n") + voxels),
                         truth);
            file("a.zraw", gzipped(voxels, 15));
            expectVoxels(
                file("a.mhd",
                     metaHeader(truth, {}, order + "CompressedData = True\nElementDataFile = a.zraw\n")),
                truth);
            file("b.raw", "???" + voxels);
            expectVoxels(
                file("b.mhd", metaHeader(truth, {}, order + "HeaderSize = -1\nElementDataFile = b.raw\n")),
                truth);
            expectVoxels(
                file("b.mhd", metaHeader(truth, {}, order + "HeaderSize = 3\nElementDataFile = b.raw\n")),
                truth);
        }
}

TEST_F(VolumeFormats, distancesThatAreNoneAreNoted)
{
    using Spacing = std::array<double, 3>;
    const auto metaImage = [this](const std::string& words) {
        return description(file(
            "a.mha", metaHeader(truth_, {}, "ElementSpacing = " + words + "\nElementDataFile = LOCAL\n") +
                         voxelsInFile(truth_, {}, false)));
    };
    EXPECT_TRUE(metaImage("2 3 4").notes.empty());
    for (const std::string words : {"0 3 4", "nan 3 4", "2 inf 4", "two 3 4"}) {
        const auto about = metaImage(words);
        ASSERT_EQ(about.notes.size(), 1u) << words;
        expectSays(about.notes[0], {"ElementSpacing", "above 0", words.c_str(), "it is not used"});
        EXPECT_FALSE(about.spacingKnown);
        EXPECT_EQ(about.spacing, (Spacing{1, 1, 1}));
    }
    const auto negative = metaImage("2 -3 4");
    ASSERT_EQ(negative.notes.size(), 1u);
    expectSays(negative.notes[0], {"ElementSpacing", "2 -3 4", "signs are not used"});
    EXPECT_EQ(negative.spacing, (Spacing{2, 3, 4}));

    NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    nifti.sform = 0;
    for (const auto& [distance, notes] : {std::pair(2.0, 0u), {0.0, 1u}, {std::nan(""), 1u}, {-2.0, 0u}}) {
        nifti.pixdim = {distance, 3, 4};
        const auto about = description(file("a.nii", nifti.header() + voxelsInFile(truth_, {}, false)));
        ASSERT_EQ(about.notes.size(), notes) << distance;
        EXPECT_EQ(about.spacing, (Spacing{notes == 0 ? 2.0 : 1.0, 3, 4})) << distance;
        if (notes) expectSays(about.notes[0], {"pixdim[1]", "1 is used"});
    }
}

TEST_F(VolumeFormats, everyAxisOrderOfMetaImageArrivesAsRightFrontUp)
{
    for (const AxisOrder& order : allAxisOrders()) {
        std::string matrix = "TransformMatrix =", letters = "   ", spacings = "ElementSpacing =";
        for (int i = 0; i < 3; ++i) {
            const auto step = order.step(i, {1, 1, 1});
            matrix += ' ';
            matrix += vectorText({-step[0], -step[1], step[2]}, " ");
            for (std::size_t a = 0; a < 3; ++a)
                if (step[a] != 0) { // the letter where the axis comes from
                    letters[std::size_t(i)] = (step[a] > 0 ? "LPI" : "RAS")[a];
                    spacings += ' ';
                    spacings += std::to_string(spacing_[a]);
                }
        }
        for (const std::string& way : {matrix, "AnatomicalOrientation = " + letters}) {
            const auto path = file(
                "a.mha", metaHeader(truth_, order, way + "\n" + spacings + "\nElementDataFile = LOCAL\n") +
                             voxelsInFile(truth_, order, false));
            expectVoxels(path, truth_);
            EXPECT_EQ(description(path).spacing, spacing_);
            EXPECT_TRUE(description(path).orientation.known);
        }
    }
}

TEST_F(VolumeFormats, badMetaImageHeadersAreTold)
{
    const auto fails = [&](const std::string& bytes, std::initializer_list<const char*> parts) {
        expectSays(failureOfReading(file("a.mha", bytes)), parts);
    };
    const std::string voxels = voxelsInFile(truth_, {}, false), local = "ElementDataFile = LOCAL\n";
    fails(metaHeader(truth_, {}, local) + voxels.substr(1), {"a.mha: cut off: expected 120 bytes"});
    fails(metaHeader(truth_, {}, ""), {"a.mha: cut off: expected a line ElementDataFile"});
    fails(metaHeader(truth_, {}, "DimSize = 5 4\n" + local),
          {"a.mha: expected 3 numbers in the field DimSize"});
    fails(metaHeader(truth_, {}, "ElementType = MET_OTHER\n" + local), {"found \"MET_OTHER\""});
    fails(metaHeader(truth_, {}, "DimSize = 16384 16384 4096\n" + local), {"expected 2199023255552 bytes"});
    fails(metaHeader(truth_, {}, "CompressedData = True\n" + local) + "junkjunk", {"a.mha: damaged"});
    fails(metaHeader(truth_, {}, "ElementNumberOfChannels = 5\n" + local),
          {"expected 1 to 4 channels, found 5"});
}

// --- DICOM

class DicomFormats : public VolumeFormats
{
protected:
    /// The slices of truth_ as files of a scanner: rows to the left, columns to the back, upward.
    void writeSeries(DicomFile dicom = {})
    {
        std::filesystem::create_directory(folder_ / "series");
        const AxisOrder order{{0, 1, 2}, {true, true, false}};
        const std::string voxels = voxelsInFile(truth_, order, false);
        // Neither names nor numbers tell the order.
        const char* names[] = {"b", "c", "a.dcm"};
        const char* numbers[] = {"7", "2", "5"};
        for (std::size_t z = 0; z < 3; ++z) {
            dicom.pixels = voxels.substr(z * 40, 40);
            dicom.position = "1\\2\\" + std::to_string(-30 + 3 * int(z));
            dicom.instance = numbers[z];
            file("series/" + std::string(names[z]), dicom.bytes());
        }
    }
    std::string series() { return folder_ / "series"; }
};

TEST_F(DicomFormats, seriesIsSortedByPlaceAndTurned)
{
    writeSeries();
    expectVoxels(series(), truth_);
    const auto about = description(series());
    EXPECT_EQ(about.format, "DICOM");
    EXPECT_EQ(about.orientation.fileAxes, "LPS");
    EXPECT_NEAR(about.spacing[0], 0.25, 1e-9); // the file names the distance of rows first
    EXPECT_NEAR(about.spacing[1], 0.5, 1e-9);
    EXPECT_NEAR(about.spacing[2], 3, 1e-9);
    EXPECT_TRUE(about.notes.empty()) << about.notes[0];
}

TEST_F(DicomFormats, runLengthsAreDecoded)
{
    DicomFile dicom;
    dicom.rle = true;
    writeSeries(dicom);
    expectVoxels(series(), truth_);
}

TEST_F(DicomFormats, zerosBehindThePixelsAndOtherFilesDoNoHarm)
{
    DicomFile dicom;
    dicom.behind.assign(3000, '\0');
    writeSeries(dicom);
    file("series/README", "nothing");
    expectVoxels(series(), truth_);
    ASSERT_EQ(description(series()).notes.size(), 1u);
    expectSays(description(series()).notes[0], {"1 file is no DICOM picture"});
}

TEST_F(DicomFormats, largestSeriesIsReadAndTheOthersAreNamed)
{
    writeSeries();
    DicomFile other;
    other.series = "9.9";
    other.description = "scout";
    other.pixels.assign(40, 'x');
    file("series/aaa", other.bytes());
    expectVoxels(series(), truth_);
    ASSERT_EQ(description(series()).notes.size(), 1u);
    expectSays(description(series()).notes[0], {"\"first\" with 3 files", "left out \"scout\" with 1 file"});
}

TEST_F(DicomFormats, commonScaleIsToldAndScalesOfTheirOwnAreApplied)
{
    DicomFile dicom;
    dicom.slope = "2.5";
    dicom.intercept = "-1024";
    writeSeries(dicom);
    expectVoxels(series(), truth_);
    EXPECT_EQ(description(series()).slope, 2.5);
    EXPECT_EQ(description(series()).intercept, -1024);

    dicom.pixels.assign(40, '\1'); // 257
    dicom.slope = "2";
    dicom.intercept = "1";
    dicom.position = "1\\2\\-33";
    file("series/d", dicom.bytes());
    auto volume = openVolume(series());
    ASSERT_TRUE(volume) << volume.failure().text;
    EXPECT_EQ(volume->info(), (VolumeInfo{{5, 4, 4}, 1, ChannelType::float32}));
    float value = 0;
    std::memcpy(&value, readBrick(*volume, {{0, 0, 0}, {1, 1, 1}}).data(), 4);
    EXPECT_EQ(value, 515);
    std::array<std::byte, 4> bytes{};
    truth_.put(1, 2, 0, 0, bytes.data());
    std::int16_t stored = 0;
    std::memcpy(&stored, bytes.data(), sizeof stored);
    std::memcpy(&value, readBrick(*volume, {{1, 2, 1}, {1, 1, 1}}).data(), 4);
    EXPECT_EQ(value, 2.5f * float(stored) - 1024);
    EXPECT_EQ(volume->description().slope, 1);
}

TEST_F(DicomFormats, unequalGapsAndSlicesInOnePlaceAreTold)
{
    writeSeries();
    DicomFile dicom;
    dicom.pixels.assign(40, 'x');
    dicom.instance = "99";
    dicom.position = "1\\2\\-30"; // where the first one lies
    file("series/e", dicom.bytes());
    dicom.position = "1\\2\\-20"; // 4 mm above the last one
    file("series/f", dicom.bytes());
    const auto about = description(series());
    ASSERT_EQ(about.notes.size(), 2u);
    expectSays(about.notes[0], {"left out 1 slices in the place of others"});
    expectSays(about.notes[1], {"3 to 4 mm apart"});
    EXPECT_NEAR(about.spacing[2], 10 / 3.0, 1e-9);
}

TEST_F(DicomFormats, bitsThatBelongToNoValueAreDropped)
{
    DicomFile dicom;
    dicom.columns = 2;
    dicom.rows = 1;
    dicom.bitsStored = 12;
    dicom.pixels = FileBytes().put(std::uint16_t(0xf801)).put(std::uint16_t(0xa7ff)).text;
    auto signedVolume = openVolume(file("a.dcm", dicom.bytes()));
    ASSERT_TRUE(signedVolume) << signedVolume.failure().text;
    // Rows run to the left, so that the first pixel comes last.
    std::int16_t values[2];
    std::memcpy(values, readBrick(*signedVolume, {{0, 0, 0}, {2, 1, 1}}).data(), 4);
    EXPECT_EQ(values[1], -2047);
    EXPECT_EQ(values[0], 0x7ff);
    dicom.isSigned = false;
    auto plain = openVolume(file("b.dcm", dicom.bytes()));
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->info().type, ChannelType::uint16);
    std::memcpy(values, readBrick(*plain, {{0, 0, 0}, {2, 1, 1}}).data(), 4);
    EXPECT_EQ(values[1], 0x801);
}

TEST_F(DicomFormats, framesAndColoursOfOneFileAreRead)
{
    DicomFile dicom;
    dicom.frames = "3";
    dicom.orientation = dicom.position = "";
    dicom.pixels = voxelsInFile(truth_, {}, false);
    expectVoxels(file("a.dcm", dicom.bytes()), truth_);

    const VolumeTruth colour({{6, 4, 1}, 4, ChannelType::uint8});
    dicom.columns = 6;
    dicom.frames = "";
    dicom.bitsAllocated = dicom.bitsStored = 8;
    dicom.isSigned = false;
    dicom.channels = 3;
    dicom.colours = "RGB";
    dicom.pixels = voxelsInFile(colour, {}, false, 3);
    auto volume = openVolume(file("c.dcm", dicom.bytes()));
    ASSERT_TRUE(volume) << volume.failure().text;
    auto expected = colour.whole();
    for (std::size_t i = 3; i < expected.size(); i += 4)
        expected[i] = std::byte{255};
    EXPECT_TRUE(readBrick(*volume, {{0, 0, 0}, {6, 4, 1}}) == expected);
    EXPECT_TRUE(volume->description().alphaAdded);
}

/// GDCM hands zeros over for what a file lacks.
TEST_F(DicomFormats, filesCutOffInThePixelsAreToldFromWholeOnes)
{
    writeSeries();
    DicomFile dicom;
    dicom.pixels.assign(40, 'x');
    dicom.position = "1\\2\\-21"; // above the others
    const std::string bytes = dicom.bytes();
    const std::string name = series() + "/d";
    for (const std::size_t missing : {1, 2, 39, 40}) {
        file("series/d", bytes.substr(0, bytes.size() - missing));
        const std::string found = "expected 40 bytes of pixels, found " + std::to_string(40 - missing);
        expectSays(failureOfReading(name), {"d: cut off or damaged: ", found.c_str()});
        expectSays(failureOfReading(series()), {"d: cut off or damaged: ", found.c_str()});
    }
    file("series/d", bytes);
    EXPECT_TRUE(openVolume(name));
    EXPECT_EQ(openVolume(series())->info().size[2], 4);
}

TEST_F(DicomFormats, badFilesAreToldInOneLineAndNothingIsPrinted)
{
    writeSeries();
    testing::internal::CaptureStderr();
    DicomFile dicom;
    dicom.pixels.assign(20, 'x');
    expectSays(failureOfReading(file("a.dcm", dicom.bytes())),
               {"a.dcm: cut off or damaged: expected 40 bytes of pixels, found"});
    dicom.columns = dicom.rows = 65535;
    dicom.frames = "300";
    expectSays(failureOfReading(file("a.dcm", dicom.bytes())), {"a.dcm: cut off or damaged: expected"});
    expectSays(failureOfReading(file("a.dcm", std::string(128, '\0') + "DICM" + "junk")),
               {"a.dcm: expected"});
    expectSays(failureOfReading(file("a.dcm", "x")), {"a.dcm: expected"});
    std::filesystem::create_directory(folder_ / "empty");
    expectSays(failureOfReading(folder_ / "empty"), {"empty: expected a folder with DICOM pictures"});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// --- all

TEST_F(VolumeFormats, contentCountsMoreThanTheEnding)
{
    const NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    expectVoxels(file("a.tif", nifti.header() + voxelsInFile(truth_, {}, false)), truth_);
    ASSERT_TRUE(writeTiffStack(folder_ / "b.nii", truth_.info(), truth_.whole()));
    expectVoxels(folder_ / "b.nii", truth_);
}

/// Changes a few bytes of a good file, many times over: it must be read or refused in one line.
void expectNoHarm(const ScratchFolder& folder, const std::string& name, const std::string& good,
                  std::size_t headerBytes, int rounds)
{
    std::mt19937 random(static_cast<unsigned>(good.size()));
    int refused = 0;
    testing::internal::CaptureStderr();
    for (int round = 0; round < rounds; ++round) {
        std::string bytes = good;
        const std::size_t reach = round % 4 ? headerBytes : bytes.size();
        for (unsigned i = 0, flips = 1 + random() % 4; i < flips; ++i)
            bytes[random() % reach] = static_cast<char>(random());
        if (round % 8 == 0) bytes.resize(random() % bytes.size());
        writeFile(folder / name, bytes);
        auto volume = openVolume(folder / name);
        std::string text = volume ? "" : volume.failure().text;
        if (volume) {
            const auto size = volumeBytes(volume->info().size, volume->info().bytesPerVoxel());
            ASSERT_TRUE(size);
            ASSERT_LT(*size, 100'000'000) << "from a file of " << bytes.size();
            std::vector<std::byte> out(static_cast<std::size_t>(*size));
            const auto read = volume->readBrick({{0, 0, 0}, volume->info().size}, out);
            if (!read) text = read.failure().text;
        }
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        refused += !text.empty();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << name;
    EXPECT_GT(refused, rounds / 20) << name;
}

TEST_F(VolumeFormats, changedBytesDoNoHarm)
{
    const std::string voxels = voxelsInFile(truth_, {}, false);
    NiftiFile nifti = niftiOf(truth_, {}, spacing_);
    expectNoHarm(folder_, "a.nii", nifti.header() + voxels, 352, 300);
    expectNoHarm(folder_, "a.nii.gz", gzipped(nifti.header() + voxels), 40, 300);
    nifti.version = 2;
    expectNoHarm(folder_, "b.nii", nifti.header() + voxels, 544, 300);
    const std::string nrrd =
        nrrdHeader(truth_, {},
                   "endian: little\nspace: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
                   "kinds: domain domain domain\nspace origin: (1,2,3)\nkey:=value\n\n",
                   "gzip");
    expectNoHarm(folder_, "a.nrrd", nrrd + gzipped(voxels), nrrd.size(), 400);
    writeFile(folder_ / "a.raw", voxels);
    const std::string detached = nrrdHeader(truth_, {}, "endian: big\nspacings: 1 2 3\ndata file: a.raw\n");
    expectNoHarm(folder_, "a.nhdr", detached, detached.size(), 300);
    const std::string meta = metaHeader(
        truth_, {}, "TransformMatrix = 1 0 0 0 1 0 0 0 1\nElementSpacing = 1 2 3\nElementDataFile = LOCAL\n");
    expectNoHarm(folder_, "a.mha", meta + voxels, meta.size(), 300);
}

TEST_F(VolumeFormats, changedBytesOfDicomDoNoHarm)
{
    DicomFile dicom;
    dicom.pixels = voxelsInFile(truth_, {}, false).substr(0, 40);
    expectNoHarm(folder_, "a.dcm", dicom.bytes(), dicom.bytes().size(), 200);
    dicom.rle = true;
    expectNoHarm(folder_, "b.dcm", dicom.bytes(), dicom.bytes().size(), 200);
}

} // namespace
} // namespace vo
