// The program vox3d: what it prints, its exit status, and what it writes.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "run_program.h"
#include "scratch_folder.h"

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
    const std::string good = scene("good.x3d", "<VolumeData/>");
    const ProgramRun fine = vox3d("-check " + good);
    EXPECT_EQ(fine.status, 0);
    EXPECT_EQ(fine.output, good + ": nothing is unsupported or wrong\n");
    const std::string bad = scene("bad.x3d", "<Teapot/>\n<VolumeData dimensions='1 1'/>");
    const ProgramRun wrong = vox3d(bad + " -check");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_EQ(wrong.output, bad + ":2: warning: unknown node \"Teapot\" skipped\n" + bad +
                                ":3: error: VolumeData.dimensions: expected 3 values, found 2\n" +
                                "vox3d: " + bad + ": 1 error, 1 warning\n");
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

TEST_F(Vox3d, drawingIsAnsweredWithOneLine)
{
    const std::string good = scene("good.x3d", "<Group/>");
    const ProgramRun draw = vox3d(good);
    EXPECT_EQ(draw.status, 1);
    EXPECT_EQ(draw.output, "vox3d: " + good + ": drawing does not exist yet: expected -check or -save OUT\n");
    EXPECT_EQ(vox3d(good + " -output a.png").status, 1);
    EXPECT_EQ(vox3d("").status, 1);
    EXPECT_EQ(vox3d("-save").status, 1);
    EXPECT_EQ(vox3d("--help").status, 0);
}

} // namespace
} // namespace vo
