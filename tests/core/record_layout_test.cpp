#include "core/record_layout.h"

#include <gtest/gtest.h>

TEST(RecordLayout, positionIsTheLastThreeFloats)
{
    EXPECT_EQ(vo::RecordLayout{}.position(), 0);
    EXPECT_EQ((vo::RecordLayout{10, 0, 3, 4}.position()), 7);
}
