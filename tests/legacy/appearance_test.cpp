#include "expect_error.h"
#include "face_scene.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <limits>
#include <set>

namespace {

using namespace vo::test;
using Partial = voPartialBrickTypeScope;
using Internal = voInternalFormatTypeScope;
using External = voExternalFormatTypeScope;
using Data = voDataTypeScope;
using Interpolation = voInterpolationTypeScope;
using Plane = voPlaneOrientationScope;

struct Sizes
{
    int x, y, z;
    friend bool operator==(const Sizes&, const Sizes&) = default;
};

std::unique_ptr<voBrickSetCollection> makeVolume(Sizes volume, Sizes brick, voPartialBrickType partial,
                                                 int overlap, voInterpolationType type = Interpolation::_3D)
{
    return std::make_unique<voBrickSetCollection>(volume.x, volume.y, volume.z, brick.x, brick.y, brick.z,
                                                  partial, overlap, Internal::INTENSITY8_EXT,
                                                  External::LUMINANCE, Data::UNSIGNED_BYTE, type);
}

/// Origin and size of a brick on one axis.
struct Extent
{
    int origin, size;
    friend bool operator==(const Extent&, const Extent&) = default;
    friend bool operator<(const Extent& a, const Extent& b) { return a.origin < b.origin; }
};

/// The different extents of a set's bricks on an axis, in order.
std::vector<Extent> extents(voBrickSet& set, int axis)
{
    std::set<Extent> all;
    for (int i = 0; i < set.getBrickCount(); ++i) {
        int origin[3], size[3];
        set.getBrick(i)->getBrickSizes(origin[0], origin[1], origin[2], size[0], size[1], size[2]);
        all.insert({origin[axis], size[axis]});
    }
    return {all.begin(), all.end()};
}

// Textures and bricks.

TEST(TextureTest, hasFormatsAndNoVoxelsAtFirst)
{
    const voTexture3D texture(Internal::RGBA8_EXT, External::ABGR_EXT, Data::UNSIGNED_SHORT);
    EXPECT_EQ(texture.getInternalFormat(), Internal::RGBA8_EXT);
    EXPECT_EQ(texture.getExternalFormat(), External::ABGR_EXT);
    EXPECT_EQ(texture.getDataType(), Data::UNSIGNED_SHORT);
    EXPECT_EQ(texture.getDataPtr(), nullptr);
    int x, y, z;
    texture.getSizes(x, y, z);
    EXPECT_EQ((Sizes{x, y, z}), (Sizes{1, 1, 1}));
    EXPECT_EQ(texture.getDataSize(), 8u);
}

TEST(TextureTest, defaultsAreResolved)
{
    const voTexture3D texture(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    EXPECT_EQ(texture.getInternalFormat(), Internal::INTENSITY8_EXT);
    EXPECT_EQ(texture.getExternalFormat(), External::LUMINANCE);
    EXPECT_EQ(texture.getDataType(), Data::UNSIGNED_BYTE);
    EXPECT_EQ(voTexture3D(Internal::DEFAULT, External::LUMINANCE_ALPHA, Data::FLOAT).getInternalFormat(),
              Internal::LUMINANCE8_ALPHA8_EXT);
    EXPECT_EQ(voTexture3D(Internal::DEFAULT, External::RGBA, Data::FLOAT).getInternalFormat(),
              Internal::RGBA8_EXT);
    expectNoError();
}

TEST(TextureTest, setDataPtrBorrowsMemory)
{
    unsigned char voxels[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    {
        voTexture3D texture(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
        texture.setDataPtr(voxels); // before the sizes, as well as after
        texture.setSizes(2, 2, 2);
        EXPECT_EQ(texture.getDataPtr(), voxels);
        double low = 0, high = 8;
        EXPECT_EQ(voAppearanceActions::dataScaleRange(&texture, low, high), 0);
        EXPECT_EQ(voxels[7], 255);
        voAppearanceActions::dataFree(&texture);
        EXPECT_EQ(texture.getDataPtr(), nullptr);
        texture.setDataPtr(voxels);
        texture.setDataPtr(NULL);
        EXPECT_EQ(texture.getDataPtr(), nullptr);
    }
    EXPECT_EQ(voxels[0], 32);
    expectNoError();
}

TEST(TextureTest, sizesBelowOneOrBeyondMemoryAreBadValue)
{
    voTexture3D texture(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    for (const Sizes bad : {Sizes{0, 1, 1}, Sizes{1, -1, 1}, Sizes{1, 1, INT_MIN},
                            Sizes{INT_MAX, INT_MAX, INT_MAX}, Sizes{1 << 21, 1 << 22, 1 << 21}}) {
        texture.setSizes(bad.x, bad.y, bad.z);
        expectBadValue("texture sizes");
        EXPECT_EQ(texture.getDataSize(), 1u);
    }
}

TEST(BrickTest, setAndGetSizesAreOriginAndSize)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    brick.setBrickSizes(1, 2, 3, 40, 50, 60);
    int origin[3], size[3];
    brick.getBrickSizes(origin[0], origin[1], origin[2], size[0], size[1], size[2]);
    EXPECT_EQ(origin[2], 3);
    EXPECT_EQ(size[0], 40);
    float position[3], sizes[3];
    brick.getBrickSizes(position, sizes);
    EXPECT_EQ(position[1], 2);
    EXPECT_EQ(sizes[2], 60);
    brick.getBrickSizes(NULL, sizes);
    brick.getBrickSizes(position, NULL);
    EXPECT_EQ(brick.getDataSize(), 40u * 50 * 60);
    expectNoError();
}

TEST(BrickTest, sizesNeedNotBePowersOfTwo)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    brick.setBrickSizes(0, 0, 0, 7, 13, 1);
    expectNoError();
}

TEST(BrickTest, badSizesAreBadValueAndChangeNothing)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    const float nan = std::nanf("");
    const float bad[][6] = {{0, 0, 0, 0, 1, 1},     {0, 0, 0, 1, -5, 1},        {nan, 0, 0, 1, 1, 1},
                            {0, 0, 0, 1, 1, nan},   {0, 0, 0, 1, 1, 3e9f},      {0, 1e30f, 0, 1, 1, 1},
                            {0, 0, -3e9f, 1, 1, 1}, {0, 0, 0, 2e9f, 2e9f, 2e9f}};
    for (const auto& b : bad) {
        brick.setBrickSizes(b[0], b[1], b[2], b[3], b[4], b[5]);
        expectBadValue();
        int v[6];
        brick.getBrickSizes(v[0], v[1], v[2], v[3], v[4], v[5]);
        EXPECT_EQ(v[0] + v[1] + v[2], 0);
        EXPECT_EQ(v[3] * v[4] * v[5], 1);
    }
}

TEST(BrickTest, clipBoxOfABrickAloneIsAllOfIt)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    brick.setBrickSizes(5, 0, 0, 10, 20, 30);
    float lower[3], upper[3];
    brick.getClipBrickSizes(lower, upper);
    EXPECT_EQ(lower[0], 5);
    EXPECT_EQ(upper[0], 15);
    EXPECT_EQ(upper[2], 30);
    brick.getClipBrickSizes(NULL, NULL);
}

// Bricks of a volume.

TEST(ClipBoxTest, shrinksByHalfTheOverlap)
{
    const auto volume = makeVolume({256, 256, 256}, {256, 256, 256}, Partial::TRUNCATE, 1);
    float lower[3], upper[3];
    volume->getCurrentBrickSet()->getBrick(0)->getClipBrickSizes(lower, upper);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(lower[axis], 0.5f);
        EXPECT_EQ(upper[axis], 255.5f);
    }
}

TEST(ClipBoxTest, boxesOfNeighboursMeetAndCoverTheVolume)
{
    for (const int overlap : {0, 1, 2, 3}) {
        const auto volume = makeVolume({100, 60, 40}, {32, 32, 32}, Partial::AUGMENT, overlap);
        voBrickSet& set = *volume->getCurrentBrickSet();
        for (int axis = 0; axis < 3; ++axis) {
            std::set<std::pair<float, float>> boxes;
            for (int i = 0; i < set.getBrickCount(); ++i) {
                float lower[3], upper[3];
                set.getBrick(i)->getClipBrickSizes(lower, upper);
                boxes.insert({lower[axis], upper[axis]});
            }
            const int size = axis == 0 ? 100 : axis == 1 ? 60 : 40;
            float reached = static_cast<float>(overlap) / 2;
            for (const auto& [from, to] : boxes) {
                EXPECT_EQ(from, reached) << "overlap " << overlap << " axis " << axis;
                reached = to;
            }
            EXPECT_EQ(reached, static_cast<float>(size) - static_cast<float>(overlap) / 2);
        }
    }
}

// 256 x 256 x 190 voxels in bricks of 128 with overlap 1: the guide's example (page 29), counted by its
// formula.
TEST(BrickCountTest, truncateDropsTheRest)
{
    const auto volume = makeVolume({256, 256, 190}, {128, 128, 128}, Partial::TRUNCATE, 1);
    voBrickSet& set = *volume->getCurrentBrickSet();
    EXPECT_EQ(set.getBrickCount(), 4);
    EXPECT_EQ(extents(set, 0), (std::vector<Extent>{{0, 128}, {127, 128}}));
    EXPECT_EQ(extents(set, 2), (std::vector<Extent>{{0, 128}}));
}

TEST(BrickCountTest, augmentAddsWholeBricks)
{
    const auto volume = makeVolume({256, 256, 190}, {128, 128, 128}, Partial::AUGMENT, 1);
    voBrickSet& set = *volume->getCurrentBrickSet();
    EXPECT_EQ(set.getBrickCount(), 18);
    EXPECT_EQ(extents(set, 0), (std::vector<Extent>{{0, 128}, {127, 128}, {254, 128}}));
    EXPECT_EQ(extents(set, 2), (std::vector<Extent>{{0, 128}, {127, 128}}));
}

TEST(BrickCountTest, augmentTightShrinksTheLastToAPowerOfTwo)
{
    const auto volume = makeVolume({256, 256, 190}, {128, 128, 128}, Partial::AUGMENT_TIGHT, 1);
    voBrickSet& set = *volume->getCurrentBrickSet();
    EXPECT_EQ(set.getBrickCount(), 18);
    EXPECT_EQ(extents(set, 0), (std::vector<Extent>{{0, 128}, {127, 128}, {254, 2}}));
    EXPECT_EQ(extents(set, 2), (std::vector<Extent>{{0, 128}, {127, 64}}));
}

TEST(BrickCountTest, followsTheFormulaForAllSizesAndOverlaps)
{
    for (const int size : {1, 5, 16, 17, 33, 64})
        for (const int brick : {1, 2, 4, 8, 16})
            for (const int asked : {0, 1, 2, 3}) {
                const int overlap = brick == 1 ? 0 : std::min(asked, brick - 1);
                const double steps = double(size - overlap) / (brick - overlap);
                const int whole = std::max(1, static_cast<int>(std::floor(steps)));
                const int all = std::max(1, static_cast<int>(std::ceil(steps)));
                const auto count = [&](voPartialBrickType partial) {
                    return makeVolume({size, 1, 1}, {brick, 1, 1}, partial, asked)
                        ->getCurrentBrickSet()
                        ->getBrickCount();
                };
                EXPECT_EQ(count(Partial::TRUNCATE), whole);
                EXPECT_EQ(count(Partial::AUGMENT), all);
                EXPECT_EQ(count(Partial::AUGMENT_TIGHT), all);
            }
    expectNoError();
}

TEST(CollectionTest, threeDimensionalHasOneSet)
{
    const auto volume = makeVolume({20, 30, 40}, {16, 16, 16}, Partial::AUGMENT, 1);
    EXPECT_EQ(volume->getBrickSetCount(), 1);
    EXPECT_EQ(volume->getInterpolationType(), Interpolation::_3D);
    voBrickSet* set = volume->getCurrentBrickSet();
    EXPECT_EQ(set->getOrientation(), Plane::UNSPECIFIED);
    for (const int any : {Plane::UNSPECIFIED, Plane::XY, Plane::XZ, Plane::YZ}) {
        volume->setCurrentBrickSet(static_cast<voPlaneOrientation>(any));
        EXPECT_EQ(volume->getCurrentBrickSet(), set);
    }
    int x, y, z;
    set->getVolumeSizes(x, y, z);
    EXPECT_EQ((Sizes{x, y, z}), (Sizes{20, 30, 40}));
    set->getBrickSizes(x, y, z);
    EXPECT_EQ((Sizes{x, y, z}), (Sizes{16, 16, 16}));
    EXPECT_EQ(set->getOverlap(), 1);
    expectNoError();
}

TEST(CollectionTest, twoDimensionalHasAStackForEachAxis)
{
    const auto volume = makeVolume({4, 5, 6}, {8, 8, 8}, Partial::AUGMENT_TIGHT, 1, Interpolation::_2D);
    const voPlaneOrientation orientations[] = {Plane::XY, Plane::XZ, Plane::YZ};
    const int counts[] = {6, 5, 4};
    voBrickSetCollectionIterator next(volume.get());
    for (int i = 0; i < 3; ++i) {
        voBrickSet* set = next();
        ASSERT_NE(set, nullptr);
        EXPECT_EQ(set->getOrientation(), orientations[i]);
        EXPECT_EQ(set->getBrickCount(), counts[i]);
        volume->setCurrentBrickSet(orientations[i]);
        EXPECT_EQ(volume->getCurrentBrickSet(), set);
        EXPECT_EQ(volume->currentBrickSet, set);
        EXPECT_EQ(volume->getBrickSet(i), set);
        for (const Extent& extent : extents(*set, 2 - i))
            EXPECT_EQ(extent.size, 1);
    }
    EXPECT_EQ(next(), nullptr);
    EXPECT_EQ(volume->getMaxBrickCount(), 6);
    volume->setCurrentBrickSet(Plane::UNSPECIFIED);
    EXPECT_EQ(volume->getCurrentBrickSet()->getOrientation(), Plane::YZ);
    expectNoError();
}

TEST(CollectionTest, defaultInterpolationIsResolved)
{
    for (const int type : {0, -1}) {
        const auto volume =
            makeVolume({4, 4, 4}, {4, 4, 4}, Partial::TRUNCATE, 0, static_cast<voInterpolationType>(type));
        EXPECT_EQ(volume->getInterpolationType(), Interpolation::_3D);
        EXPECT_EQ(volume->interpolationType, Interpolation::_3D);
    }
}

TEST(CollectionTest, hasNoVoxelsUntilTheyAreAllocated)
{
    const auto volume = byteVolume(16, 8);
    voBrickSetIterator next(volume->getCurrentBrickSet());
    int count = 0;
    for (voBrick* brick; (brick = next()); ++count)
        EXPECT_EQ(brick->getDataPtr(), nullptr);
    EXPECT_EQ(count, volume->getCurrentBrickSet()->getBrickCount());
    EXPECT_EQ(next(), nullptr);
}

TEST(CollectionTest, bricksCarryTheFormats)
{
    const voBrickSetCollection volume(8, 8, 8, 8, 8, 8, Partial::DEFAULT, 0, Internal::RGBA8_EXT,
                                      External::ABGR_EXT, Data::SHORT, Interpolation::DEFAULT);
    const voBrick& brick = *volume.getCurrentBrickSet()->getBrick(0);
    EXPECT_EQ(brick.getInternalFormat(), Internal::RGBA8_EXT);
    EXPECT_EQ(brick.getExternalFormat(), External::ABGR_EXT);
    EXPECT_EQ(brick.getDataType(), Data::SHORT);
    EXPECT_EQ(brick.getDataSize(), 512u * 8);
}

TEST(CollectionTest, brickNumbersOutsideAreBadValueAndNull)
{
    const auto volume = byteVolume(16, 8);
    for (const int i : {-1, volume->getCurrentBrickSet()->getBrickCount(), INT_MAX, INT_MIN}) {
        EXPECT_EQ(volume->getCurrentBrickSet()->getBrick(i), nullptr);
        expectBadValue();
        EXPECT_EQ(volume->getBrickSet(i), nullptr);
        expectBadValue();
    }
}

TEST(CollectionTest, badSizesAreBadValueRightAfterTheConstructor)
{
    const Sizes good{8, 8, 8};
    const Sizes bad[] = {{0, 8, 8}, {8, -1, 8}, {8, 8, INT_MIN}};
    for (const Sizes& sizes : bad) {
        auto volume = makeVolume(sizes, good, Partial::TRUNCATE, 0);
        expectBadValue("volume sizes");
        ASSERT_NE(volume->getCurrentBrickSet(), nullptr);
        EXPECT_EQ(volume->getCurrentBrickSet()->getBrickCount(), 1);
        volume = makeVolume(good, sizes, Partial::TRUNCATE, 0);
        expectBadValue("brick sizes");
    }
    for (const int overlap : {-1, INT_MIN}) {
        makeVolume(good, good, Partial::TRUNCATE, overlap);
        expectBadValue("overlap");
    }
    makeVolume(good, good, Partial::TRUNCATE, INT_MAX);
    expectNoError();
}

TEST(CollectionTest, sizesBeyondMemoryAreRefusedBeforeTheyAreAskedFor)
{
    const int most = INT_MAX;
    makeVolume({most, most, most}, {1, 1, 1}, Partial::TRUNCATE, 0);
    expectBadValue("volume sizes");
    makeVolume({8, 8, 8}, {most, most, most}, Partial::AUGMENT, 0);
    expectBadValue("brick sizes");
    makeVolume({most, 1, 1}, {1, 1, 1}, Partial::TRUNCATE, 0);
    expectBadValue("bricks, at most");
    makeVolume({(1 << 20) + 1, 1, 1}, {1, 1, 1}, Partial::TRUNCATE, 0);
    expectBadValue("bricks, at most 1048576");
    makeVolume({4096, 4096, 4096}, {2, 2, 2}, Partial::AUGMENT, 1, Interpolation::_2D);
    expectBadValue("bricks, at most");
    const auto wide = makeVolume({most, 1, 1}, {most, 1, 1}, Partial::AUGMENT, 1);
    expectNoError();
    EXPECT_EQ(wide->getCurrentBrickSet()->getBrickCount(), 1);
}

TEST(CollectionTest, currentBrickSetOutsideTheEnumerationIsBadEnum)
{
    const auto volume = byteVolume(8, 8, Interpolation::_2D);
    voBrickSet* before = volume->getCurrentBrickSet();
    for (const int value : {4, -2, INT_MAX}) {
        volume->setCurrentBrickSet(static_cast<voPlaneOrientation>(value));
        expectBadEnum();
        EXPECT_EQ(volume->getCurrentBrickSet(), before);
    }
}

TEST(CollectionTest, iteratorsOverNothingEndAtOnce)
{
    EXPECT_EQ(voBrickSetIterator(NULL)(), nullptr);
    EXPECT_EQ(voBrickSetCollectionIterator(NULL)(), nullptr);
    expectNoError();
}

TEST(CollectionTest, deletingItFreesVoxelsThatNobodyFreed)
{
    unsigned char borrowed[512] = {};
    const auto volume = byteVolume(16, 8);
    voAppearanceActions::dataAlloc(volume->getCurrentBrickSet());
    volume->getCurrentBrickSet()->getBrick(0)->setDataPtr(borrowed);
    volume->setDirtyFlag(VO_TRUE);
    volume->setDirtyFlag(VO_FALSE);
    expectNoError();
}

} // namespace
