// Programs in two dialects: what compile/ holds was compiled as C++98, and as C++20 with all warnings. Each
// signature by itself: tests/contract.

#include "expect_error.h"

#include <gtest/gtest.h>

int guideProgram98(int size, int brickSize, voInterpolationType interpolationType);
int guideProgram20(int size, int brickSize, voInterpolationType interpolationType);
int dialect1998();
int reservedNames();

namespace {

using namespace vo::test;

TEST(CompileTest, guideProgramGivesTheSameInBothDialects)
{
    for (const voInterpolationType type : {voInterpolationTypeScope::_2D, voInterpolationTypeScope::_3D}) {
        const int polygons = guideProgram98(8, 5, type);
        EXPECT_GT(polygons, 8);
        EXPECT_EQ(guideProgram20(8, 5, type), polygons);
    }
    expectNoError();
}

TEST(CompileTest, dialectOf1998Works)
{
    EXPECT_EQ(dialect1998(), 48);
}

TEST(CompileTest, reservedNamesBelongToApplications)
{
    EXPECT_EQ(reservedNames(), 33);
}

} // namespace
