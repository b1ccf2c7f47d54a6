#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace {

using vo::channel;
using vo::Picture;
using vo::ProgramRun;

class VoglPrograms : public testing::Test
{
protected:
    /// Draws with voglBasic and the words; the picture must come.
    Picture draw(const std::string& words, const std::string& program = "voglBasic")
    {
        return vo::drawnPicture(folder, program, words).picture;
    }

    /// A volume of 24 x 20 x 16 voxels, soft, different along each axis.
    void writeBlob(const std::string& name)
    {
        vo::writeBytes(folder / name, 24, 20, 16, [](int x, int y, int z) {
            const int d = (x - 9) * (x - 9) + 2 * (y - 12) * (y - 12) + 3 * (z - 6) * (z - 6);
            return std::max(0, 250 - 3 * d);
        });
    }

    /// Wide planes of 255 at the ends that x, y, z say (0 or 1; -1: anywhere), black elsewhere.
    void writeEnd(const std::string& name, int axis, bool far)
    {
        vo::writeBytes(folder / name, 16, 16, 16, [=](int x, int y, int z) {
            const int at = axis == 0 ? x : axis == 1 ? y : z;
            return (far ? at >= 11 : at < 5) ? 255 : 0;
        });
    }

    vo::ScratchFolder folder;
};

int brightest(const Picture& picture)
{
    return *std::max_element(picture.bytes.begin(), picture.bytes.end());
}

TEST_F(VoglPrograms, pictureHasTheSizeAskedFor)
{
    ASSERT_EQ(folder.run("mkcubes", "32 32 32 16 cubes.tif").status, 0);
    for (const char* program : {"voglBasic", "voglSimple"}) {
        const Picture usual = draw("cubes.tif", program);
        EXPECT_EQ(usual.width, 512);
        EXPECT_EQ(usual.height, 512);
        const Picture asked = draw("-size 61 40 cubes.tif", program);
        EXPECT_EQ(asked.width, 61);
        EXPECT_EQ(asked.height, 40);
        EXPECT_GT(brightest(asked), 50);
    }
}

TEST_F(VoglPrograms, vorenderDrawsThePicturesOfVoglBasic)
{
    writeBlob("blob.tif");
    std::ofstream(folder / "steep.lut") << "0 0 0 0\n255 80 20 0\n255 200 90 60\n250 250 255 200\n";
    for (const std::string options :
         {"-view 20 30", "-view 0 180 -lutFile steep.lut", "-lut 120 90 -view -40 10 -color",
          "-dataRange 20 200 -perspective 50 -view 10 200 -lutFile steep.lut -monochrome",
          "-mip -view 30 70 -lutFile steep.lut", "-shells -perspective 100 -view 5 5", "-2D -view 25 50",
          "-2D -view 80 10 -sampling 0.6", "-scale 1 2 0.5 -sampling 2 -view 40 300",
          "-space view -view 12 34", "-bricks 2 3 1 -overlap 2 -view 12 34",
          "-overlap 0 -view 60 34 -lutFile steep.lut"}) {
        const std::string words = "-size 120 90 blob.tif " + options;
        const Picture drawn = draw(words), rendered = draw(words, "vorender");
        ASSERT_EQ(rendered.width, 120);
        EXPECT_GT(brightest(rendered), 40) << options;
        EXPECT_LE(vo::difference(drawn, rendered).pixelsBeyondOne, 120 * 90 / 500) << options;
    }
}

TEST_F(VoglPrograms, vorenderDrawsVolumesOfEveryKind)
{
    vo::writeShorts(folder / "shorts.tif", 20, 18, 16,
                    [](int x, int y, int z) { return 40 * x + 30 * y * (z % 3) - 300; });
    const auto draws = [&](const std::string& words) {
        const Picture drawn = draw("-size 80 80 " + words),
                      rendered = draw("-size 80 80 " + words, "vorender");
        EXPECT_GT(brightest(rendered), 10) << words;
        EXPECT_LE(vo::difference(drawn, rendered).pixelsBeyondOne, 80 * 80 / 500) << words;
    };
    draws("shorts.tif -view 20 30");
    draws("shorts.tif -view 20 30 -dataRange -100 500 -lut 100 300");
    for (const auto& [name, channels] : {std::pair("two.tif", 2), std::pair("four.tif", 4)}) {
        const vo::VolumeInfo info{{12, 14, 10}, channels, vo::ChannelType::uint8};
        std::vector<std::byte> voxels;
        for (int i = 0; i < 12 * 14 * 10; ++i)
            for (int c = 0; c < channels; ++c)
                voxels.push_back(std::byte(c == channels - 1 ? i % 40 : (i * (c + 3)) % 256));
        ASSERT_TRUE(vo::writeTiffStack(folder / name, info, voxels));
        draws(std::string(name) + " -view 20 30");
        draws(std::string(name) + " -view 20 30 -color");
        draws(std::string(name) + " -view 20 30 -lut 100 150");
    }
    std::string colours;
    for (int i = 0; i < 3 * 12 * 14 * 10; ++i)
        colours += static_cast<char>(i % 7 == 0 ? i % 200 : i % 11);
    vo::writeChannels(folder / "three.nrrd", 12, 14, 10, colours);
    for (const char* words : {"", " -color", " -color -mip", " -color -lut 100 150"})
        draws("three.nrrd -view 20 30" + std::string(words));
}

TEST_F(VoglPrograms, twoRunsGiveTheSameBytes)
{
    writeBlob("blob.tif");
    const std::string words = "blob.tif -view 20 30 -size 90 70 -output ";
    ASSERT_EQ(folder.run("voglBasic", words + "a.png").status, 0);
    ASSERT_EQ(folder.run("voglBasic", words + "b.png").status, 0);
    EXPECT_EQ(vo::readFile(folder / "a.png"), vo::readFile(folder / "b.png"));
    EXPECT_NE(vo::readFile(folder / "a.png"), "");
}

TEST_F(VoglPrograms, axesPointWhereTheyShould)
{
    writeEnd("right.tif", 0, true);
    writeEnd("top.tif", 2, true);
    writeEnd("back.tif", 1, true);
    const auto halves = [this](const std::string& words) {
        const Picture p = draw(words + " -size 64 64");
        return std::array<int, 4>{channel(p, 20, 32, 0), channel(p, 44, 32, 0), channel(p, 32, 20, 0),
                                  channel(p, 32, 44, 0)}; // left, right, top, bottom
    };
    const auto right = halves("right.tif");
    EXPECT_GT(right[1], right[0] + 50) << "x points right";
    const auto turned = halves("right.tif -view 0 180");
    EXPECT_GT(turned[0], turned[1] + 50) << "and left when seen from the other side";
    const auto top = halves("top.tif");
    EXPECT_GT(top[2], top[3] + 50) << "z points up";
    const auto above = halves("back.tif -view -90 0");
    EXPECT_GT(above[2], above[3] + 50) << "seen from above, y points up";
}

TEST_F(VoglPrograms, coreContextDrawsTheSamePicture)
{
    writeBlob("blob.tif");
    for (const char* words :
         {"blob.tif -view 20 30 -size 90 70", "blob.tif -view 20 30 -size 90 70 -perspective 40",
          "blob.tif -view 20 30 -size 90 70 -2D -mip -wireframe"}) {
        const auto apart = vo::difference(draw(words), draw(std::string(words) + " -core"));
        EXPECT_LE(apart.largest, 1) << words;
    }
}

TEST_F(VoglPrograms, bricksLeaveThePictureAsItWas)
{
    writeBlob("blob.tif");
    const Picture whole = draw("blob.tif -view 20 30");
    for (const char* bricks : {"2 2 2", "3 2 1"}) {
        const auto apart = vo::difference(whole, draw(std::string("blob.tif -view 20 30 -bricks ") + bricks));
        EXPECT_LE(apart.pixelsBeyondOne, 512 * 512 / 2000) << bricks;
    }
}

TEST_F(VoglPrograms, stacksAndTexturesShowTheSameVolume)
{
    writeBlob("blob.tif");
    const auto apart = vo::difference(draw("blob.tif -size 90 90 -2D"), draw("blob.tif -size 90 90 -3D"));
    EXPECT_LE(apart.largest, 8);
    const auto turned = vo::difference(draw("blob.tif -size 90 90 -2D -view 0 90"),
                                       draw("blob.tif -size 90 90 -3D -view 0 90"));
    EXPECT_LE(turned.largest, 8) << "the YZ stack";
}

TEST_F(VoglPrograms, shellsShowTheSameVolumeSampledAnew)
{
    writeBlob("blob.tif");
    const std::string words = "blob.tif -size 90 90 -view 20 30 -perspective 120 -lut 20 20";
    const Picture planes = draw(words), shells = draw(words + " -shells");
    EXPECT_LE(vo::difference(planes, shells).largest, 60) << "planes lie farther apart at the rim";
    EXPECT_GT(vo::difference(planes, shells).pixelsBeyondOne, 50);
    const auto cut = vo::difference(shells, draw(words + " -shells -bricks 2 2 2"));
    EXPECT_LE(cut.pixelsBeyondOne, 10);
    const ProgramRun refused = folder.run("voglBasic", words + " -shells -2D -output a.png");
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.errors.find("-shells"), std::string::npos) << refused.errors;
}

TEST_F(VoglPrograms, tableColoursThePicture)
{
    writeBlob("blob.tif");
    std::ofstream(folder / "red.lut") << "0 0 0 0\n255 0 0 64\n";
    const Picture red = draw("blob.tif -size 64 64 -lutFile red.lut");
    EXPECT_GT(channel(red, 29, 34, 0), 50);
    EXPECT_EQ(channel(red, 29, 34, 1), 0);
    const Picture grey = draw("blob.tif -size 64 64 -lutFile red.lut -monochrome");
    EXPECT_GT(channel(grey, 29, 34, 0), 10);
    EXPECT_EQ(channel(grey, 29, 34, 0), channel(grey, 29, 34, 1));
}

TEST_F(VoglPrograms, rampMovesWithItsCenter)
{
    writeBlob("blob.tif");
    const Picture low = draw("blob.tif -size 64 64 -lut 20 40");
    const Picture high = draw("blob.tif -size 64 64 -lut 230 40");
    EXPECT_GT(brightest(low), brightest(high));
    EXPECT_EQ(brightest(draw("blob.tif -size 64 64 -lut 400 40")), 0) << "nothing is as bright";
}

TEST_F(VoglPrograms, dataRangeOfShortsIsThatOfTheFile)
{
    vo::writeShorts(folder / "ct.tif", 12, 12, 12,
                    [](int x, int y, int z) { return 900 + 10 * x + y + 80 * z; });
    const Picture scanned = draw("ct.tif -size 64 64");
    const Picture told = draw("ct.tif -size 64 64 -dataRange 900 1901");
    EXPECT_EQ(scanned.bytes, told.bytes);
    EXPECT_GT(brightest(scanned), 100);
    EXPECT_EQ(scanned.bytes, draw("ct.tif -size 64 64 -bricks 1 1 1").bytes);
    EXPECT_LE(vo::difference(scanned, draw("ct.tif -size 64 64 -bricks 2 2 2")).largest, 1)
        << "what pads the last bricks is no value of the file";
    EXPECT_LT(brightest(draw("ct.tif -size 64 64 -dataRange 0 65535")), 30);
}

TEST_F(VoglPrograms, perspectiveAndScaleKeepTheVolumeInThePicture)
{
    vo::writeBytes(folder / "full.tif", 8, 8, 8, [](int x, int, int) { return x == 4 ? 254 : 255; });
    for (const char* words :
         {"-perspective 60", "-scale 1 2 3", "-perspective 20 -scale 4 1 1", "-space view"}) {
        const Picture p = draw("full.tif -size 80 60 -view 20 30 " + std::string(words));
        EXPECT_GT(channel(p, 40, 30, 0), 100) << words;
        for (const int x : {0, 79}) {
            for (int y = 0; y < 60; ++y)
                ASSERT_EQ(channel(p, x, y, 0), 0) << words;
        }
    }
}

TEST_F(VoglPrograms, framesPrintOneLineOfTimes)
{
    writeBlob("blob.tif");
    const ProgramRun run = folder.run("voglBasic", "blob.tif -frames 3 -size 32 32 -output last.png");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.errors, "");
    EXPECT_EQ(run.output.find("3 frames, median "), 0u) << run.output;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1);
    EXPECT_EQ(vo::readPng(folder / "last.png")->bytes, draw("blob.tif -size 32 32").bytes)
        << "the turn ends where it began";
}

TEST_F(VoglPrograms, numberedPicturesOfATurnAreThoseOfVorender)
{
    writeBlob("blob.tif");
    const std::string words = "blob.tif -view 10 20 -size 60 50 ";
    const ProgramRun turned = folder.run("voglBasic", words + "-frames 3 -output x%02d.png");
    EXPECT_EQ(turned.status, 0);
    EXPECT_EQ(turned.errors, "");
    EXPECT_EQ(folder.files().size(), 4u) << "the volume and three pictures";
    ASSERT_EQ(folder.run("vorender", words + "-frames 3 -output v%02d.png").status, 0);
    for (const auto& [number, view] : {std::pair("00", "10 20"), {"01", "10 140"}, {"02", "10 260"}}) {
        const auto picture = vo::readPng(folder / ("x" + std::string(number) + ".png")),
                   rendered = vo::readPng(folder / ("v" + std::string(number) + ".png"));
        ASSERT_TRUE(picture && rendered) << number;
        EXPECT_EQ(picture->bytes, draw("blob.tif -size 60 50 -view " + std::string(view)).bytes) << number;
        EXPECT_LE(vo::difference(*picture, *rendered).pixelsBeyondOne, 60 * 50 / 500) << number;
    }
    const ProgramRun refused = folder.run("voglBasic", words + "-frames 3 -output x%s.png");
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.errors.find("option -output: expected a name with a %d"), std::string::npos)
        << refused.errors;
}

TEST_F(VoglPrograms, timesAloneWriteNoPicture)
{
    writeBlob("blob.tif");
    const ProgramRun run = folder.run("voglBasic", "blob.tif -size 20 20 -frames 2");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.output.find("2 frames, median "), 0u) << run.output;
    EXPECT_EQ(folder.files(), std::vector<std::string>{"blob.tif"});
}

TEST_F(VoglPrograms, withoutADisplayThePictureIsNamedAfterTheProgram)
{
    writeBlob("blob.tif");
    const ProgramRun run = folder.run("voglBasic", "blob.tif -size 20 20");
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.errors.find("into voglBasic.png"), std::string::npos) << run.errors;
    EXPECT_TRUE(vo::readPng(folder / "voglBasic.png"));
}

TEST_F(VoglPrograms, helpAndVersionNeedNoVolume)
{
    for (const char* program : {"voglBasic", "voglSimple"}) {
        for (const char* word : {"-help", "--help", "-h"}) {
            const ProgramRun run = folder.run(program, word);
            EXPECT_EQ(run.status, 0);
            EXPECT_NE(run.output.find("Example: "), std::string::npos);
            EXPECT_NE(run.output.find("-view LATITUDE LONGITUDE"), std::string::npos);
        }
        EXPECT_EQ(folder.run(program, "--version").output.find('\n'),
                  folder.run(program, "--version").output.size() - 1);
    }
}

TEST_F(VoglPrograms, badInputIsOneLineAndLeavesNoPicture)
{
    writeBlob("blob.tif");
    std::ofstream(folder / "junk.tif") << "this is no volume";
    std::ofstream(folder / "letters.lut") << "0 0\n12 abc\n";
    std::filesystem::copy(folder / "blob.tif", folder / "cut.tif");
    std::filesystem::resize_file(folder / "cut.tif", std::filesystem::file_size(folder / "blob.tif") / 2);
    const auto before = folder.files();
    struct Case
    {
        const char* words;
        const char* named;
    };
    for (const auto& [words, named] :
         std::vector<Case>{{"", "volume"},
                           {"blob.tif blob.tif", "blob.tif"},
                           {"missing.tif", "missing.tif"},
                           {"junk.tif", "junk.tif"},
                           {"cut.tif", "cut.tif"},
                           {"blob.tif -colour", "-colour"},
                           {"blob.tif -size 0 5", "-size"},
                           {"blob.tif -size 2147483648 5", "-size"},
                           {"blob.tif -size 16384 16384", "-size"},
                           {"blob.tif -view 1 x", "-view"},
                           {"blob.tif -lutFile missing.lut", "missing.lut"},
                           {"blob.tif -lutFile letters.lut", "letters.lut"},
                           {"blob.tif -overlap 24", "-overlap"},
                           {"blob.tif -sampling 1e-4", "-sampling: expected at most 65536"},
                           {"blob.tif -scale 9e5 1 1", "option -scale: expected"},
                           {"blob.tif -bricks 900 900 900", "-bricks: expected at most 4096"},
                           {"blob.tif -frames", "-frames"}}) {
        const ProgramRun run = folder.run("voglBasic", "-output picture.png " + std::string(words));
        EXPECT_EQ(run.status, 1) << words;
        EXPECT_NE(run.errors.find(named), std::string::npos) << words << ": " << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << words << ": " << run.errors;
        EXPECT_EQ(run.output, "") << words;
        EXPECT_EQ(folder.files(), before) << words;
    }
}

TEST_F(VoglPrograms, bothProgramsRefuseTheSameCuts)
{
    writeBlob("blob.tif");
    vo::writeBytes(folder / "thin.tif", 1, 20, 20, [](int, int y, int z) { return 5 * y + 6 * z; });
    const auto outcome = [this](const std::string& program, const std::string& words) {
        const ProgramRun run = folder.run(program, "-size 8 8 -output p.png " + words);
        const auto said = run.errors.find(": ");
        return std::pair(run.status, said == std::string::npos ? "" : run.errors.substr(said));
    };
    for (const auto& [words, status] : {std::pair("blob.tif -bricks 999 999 999", 1),
                                        {"blob.tif -bricks 900 1 900", 0},
                                        {"blob.tif -2D -bricks 9 900 900", 1},
                                        {"blob.tif -overlap 500", 1},
                                        {"blob.tif -overlap 16", 1},
                                        {"blob.tif -overlap 15", 0},
                                        {"blob.tif -bricks 3 3 3 -overlap 12", 0},
                                        {"thin.tif -overlap 2", 0},
                                        {"thin.tif -overlap 20", 1},
                                        {"blob.tif -shells", 0}}) {
        const auto drawn = outcome("voglBasic", words), rendered = outcome("vorender", words);
        EXPECT_EQ(drawn.first, status) << words << drawn.second;
        EXPECT_EQ(rendered, drawn) << words << rendered.second;
    }
    const std::string vain =
        ": option -shells: without effect, expected -perspective beside it, found none\n";
    EXPECT_EQ(outcome("voglBasic", "blob.tif -shells").second, vain);
    EXPECT_EQ(outcome("voglBasic", "blob.tif -shells -perspective 30").second, "");
}

TEST_F(VoglPrograms, fullOutputDeviceFails)
{
    const std::string programs = VOLUMIZER_PROGRAMS;
    for (const char* program : {"voglBasic", "voglSimple"}) {
        const ProgramRun run = folder.run("/bin/sh", {"-c", programs + "/" + program + " -help >/dev/full"});
        EXPECT_EQ(run.status, 1);
        EXPECT_EQ(run.errors, std::string(program) + ": cannot write to standard output\n");
    }
}

TEST_F(VoglPrograms, limitOnTheSizeOfFilesGivesOneLineAndNoPicture)
{
    writeBlob("blob.tif");
    const std::string programs = VOLUMIZER_PROGRAMS;
    for (const char* program : {"voglBasic", "voglSimple"}) {
        const ProgramRun run =
            folder.run("/bin/sh", {"-c", "ulimit -f 4 && " + programs + "/" + program +
                                             " blob.tif -view 20 30 -size 400 400 -output p.png"});
        EXPECT_EQ(run.status, 1) << program;
        EXPECT_EQ(run.errors.find(std::string(program) + ": p.png: cannot write"), 0u) << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_EQ(folder.files(), std::vector<std::string>{"blob.tif"}) << program;
    }
}

TEST_F(VoglPrograms, constantVolumeIsToldAndDrawn)
{
    vo::writeShorts(folder / "flat.tif", 6, 6, 6, [](int, int, int) { return 7; });
    const ProgramRun run = folder.run("voglBasic", "flat.tif -size 8 8 -output picture.png");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.errors, "voglBasic: flat.tif: all voxels are 7; nothing to tell apart\n");
}

TEST_F(VoglPrograms, unwritablePictureIsNamed)
{
    writeBlob("blob.tif");
    const ProgramRun run = folder.run("voglBasic", "blob.tif -size 8 8 -output nowhere/picture.png");
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.errors.find("nowhere/picture.png"), std::string::npos) << run.errors;
}

TEST_F(VoglPrograms, failureLeavesAnOlderPictureAlone)
{
    std::ofstream(folder / "picture.png") << "older";
    EXPECT_EQ(folder.run("voglBasic", "missing.tif -output picture.png").status, 1);
    EXPECT_EQ(vo::readFile(folder / "picture.png"), "older");
}

} // namespace
