// Every program that draws whole volumes makes the same picture with either engine.
#include "run_program.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

struct Drawing
{
    const char* program;
    const char* words;
};

std::ostream& operator<<(std::ostream& stream, const Drawing& drawing)
{
    return stream << drawing.program << " " << drawing.words;
}

class Engines : public testing::TestWithParam<Drawing>
{
protected:
    void SetUp() override
    {
        vo::writeBytes(folder / "blob.tif", 24, 20, 16, [](int x, int y, int z) {
            const int d = (x - 9) * (x - 9) + 2 * (y - 12) * (y - 12) + 3 * (z - 6) * (z - 6);
            return std::max(0, 250 - 3 * d);
        });
        std::ofstream(folder / "warm.lut") << "0 0 0 0\n90 20 0 0\n255 90 20 40\n255 255 200 90\n";
        vo::writeShorts(folder / "shorts.tif", 17, 19, 15,
                        [](int x, int y, int z) { return 40 * x * z + 130 * y; });
    }

    /// A picture of the words and `-engine ENGINE`; what the library says at debug level 2 goes to `told`.
    std::vector<float> draw(const std::string& words, const std::string& engine)
    {
        std::istringstream line(words + " -size 110 90 -output picture.png -engine " + engine);
        std::vector<std::string> arguments;
        for (std::string word; line >> word;)
            arguments.push_back(word);
        const vo::ProgramRun run =
            folder.run(std::string(VOLUMIZER_PROGRAMS "/") + GetParam().program, arguments, "VO_DEBUG=2");
        EXPECT_EQ(run.status, 0) << words << ": " << run.errors;
        told = run.errors;
        const auto picture = vo::readPng(folder / "picture.png");
        EXPECT_TRUE(picture) << words;
        return picture ? vo::pixelsOf(*picture) : std::vector<float>{};
    }

    vo::ScratchFolder folder;
    std::string told;
};

TEST_P(Engines, makeOnePicture)
{
    const std::vector<float> slices = draw(GetParam().words, "slices");
    EXPECT_NE(told.find("drawn as slices"), std::string::npos) << told;
    EXPECT_EQ(told.find("computed by the CPU engine"), std::string::npos) << told;
    const std::vector<float> cast = draw(GetParam().words, "cast");
    EXPECT_EQ(told.find("drawn as slices"), std::string::npos) << told;
    EXPECT_NE(told.find("computed by the CPU engine"), std::string::npos) << told;

    const vo::test::Comparison comparison = vo::test::compareDrawn(cast, slices);
    EXPECT_GE(comparison.psnrAll, 50) << comparison.summary();
    EXPECT_LE(comparison.fractionOff, 0.002) << comparison.summary();
    EXPECT_GT(comparison.opaquePixels, 150u);
}

constexpr Drawing kDrawings[] = {
    {"voglBasic", "blob.tif -lutFile warm.lut -view 20 30"},
    {"voglBasic", "blob.tif -view -30 200 -perspective 60 -bricks 2 2 2"},
    {"voglBasic", "blob.tif -mip -sampling 0.4 -view 10 60 -core"},
    {"voglBasic", "blob.tif -2D -lutFile warm.lut -view 10 60"},
    {"voglBasic", "blob.tif -shells -perspective 90 -view 10 60 -lutFile warm.lut"},
    {"voglBasic", "blob.tif -space view -view 10 60 -wireframe"},
    {"voglBasic", "shorts.tif -view 40 -70 -scale 1 1 1.4"},
    {"voglBasic", "blob.tif -bricks 3 2 2 -overlap 0 -view 20 30 -lutFile warm.lut"},
    {"voglCache", "blob.tif -lutFile warm.lut -view 20 30 -bricks 2 1 2"},
    {"voglSpaceLeap", "blob.tif -tess 8 1 255 -lutFile warm.lut -view 20 30 -separate"},
    {"voglSpaceLeap", "blob.tif -tess 6 1 255 -lutFile warm.lut -view 20 30"},
    {"voglMorph", "blob.tif -lutFile warm.lut -twist 60 -bend 40 -view 10 60"},
    {"voglMorph", "blob.tif -twist 60 -bend 40 -view 10 60 -bricks 2 2 1 -perspective 40"},
    {"voglSphere", "blob.tif -radius 9 -lutFile warm.lut -view 10 60"},
    {"voglMirror", "blob.tif -lutFile warm.lut -view -20 210"},
    {"voglPick", "blob.tif -lutFile warm.lut -view -20 210"},
};

INSTANTIATE_TEST_SUITE_P(Programs, Engines, testing::ValuesIn(kDrawings));

/// Programs with a loop of their own say that they keep to it.
class OwnLoops : public testing::Test
{
};

TEST_F(OwnLoops, sayThatTheEngineChangesNothing)
{
    const vo::ScratchFolder folder;
    vo::writeBytes(folder / "blob.tif", 9, 9, 9, [](int x, int y, int) { return 10 * x + 9 * y; });
    for (const std::string program : {"voglRoam", "voglShade", "voglMPR1"}) {
        const vo::ProgramRun run =
            folder.run(program, "blob.tif -size 30 30 -output picture.png -engine cast");
        EXPECT_EQ(run.status, 0) << run.errors;
        EXPECT_NE(run.errors.find(program + ": draws its polygons in a loop of its own"), std::string::npos)
            << run.errors;
    }
}

} // namespace
