#include "appearance/transposed_stacks.h"

#include <gtest/gtest.h>

#include <cstring>

namespace {

using vo::BrickExtent;
using vo::BrickVoxels;
using vo::PartialBricks;
using vo::VoxelSize;

/// Bricks with voxels of their own.
struct Stack
{
    std::vector<BrickExtent> extents;
    std::vector<std::vector<std::byte>> storage;
    std::size_t voxelBytes;

    Stack(std::vector<BrickExtent> bricks, std::size_t bytes) : extents(std::move(bricks)), voxelBytes(bytes)
    {
        for (const BrickExtent& extent : extents)
            storage.emplace_back(extent.size.count() * voxelBytes, std::byte{0xee});
    }

    std::vector<BrickVoxels> views()
    {
        std::vector<BrickVoxels> views;
        for (std::size_t i = 0; i < extents.size(); ++i)
            views.push_back({extents[i], storage[i]});
        return views;
    }
};

/// The bytes of a voxel of the volume, unlike those of any other.
std::vector<std::byte> truth(std::uint64_t voxelNumber, std::size_t bytes)
{
    std::vector<std::byte> voxel(bytes);
    const std::uint64_t number = voxelNumber + 1;
    for (std::size_t i = 0; i < bytes; ++i)
        voxel[i] = static_cast<std::byte>((number >> 8 * (i % 3)) + 37 * i);
    return voxel;
}

/// Calls function(brick's bytes of the voxel, x, y, z of the volume) for all voxels of all bricks.
template <class Function>
void forEachVoxel(Stack& stack, Function function)
{
    for (std::size_t i = 0; i < stack.extents.size(); ++i) {
        const BrickExtent& e = stack.extents[i];
        std::byte* voxel = stack.storage[i].data();
        for (int z = 0; z < e.size.z; ++z)
            for (int y = 0; y < e.size.y; ++y)
                for (int x = 0; x < e.size.x; ++x, voxel += stack.voxelBytes)
                    function(voxel, e.origin.x + x, e.origin.y + y, e.origin.z + z);
    }
}

std::vector<std::byte> expectedVoxel(const VoxelSize& volume, std::size_t bytes, int x, int y, int z)
{
    if (x >= volume.x || y >= volume.y || z >= volume.z) return std::vector<std::byte>(bytes, std::byte{0});
    const auto number = static_cast<std::uint64_t>((z * volume.y + y) * volume.x + x);
    return truth(number, bytes);
}

void fillWithTruth(Stack& stack, const VoxelSize& volume)
{
    forEachVoxel(stack, [&](std::byte* voxel, int x, int y, int z) {
        std::memcpy(voxel, expectedVoxel(volume, stack.voxelBytes, x, y, z).data(), stack.voxelBytes);
    });
}

std::size_t wrongVoxels(Stack& stack, const VoxelSize& volume)
{
    std::size_t wrong = 0;
    forEachVoxel(stack, [&](const std::byte* voxel, int x, int y, int z) {
        wrong += std::memcmp(voxel, expectedVoxel(volume, stack.voxelBytes, x, y, z).data(),
                             stack.voxelBytes) != 0;
    });
    return wrong;
}

VoxelSize sliceSize(int thinAxis, int brick)
{
    return {thinAxis == 0 ? 1 : brick, thinAxis == 1 ? 1 : brick, thinAxis == 2 ? 1 : brick};
}

struct Case
{
    VoxelSize volume;
    int brick;
    int overlap;
};

const std::vector<Case> kCases{{{5, 7, 3}, 8, 0},   {{5, 7, 3}, 8, 1}, {{13, 9, 11}, 4, 1},
                               {{13, 9, 11}, 5, 2}, {{1, 6, 4}, 4, 1}, {{16, 16, 16}, 16, 1}};

TEST(FillFromBricks, stacksAcrossAreExactForOddSizesBricksAndOverlaps)
{
    for (const Case& c : kCases)
        for (const PartialBricks partial : {PartialBricks::augment, PartialBricks::augmentTight})
            for (const std::size_t bytes : {2u, 3u, 4u, 8u, 16u})
                for (const int thinAxis : {0, 1}) {
                    Stack xy(vo::brickGrid({c.volume, sliceSize(2, c.brick), c.overlap, partial}), bytes);
                    Stack across(vo::brickGrid({c.volume, sliceSize(thinAxis, c.brick), c.overlap, partial}),
                                 bytes);
                    fillWithTruth(xy, c.volume);
                    vo::fillFromBricks(xy.views(), across.views(), bytes, c.volume);
                    EXPECT_EQ(wrongVoxels(across, c.volume), 0u)
                        << c.volume.x << ' ' << bytes << ' ' << thinAxis;
                }
}

TEST(FillFromBricks, singleBytesAreExactToo)
{
    const VoxelSize volume{5, 6, 7}; // 210 voxels: every byte differs
    Stack xy(vo::brickGrid({volume, {4, 4, 1}, 1, PartialBricks::augment}), 1);
    Stack yz(vo::brickGrid({volume, {1, 4, 4}, 1, PartialBricks::augment}), 1);
    fillWithTruth(xy, volume);
    vo::fillFromBricks(xy.views(), yz.views(), 1, volume);
    EXPECT_EQ(wrongVoxels(yz, volume), 0u);
}

TEST(FillFromBricks, voxelsThatNoSourceCoversBecomeZero)
{
    const VoxelSize volume{4, 4, 4};
    Stack xy(vo::brickGrid({volume, {4, 4, 1}, 0, PartialBricks::augment}), 2);
    Stack xz(vo::brickGrid({volume, {4, 1, 4}, 0, PartialBricks::augment}), 2);
    fillWithTruth(xy, volume);
    auto sources = xy.views();
    sources[2].voxels = {}; // nothing was read for z = 2
    vo::fillFromBricks(sources, xz.views(), 2, volume);
    forEachVoxel(xz, [&](const std::byte* voxel, int x, int y, int z) {
        const auto expected = z == 2 ? std::vector<std::byte>(2) : expectedVoxel(volume, 2, x, y, z);
        EXPECT_EQ(std::memcmp(voxel, expected.data(), 2), 0);
    });
}

TEST(FillFromBricks, whatSourcesHoldBeyondTheVolumeIsLeftOut)
{
    const VoxelSize volume{3, 3, 3};
    Stack xy(vo::brickGrid({volume, {4, 4, 1}, 0, PartialBricks::augment}), 1);
    fillWithTruth(xy, {4, 4, 3}); // the padding of 3 to 4 holds something
    Stack yz(vo::brickGrid({volume, {1, 4, 4}, 0, PartialBricks::augment}), 1);
    vo::fillFromBricks(xy.views(), yz.views(), 1, volume);
    forEachVoxel(yz, [&](const std::byte* voxel, int, int y, int z) {
        if (y >= 3 || z >= 3) {
            EXPECT_EQ(*voxel, std::byte{0});
        }
    });
}

TEST(FillFromBricks, targetsWithoutVoxelsAreSkipped)
{
    const VoxelSize volume{4, 4, 4};
    Stack xy(vo::brickGrid({volume, {4, 4, 1}, 0, PartialBricks::augment}), 2);
    Stack xz(vo::brickGrid({volume, {4, 1, 4}, 0, PartialBricks::augment}), 2);
    fillWithTruth(xy, volume);
    auto targets = xz.views();
    targets[1].voxels = {};
    vo::fillFromBricks(xy.views(), targets, 2, volume);
    EXPECT_EQ(wrongVoxels(xz, volume), 16u); // those of the second slice, as they were
}

} // namespace
