// Colours without alpha in the file: as opaque as bright where slices are blended, opaque elsewhere.
#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace {

/// A core of one colour in black, of 16 voxels a side: without alpha, with an alpha of its brightness, and
/// opaque.
class Colours : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string rgb, bright, opaque;
        for (int i = 0; i < 16 * 16 * 16; ++i) {
            const auto isCore = [](int at) { return at >= 5 && at < 11; };
            const bool core = isCore(i % 16) && isCore(i / 16 % 16) && isCore(i / 256);
            const std::string voxel = core ? "\x60\x30\x18" : std::string(3, '\0');
            rgb += voxel;
            bright += voxel + voxel[0];
            opaque += voxel + '\xff';
        }
        for (const auto& [name, voxels] : {std::pair("rgb", rgb), {"bright", bright}, {"opaque", opaque}})
            vo::writeChannels(folder / (name + std::string(".nrrd")), 16, 16, 16, voxels);
        vo::writeBytes(folder / "tags.tif", 16, 16, 16, [](int, int, int) { return 1; });
        std::ofstream(folder / "warm.lut") << "0 0 0 0\n255 255 200 90\n";
    }

    /// The picture of a program and its words, the volume called VOLUME there; what it prints goes to `told`.
    vo::Picture draw(std::string words, const std::string& volume)
    {
        for (std::size_t at; (at = words.find("VOLUME")) != words.npos;)
            words.replace(at, 6, volume + ".nrrd");
        const std::size_t space = words.find(' ');
        const vo::ProgramRun run =
            folder.run(words.substr(0, space),
                       words.substr(space) + " -view 20 30 -size 60 60 -color -output picture.png");
        EXPECT_EQ(run.status, 0) << words << ": " << run.errors;
        told = run.output;
        const auto picture = vo::readPng(folder / "picture.png");
        EXPECT_TRUE(picture) << words;
        return picture ? *picture : vo::Picture{};
    }

    void expectSame(const std::string& words, const std::string& other)
    {
        const vo::Picture one = draw(words, "rgb");
        const std::string toldOfOne = told;
        EXPECT_EQ(vo::difference(one, draw(words, other)).largest, 0) << words;
        EXPECT_EQ(toldOfOne, told) << words;
    }

    vo::ScratchFolder folder;
    std::string told;
};

int brightest(const vo::Picture& picture)
{
    return *std::ranges::max_element(picture.bytes);
}

TEST_F(Colours, withoutAlphaAreAsOpaqueAsBright)
{
    for (const std::string words :
         {"voglBasic VOLUME", "voglBasic VOLUME -2D", "voglBasic VOLUME -bricks 2 2 2",
          "voglBasic VOLUME -engine cast", "voglBasic VOLUME -core", "voglCache VOLUME",
          "voglMorph VOLUME -twist 60", "voglSphere VOLUME -radius 8", "voglMirror VOLUME", "voglRoam VOLUME",
          "voglShade VOLUME", "voglTwo VOLUME VOLUME", "voglTagged VOLUME tags.tif",
          "voglSpaceLeap VOLUME 20 255"}) {
        expectSame(words, "bright");
        EXPECT_GT(brightest(draw(words, "rgb")), 20) << words;
    }
}

TEST_F(Colours, areAsInTheFileWithATableOrMaxima)
{
    for (const std::string words :
         {"voglBasic VOLUME -mip", "voglBasic VOLUME -lut 50 80", "voglBasic VOLUME -lutFile warm.lut",
          "voglTwo VOLUME VOLUME -lut 50 80 -lutFile2 warm.lut",
          "voglTagged VOLUME tags.tif -table 1 warm.lut"})
        expectSame(words, "opaque");
}

TEST_F(Colours, areAsInTheFileWhereNothingIsBlended)
{
    for (const std::string words :
         {"voglMPR1 VOLUME", "voglMPR1 VOLUME -2D", "voglMPR2 VOLUME", "voglPick VOLUME -pick 30 30"})
        expectSame(words, "opaque");
}

TEST_F(Colours, blackWithAnAlphaOfItsOwnHidesAll)
{
    EXPECT_EQ(brightest(draw("voglBasic VOLUME", "opaque")), 0);
}

} // namespace
