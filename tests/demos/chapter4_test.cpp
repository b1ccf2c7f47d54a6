#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

TEST(Chapter4, guidesProgramAndVoglSimpleDrawTheSamePicture)
{
    const vo::ScratchFolder folder;
    const std::string programs = VOLUMIZER_PROGRAMS;
    ASSERT_EQ(folder.run("mkcubes", "80 80 40 16 cubes.tif").status, 0);
    for (const auto& [latitude, longitude] : {std::pair{"0", "0"}, {"25", "35"}, {"-70", "200"}}) {
        const auto guides = folder.run(CHAPTER4_PROGRAM, {"cubes.tif", latitude, longitude, "guide.png"});
        ASSERT_EQ(guides.status, 0) << guides.errors;
        const auto ours = folder.run(programs + "/voglSimple",
                                     {"cubes.tif", "-view", latitude, longitude, "-size", "400", "400",
                                      "-wireframe", "-output", "ours.png"},
                                     "VO_OFFSCREEN=egl");
        ASSERT_EQ(ours.status, 0) << ours.errors;
        const auto a = vo::readPng(folder / "guide.png"), b = vo::readPng(folder / "ours.png");
        ASSERT_TRUE(a && b);
        EXPECT_EQ(a->bytes, b->bytes) << latitude << ' ' << longitude;
        EXPECT_GT(std::count_if(a->bytes.begin(), a->bytes.end(), [](int value) { return value > 50; }),
                  1000);
    }
}

} // namespace
