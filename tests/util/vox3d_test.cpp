// The program vox3d: what it prints, its exit status, and what it writes.

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <regex>
#include <sstream>
#include <sys/stat.h>

#include "run_program.h"
#include "scratch_folder.h"
#include "volume_io/volume_io.h"

namespace vo {
namespace {

class Vox3d : public testing::Test
{
protected:
    std::string write(const std::string& name, const std::string& text)
    {
        std::ofstream(folder / name) << text;
        return folder / name;
    }
    std::string scene(const std::string& name, const std::string& nodes)
    {
        return write(name, "<X3D profile='Full' version='4.0'><Scene>\n" + nodes + "</Scene></X3D>");
    }
    static std::string read(const std::string& path)
    {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    static ProgramRun vox3d(const std::string& arguments) { return runProgram(VOX3D " " + arguments); }
    ScratchFolder folder;
};

TEST_F(Vox3d, checkListsWhatIsWrongWithItsLine)
{
    const std::string good = scene("good.x3d", "<Group/>");
    const ProgramRun fine = vox3d("-check " + good);
    EXPECT_EQ(fine.status, 0);
    EXPECT_EQ(fine.output, good + ": nothing is unsupported or wrong\n");
    const std::string bad =
        scene("bad.x3d", "<Teapot/>\n<Transform scale='1 1'/>\n<ClipPlane plane='0 0 0 -1'/>");
    const ProgramRun wrong = vox3d(bad + " -check");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(wrong.output,
              bad + ":2: warning: unknown node \"Teapot\" skipped\n" + bad +
                  ":3: error: Transform.scale: expected 3 values, found 2\n" + bad +
                  ":4: warning: ClipPlane.plane: expected a normal other than 0 0 0, found 0 0 0 -1: "
                  "cuts all away\n" +
                  "vox3d: " + bad + ": 1 error, 2 warnings\n");
    // What a check has told a picture does not tell again.
    const ProgramRun both =
        vox3d("-check -engine cast " + scene("plane.x3d", "<ClipPlane plane='0 0 0 -1'/>") + " -save " +
              (folder / "saved.x3d"));
    EXPECT_EQ(both.output.find("warning"), both.output.rfind("warning: ")) << both.output;
    const ProgramRun none = vox3d("-check " + write("none.x3d", "<X3D"));
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.output.find("none.x3d:1: error: expected XML"), std::string::npos) << none.output;
    EXPECT_EQ(vox3d("-check " + (folder / "absent.x3d")).status, 1);
}

TEST_F(Vox3d, saveWritesWhatReadsTheSame)
{
    const std::string first =
        scene("a.x3d", "<Group DEF='G'><VolumeData dimensions='1 2 3'/></Group>\n<Group USE='G'/>");
    EXPECT_EQ(vox3d(first + " -save " + (folder / "b.x3dv")).output, "");
    EXPECT_EQ(read(folder / "b.x3dv").substr(0, 14), "#X3D V4.0 utf8");
    EXPECT_EQ(vox3d((folder / "b.x3dv") + " -save " + (folder / "c.x3d")).status, 0);
    EXPECT_EQ(vox3d(first + " -save " + (folder / "d.x3d")).status, 0);
    EXPECT_EQ(read(folder / "c.x3d"), read(folder / "d.x3d"));
    EXPECT_NE(read(folder / "d.x3d").find("<VolumeData dimensions='1 2 3'/>"), std::string::npos);
    EXPECT_NE(read(folder / "d.x3d").find("<Group USE='G'/>"), std::string::npos);
}

TEST_F(Vox3d, saveKeepsFilesThatItShouldNotReplace)
{
    const std::string bad = scene("bad.x3d", "<VolumeData dimensions='1 1'/>"),
                      good = scene("good.x3d", "<Group/>");
    EXPECT_EQ(vox3d(bad + " -save " + (folder / "out.x3d")).status, 1);
    EXPECT_FALSE(std::filesystem::exists(folder / "out.x3d"));
    EXPECT_EQ(vox3d(good + " -save " + good).status, 1);
    const std::string other = write("notes.txt", "notes");
    EXPECT_EQ(vox3d(good + " -save " + other).status, 1);
    EXPECT_EQ(read(other), "notes");
    EXPECT_EQ(vox3d(good + " -save " + (folder / "absent/out.x3d")).status, 1);
    EXPECT_EQ(folder.fileCount(), 3);
}

TEST_F(Vox3d, pipesAreNotWaitedFor)
{
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const std::string& options : {pipe + " -check", pipe + " -save " + (folder / "out.x3d"),
                                       scene("good.x3d", "<Group/>") + " -save " + pipe}) {
        const ProgramRun run = vox3d(options);
        EXPECT_EQ(run.status, 1) << options;
        EXPECT_NE(run.output.find("expected a regular file"), std::string::npos) << run.output;
    }
}

TEST_F(Vox3d, allowLetsFilesIn)
{
    std::filesystem::create_directory(folder / "scene");
    std::filesystem::create_directory(folder / "data");
    scene("data/part.x3d", "<Group/>");
    const std::string top = scene("scene/top.x3d", "<Inline url='\"../data/part.x3d\"'/>");
    EXPECT_EQ(vox3d("-check " + top).status, 1);
    EXPECT_EQ(vox3d("-check -allow " + (folder / "data") + " " + top).status, 0);
    EXPECT_EQ(vox3d("-check -allow " + (folder / "absent") + " " + top).status, 1);
}

/// A cube of 2 x 2 x 2 voxels of one colour, with this opacity of a voxel, seen in the middle half of a
/// picture.
std::string cube(const std::string& rgba)
{
    return "<OrthoViewpoint DEF='Front' description='The front' position='0 0 5' fieldOfView='-2 -2 2 2'/>"
           "<OrthoViewpoint DEF='Near' position='0 0 5' fieldOfView='-1 -1 1 1'/>"
           "<Transform DEF='T'><VolumeData dimensions='2 2 2'>"
           "<PixelTexture3D containerField='voxels' image='1 2 2 2 128 128 128 128 128 128 128 128'/>"
           "<OpacityMapVolumeStyle><PixelTexture containerField='transferFunction' image='1 1 4 " +
           rgba + "'/></OpacityMapVolumeStyle></VolumeData></Transform>";
}

std::array<int, 3> pixel(const Picture& picture, int x, int y)
{
    const auto at =
        static_cast<std::size_t>(picture.channels) *
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    return {picture.bytes[at], picture.bytes[at + 1], picture.bytes[at + 2]};
}

class Vox3dPicture : public Vox3d
{
protected:
    Picture picture(const std::string& name)
    {
        const auto read = readPng(folder / name);
        EXPECT_TRUE(read) << name;
        return read ? *read : Picture();
    }
    std::string floats(const std::string& name, const std::string& sizes, const std::vector<float>& numbers,
                       const std::string& more = "")
    {
        std::ofstream file(folder / name, std::ios::binary);
        file << "NRRD0004\ntype: float\ndimension: 3\nsizes: " << sizes << "\nendian: little\nencoding: raw\n"
             << more << "\n";
        file.write(reinterpret_cast<const char*>(numbers.data()),
                   static_cast<std::streamsize>(numbers.size() * sizeof(float)));
        return folder / name;
    }
    /// A ball in a volume of values from 0 to 200.
    std::string ball()
    {
        const VolumeInfo info{{24, 20, 16}, 1, ChannelType::uint8};
        std::vector<std::byte> voxels;
        for (int z = 0; z < 16; ++z)
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 24; ++x) {
                    const double away = std::hypot(x - 11.5, y - 9.5, z - 7.5);
                    voxels.push_back(static_cast<std::byte>(std::clamp(200 - 40 * (away - 4), 0.0, 200.0)));
                }
        EXPECT_TRUE(writeTiffStack(folder / "ball.tif", info, voxels));
        return folder / "ball.tif";
    }
};

TEST_F(Vox3dPicture, aCubeHasTheOpacityOfItsLength)
{
    // Two voxels deep: 1 - (1 - 128/255)^2 of red, nothing beside it.
    const std::string path = scene("cube.x3d", cube("0xff000080"));
    const ProgramRun run = vox3d(path + " -size 32 32 -output " + (folder / "cube.png"));
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_EQ(run.output, "");
    const Picture seen = picture("cube.png");
    ASSERT_EQ(seen.width, 32);
    EXPECT_EQ(pixel(seen, 16, 16), (std::array{192, 0, 0}));
    EXPECT_EQ(pixel(seen, 9, 22), (std::array{192, 0, 0}));
    EXPECT_EQ(pixel(seen, 6, 16), (std::array{0, 0, 0}));
    EXPECT_EQ(vox3d(path + " -viewpoint Near -size 40 20 -output " + (folder / "near.png")).status, 0);
    EXPECT_EQ(pixel(picture("near.png"), 11, 1), (std::array{192, 0, 0})) << "the smaller side sees all";
    EXPECT_EQ(pixel(picture("near.png"), 8, 10), (std::array{0, 0, 0}));
    for (const char* name : {"Front", "'The front'", "1"})
        EXPECT_EQ(vox3d(path + " -size 32 32 -viewpoint " + name + " -output " + (folder / "f.png")).status,
                  0);
    EXPECT_EQ(read(folder / "f.png"), read(folder / "cube.png"));
}

TEST_F(Vox3dPicture, samplingChangesWhatPlanesMissAndNotTheOpacity)
{
    const std::string path = scene("cube.x3d", cube("0xff000080"));
    const auto seen = [&](const std::string& sampling) {
        const std::string options = " -size 32 32 -sampling " + sampling + " -output " + (folder / "s.png");
        EXPECT_EQ(vox3d(path + options).output, "");
        return pixel(picture("s.png"), 16, 16)[0];
    };
    EXPECT_EQ(seen("0.1"), 192);
    EXPECT_EQ(seen("1"), 192);
    // 50 times as far apart as 32 planes: one meets the cube, and counts for all of its distance.
    EXPECT_EQ(seen("50"), std::lround(255 * (1 - std::pow(1 - 128.0 / 255, 50 * 2 / 32.0))));
}

TEST_F(Vox3dPicture, framesGoOverTheCycleOfTheTimeSensors)
{
    const std::string moved =
        cube("0xffffffff") +
        "<TimeSensor DEF='C' cycleInterval='4' loop='true'/>"
        "<PositionInterpolator DEF='P' key='0 1' keyValue='0 0 0 4 0 0'/>"
        "<ROUTE fromNode='C' fromField='fraction_changed' toNode='P' toField='set_fraction'/>"
        "<ROUTE fromNode='P' fromField='value_changed' toNode='T' toField='translation'/>";
    const std::string path = scene("moved.x3d", moved);
    ASSERT_EQ(vox3d(path + " -size 32 32 -frames 4 -output " + (folder / "f%02d.png")).output, "");
    // The cube's left edge goes from pixel 8 by 8 pixels a frame.
    for (int frame = 0; frame < 4; ++frame) {
        const Picture seen = picture("f0" + std::to_string(frame) + ".png");
        for (int x = 0; x < 32; ++x)
            EXPECT_EQ(pixel(seen, x, 16)[0], x >= 8 + 8 * frame && x < 24 + 8 * frame ? 255 : 0)
                << frame << x;
    }
    EXPECT_EQ(vox3d(path + " -size 32 32 -time 2 -output " + (folder / "time.png")).status, 0);
    EXPECT_EQ(read(folder / "time.png"), read(folder / "f02.png"));
}

TEST_F(Vox3dPicture, withoutTimeSensorsFramesTurn)
{
    // A bar along x before the middle is seen at its end after a quarter.
    const std::string bar = "<OrthoViewpoint position='0 0 9' fieldOfView='-4 -4 4 4'/><NavigationInfo/>"
                            "<VolumeData dimensions='6 2 2'><PixelTexture3D containerField='voxels' "
                            "image='1 3 1 1 255 255 255'/></VolumeData>";
    const std::string path = scene("bar.x3d", bar);
    ASSERT_EQ(vox3d(path + " -size 32 32 -frames 4 -output " + (folder / "t%d.png")).output, "");
    const auto width = [&](const std::string& name) {
        int count = 0;
        for (int x = 0; x < 32; ++x)
            count += pixel(picture(name), x, 16)[0] > 0;
        return count;
    };
    EXPECT_EQ(width("t0.png"), 24);
    EXPECT_EQ(width("t1.png"), 8);
    EXPECT_EQ(width("t2.png"), 24);
}

TEST_F(Vox3dPicture, warningsAreToldAndErrorsEndWithOne)
{
    const std::string odd = scene("odd.x3d", "<Teapot/>" + cube("0xff000080"));
    const ProgramRun warned = vox3d(odd + " -size 8 8 -output " + (folder / "odd.png"));
    EXPECT_EQ(warned.status, 0);
    EXPECT_EQ(warned.output, odd + ":2: warning: unknown node \"Teapot\" skipped\n");
    const std::string bad = scene("bad.x3d", cube("0xff000080") + "<Group bboxSize='1'/>");
    const ProgramRun wrong = vox3d(bad + " -size 8 8 -output " + (folder / "bad.png"));
    EXPECT_EQ(wrong.status, 1);
    EXPECT_NE(wrong.output.find("bad.x3d: drawn without what is wrong: 1 error, 0 warnings"),
              std::string::npos)
        << wrong.output;
    EXPECT_EQ(read(folder / "bad.png"), read(folder / "odd.png"));
}

TEST_F(Vox3dPicture, aVolumeIsShownInEveryStyle)
{
    const std::string volume = ball();
    std::set<std::string> pictures;
    for (const char* style : {"opacity", "boundary", "cartoon", "edge", "silhouette", "tone", "shaded", "iso",
                              "projection", "stipple", "blended", "composed"}) {
        const std::string arguments = volume + " -size 48 48 -style " + style;
        const ProgramRun run =
            vox3d(arguments + " -output " + (folder / "a.png") + " -save " + (folder / "saved.x3d"));
        EXPECT_EQ(run.status, 0) << style << run.output;
        EXPECT_EQ(run.output, "") << style;
        const Picture seen = picture("a.png");
        EXPECT_EQ(pixel(seen, 1, 1), (std::array{0, 0, 0})) << style;
        int drawn = 0;
        for (int i = 0; i < 48 * 48; ++i)
            drawn += pixel(seen, i % 48, i / 48) != std::array{0, 0, 0};
        EXPECT_GT(drawn, 150) << style;
        const ProgramRun again = vox3d((folder / "saved.x3d") + " -size 48 48 -output " + (folder / "b.png"));
        EXPECT_EQ(again.status, 0) << style << again.output;
        EXPECT_EQ(read(folder / "b.png"), read(folder / "a.png")) << style;
        EXPECT_TRUE(pictures.insert(read(folder / "a.png")).second) << style << " looks like another one";
    }
    EXPECT_NE(read(folder / "saved.x3d").find("\"ball.tif\""), std::string::npos) << "relative to the scene";
}

TEST_F(Vox3dPicture, aViewIsThatOfTheOtherPrograms)
{
    // voglBasic's -view 0 90 looks from +x, where the right of a person is, and -view 0 0 from -y; positive
    // latitudes look from below.
    const auto eye = [&](const std::string& view) {
        EXPECT_EQ(vox3d(ball() + " -view " + view + " -save " + (folder / "view.x3d")).status, 0);
        const std::string text = read(folder / "view.x3d");
        std::istringstream numbers(text.substr(text.find("position='") + 10));
        std::array<double, 3> place{};
        numbers >> place[0] >> place[1] >> place[2];
        return place;
    };
    const auto right = eye("0 90"), back = eye("0 0"), below = eye("90 0");
    EXPECT_GT(right[0], 20);
    EXPECT_NEAR(right[1], 0, 1e-3);
    EXPECT_LT(back[1], -20);
    EXPECT_NEAR(back[0], 0, 1e-3);
    EXPECT_NEAR(below[0], 0, 1e-3);
    EXPECT_NEAR(below[1], 0, 1e-3);
    EXPECT_LT(below[2], -20);
}

TEST_F(Vox3dPicture, labelsChooseColoursAndHideWhatHasNone)
{
    const std::string volume = ball();
    const VolumeInfo info{{24, 20, 16}, 1, ChannelType::uint8};
    std::vector<std::byte> labels(24 * 20 * 16, std::byte{0});
    EXPECT_TRUE(writeTiffStack(folder / "none.tif", info, labels));
    for (std::size_t i = 0; i < labels.size(); ++i)
        labels[i] = std::byte(i % 24 < 12 ? 1 : 2);
    EXPECT_TRUE(writeTiffStack(folder / "halves.tif", info, labels));
    EXPECT_EQ(vox3d(volume + " -style cartoon -size 32 32 -labels " + (folder / "none.tif") + " -output " +
                    (folder / "none.png"))
                  .output,
              "");
    const Picture none = picture("none.png");
    for (int i = 0; i < 32 * 32; ++i)
        ASSERT_EQ(pixel(none, i % 32, i / 32), (std::array{0, 0, 0}));
    EXPECT_EQ(vox3d(volume + " -size 32 32 -labels " + (folder / "halves.tif") + " -output " +
                    (folder / "halves.png"))
                  .status,
              0);
    const auto left = pixel(picture("halves.png"), 13, 16), right = pixel(picture("halves.png"), 19, 16);
    EXPECT_NE(left, right);
    EXPECT_GT(left[0] + left[1] + left[2], 0);
    const ProgramRun wrong =
        vox3d(volume + " -labels " + VOLUMIZER_SOURCE_DIR "/data/volumes/brain-maps.tif -output " +
              (folder / "no.png"));
    EXPECT_EQ(wrong.status, 1);
    EXPECT_NE(wrong.output.find("expected 24 x 20 x 16 voxels as in " + volume), std::string::npos)
        << wrong.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "no.png"));
}

/// Halves of 1 and 2, and of 2 and 1. What a picture shows is linear in the colours of labels, so where they
/// change places a pixel changes along the difference of the two colours, whatever the style is.
TEST_F(Vox3dPicture, stylesWithColoursOfTheirOwnShowThoseOfLabels)
{
    const std::string volume = ball();
    for (const int first : {1, 2}) {
        std::vector<std::byte> labels(24 * 20 * 16);
        for (std::size_t i = 0; i < labels.size(); ++i)
            labels[i] = std::byte(i % 24 < 12 ? first : 3 - first);
        EXPECT_TRUE(writeTiffStack(folder / ("from" + std::to_string(first) + ".tif"),
                                   {{24, 20, 16}, 1, ChannelType::uint8}, labels));
    }
    const auto change = [&](const std::string& style) {
        std::array<std::array<int, 3>, 2> seen{};
        for (const int first : {1, 2}) {
            EXPECT_EQ(vox3d(volume + " -size 32 32 -style " + style + " -labels " +
                            (folder / ("from" + std::to_string(first) + ".tif")) + " -output " +
                            (folder / "p.png"))
                          .output,
                      "");
            seen[static_cast<std::size_t>(first - 1)] = pixel(picture("p.png"), 13, 16);
        }
        std::array<double, 3> difference{};
        double length = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            difference[c] = seen[0][c] - seen[1][c];
            length += difference[c] * difference[c];
        }
        EXPECT_GT(length, 30 * 30) << style;
        for (double& number : difference)
            number /= std::max(std::sqrt(length), 1.0);
        return difference;
    };
    const auto wanted = change("opacity");
    for (const char* const style : {"cartoon", "tone"}) {
        const auto found = change(style);
        EXPECT_GT(wanted[0] * found[0] + wanted[1] * found[1] + wanted[2] * found[2], 0.99) << style;
    }
}

/// The last colours of all tables of a scene, as they stand in it.
std::vector<std::array<int, 3>> lastColors(const std::string& scene)
{
    std::vector<std::array<int, 3>> colors;
    for (std::size_t at = scene.find(" image='"); at != std::string::npos;
         at = scene.find(" image='", at + 1)) {
        const std::size_t end = scene.find('\'', at + 8), last = scene.find_last_of(" \n", end - 2);
        const long long rgba = std::stoll(scene.substr(last, end - last), nullptr, 0);
        colors.push_back({int(rgba >> 24 & 255), int(rgba >> 16 & 255), int(rgba >> 8 & 255)});
    }
    return colors;
}

/// Squares of a grid have the labels 1 to 725 but for one, the last ones none.
TEST_F(Vox3dPicture, everyLabelHasAColourOfItsOwn)
{
    constexpr int kAcross = 27, kLabels = 725, kAbsent = 400;
    std::vector<std::uint16_t> labels(kAcross * kAcross * 4);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto label = static_cast<int>(i) % (kAcross * kAcross) + 1;
        labels[i] = static_cast<std::uint16_t>(label > kLabels || label == kAbsent ? 0 : label);
    }
    const auto* const bytes = reinterpret_cast<const std::byte*>(labels.data());
    EXPECT_TRUE(writeTiffStack(folder / "labels.tif", {{kAcross, kAcross, 4}, 1, ChannelType::uint16},
                               {bytes, bytes + 2 * labels.size()}));
    EXPECT_TRUE(writeTiffStack(folder / "even.tif", {{kAcross, kAcross, 4}, 1, ChannelType::uint8},
                               std::vector<std::byte>(labels.size(), std::byte{200})));
    const std::string made = (folder / "even.tif") + " -style edge -lut 100 50 -labels ";
    EXPECT_EQ(vox3d(made + (folder / "labels.tif") + " -save " + (folder / "made.x3d")).status, 0);
    const std::string text = read(folder / "made.x3d");
    const std::vector<std::array<int, 3>> colors = lastColors(text);
    ASSERT_EQ(colors.size(), std::size_t{kLabels - 1});
    EXPECT_EQ(std::set(colors.begin(), colors.end()).size(), colors.size());

    // Four voxels deep, each with an opacity of 0.9.
    write("seen.x3d",
          std::regex_replace(text, std::regex("<Viewpoint[^>]*/>"),
                             "<OrthoViewpoint position='0 0 9' fieldOfView='-13.5 -13.5 13.5 13.5'/>"));
    EXPECT_EQ(vox3d((folder / "seen.x3d") + " -size 270 270 -output " + (folder / "seen.png")).output, "");
    const Picture seen = picture("seen.png");
    for (int label = 1, i = 0; label <= kAcross * kAcross; ++label) {
        const bool isDrawn = label != kAbsent && label <= kLabels;
        const auto expected = isDrawn ? colors[static_cast<std::size_t>(i++)] : std::array{0, 0, 0};
        const auto there =
            pixel(seen, 10 * ((label - 1) % kAcross) + 5, 269 - (10 * ((label - 1) / kAcross) + 5));
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(there[c], expected[c], 1) << "label " << label;
    }
}

/// Whatever other labels there are.
TEST_F(Vox3dPicture, coloursOfLabelsGoByTheirNumbers)
{
    const auto colorOf = [&](const std::string& name, const std::vector<float>& numbers, std::size_t which) {
        std::vector<float> labels(24 * 20 * 16, 0);
        std::ranges::copy(numbers, labels.begin());
        EXPECT_EQ(vox3d(ball() + " -labels " + floats(name, "24 20 16", labels) + " -save " +
                        (folder / "saved.x3d"))
                      .status,
                  0);
        const auto colors = lastColors(read(folder / "saved.x3d"));
        EXPECT_EQ(colors.size(), numbers.size());
        return colors.at(which);
    };
    EXPECT_EQ(colorOf("few.nrrd", {7, 300}, 1), colorOf("more.nrrd", {1, 2, 7, 299, 300, 4096}, 4));
    EXPECT_NE(colorOf("few.nrrd", {7, 300}, 0), colorOf("few.nrrd", {8, 300}, 0));
}

TEST_F(Vox3dPicture, labelsAreWholeNumbers)
{
    const std::string labels = floats("labels.nrrd", "24 20 16", std::vector<float>(24 * 20 * 16, 1.5f));
    const ProgramRun run = vox3d(ball() + " -labels " + labels + " -output " + (folder / "no.png"));
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.output,
              "vox3d: " + labels +
                  ": expected whole numbers of segments, found 1.5 and 7679 more that are none\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "no.png"));
    const std::string whole = floats("whole.nrrd", "24 20 16", std::vector<float>(24 * 20 * 16, 2));
    EXPECT_EQ(vox3d(ball() + " -size 8 8 -labels " + whole + " -output " + (folder / "yes.png")).output, "");
}

TEST_F(Vox3dPicture, valuesThatAreNoNumbersAreToldOf)
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::string none = floats("none.nrrd", "2 1 2", {kNan, kNan, kInfinity, kNan});
    const std::string to = " -size 8 8 -output " + (folder / "a.png");
    const ProgramRun nothing = vox3d(none + to);
    EXPECT_EQ(nothing.status, 1);
    EXPECT_EQ(nothing.output,
              "vox3d: " + none +
                  ": expected numbers, found only 3 that are none (NaN) and 1 infinite ones\n");
    const std::string some = floats("some.nrrd", "2 1 2", {1, kNan, -kInfinity, 3});
    const ProgramRun drawn = vox3d(some + to);
    EXPECT_EQ(drawn.status, 0);
    EXPECT_EQ(drawn.output,
              some + ": warning: ImageTexture3D: " + some +
                  ": expected numbers, found 1 that are none (NaN) and 1 infinite ones among 4: NaN "
                  "and -infinity count as the smallest, infinity as the largest\n");
}

TEST_F(Vox3dPicture, optionsThatLeaveNothingToBeSeenAreToldOf)
{
    const std::string volume = ball(), to = " -size 8 8 -output " + (folder / "a.png");
    const auto told = [&](const std::string& options) { return vox3d(volume + options + to).output; };
    EXPECT_EQ(
        told(" -lut 1e9 1"),
        "vox3d: option -lut: expected values that become opaque from below 200 on, found them clear up to "
        "1e+09, and " +
            volume + " with values from 0 to 200: nothing is seen\n");
    EXPECT_EQ(told(" -lut 200 2"), "");
    EXPECT_EQ(told(" -style iso -lut 9999 1"),
              "vox3d: option -lut: expected a center that voxels are below and above, found 9999 for " +
                  volume + " with values from 0 to 200: nothing is seen\n");
    EXPECT_EQ(told(" -style iso -lut 0 1"),
              "vox3d: option -lut: expected a center that voxels are below and above, found 0 for " + volume +
                  " with values from 0 to 200: nothing is seen\n");
    EXPECT_EQ(told(" -style iso -lut 199 1"), "");
    std::string table;
    for (int i = 0; i < 256; ++i)
        table += "255 255 255 " + std::string(i > 250 ? "255" : "0") + "\n";
    // Over all values of 8 bits: nothing up to 250.
    const std::string late = write("late.lut", table);
    EXPECT_EQ(told(" -lutFile " + late), "vox3d: " + late + ": expected opacities above 0 for voxels of " +
                                             volume +
                                             ", found none for values from 0 to 200: nothing is seen\n");
    EXPECT_EQ(told(" -style projection -lut 1 1"),
              "vox3d: option -lut: changes nothing with -style projection\n");
}

TEST_F(Vox3dPicture, colouredVoxelsKeepTheirColoursBesideLabels)
{
    const VolumeInfo info{{8, 8, 8}, 4, ChannelType::uint8};
    EXPECT_TRUE(writeTiffStack(folder / "colours.tif", info, std::vector<std::byte>(4 * 512, std::byte{99})));
    const std::string labels = floats("labels.nrrd", "8 8 8", std::vector<float>(512, 1));
    const auto told = [&](const std::string& style) {
        return vox3d((folder / "colours.tif") + " -size 8 8 -labels " + labels + " -style " + style +
                     " -output " + (folder / "a.png"))
            .output;
    };
    EXPECT_EQ(told("opacity"),
              "vox3d: option -labels: gives no colours to voxels that have colours, and hides "
              "those of the number 0\n");
    EXPECT_EQ(told("cartoon"), "") << "its colours are those of labels";
}

/// What a command reads from files, as the system counts it.
long long bytesRead(const std::string& command)
{
    const ProgramRun run = runProgram("sh -c '" + command + "; cat /proc/$$/io'");
    const std::size_t at = run.output.find("rchar: ");
    return at == std::string::npos ? 0 : std::stoll(run.output.substr(at + 7));
}

TEST_F(Vox3dPicture, filesOfVolumesAndLabelsAreReadOnce)
{
    constexpr long long kBytes = 4 * 100 * 100 * 100;
    const std::vector<float> few(8, 1), many(100 * 100 * 100, 2);
    const std::string small = floats("small.nrrd", "2 2 2", few),
                      large = floats("large.nrrd", "100 100 100", many);
    const auto bytesOf = [&](const std::string& arguments) {
        return bytesRead(VOX3D " -size 8 8 -output " + (folder / "a.png ") + arguments);
    };
    const long long least = bytesOf(small);
    ASSERT_GT(least, 0) << "/proc/PID/io counts them";
    EXPECT_LT(double(bytesOf(large) - least) / kBytes, 1.5);
    EXPECT_LT(double(bytesOf(large + " -labels " + large) - least) / kBytes, 3.0);
}

TEST_F(Vox3dPicture, aSceneWithNothingToDrawIsToldOf)
{
    const std::string path = scene("none.x3d", "<Group/>");
    EXPECT_EQ(vox3d(path + " -size 8 8 -output " + (folder / "a.png")).output,
              "vox3d: " + path + ": expected volumes or shapes to draw, found none\n");
}

TEST_F(Vox3dPicture, voxelsThatAreAllTheSameAreABody)
{
    const std::string to = " -size 8 8 -output " + (folder / "a.png");
    const std::string one = floats("one.nrrd", "1 1 1", {5});
    EXPECT_EQ(vox3d(one + to).output, one + ": warning: ImageTexture3D: " + one +
                                          ": expected numbers that differ, found 5 alone: taken as 0\n");
    EXPECT_GT(pixel(picture("a.png"), 4, 4)[0], 0);
    EXPECT_NE(
        vox3d(one + " -style iso" + to)
            .output.find("vox3d: " + one +
                         ": expected values below and above a surface, found the value 5 alone: nothing "
                         "is seen\n"),
        std::string::npos);
    const std::string none = floats("none.nrrd", "1 2 1", {0, 0});
    EXPECT_NE(
        vox3d(none + to).output.find("vox3d: " + none +
                                     ": expected values that differ, found the value 0 alone: nothing is "
                                     "seen\n"),
        std::string::npos);
}

TEST_F(Vox3dPicture, foldersThatASavedSceneNeedsAreToldOnce)
{
    std::filesystem::create_directory(folder / "scenes");
    const std::string labels = floats("labels.nrrd", "24 20 16", std::vector<float>(24 * 20 * 16, 1));
    const std::string saved = folder / "scenes/s.x3d";
    EXPECT_EQ(vox3d(ball() + " -labels " + labels + " -save " + saved).output,
              "vox3d: " + saved + ": is read with -allow " +
                  std::filesystem::canonical(folder / ".").string() + "\n");
}

TEST_F(Vox3dPicture, spacingsThatNoSceneHasBecomeOne)
{
    const std::string path = floats("far.nrrd", "2 1 2", {1, 2, 3, 4}, "spacings: 1e300 1 1\n");
    const ProgramRun run = vox3d(path + " -size 8 8 -output " + (folder / "a.png"));
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.output,
              "vox3d: " + path +
                  ": expected edges from 1e-15 to 1e15 long, found voxels 1e+300 apart: taken as 1\n");
}

TEST_F(Vox3dPicture, wrongOptionsSayWhatTheSceneHas)
{
    const std::string path = scene("cube.x3d", cube("0xff000080")), none = scene("none.x3d", "<Group/>");
    const std::string to = " -output " + (folder / "a.png");
    EXPECT_EQ(vox3d(path + " -viewpoint nix" + to).output,
              "vox3d: option -viewpoint: expected a viewpoint of " + path +
                  ": 1 (Front, The front), 2 (Near); found \"nix\"\n");
    EXPECT_EQ(vox3d(none + " -viewpoint nix" + to).output, "vox3d: option -viewpoint: expected none, since " +
                                                               none + " has no viewpoints; found \"nix\"\n");
    EXPECT_EQ(vox3d(path + " -time 1e300" + to).output,
              "vox3d: option -time: expected a time from -1e12 to 1e12 seconds, found \"1e300\"\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST_F(Vox3dPicture, aLongPictureEndsWhenItIsToldTo)
{
    std::string nodes = "<Group DEF='G0'>" + cube("0xff000001") + "</Group>";
    for (int level = 1; level <= 9; ++level) {
        const std::string before = "<Group USE='G" + std::to_string(level - 1) + "'/>";
        nodes += "<Group DEF='G" + std::to_string(level) + "'>" + before + before + "</Group>";
    }
    const std::string output = folder / "long.png";
    const ProgramRun run = runProgram("timeout -s TERM -k 60 2 " VOX3D " " + scene("long.x3d", nodes) +
                                      " -size 8000 8000 -output " + output);
    EXPECT_EQ(run.status, 124) << "137: it went on until it was killed\n" << run.output;
    EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(Vox3dPicture, nothingHalfWrittenStays)
{
    const std::string path = scene("far.x3d", "<Viewpoint position='0 0 1000'/><Shape><Box/></Shape>");
    // The signal comes when the unfinished file is there.
    const ProgramRun run = runProgram(VOX3D " " + path + " -size 5000 5000 -output " + (folder / "a.png") +
                                      " & while kill -0 $! && ! ls " + (folder / ".") +
                                      " | grep -q partial; do sleep 0.01; done;"
                                      " kill -TERM $!; wait $!");
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_NE(run.output.find("interrupted\n"), std::string::npos) << run.output;
    EXPECT_EQ(folder.fileCount(), 1);
}

#if !defined(__SANITIZE_ADDRESS__) // which reserves more than any limit
TEST_F(Vox3dPicture, sizesBeyondTheMemoryAreRefused)
{
    const std::string path = scene("cube.x3d", cube("0xff000080"));
    const ProgramRun run = runProgram("ulimit -v 4194304; " VOX3D " " + path +
                                      " -engine cast -size 32768 32768 -output " + (folder / "a.png"));
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.output.find("expected a picture that 4.0 GiB of memory hold, found 32768 x 32768 pixels, "
                              "which take 39.0 GiB\n"),
              std::string::npos)
        << run.output;
    EXPECT_EQ(folder.fileCount(), 1);
}
#endif

TEST_F(Vox3dPicture, withoutADisplayAPictureIsWritten)
{
    const std::string path = scene("cube.x3d", cube("0xff000080"));
    const ProgramRun run = runProgram(
        "cd " + (folder / ".") + " && env -u DISPLAY -u WAYLAND_DISPLAY " VOX3D " " + path + " -size 32 32");
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_NE(run.output.find("vox3d: no window ("), std::string::npos) << run.output;
    EXPECT_EQ(pixel(picture("vox3d.png"), 16, 16), (std::array{192, 0, 0}));
}

TEST_F(Vox3dPicture, wrongArgumentsAreAnsweredWithOneLine)
{
    const std::string good = scene("good.x3d", cube("0xff000080"));
    const std::string out = " -output " + (folder / "out.png");
    const auto refused = [&](const std::string& arguments, const std::string& text) {
        const ProgramRun run = vox3d(arguments);
        EXPECT_EQ(run.status, 1) << arguments;
        EXPECT_NE(run.output.find(text), std::string::npos) << arguments << ": " << run.output;
        EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
    };
    refused("", "expected a scene or a volume, found none");
    refused(good + " -teapot", "expected an option that vox3d -help lists, found \"-teapot\"");
    refused(good + " -size 0 5" + out, "option -size: expected a width from 1 to 32768, found \"0\"");
    refused(good + " -size 10 5.5" + out, "option -size: expected a height from 1 to 32768, found \"5.5\"");
    refused(good + " -size 10", "option -size: expected a height from 1 to 32768, found the end");
    refused(good + " -output a.jpg", "option -output: expected a file name that ends in .png");
    refused(good + " -viewpoint Back" + out, "found \"Back\"");
    refused(good + " -frames 3", "option -frames: expected -output FILE.png beside it");
    for (const char* const name : {"f%s.png", "f.png"})
        refused(good + " -frames 3 -output " + name, "option -output: expected a name with a %d or %03d for "
                                                     "the number of each of the -frames, found '" +
                                                         std::string(name) + "'");
    refused(good + " -sampling 0" + out,
            "option -sampling: expected a distance from 0.01 to 100, found \"0\"");
    refused(good + " -engine ray" + out, "option -engine: expected slices or cast, found \"ray\"");
    refused(good + " -style cartoon" + out, "option -style: expected a volume, found the scene");
    refused(good + " -style teapot" + out, "option -style: expected a style (opacity, boundary");
    refused(good + " -save ''", "option -save: expected a file name, found \"\"");
    refused(good + " -labels ''", "option -labels: expected a file name, found \"\"");
    refused(good + " -save -output" + out, "option -save: expected a file name, found the option -output");
    refused("'\033[31m'", ".[31m: cannot open");
    refused(good + " " + good, "expected one scene or volume");
    refused(good + " -output " + (folder / "absent/out.png"), "absent");
    refused((folder / "absent.tif") + out, "absent.tif");
    refused(write("text.txt", "nothing") + out, "text.txt");
    EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
    EXPECT_EQ(vox3d("--help").status, 0);
    EXPECT_NE(vox3d("-help").output.find("vox3d head.nii -style cartoon -output head.png"),
              std::string::npos);
}

} // namespace
} // namespace vo
