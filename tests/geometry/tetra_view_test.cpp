#include "geometry/tetra_view.h"

#include <gtest/gtest.h>

#include <vector>

TEST(TetraView, positionIsTheEndOfARecord)
{
    const std::vector<float> records{9, 1, 2, 3, 9, 4, 5, 6};
    const std::vector<int> indices{0, 1, 0, 1};
    const vo::TetraView view{records, 4, indices};
    EXPECT_EQ(view.tetraCount(), 1);
    EXPECT_EQ(view.record(1), records.data() + 4);
    EXPECT_EQ(view.position(1), glm::dvec3(4, 5, 6));
}

TEST(TetraView, emptyArraysHoldNoTetrahedra)
{
    EXPECT_EQ(vo::TetraView{}.tetraCount(), 0);
}
