#include "appearance/cell_range_store.h"

#include <gtest/gtest.h>

namespace {

/// Ranges of so many cells.
std::shared_ptr<const vo::CellRanges> rangesOf(int cells)
{
    vo::CellRanges ranges;
    ranges.count = {cells, 1, 1};
    ranges.ranges.resize(static_cast<std::size_t>(cells));
    return std::make_shared<const vo::CellRanges>(ranges);
}

vo::CellRangeKey keyOf(std::uint64_t id)
{
    return {id, 1, vo::VoxelComponent::red, {0, 0, 0}};
}

TEST(CellRangeStore, givesWhatItKeepsAndNothingElse)
{
    vo::CellRangeStore store;
    const auto ranges = rangesOf(3);
    store.keep(keyOf(7), ranges);
    EXPECT_EQ(store.find(keyOf(7)), ranges);
    vo::CellRangeKey other = keyOf(7);
    other.version = 2;
    EXPECT_FALSE(store.find(other));
    other = keyOf(7);
    other.component = vo::VoxelComponent::alpha;
    EXPECT_FALSE(store.find(other));
    other = keyOf(7);
    other.origin = {0, 8, 0};
    EXPECT_FALSE(store.find(other));
    EXPECT_FALSE(store.find(keyOf(8)));
    EXPECT_EQ(store.find(keyOf(7)), ranges);
}

TEST(CellRangeStore, newVersionTakesThePlaceOfTheOld)
{
    vo::CellRangeStore store;
    store.keep(keyOf(7), rangesOf(3));
    const std::size_t bytes = store.bytes();
    vo::CellRangeKey newer = keyOf(7);
    newer.version = 2;
    store.keep(newer, rangesOf(3));
    EXPECT_EQ(store.bytes(), bytes);
    EXPECT_TRUE(store.find(newer));
    EXPECT_FALSE(store.find(keyOf(7)));
}

TEST(CellRangeStore, forgetsBothComponentsOfABrick)
{
    vo::CellRangeStore store;
    vo::CellRangeKey alpha = keyOf(7);
    alpha.component = vo::VoxelComponent::alpha;
    store.keep(keyOf(6), rangesOf(3));
    const std::size_t bytes = store.bytes();
    store.keep(keyOf(7), rangesOf(3));
    store.keep(alpha, rangesOf(3));
    store.forget(7);
    store.forget(9);
    EXPECT_FALSE(store.find(keyOf(7)));
    EXPECT_FALSE(store.find(alpha));
    EXPECT_TRUE(store.find(keyOf(6)));
    EXPECT_EQ(store.bytes(), bytes);
}

TEST(CellRangeStore, letsGoOfWhatWasAskedForLongestAgo)
{
    vo::CellRangeStore measured;
    measured.keep(keyOf(1), rangesOf(100));
    vo::CellRangeStore store(3 * measured.bytes());
    for (const std::uint64_t id : {1, 2, 3})
        store.keep(keyOf(id), rangesOf(100));
    EXPECT_TRUE(store.find(keyOf(1)));
    store.keep(keyOf(4), rangesOf(100));
    EXPECT_TRUE(store.find(keyOf(1)));
    EXPECT_FALSE(store.find(keyOf(2)));
    EXPECT_TRUE(store.find(keyOf(3)));
    EXPECT_LE(store.bytes(), 3 * measured.bytes());
    const auto held = store.find(keyOf(4));
    store.keep(keyOf(5), rangesOf(1000));
    EXPECT_EQ(store.bytes(), 0u) << "larger than the bound: not kept, nor anything else";
    EXPECT_EQ(held->ranges.size(), 100u) << "what is held lives on";
}

} // namespace
