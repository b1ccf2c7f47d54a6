// A library without CGAL has the class, and it says what is missing.
#include "../legacy/expect_error.h"

#include <vo/utClosedSurface.h>

#include <gtest/gtest.h>

namespace {

using namespace vo::test;

const float kCorners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const int kTriangles[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

TEST(VoutClosedSurfaceWithoutCgal, isUnsupportedFromArraysAndFiles)
{
    voutClosedSurface tetrahedron(kCorners, 4, kTriangles, 12);
    expectUnsupported("built without CGAL");
    voutClosedSurface file("surface.off");
    expectUnsupported("built without CGAL");
}

TEST(VoutClosedSurfaceWithoutCgal, givesNoTetrahedra)
{
    voutClosedSurface tetrahedron(kCorners, 4, kTriangles, 12);
    EXPECT_EQ(tetrahedron.tessellate(), nullptr);
    expectBadValue("there is no surface");
    voIndexedTetraSet *inside, *rest;
    const float lower[3] = {-1, -1, -1}, upper[3] = {2, 2, 2};
    EXPECT_EQ(tetrahedron.tessellateInBox(lower, upper, inside, rest), 1);
    EXPECT_EQ(inside, nullptr);
    EXPECT_EQ(rest, nullptr);
    expectBadValue("there is no surface");
}

} // namespace
