// voglCache, voglRaw and voglSpaceLeap, which draw what voglBasic draws.
#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace {

using vo::Picture;
using vo::ProgramRun;

int count(const std::string& text, const std::string& part)
{
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

class CachedDemos : public testing::Test
{
protected:
    Picture draw(const std::string& program, const std::string& words)
    {
        const auto drawn = vo::drawnPicture(folder, program, words);
        printed = drawn.printed;
        return drawn.picture;
    }

    void expectOneLine(const std::string& program, const std::string& words, const std::string& named)
    {
        vo::expectOneLine(folder, program, words, named);
    }

    vo::ScratchFolder folder;
    std::string printed;
};

/// 24 x 20 x 16 voxels, soft, different along each axis.
int blob(int x, int y, int z)
{
    const int d = (x - 9) * (x - 9) + 2 * (y - 12) * (y - 12) + 3 * (z - 6) * (z - 6);
    return std::max(0, 250 - 3 * d);
}

TEST_F(CachedDemos, cacheDrawsWhatBasicDraws)
{
    vo::writeBytes(folder / "blob.tif", 24, 20, 16, blob);
    std::ofstream(folder / "red.lut") << "0 0 0 0\n255 0 90 64\n";
    for (const char* words :
         {"", "-core", "-2D", "-2D -core -bricks 2 1 2", "-bricks 2 2 2", "-perspective 50 -mip",
          "-lutFile red.lut -space view", "-scale 1 1 2 -sampling 0.7 -wireframe",
          "-wireframe -bricks 2 1 1 -core", "-2D -wireframe"}) {
        const std::string line = std::string("blob.tif -view 20 30 -size 90 70 ") + words;
        const Picture basic = draw("voglBasic", line);
        EXPECT_GT(*std::max_element(basic.bytes.begin(), basic.bytes.end()), 40) << words;
        const auto apart = vo::difference(basic, draw("voglCache", line));
        // Outlines are drawn by other calls: where a yellow and a blue one meet, either may win.
        const bool outlined = line.find("-wireframe") != std::string::npos;
        EXPECT_LE(outlined ? apart.pixelsBeyondOne / 20 : apart.largest, 1)
            << words << ": " << apart.pixelsBeyondOne;
    }
}

TEST_F(CachedDemos, cacheKeepsPolygonsWithinTheThreshold)
{
    vo::writeBytes(folder / "blob.tif", 24, 20, 16, blob);
    const auto made = [this](const std::string& threshold) {
        const ProgramRun run = folder.run(std::string(VOLUMIZER_PROGRAMS) + "/voglCache",
                                          {"blob.tif", "-size", "40", "40", "-frames", "36", "-output",
                                           "last.png", "-engine", "slices", "-threshold", threshold},
                                          "VO_DEBUG=2");
        EXPECT_EQ(run.status, 0) << run.errors;
        EXPECT_EQ(count(run.errors, "new polygons") + count(run.errors, "kept polygons"), 36) << run.errors;
        return count(run.errors, "new polygons");
    };
    EXPECT_EQ(made("0"), 36) << "10 degrees a frame";
    EXPECT_EQ(made("15"), 18);
    EXPECT_EQ(made("35"), 9);
    EXPECT_EQ(vo::readPng(folder / "last.png")->width, 40);
    expectOneLine("voglCache", "blob.tif -threshold -1", "-threshold");
}

/// The same voxels in a TIFF and in raw files.
class RawDemo : public CachedDemos
{
protected:
    static constexpr int kX = 14, kY = 11, kZ = 6;

    template <typename Channel>
    void write(vo::ChannelType type, double factor, double offset)
    {
        std::vector<Channel> voxels;
        for (int z = 0; z < kZ; ++z)
            for (int y = 0; y < kY; ++y)
                for (int x = 0; x < kX; ++x)
                    voxels.push_back(Channel(offset + factor * (10 * x + 5 * y * (z + 1) - x * z)));
        ASSERT_TRUE(vo::writeTiffStack(folder / "volume.tif", {{kX, kY, kZ}, 1, type},
                                       std::as_bytes(std::span(voxels))));
        std::ofstream all(folder / "all.raw"), swapped(folder / "swapped.raw");
        all << "seven..";
        for (int z = 0; z < kZ; ++z) {
            std::ofstream slice(folder / ("slice" + std::to_string(z) + ".raw"));
            slice << "seven..";
            for (int i = 0; i < kX * kY; ++i) {
                char bytes[sizeof(Channel)];
                std::memcpy(bytes, &voxels[std::size_t(z * kX * kY + i)], sizeof(Channel));
                slice.write(bytes, sizeof bytes);
                all.write(bytes, sizeof bytes);
                std::reverse(bytes, bytes + sizeof bytes);
                swapped.write(bytes, sizeof bytes);
            }
        }
    }

    std::string slices(int number)
    {
        std::string names;
        for (int z = 0; z < number; ++z)
            names += " slice" + std::to_string(z) + ".raw";
        return names;
    }

    void expectBasicsPicture(const std::string& type, const std::string& view = "-view 20 30 -size 50 40")
    {
        const std::string words = view + " -engine slices"; // one way to draw, to the byte
        const Picture basic = draw("voglBasic", "volume.tif " + words);
        EXPECT_GT(*std::max_element(basic.bytes.begin(), basic.bytes.end()), 40) << type;
        const std::string sizes = " 14 11 6 " + type + " ";
        EXPECT_EQ(basic.bytes, draw("voglRaw", "7" + sizes + words + slices(kZ)).bytes) << type;
        EXPECT_EQ(basic.bytes, draw("voglRaw", "7" + sizes + "all.raw " + words).bytes) << type;
        EXPECT_EQ(basic.bytes, draw("voglRaw", "-bigEndian 0" + sizes + "swapped.raw " + words).bytes)
            << type;
    }
};

TEST_F(RawDemo, bytesDrawWhatBasicDraws)
{
    write<std::uint8_t>(vo::ChannelType::uint8, 0.5, 0);
    expectBasicsPicture("uchar");
    expectBasicsPicture("ubyte");
    write<std::int8_t>(vo::ChannelType::int8, 0.5, -100);
    expectBasicsPicture("char");
}

TEST_F(RawDemo, shortsDrawWhatBasicDraws)
{
    write<std::uint16_t>(vo::ChannelType::uint16, 130, 300);
    expectBasicsPicture("ushort");
    expectBasicsPicture("ushort", "-size 50 40 -2D -bricks 2 2 1 -core");
    write<std::int16_t>(vo::ChannelType::int16, 60, -9000);
    expectBasicsPicture("short");
}

TEST_F(RawDemo, floatsDrawWhatBasicDraws)
{
    write<float>(vo::ChannelType::float32, 0.003, -0.2);
    expectBasicsPicture("float");
}

TEST_F(RawDemo, badArgumentsAreNamed)
{
    write<std::uint8_t>(vo::ChannelType::uint8, 0.5, 0);
    expectOneLine("voglRaw", "7 14 11 6 uchar", "HEADER X Y Z TYPE");
    expectOneLine("voglRaw", "seven 14 11 6 uchar all.raw", "'seven'");
    expectOneLine("voglRaw", "7 14 0 6 uchar all.raw", "along y");
    expectOneLine("voglRaw", "7 14 11 6 int all.raw", "found \"int\"");
    expectOneLine("voglRaw", "7 14 11 6 uchar missing.raw", "missing.raw");
    expectOneLine("voglRaw", "7 14 11 6 uchar" + slices(5), "expected 6 files, one a slice, found 5");
    expectOneLine("voglRaw", "7 14 11 7 uchar all.raw", "all.raw: expected");
    expectOneLine("voglRaw", "8 14 11 6 uchar" + slices(6), "slice0.raw: expected");
    expectOneLine("voglRaw", "0 2000000000 2000000000 2000000000 float all.raw", "all.raw");
}

/// 40 x 32 x 24 voxels: two things far apart, and nothing else.
int twoThings(int x, int y, int z)
{
    const int ball = (x - 8) * (x - 8) + (y - 8) * (y - 8) + (z - 8) * (z - 8);
    const bool box = x >= 27 && x < 35 && y >= 14 && y < 30 && z >= 17 && z < 20;
    return box ? 150 : std::max(0, 240 - 9 * ball);
}

TEST_F(CachedDemos, spaceLeapDrawsWhatBasicDraws)
{
    vo::writeBytes(folder / "things.tif", 40, 32, 24, twoThings);
    for (const char* words :
         {"-tess 8", "-tess 8 -core", "-tess 5 -2D", "-tess 6 -bricks 2 2 2", "-tess 3 -perspective 50",
          "-tess 8 -mip -space view", "-tess 100", "-tess 8 -scale 1 2 1 -sampling 0.8"}) {
        const std::string line = std::string("-view 20 30 -size 90 70 ") + words;
        const Picture basic = draw("voglBasic", "things.tif " + line);
        for (const char* boxes : {"", "-separate "}) {
            const Picture leaped = draw("voglSpaceLeap", "things.tif 1 255 " + (boxes + line));
            EXPECT_LE(vo::difference(basic, leaped).largest, 1) << boxes << words;
        }
    }
}

TEST_F(CachedDemos, spaceLeapByTheLibrarysEnginesIsBasicToTheBit)
{
    vo::writeBytes(folder / "things.tif", 40, 32, 24, twoThings);
    for (const char* words : {"-tess 8", "-tess 4 -bricks 2 2 2 -core", "-tess 12 -perspective 50"})
        for (const char* engine : {" -engine slices", " -engine cast"}) {
            const std::string line = std::string("-view 20 30 -size 90 70 ") + words + engine;
            const Picture basic = draw("voglBasic", "things.tif " + line);
            draw("voglSpaceLeap", "things.tif 1 255 -view 20 30 -size 90 70 " + std::string(words));
            const std::string printedByLoop = printed;
            const Picture leaped = draw("voglSpaceLeap", "things.tif 1 255 " + line);
            EXPECT_EQ(basic.bytes, leaped.bytes) << line;
            EXPECT_EQ(printed, printedByLoop) << "fragments of polygons, though there may be none";
        }
}

TEST_F(CachedDemos, spaceLeapOutlinesBoxesWithoutDiagonals)
{
    // Two sub-cubes of 8 voxels that do not touch, seen along an axis: 24 voxels span half the diagonal.
    vo::writeBytes(folder / "two.tif", 24, 24, 24,
                   [](int x, int, int z) { return (x == 4 && z == 4) || (x == 20 && z == 20) ? 1 : 0; });
    const Picture p = draw("voglSpaceLeap", "two.tif 1 255 -size 300 300 -wireframe");
    EXPECT_NE(printed.find("in 2 boxes"), std::string::npos) << printed;
    const double pixelsPerVoxel = 300 / (24 * std::sqrt(3.0));
    const auto atEdge = [](double voxel, double low, double high) {
        return std::min(std::abs(voxel - low), std::abs(voxel - high)) < 0.3;
    };
    int outlined = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x) {
            if (channel(p, x, y, 0) < 100) continue; // yellow
            const double across = 12 + (x + 0.5 - 150) / pixelsPerVoxel,
                         up = 12 + (149.5 - y) / pixelsPerVoxel;
            const double low = across < 12 ? 0 : 16;
            ++outlined;
            EXPECT_TRUE(atEdge(across, low, low + 8) || atEdge(up, low, low + 8)) << x << ' ' << y;
        }
    EXPECT_GT(outlined, 4 * 2 * 8 * pixelsPerVoxel * 0.9);
}

struct Kept
{
    int cubes = 0;
    double share = 0; ///< of what the picture shows of the volume, seen along an axis
};

/// By reading every voxel that textures read in a sub-cube.
Kept keptBy(int size, int low, int high)
{
    const int volume[3] = {40, 32, 24};
    Kept kept;
    for (int z = 0; z < volume[2]; z += size)
        for (int y = 0; y < volume[1]; y += size)
            for (int x = 0; x < volume[0]; x += size) {
                bool below = true, above = true;
                double part = 1;
                const int from[3] = {x, y, z};
                for (int axis = 0; axis < 3; ++axis) {
                    const double first = std::max(from[axis] + 0.0, 0.5);
                    const double last = std::min(from[axis] + size + 0.0, volume[axis] - 0.5);
                    // Sampling planes lie in the middle of voxels, along y.
                    part *= axis == 1 ? std::min(from[1] + size, volume[1]) - from[1] : last - first;
                }
                for (int k = z - 1; k <= z + size; ++k)
                    for (int j = y - 1; j <= y + size; ++j)
                        for (int i = x - 1; i <= x + size; ++i) {
                            if (i < 0 || j < 0 || k < 0 || i > 39 || j > 31 || k > 23) continue;
                            below &= twoThings(i, j, k) < low;
                            above &= twoThings(i, j, k) > high;
                        }
                if (below || above) continue;
                kept.cubes++;
                kept.share += part / (39.0 * 32 * 23);
            }
    return kept;
}

TEST_F(CachedDemos, spaceLeapSaysWhatItSaves)
{
    vo::writeBytes(folder / "things.tif", 40, 32, 24, twoThings);
    for (const auto& [size, low, high] :
         {std::array{8, 1, 255}, std::array{5, 1, 255}, std::array{4, 150, 150}}) {
        draw("voglSpaceLeap", "things.tif -core -size 400 400 -tess " + std::to_string(size) + " " +
                                  std::to_string(low) + " " + std::to_string(high));
        const Kept kept = keptBy(size, low, high);
        int found = 0, all = 0, boxes = 0;
        double drawn = 0, whole = 0, saved = 0;
        ASSERT_EQ(
            std::sscanf(printed.c_str(),
                        "kept %d of %d sub-cubes, in %d boxes\n%lf fragments instead of %lf: saved %lf %%",
                        &found, &all, &boxes, &drawn, &whole, &saved),
            6)
            << printed;
        EXPECT_EQ(found, kept.cubes);
        EXPECT_GT(found, 0);
        EXPECT_LT(found, all);
        EXPECT_LT(boxes, found);
        const double pixels = 400 / std::hypot(40.0, 32.0, 24.0); // along a voxel
        EXPECT_NEAR(whole, 32 * 39 * 23 * pixels * pixels, 1e-3 * whole);
        EXPECT_NEAR(drawn, kept.share * whole, 1e-3 * whole);
        EXPECT_NEAR(saved, 100 * (1 - kept.share), 0.1);
    }
}

TEST_F(CachedDemos, spaceLeapKeepsWhatInterpolationBringsIntoTheRange)
{
    // Sub-cubes of 4: values leap from 0 to 200 between two of them, past 90 to 110.
    vo::writeBytes(folder / "step.tif", 8, 8, 8, [](int x, int, int) { return x < 4 ? 0 : 200; });
    std::ofstream lut(folder / "shell.lut");
    for (int i = 0; i < 256; ++i)
        lut << (i > 90 && i < 110 ? "255 200\n" : "0 0\n");
    lut.close();
    const std::string words = " -lutFile shell.lut -sampling 0.1 -size 40 40 -view 10 40";
    const Picture basic = draw("voglBasic", "step.tif" + words);
    EXPECT_GT(*std::max_element(basic.bytes.begin(), basic.bytes.end()), 200);
    const auto apart = vo::difference(basic, draw("voglSpaceLeap", "step.tif 90 110 -tess 2" + words));
    EXPECT_LE(apart.pixelsBeyondOne, 10);
    EXPECT_EQ(printed.find("kept 32 of 64 "), 0u) << printed;
}

TEST_F(CachedDemos, spaceLeapOfNothingIsBlack)
{
    vo::writeBytes(folder / "things.tif", 40, 32, 24, twoThings);
    const Picture nothing = draw("voglSpaceLeap", "things.tif 250 255 -size 30 30");
    EXPECT_EQ(*std::max_element(nothing.bytes.begin(), nothing.bytes.end()), 0);
    EXPECT_NE(printed.find("saved 100.0 %"), std::string::npos) << printed;
    expectOneLine("voglSpaceLeap", "things.tif", "LOW and HIGH");
    expectOneLine("voglSpaceLeap", "things.tif 5 x", "'x'");
    expectOneLine("voglSpaceLeap", "things.tif 5 4", "5 4");
    expectOneLine("voglSpaceLeap", "things.tif 5 9 -tess 0", "-tessellationSize");
    vo::writeBytes(folder / "large.tif", 80, 80, 80, twoThings);
    expectOneLine("voglSpaceLeap", "large.tif 5 9 -tess 1", "at most 262144 sub-cubes, found 512000");
}

TEST_F(CachedDemos, tenFramesEndAsTheyBegan)
{
    vo::writeBytes(folder / "blob.tif", 24, 20, 16, blob);
    for (const char* program : {"voglCache blob.tif", "voglSpaceLeap blob.tif 1 255"}) {
        const std::string line = program;
        const std::string name = line.substr(0, line.find(' ')), words = line.substr(line.find(' '));
        const Picture still = draw(name, words + " -size 24 24");
        EXPECT_EQ(draw(name, words + " -size 24 24 -frames 10").bytes, still.bytes) << program;
        EXPECT_NE(printed.find("10 frames, median "), std::string::npos) << printed;
    }
}

} // namespace
