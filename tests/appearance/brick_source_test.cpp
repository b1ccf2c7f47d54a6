#include "appearance/brick_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

// A request that no memory can answer is to return null under the sanitizer too, as it does without.
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options()
{
    return "allocator_may_return_null=1";
}

namespace {

using vo::MemoryBrickSource;

TEST(MemoryBrickSource, hasNoVoxelsAtFirst)
{
    const MemoryBrickSource source(3);
    for (std::size_t brick = 0; brick < 3; ++brick) {
        EXPECT_TRUE(source.voxels(brick).empty());
        EXPECT_FALSE(source.owns(brick));
    }
}

TEST(MemoryBrickSource, allocatedVoxelsAreZeroAndItsOwn)
{
    MemoryBrickSource source(2);
    // Memory that was used before, so that zeros are no accident.
    ASSERT_TRUE(source.allocate(1, 1000));
    std::fill(source.voxels(1).begin(), source.voxels(1).end(), std::byte{0xee});
    source.release(1);
    ASSERT_TRUE(source.allocate(1, 1000));
    const auto voxels = source.voxels(1);
    ASSERT_EQ(voxels.size(), 1000u);
    EXPECT_TRUE(std::all_of(voxels.begin(), voxels.end(), [](std::byte b) { return b == std::byte{0}; }));
    EXPECT_TRUE(source.owns(1));
    EXPECT_TRUE(source.voxels(0).empty());
}

TEST(MemoryBrickSource, allocatingAgainGivesZeroedStorageOfTheNewSize)
{
    MemoryBrickSource source(1);
    ASSERT_TRUE(source.allocate(0, 100));
    source.voxels(0)[5] = std::byte{7};
    ASSERT_TRUE(source.allocate(0, 200));
    ASSERT_EQ(source.voxels(0).size(), 200u);
    EXPECT_EQ(source.voxels(0)[5], std::byte{0});
}

TEST(MemoryBrickSource, impossibleSizeIsRefusedAndChangesNothing)
{
    MemoryBrickSource source(1);
    ASSERT_TRUE(source.allocate(0, 100));
    std::byte* before = source.voxels(0).data();
    EXPECT_FALSE(source.allocate(0, std::numeric_limits<std::size_t>::max() / 2));
    EXPECT_EQ(source.voxels(0).data(), before);
    EXPECT_EQ(source.voxels(0).size(), 100u);
}

TEST(MemoryBrickSource, borrowedVoxelsAreForgottenNotFreed)
{
    std::array<std::byte, 16> mine{};
    mine[3] = std::byte{9};
    MemoryBrickSource source(1);
    ASSERT_TRUE(source.allocate(0, 100));
    source.borrow(0, mine);
    EXPECT_EQ(source.voxels(0).data(), mine.data());
    EXPECT_FALSE(source.owns(0));
    source.release(0);
    EXPECT_TRUE(source.voxels(0).empty());
    EXPECT_EQ(mine[3], std::byte{9});
}

TEST(MemoryBrickSource, releasingTwiceIsHarmless)
{
    MemoryBrickSource source(1);
    ASSERT_TRUE(source.allocate(0, 100));
    source.release(0);
    source.release(0);
    EXPECT_TRUE(source.voxels(0).empty());
    EXPECT_FALSE(source.owns(0));
}

} // namespace
