#include "core/volume_size.h"

#include <gtest/gtest.h>

TEST(VolumeSize, countOfLargeVolumesDoesNotOverflow)
{
    EXPECT_EQ((vo::VoxelSize{4096, 4096, 4096}.count()), 68719476736u);
    EXPECT_EQ(vo::VoxelSize{}.count(), 1u);
}

TEST(VolumeSize, axesAreNumberedFromX)
{
    const vo::VoxelSize size{1, 2, 3};
    const vo::VoxelOrigin origin{4, 5, 6};
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(size[axis], 1 + axis);
        EXPECT_EQ(origin[axis], 4 + axis);
    }
}
