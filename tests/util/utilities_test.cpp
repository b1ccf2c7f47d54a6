// iflfrombin, iflto3Dtiff and volinfo as a user calls them.

#include <algorithm>
#include <limits>

#include "foreign_volumes.h"
#include "run_program.h"
#include "scratch_folder.h"

namespace vo {
namespace {

constexpr const char* kPrograms[] = {IFLFROMBIN, IFLTO3DTIFF, VOLINFO};

class Utilities : public testing::Test
{
protected:
    ProgramRun run(const std::string& command)
    {
        return runProgram("cd '" + (folder_ / "") + "' && " + command);
    }
    /// A run that must fail with one line that holds `parts` and leave no more files than there were.
    void expectFails(const std::string& command, std::initializer_list<const char*> parts)
    {
        const int before = folder_.fileCount();
        auto failed = run(command);
        EXPECT_EQ(failed.status, 1) << command;
        ASSERT_EQ(std::ranges::count(failed.output, '\n'), 1) << command << "\n" << failed.output;
        failed.output.pop_back();
        expectSays(failed.output, parts);
        EXPECT_EQ(folder_.fileCount(), before) << command;
    }
    void writeTiff(const std::string& name, const VolumeTruth& truth)
    {
        ASSERT_TRUE(writeTiffStack(folder_ / name, truth.info(), truth.whole()));
    }
    void expectTiff(const std::string& name, const VolumeTruth& truth)
    {
        auto volume = openVolume(folder_ / name);
        ASSERT_TRUE(volume) << volume.failure().text;
        EXPECT_EQ(volume->description().format, "TIFF");
        expectReadsAs(*volume, truth);
    }

    ScratchFolder folder_;
};

TEST_F(Utilities, helpShowsAnExampleAndVersionIsOneLine)
{
    for (const std::string program : kPrograms) {
        for (const char* word : {"-h", "-help", "--help", "a -help"}) {
            const auto help = run(program + " " + word);
            EXPECT_EQ(help.status, 0);
            EXPECT_NE(help.output.find("Example"), std::string::npos);
        }
        for (const char* word : {"-version", "--version"}) {
            const auto version = run(program + " " + word);
            EXPECT_EQ(version.status, 0);
            EXPECT_EQ(version.output.find("Volumizer "), 0u);
            EXPECT_EQ(std::ranges::count(version.output, '\n'), 1);
        }
        EXPECT_EQ(run(program + " -help >/dev/full").status, 1);
    }
    EXPECT_TRUE(folder_.isEmpty());
}

TEST_F(Utilities, rawImageOfEveryTypeBecomesTiff)
{
    const std::pair<const char*, ChannelType> types[] = {
        {"char", ChannelType::int8},   {"uchar", ChannelType::uint8},   {"ubyte", ChannelType::uint8},
        {"short", ChannelType::int16}, {"ushort", ChannelType::uint16}, {"float", ChannelType::float32}};
    for (const auto& [name, type] : types)
        for (const int channels : {1, 2, 4})
            for (const bool big : {false, true}) {
                const VolumeTruth truth({{7, 5, 1}, channels, type});
                writeFile(folder_ / "in.raw", "head" + voxelsInFile(truth, {}, big) + "tail");
                const auto made = run(std::string(IFLFROMBIN) + (big ? " -bigEndian" : " -littleEndian") +
                                      " 4 7 5 " + std::to_string(channels) + " " + name + " in.raw out.tif");
                ASSERT_EQ(made.status, 0) << made.output;
                EXPECT_EQ(made.output, "");
                expectTiff("out.tif", truth);
            }
}

TEST_F(Utilities, rawRgbGetsFullAlpha)
{
    writeFile(folder_ / "in.raw", "abcdef");
    ASSERT_EQ(run(IFLFROMBIN " 0 2 1 3 uchar in.raw out.tif").status, 0);
    auto volume = openVolume(folder_ / "out.tif");
    ASSERT_TRUE(volume) << volume.failure().text;
    ASSERT_EQ(volume->info(), (VolumeInfo{{2, 1, 1}, 4, ChannelType::uint8}));
    const auto bytes = readBrick(*volume, {{0, 0, 0}, {2, 1, 1}});
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), 8), "abc\xff"
                                                                           "def\xff");
}

TEST_F(Utilities, badRawImagesGiveOneLineAndNoFile)
{
    writeFile(folder_ / "in.raw", std::string(20, 'x'));
    const std::string program = IFLFROMBIN;
    expectFails(program, {"iflfrombin: expected hdrlen xsize", "found 0 arguments"});
    expectFails(program + " 0 4 5 1 uchar in.raw", {"found 6 arguments"});
    expectFails(program + " 1 4 5 1 uchar in.raw a.tif",
                {"in.raw: expected a header of 1 bytes and 20 bytes", "found 20 bytes"});
    expectFails(program + " -1 4 5 1 uchar in.raw a.tif", {"hdrlen: expected a whole number from 0"});
    expectFails(program + " 0 0 5 1 uchar in.raw a.tif", {"xsize: expected", "found \"0\""});
    expectFails(program + " 0 4 5.5 1 uchar in.raw a.tif", {"ysize: expected"});
    expectFails(program + " 0 4 5 5 uchar in.raw a.tif", {"csize: expected a whole number from 1 to 4"});
    expectFails(program + " 0 4 5 1 double in.raw a.tif", {"bpp: expected char", "found \"double\""});
    expectFails(program + " 0 4 5 1 uchar none.raw a.tif", {"none.raw: cannot open"});
    expectFails(program + " 0 4 5 1 uchar in.raw no/a.tif", {"no/a.tif: cannot write"});
    expectFails(program + " 9223372036854775807 4 5 1 uchar in.raw a.tif", {"in.raw: expected a header"});
    expectFails(program + " 0 2147483647 2147483647 4 float in.raw a.tif", {"in.raw: expected"});
    expectFails(program + " -x 0 4 5 1 uchar in.raw a.tif", {"found 8 arguments"});
    EXPECT_EQ(folder_.fileCount(), 1);
}

TEST_F(Utilities, filesThatAreNoTiffAndInputsAreNotReplaced)
{
    writeFile(folder_ / "a.raw", std::string(30, 'r'));
    writeFile(folder_ / "b.raw", std::string(30, 'q'));
    ASSERT_EQ(run(IFLFROMBIN " 0 6 5 1 uchar a.raw a.tif").status, 0);
    ASSERT_EQ(run(IFLFROMBIN " 0 6 5 1 uchar b.raw a.tif").status, 0) << "a TIFF is replaced";
    expectFails(IFLFROMBIN " 0 6 5 1 uchar a.raw a.raw", {"a.raw", "no input"});
    expectFails(IFLFROMBIN " 0 6 5 1 uchar a.raw b.raw", {"b.raw", "TIFF"});
    expectFails(IFLTO3DTIFF " a.tif ./a.tif", {"a.tif", "no input"});
    expectFails(IFLTO3DTIFF " a.tif b.raw", {"b.raw", "TIFF"});
    EXPECT_EQ(run("grep -c rrrrrr a.raw").output, "1\n");
    EXPECT_EQ(run("grep -c qqqqqq b.raw").output, "1\n");
}

TEST_F(Utilities, slicesOfAnyFormatBecomeAVolume)
{
    const VolumeTruth truth({{6, 5, 4}, 1, ChannelType::uint8});
    const std::string voxels = voxelsInFile(truth, {}, false);
    const auto slice = [&](std::size_t z) { return voxels.substr(z * 30, 30); };
    ASSERT_TRUE(writeTiffStack(folder_ / "0.tif", {{6, 5, 1}, 1, ChannelType::uint8},
                               truth.brick({{0, 0, 0}, {6, 5, 1}})));
    writeFile(folder_ / "1.nrrd",
              "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 6 5\nencoding: raw\n\n" + slice(1));
    // Two slices in one file.
    writeFile(folder_ / "2.mha",
              "NDims = 3\nDimSize = 6 5 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + slice(2) +
                  slice(3));
    for (const char* option : {"", " -compress"}) {
        const auto made = run(IFLTO3DTIFF + std::string(option) + " 0.tif 1.nrrd 2.mha out.tif");
        ASSERT_EQ(made.status, 0) << made.output;
        EXPECT_EQ(made.output, "");
        expectTiff("out.tif", truth);
    }
}

TEST_F(Utilities, pngSlicesBecomeAVolume)
{
    const std::vector<std::uint8_t> red{255, 0, 0, 9, 8, 7}, blue{0, 0, 255, 1, 2, 3};
    ASSERT_TRUE(writePng(folder_ / "a.png", 2, 1, 3, red));
    ASSERT_TRUE(writePng(folder_ / "b.png", 2, 1, 3, blue));
    ASSERT_EQ(run(IFLTO3DTIFF " b.png a.png out.tif").status, 0);
    auto volume = openVolume(folder_ / "out.tif");
    ASSERT_TRUE(volume) << volume.failure().text;
    ASSERT_EQ(volume->info(), (VolumeInfo{{2, 1, 2}, 4, ChannelType::uint8}));
    const auto bytes = readBrick(*volume, {{0, 0, 0}, {2, 1, 2}});
    const unsigned char expected[] = {0, 0, 255, 255, 1, 2, 3, 255, 255, 0, 0, 255, 9, 8, 7, 255};
    EXPECT_EQ(std::memcmp(bytes.data(), expected, sizeof expected), 0);
}

TEST_F(Utilities, oneVolumeIsConvertedAndItsNotesAreTold)
{
    const VolumeTruth truth({{6, 5, 4}, 1, ChannelType::int16});
    NiftiFile nifti;
    nifti.dim = {6, 5, 4, 2};
    nifti.datatype = 4;
    nifti.bits = 16;
    nifti.steps = {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const AxisOrder order{{0, 1, 2}, {true, false, false}};
    writeFile(folder_ / "a.nii", nifti.header() + voxelsInFile(truth, order, false) + std::string(240, 'x'));
    const auto made = run(IFLTO3DTIFF " a.nii out.tif");
    ASSERT_EQ(made.status, 0);
    EXPECT_EQ(made.output, "iflto3Dtiff: a.nii: the first of 2 volumes is read\n");
    expectTiff("out.tif", truth);
}

TEST_F(Utilities, slicesThatDoNotFitGiveOneLineAndNoFile)
{
    writeTiff("a.tif", VolumeTruth({{6, 5, 1}, 1, ChannelType::uint8}));
    writeTiff("wide.tif", VolumeTruth({{7, 5, 1}, 1, ChannelType::uint8}));
    writeTiff("deep.tif", VolumeTruth({{6, 5, 1}, 1, ChannelType::uint16}));
    writeTiff("rgba.tif", VolumeTruth({{6, 5, 1}, 4, ChannelType::uint8}));
    const std::string program = IFLTO3DTIFF;
    expectFails(program, {"iflto3Dtiff: expected in1", "found 0 file names"});
    expectFails(program + " a.tif", {"found 1 file names"});
    expectFails(program + " a.tif wide.tif o.tif",
                {"wide.tif: expected slices like those of a.tif", "found 7 x 5"});
    expectFails(program + " a.tif deep.tif o.tif",
                {"deep.tif: expected", "found 6 x 5 with 1 channels of uint16"});
    expectFails(program + " a.tif rgba.tif o.tif", {"rgba.tif: expected", "4 channels"});
    expectFails(program + " a.tif none.tif o.tif", {"none.tif: cannot open"});
    expectFails(program + " a.tif a.tif no/o.tif", {"no/o.tif: cannot write"});
    expectFails(program + " -x a.tif o.tif", {"found the option \"-x\""});
}

TEST_F(Utilities, volinfoPrintsWhatAFileHolds)
{
    // Two bins of equal width: 0 0 1 | 3 3 3 is 3 and 3.
    writeFile(folder_ / "a.nrrd",
              "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 3 2 1\n"
              "space directions: (0.5,0,0) (0,0,2) (0,-4,0)\nencoding: ascii\n\n0 0 1 3 3 3\n");
    const auto printed = run(VOLINFO " a.nrrd");
    ASSERT_EQ(printed.status, 0) << printed.output;
    for (const char* part :
         {"a.nrrd\n", "format          NRRD\n", "size            3 x 1 x 2 voxels\n",
          "type            uint8, 1 channel\n", "spacing         0.5 x 4 x 2 mm\n",
          "orientation     LSA in the file", "range         0 to 3\n", "mean          1.666667\n",
          "0             2 #", "1             1 #", "2             0 \n",
          "3             3 ########################################\n"})
        EXPECT_NE(printed.output.find(part), std::string::npos) << part << "\n" << printed.output;
    EXPECT_EQ(printed.output.find("scale"), std::string::npos);
}

TEST_F(Utilities, volinfoCountsNoNumbersApart)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<float> values{nan, 2, inf, -inf, nan, 6, nan, 4};
    ASSERT_TRUE(writeTiffStack(folder_ / "a.tif", {{8, 1, 1}, 1, ChannelType::float32},
                               std::as_bytes(std::span(values))));
    const auto printed = run(VOLINFO " a.tif");
    for (const char* part : {"not a number  3\n", "infinite      2\n", "range         2 to 6\n",
                             "mean          4\n", "spacing         unknown", "orientation     unknown"})
        EXPECT_NE(printed.output.find(part), std::string::npos) << part << "\n" << printed.output;
    const auto json = run(VOLINFO " -json a.tif").output;
    EXPECT_NE(json.find("\"low\": 2, \"high\": 6, \"mean\": 4, \"notANumber\": 3, \"infinite\": 2"),
              std::string::npos)
        << json;
    EXPECT_NE(json.find("\"histogram\": [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1]"),
              std::string::npos)
        << json;
    // Nothing but NaN, and one value alone.
    const std::vector<float> none{nan, nan};
    ASSERT_TRUE(writeTiffStack(folder_ / "b.tif", {{2, 1, 1}, 1, ChannelType::float32},
                               std::as_bytes(std::span(none))));
    EXPECT_NE(run(VOLINFO " -json b.tif").output.find("\"low\": null"), std::string::npos);
    EXPECT_EQ(run(VOLINFO " b.tif").status, 0);
    const std::vector<float> one{7, 7};
    ASSERT_TRUE(writeTiffStack(folder_ / "c.tif", {{2, 1, 1}, 1, ChannelType::float32},
                               std::as_bytes(std::span(one))));
    EXPECT_NE(run(VOLINFO " -json c.tif").output.find("\"histogram\": [2]"), std::string::npos);
}

TEST_F(Utilities, volinfoJsonIsAnArrayAndReadableFilesAreDescribed)
{
    writeTiff("a \"b\".tif", VolumeTruth({{2, 1, 1}, 4, ChannelType::uint8}));
    const auto both = run(VOLINFO " -json 'a \"b\".tif' none.tif 'a \"b\".tif' 2>/dev/null");
    EXPECT_EQ(both.status, 1);
    EXPECT_EQ(both.output.find("[\n"), 0u);
    EXPECT_EQ(both.output.substr(both.output.size() - 3), "\n]\n");
    const auto first = both.output.find("{\"file\": \"a \\\"b\\\".tif\", \"format\": \"TIFF\"");
    ASSERT_NE(first, std::string::npos) << both.output;
    EXPECT_NE(both.output.find("{\"file\": \"a \\\"b\\\".tif\"", first + 1), std::string::npos);
    EXPECT_NE(
        both.output.find("\"size\": [2, 1, 1], \"channels\": 4, \"type\": \"uint8\", \"alphaAdded\": false"),
        std::string::npos);
    EXPECT_EQ(std::ranges::count(both.output, '{'), 2 * (1 + 4));
}

TEST_F(Utilities, volinfoTellsBadFilesInOneLineEach)
{
    expectFails(VOLINFO, {"volinfo: expected files, found none"});
    expectFails(VOLINFO " -x", {"found the option \"-x\""});
    expectFails(VOLINFO " none.tif", {"volinfo: none.tif: cannot open"});
    writeFile(folder_ / "junk", "junk");
    expectFails(VOLINFO " junk", {"junk: expected a volume", "found \"junk\""});
    const auto two = run(VOLINFO " none junk");
    EXPECT_EQ(two.status, 1);
    EXPECT_EQ(std::ranges::count(two.output, '\n'), 2) << two.output;
}

} // namespace
} // namespace vo
