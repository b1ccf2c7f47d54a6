#include "appearance/brick_grid.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

namespace {

using vo::Box;
using vo::BrickExtent;
using vo::BrickGridRequest;
using vo::PartialBricks;
using vo::VoxelOrigin;
using vo::VoxelSize;

constexpr VoxelSize kGuideVolume{256, 256, 190};

BrickGridRequest guideRequest(PartialBricks partial)
{
    return {kGuideVolume, {128, 128, 128}, 1, partial};
}

Box clipBoxOf(const BrickExtent& brick, const VoxelSize& volume, int overlap)
{
    return vo::clipBox({brick.origin.x, brick.origin.y, brick.origin.z},
                       {brick.size.x, brick.size.y, brick.size.z}, volume, overlap);
}

/// Bricks on one axis, the others being 1 thick.
std::vector<BrickExtent> bricksAlong(int axis, int volume, int brick, int overlap, PartialBricks partial)
{
    VoxelSize volumeSize;
    VoxelSize brickSize;
    (axis == 0 ? volumeSize.x : axis == 1 ? volumeSize.y : volumeSize.z) = volume;
    (axis == 0 ? brickSize.x : axis == 1 ? brickSize.y : brickSize.z) = brick;
    return vo::brickGrid({volumeSize, brickSize, overlap, partial});
}

TEST(BrickGrid, truncateDropsWhatFillsNoBrick)
{
    const auto bricks = vo::brickGrid(guideRequest(PartialBricks::truncate));
    ASSERT_EQ(bricks.size(), 4u); // 2 x 2 x 1: the layers from 128 on are discarded
    EXPECT_EQ(vo::brickCount(guideRequest(PartialBricks::truncate)), 4);
    for (const BrickExtent& brick : bricks)
        EXPECT_EQ(brick.size, (VoxelSize{128, 128, 128}));
    EXPECT_EQ(bricks[3].origin, (VoxelOrigin{127, 127, 0}));
}

TEST(BrickGrid, augmentKeepsTheSizeAskedFor)
{
    const auto bricks = vo::brickGrid(guideRequest(PartialBricks::augment));
    ASSERT_EQ(bricks.size(), 18u); // 3 x 3 x 2
    EXPECT_EQ(vo::brickCount(guideRequest(PartialBricks::augment)), 18);
    for (const BrickExtent& brick : bricks)
        EXPECT_EQ(brick.size, (VoxelSize{128, 128, 128}));
    EXPECT_EQ(bricks.back().origin, (VoxelOrigin{254, 254, 127}));
}

TEST(BrickGrid, augmentTightShrinksTheLastToAPowerOfTwo)
{
    const auto bricks = vo::brickGrid(guideRequest(PartialBricks::augmentTight));
    ASSERT_EQ(bricks.size(), 18u);
    EXPECT_EQ(bricks.front().size, (VoxelSize{128, 128, 128}));
    EXPECT_EQ(bricks.back().size, (VoxelSize{2, 2, 64}));
    EXPECT_EQ(bricks.back().origin, (VoxelOrigin{254, 254, 127}));
}

TEST(BrickGrid, xRunsFastestThenYThenZ)
{
    const auto bricks = vo::brickGrid({{4, 4, 4}, {2, 2, 2}, 0, PartialBricks::augment});
    ASSERT_EQ(bricks.size(), 8u);
    for (int i = 0; i < 8; ++i) {
        const VoxelOrigin expected{2 * (i & 1), 2 * (i >> 1 & 1), 2 * (i >> 2 & 1)};
        EXPECT_EQ(bricks[static_cast<std::size_t>(i)].origin, expected) << i;
    }
}

TEST(BrickGrid, bricksOneThickIgnoreTheOverlap)
{
    for (const PartialBricks partial :
         {PartialBricks::truncate, PartialBricks::augment, PartialBricks::augmentTight}) {
        const auto slices = vo::brickGrid({{64, 64, 5}, {64, 64, 1}, 1, partial});
        ASSERT_EQ(slices.size(), 5u);
        for (int z = 0; z < 5; ++z) {
            const BrickExtent& slice = slices[static_cast<std::size_t>(z)];
            EXPECT_EQ(slice.origin, (VoxelOrigin{0, 0, z}));
            const Box box = clipBoxOf(slice, {64, 64, 5}, 1);
            EXPECT_EQ(box.lower, glm::dvec3(0.5, 0.5, z));
            EXPECT_EQ(box.upper, glm::dvec3(63.5, 63.5, z + 1));
        }
    }
}

TEST(BrickGrid, brickLargerThanTheVolume)
{
    EXPECT_EQ(bricksAlong(0, 100, 512, 1, PartialBricks::truncate).at(0).size.x, 100);
    EXPECT_EQ(bricksAlong(0, 100, 512, 1, PartialBricks::augment).at(0).size.x, 512);
    EXPECT_EQ(bricksAlong(0, 100, 512, 1, PartialBricks::augmentTight).at(0).size.x, 128);
    EXPECT_EQ(bricksAlong(0, 100, 120, 1, PartialBricks::augmentTight).at(0).size.x, 120);
    for (const PartialBricks partial :
         {PartialBricks::truncate, PartialBricks::augment, PartialBricks::augmentTight})
        EXPECT_EQ(bricksAlong(0, 100, 512, 1, partial).size(), 1u);
}

TEST(BrickGrid, countsFollowTheFormulaOnEveryAxis)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int volume = 1; volume <= 40; ++volume)
            for (int brick = 2; brick <= 20; ++brick)
                for (int overlap = 0; overlap < brick && overlap <= 4; ++overlap) {
                    const double bricks = static_cast<double>(volume - overlap) / (brick - overlap);
                    const auto truncated = static_cast<std::size_t>(std::max(1.0, std::floor(bricks)));
                    const auto augmented = static_cast<std::size_t>(std::max(1.0, std::ceil(bricks)));
                    EXPECT_EQ(bricksAlong(axis, volume, brick, overlap, PartialBricks::truncate).size(),
                              truncated);
                    EXPECT_EQ(bricksAlong(axis, volume, brick, overlap, PartialBricks::augment).size(),
                              augmented);
                    EXPECT_EQ(bricksAlong(axis, volume, brick, overlap, PartialBricks::augmentTight).size(),
                              augmented);
                }
}

TEST(BrickGrid, augmentedBricksCoverTheVolumeAndShareTheOverlap)
{
    for (const PartialBricks partial : {PartialBricks::augment, PartialBricks::augmentTight})
        for (int volume = 1; volume <= 40; ++volume)
            for (int brick = 1; brick <= 20; ++brick)
                for (int overlap = 0; overlap <= 5; ++overlap) {
                    const auto bricks = bricksAlong(1, volume, brick, overlap, partial);
                    const int shared = std::min(overlap, brick - 1);
                    for (std::size_t i = 1; i < bricks.size(); ++i)
                        EXPECT_EQ(bricks[i - 1].origin.y + bricks[i - 1].size.y - bricks[i].origin.y, shared);
                    EXPECT_GE(bricks.back().origin.y + bricks.back().size.y, volume);
                    EXPECT_LT(bricks.back().origin.y, volume);
                }
}

TEST(BrickGrid, hugeSizesDoNotOverflowTheCount)
{
    constexpr int kHuge = std::numeric_limits<int>::max();
    const VoxelSize huge{kHuge, kHuge, kHuge};
    EXPECT_EQ(vo::brickCount({huge, {1, 1, 1}, 0, PartialBricks::augment}), std::int64_t{1} << 62);
    EXPECT_EQ(vo::brickCount({huge, {2, 2, 2}, kHuge, PartialBricks::augmentTight}), std::int64_t{1} << 62);
    EXPECT_EQ(vo::brickCount({huge, huge, 1, PartialBricks::augmentTight}), 1);
    EXPECT_EQ(vo::brickCount({{kHuge, 1, 1}, {2, 2, 2}, 1, PartialBricks::truncate}), kHuge - 1);
    const auto one = vo::brickGrid({huge, huge, 1, PartialBricks::truncate});
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].size, huge);
}

TEST(ClipBox, neighboursMeetExactlyAndCoverTheVolumeLessHalfTheOverlap)
{
    for (const PartialBricks partial : {PartialBricks::augment, PartialBricks::augmentTight})
        for (int volume = 1; volume <= 40; ++volume)
            for (int brick = 1; brick <= 20; ++brick)
                for (int overlap = 0; overlap <= 5; ++overlap) {
                    const auto bricks = bricksAlong(2, volume, brick, overlap, partial);
                    const VoxelSize size{1, 1, volume};
                    const double half = 0.5 * std::min({overlap, brick - 1, volume - 1});
                    EXPECT_EQ(clipBoxOf(bricks.front(), size, overlap).lower.z, half);
                    EXPECT_EQ(clipBoxOf(bricks.back(), size, overlap).upper.z, volume - half);
                    for (std::size_t i = 1; i < bricks.size(); ++i)
                        EXPECT_EQ(clipBoxOf(bricks[i - 1], size, overlap).upper.z,
                                  clipBoxOf(bricks[i], size, overlap).lower.z);
                }
}

TEST(ClipBox, isHalfAVoxelInsideTheVolumeForOverlapOne)
{
    const Box box = vo::clipBox({0, 0, 0}, {256, 256, 256}, {256, 256, 256}, 1);
    EXPECT_EQ(box.lower, glm::dvec3(0.5));
    EXPECT_EQ(box.upper, glm::dvec3(255.5));
}

TEST(ClipBox, voxelsPaddedBeyondTheVolumeAreOutside)
{
    const Box box = vo::clipBox({127, 0, 0}, {128, 128, 128}, {190, 100, 128}, 1);
    EXPECT_EQ(box.lower, glm::dvec3(127.5, 0.5, 0.5));
    EXPECT_EQ(box.upper, glm::dvec3(189.5, 99.5, 127.5));
}

TEST(ClipBox, isNeverInverted)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> position(-20, 60);
    std::uniform_int_distribution<int> extent(1, 40);
    std::uniform_int_distribution<int> layers(0, 50);
    for (int i = 0; i < 10000; ++i) {
        const VoxelSize volume{extent(random), extent(random), extent(random)};
        const glm::dvec3 origin(position(random), position(random), position(random));
        const glm::dvec3 size(extent(random), extent(random), extent(random));
        const Box box = vo::clipBox(origin, size, volume, layers(random));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(box.lower[axis], box.upper[axis]);
            EXPECT_GE(box.lower[axis], 0.0);
            EXPECT_LE(box.upper[axis], volume[axis]);
        }
    }
}

} // namespace
