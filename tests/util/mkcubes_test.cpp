#include <algorithm>
#include <cmath>
#include <csignal>
#include <sys/wait.h>

#include "run_program.h"
#include "scratch_folder.h"
#include "volume_truth.h"

namespace vo {
namespace {

/// The definition of the man page, in floating point.
int closedForm(std::array<std::int64_t, 3> voxel, double cubeSize)
{
    double farthest = 0;
    for (const std::int64_t i : voxel) {
        const double t = std::fmod(double(i) + 0.5, cubeSize) / cubeSize;
        farthest = std::max(farthest, std::abs(2 * t - 1));
    }
    return static_cast<int>(std::floor(255 * (1 - farthest) + 0.5 + 1e-9));
}

ProgramRun mkcubes(const std::string& arguments, const ScratchFolder& folder)
{
    return runProgram("cd '" + (folder / "") + "' && " MKCUBES " " + arguments);
}

TEST(Mkcubes, everyVoxelFollowsTheClosedForm)
{
    for (const auto& [size, cubeSize] : {std::pair{std::array<std::int64_t, 3>{32, 32, 32}, 16},
                                         {{20, 13, 9}, 7},
                                         {{5, 6, 7}, 1},
                                         {{5, 6, 7}, 2},
                                         {{3, 4, 5}, 1000},
                                         {{700, 3, 2}, 600}}) {
        ScratchFolder folder;
        const auto run = mkcubes(std::to_string(size[0]) + " " + std::to_string(size[1]) + " " +
                                     std::to_string(size[2]) + " " + std::to_string(cubeSize) + " a.tif",
                                 folder);
        ASSERT_EQ(run.status, 0) << run.output;
        EXPECT_EQ(run.output, "");
        auto volume = openVolume(folder / "a.tif");
        ASSERT_TRUE(volume) << volume.failure().text;
        ASSERT_EQ(volume->info(), (VolumeInfo{size, 1, ChannelType::uint8}));
        const auto bytes = readBrick(*volume, {{0, 0, 0}, size});
        std::size_t i = 0;
        int wrong = 0;
        for (std::int64_t z = 0; z < size[2]; ++z)
            for (std::int64_t y = 0; y < size[1]; ++y)
                for (std::int64_t x = 0; x < size[0]; ++x)
                    wrong += std::to_integer<int>(bytes[i++]) != closedForm({x, y, z}, cubeSize);
        EXPECT_EQ(wrong, 0) << "cube size " << cubeSize;
    }
}

TEST(Mkcubes, cubeSizeIsThePeriod)
{
    ScratchFolder folder;
    ASSERT_EQ(mkcubes("32 32 32 8 a.tif", folder).status, 0);
    auto volume = openVolume(folder / "a.tif");
    ASSERT_TRUE(volume);
    const auto row = readBrick(*volume, {{0, 3, 3}, {32, 1, 1}});
    EXPECT_EQ(std::ranges::count(row, std::byte{223}), 8); // the two middle voxels of 4 cubes
    EXPECT_EQ(row[0], std::byte{32});
    EXPECT_EQ(row[3], std::byte{223});
}

TEST(Mkcubes, fileIsOutTifUnlessNamed)
{
    ScratchFolder folder;
    ASSERT_EQ(mkcubes("4 4 4 2", folder).status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "out.tif"));
    EXPECT_EQ(folder.fileCount(), 1);
}

TEST(Mkcubes, badArgumentsGiveOneLineAndNoFile)
{
    for (const char* arguments : {"",
                                  "4",
                                  "4 4 4",
                                  "4 4 4 2 a.tif b.tif",
                                  "x 4 4 2",
                                  "4 4y 4 2",
                                  "4 4 0 2",
                                  "4 4 4 -2",
                                  "-4 4 4 2",
                                  "2147483648 4 4 2",
                                  "4 4 4 2147483648",
                                  "99999999999999999999 1 1 1",
                                  "4.0 4 4 2",
                                  "'' 4 4 2",
                                  "' 4' 4 4 2",
                                  "+4 4 4 2",
                                  "4 4 4 2 no/such/folder/a.tif",
                                  "4 4 4 2 .",
                                  "4 4 4 2 ''",
                                  "2147483647 2147483647 2147483647 1",
                                  "2147483647 2147483647 1 1"}) {
        ScratchFolder folder;
        const auto run = mkcubes(arguments, folder);
        EXPECT_EQ(run.status, 1) << arguments << run.output;
        EXPECT_EQ(run.output.find("mkcubes: "), 0u) << run.output;
        EXPECT_TRUE(run.output.find("expected") < run.output.size() ||
                    run.output.find("cannot write") < run.output.size())
            << run.output;
        EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
        EXPECT_TRUE(folder.isEmpty()) << arguments;
    }
}

TEST(Mkcubes, helpShowsAnExample)
{
    ScratchFolder folder;
    for (const char* help : {"-h", "-help", "--help", "4 4 -help"}) {
        const auto run = mkcubes(help, folder);
        EXPECT_EQ(run.status, 0);
        EXPECT_NE(run.output.find("mkcubes 256 256 256 128"), std::string::npos);
    }
    EXPECT_TRUE(folder.isEmpty());
}

TEST(Mkcubes, versionIsOneLine)
{
    ScratchFolder folder;
    for (const char* word : {"-version", "--version"}) {
        const auto run = mkcubes(word, folder);
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(run.output.find("Volumizer "), 0u) << run.output;
        EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
    }
    EXPECT_EQ(mkcubes("-help >/dev/full", folder).status, 1);
}

TEST(Mkcubes, fullDiskGivesOneLineAndNoFile)
{
    ScratchFolder folder;
    const auto run = runProgram("cd '" + (folder / "") +
                                "' && trap '' XFSZ && ulimit -f 8 && " MKCUBES " 64 64 64 8 a.tif");
    EXPECT_EQ(run.status, 1);
    expectSays(run.output.substr(0, run.output.size() - 1), {"mkcubes: a.tif: cannot write"});
    EXPECT_TRUE(folder.isEmpty());
}

TEST(Mkcubes, limitOnTheSizeOfFilesGivesOneLineAndNoFile)
{
    ScratchFolder folder;
    const auto run = runProgram("cd '" + (folder / "") + "' && ulimit -f 8 && " MKCUBES " 64 64 64 8 a.tif");
    EXPECT_EQ(run.status, 1);
    ASSERT_FALSE(run.output.empty());
    expectSays(run.output.substr(0, run.output.size() - 1), {"mkcubes: a.tif: cannot write"});
    EXPECT_TRUE(folder.isEmpty());
}

TEST(Mkcubes, memoryThatIsNotThereIsNamed)
{
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer reserves more than any limit";
#endif
    ScratchFolder folder;
    const auto run =
        runProgram("cd '" + (folder / "") + "' && ulimit -v 500000 && " MKCUBES " 500000000 1 1 8 a.tif");
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.output, "mkcubes: a.tif: expected memory for 500000000 bytes of voxels, found less\n");
    EXPECT_TRUE(folder.isEmpty());
}

TEST(Mkcubes, interruptedLeavesNoFile)
{
    ScratchFolder folder;
    // Large enough to be still at work when the signal comes: it waits for the temporary file to show.
    const auto run = runProgram(
        "cd '" + (folder / "") +
        "' && (" MKCUBES " 1000 1000 1000 8 a.tif & pid=$!; "
        "while [ -z \"$(ls)\" ] && kill -0 $pid; do sleep 0.01; done; kill -TERM $pid; wait $pid)");
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_NE(run.output.find("a.tif: interrupted"), std::string::npos) << run.output;
    EXPECT_TRUE(folder.isEmpty());
}

} // namespace
} // namespace vo
