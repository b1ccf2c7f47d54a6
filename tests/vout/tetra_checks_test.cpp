// The checks see what is wrong.
#include "tetra_checks.h"

#include <gtest/gtest.h>

namespace {

using namespace vo::test;

/// The guide's cube, with all tetrahedra positive.
Tetras cube()
{
    return {3,
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
            {{0, 5, 2, 7}, {3, 0, 2, 7}, {1, 5, 2, 0}, {2, 6, 7, 5}, {5, 0, 4, 7}}};
}

TEST(TetraChecks, soundSolidsPass)
{
    expectSolid(cube(), 1, 6);
    const Surface surface = boxSurface({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    expectSolid(cube(), surface);
    EXPECT_NEAR(surface.volume(), 1, 1e-12);
    EXPECT_NEAR(surface.area(), 6, 1e-12);
    EXPECT_EQ(boundaryVertices(cube()).size(), 8u);
}

TEST(TetraChecks, turnedTetrahedronIsSeen)
{
    Tetras tetras = cube();
    std::swap(tetras.corners[2][0], tetras.corners[2][1]);
    EXPECT_NE(wrongHandedness(tetras), "");
    Tetras flat = cube();
    flat.records[6] = flat.records[2];
    EXPECT_NE(wrongHandedness(flat), "");
}

TEST(TetraChecks, tetrahedronTwiceIsSeen)
{
    Tetras tetras = cube();
    tetras.corners.push_back(tetras.corners[0]);
    EXPECT_NE(unmatchedFaces(tetras), "");
    EXPECT_NE(overlaps(tetras), "");
}

TEST(TetraChecks, otherDiagonalIsSeen)
{
    // A second cube to the right of the first, cut alike: the face between them is cut in two ways.
    Tetras tetras = cube();
    Tetras second = cube();
    for (auto& record : second.records)
        record[0] += 1;
    tetras.append(second);
    EXPECT_EQ(tetras.records.size(), 12u);
    EXPECT_EQ(overlaps(tetras), "");
    EXPECT_NEAR(volumeOf(tetras), 2, 1e-12);
    EXPECT_NEAR(areaOf(tetras), 12, 1e-12) << "10 outside and 2 between";
}

TEST(TetraChecks, overlapWithoutSharedFacesIsSeen)
{
    Tetras tetras = cube();
    tetras.records.insert(tetras.records.end(),
                          {{0.4f, 0.4f, 0.4f}, {2, 0.4f, 0.4f}, {0.4f, 2, 0.4f}, {0.4f, 0.4f, 2}});
    tetras.corners.push_back({8, 9, 10, 11});
    EXPECT_EQ(wrongHandedness(tetras), "");
    EXPECT_EQ(unmatchedFaces(tetras), "");
    EXPECT_NE(overlaps(tetras), "");
}

TEST(TetraChecks, regularTetrahedronHasItsDihedralAngle)
{
    const Tetras tetras{3, {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 3, 2}}};
    EXPECT_NEAR(smallestDihedral(tetras), 70.528779, 1e-5);
    EXPECT_NEAR(std::abs(volumeOf(tetras)), 8.0 / 3, 1e-6);
}

} // namespace
