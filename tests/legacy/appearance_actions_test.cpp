#include "expect_error.h"
#include "face_scene.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstring>

namespace {

using namespace vo::test;
using Internal = voInternalFormatTypeScope;
using External = voExternalFormatTypeScope;
using Data = voDataTypeScope;
using Interpolation = voInterpolationTypeScope;
using Rendering = voRenderingModeScope;
using Format = voInterleavedArrayTypeScope;
using Plane = voPlaneOrientationScope;

// getBestParameters.

struct Suggestion
{
    explicit Suggestion(voRenderingMode mode, voExternalFormatType disk, int size = 64)
        : xBrick(size), yBrick(size), zBrick(size)
    {
        EXPECT_EQ(voAppearanceActions::getBestParameters(interpolation, mode, Data::UNSIGNED_BYTE, disk,
                                                         internal, external, xBrick, yBrick, zBrick),
                  0);
    }
    voInterpolationType interpolation = Interpolation::DEFAULT;
    voInternalFormatType internal = Internal::DEFAULT;
    voExternalFormatType external = External::DEFAULT;
    int xBrick, yBrick, zBrick;
};

TEST(BestParametersTest, oneChannelBecomesLuminanceKeptAsIntensity)
{
    for (const voRenderingMode mode : {Rendering::DEFAULT, Rendering::MONOCHROME, Rendering::COLOR})
        for (const voExternalFormatType disk : {External::INTENSITY, External::LUMINANCE}) {
            const Suggestion best(mode, disk);
            EXPECT_EQ(best.external, External::LUMINANCE);
            EXPECT_EQ(best.internal, Internal::INTENSITY8_EXT);
        }
}

TEST(BestParametersTest, severalChannelsFollowTheMode)
{
    for (const voExternalFormatType disk : {External::RGBA, External::ABGR_EXT}) {
        const Suggestion color(Rendering::COLOR, disk), grey(Rendering::MONOCHROME, disk);
        EXPECT_EQ(color.external, disk);
        EXPECT_EQ(color.internal, Internal::RGBA8_EXT);
        EXPECT_EQ(grey.external, External::LUMINANCE_ALPHA);
        EXPECT_EQ(grey.internal, Internal::LUMINANCE8_ALPHA8_EXT);
    }
    const Suggestion two(Rendering::COLOR, External::LUMINANCE_ALPHA);
    EXPECT_EQ(two.external, External::LUMINANCE_ALPHA);
}

TEST(BestParametersTest, interpolationIsResolvedInPlace)
{
    EXPECT_EQ(Suggestion(Rendering::COLOR, External::RGBA).interpolation, Interpolation::_3D);
    voInterpolationType two = Interpolation::_2D;
    voInternalFormatType internal;
    voExternalFormatType external;
    int x = 4, y = 4, z = 4;
    voAppearanceActions::getBestParameters(two, Rendering::DEFAULT, Data::FLOAT, External::RGBA, internal,
                                           external, x, y, z);
    EXPECT_EQ(two, Interpolation::_2D);
    EXPECT_EQ(voAppearanceActions::getBestParameters(Interpolation::_3D, Rendering::DEFAULT, Data::FLOAT,
                                                     External::RGBA, internal, external, x, y, z),
              0);
    expectNoError();
}

TEST(BestParametersTest, bricksAreAtMostWhatIsWantedAndTheLimit)
{
    const Suggestion small(Rendering::COLOR, External::RGBA, 190);
    EXPECT_EQ(small.xBrick, 190);
    const Suggestion large(Rendering::COLOR, External::RGBA, INT_MAX);
    EXPECT_EQ(large.zBrick, 2048);
}

TEST(BestParametersTest, badArgumentsWriteNothing)
{
    voInterpolationType interpolation = Interpolation::DEFAULT;
    voInternalFormatType internal = Internal::RGB8_EXT;
    voExternalFormatType external = External::ABGR_EXT;
    int x = 4, y = -4, z = 4;
    const auto call = [&](int mode, int type, int disk) {
        return voAppearanceActions::getBestParameters(
            interpolation, static_cast<voRenderingMode>(mode), static_cast<voDataType>(type),
            static_cast<voExternalFormatType>(disk), internal, external, x, y, z);
    };
    EXPECT_NE(call(0, 0, 0), 0);
    expectBadValue("brick size");
    y = 4;
    EXPECT_NE(call(3, 0, 0), 0);
    expectBadEnum();
    EXPECT_NE(call(0, 99, 0), 0);
    expectBadEnum();
    EXPECT_NE(call(0, 0, -5), 0);
    expectBadEnum();
    interpolation = static_cast<voInterpolationType>(8);
    EXPECT_NE(call(0, 0, 0), 0);
    expectBadEnum();
    EXPECT_EQ(internal, Internal::RGB8_EXT);
    EXPECT_EQ(external, External::ABGR_EXT);
}

// Storage.

/// A brick of count x 1 x 1 voxels.
std::unique_ptr<voBrick> rowOf(int count, voExternalFormatType format, voDataType type)
{
    auto brick = std::make_unique<voBrick>(Internal::DEFAULT, format, type);
    brick->setBrickSizes(0, 0, 0, static_cast<float>(count), 1, 1);
    return brick;
}

template <class T>
std::unique_ptr<voBrick> rowWith(const std::vector<T>& values, voExternalFormatType format, voDataType type,
                                 int channels = 1)
{
    const int count = static_cast<int>(values.size()) / channels;
    auto brick = rowOf(count, format, type);
    std::memcpy(voAppearanceActions::dataAlloc(brick.get()), values.data(), values.size() * sizeof(T));
    return brick;
}

template <class T>
std::vector<T> valuesOf(const voBrick& brick)
{
    const T* data = static_cast<const T*>(brick.getDataPtr());
    return {data, data + brick.getDataSize() / sizeof(T)};
}

using Bytes = std::vector<unsigned char>;

TEST(DataAllocTest, givesZeroedRoomForAnyDiskFormat)
{
    const auto brick = rowOf(100, External::LUMINANCE, Data::UNSIGNED_SHORT);
    auto* data = static_cast<unsigned short*>(voAppearanceActions::dataAlloc(brick.get()));
    ASSERT_NE(data, nullptr);
    EXPECT_EQ(data, brick->getDataPtr());
    for (int i = 0; i < 400; ++i) {
        EXPECT_EQ(data[i], 0);
        data[i] = 1; // room for RGBA
    }
}

TEST(DataAllocTest, ofASetAllocatesAllItsBricks)
{
    const auto volume = byteVolume(16, 8);
    voBrickSet* set = volume->getCurrentBrickSet();
    const void* first = voAppearanceActions::dataAlloc(set);
    EXPECT_EQ(first, set->getBrick(0)->getDataPtr());
    for (int i = 0; i < set->getBrickCount(); ++i)
        EXPECT_NE(set->getBrick(i)->getDataPtr(), nullptr);
    voAppearanceActions::dataFree(set);
    for (int i = 0; i < set->getBrickCount(); ++i)
        EXPECT_EQ(set->getBrick(i)->getDataPtr(), nullptr);
    expectNoError();
}

TEST(DataAllocTest, freeingTwiceIsHarmless)
{
    const auto brick = rowOf(10, External::LUMINANCE, Data::FLOAT);
    voAppearanceActions::dataFree(brick.get());
    voAppearanceActions::dataAlloc(brick.get());
    voAppearanceActions::dataAlloc(brick.get());
    voAppearanceActions::dataFree(brick.get());
    voAppearanceActions::dataFree(brick.get());
    EXPECT_EQ(brick->getDataPtr(), nullptr);
    expectNoError();
}

TEST(DataAllocTest, nullIsBadValue)
{
    EXPECT_EQ(voAppearanceActions::dataAlloc(static_cast<voTexture3D*>(NULL)), nullptr);
    expectBadValue("texture is NULL");
    EXPECT_EQ(voAppearanceActions::dataAlloc(static_cast<voBrickSet*>(NULL)), nullptr);
    expectBadValue("brickSet is NULL");
    voAppearanceActions::dataFree(static_cast<voTexture3D*>(NULL));
    expectBadValue("texture is NULL");
    voAppearanceActions::dataFree(static_cast<voBrickSet*>(NULL));
    expectBadValue("brickSet is NULL");
}

#if !defined(__SANITIZE_ADDRESS__) // which ends the program where memory ends
TEST(DataAllocTest, moreThanMemoryHasIsOutOfMemory)
{
    voBrick brick(Internal::DEFAULT, External::RGBA, Data::FLOAT);
    brick.setBrickSizes(0, 0, 0, 1 << 20, 1 << 20, 1 << 15);
    EXPECT_EQ(voAppearanceActions::dataAlloc(&brick), nullptr);
    expectError(voErrorTypeScope::OUT_OF_MEMORY, "memory");
    EXPECT_EQ(brick.getDataPtr(), nullptr);
}
#endif

// dataScaleRange.

template <class T>
void expectScaled(voDataType type, const std::vector<T>& before, double low, double high,
                  const std::vector<T>& after)
{
    const auto brick = rowWith<T>(before, External::LUMINANCE, type);
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick.get(), low, high), 0);
    EXPECT_EQ(valuesOf<T>(*brick), after);
    expectNoError();
}

TEST(ScaleRangeTest, mapsTheRangeToThatOfTheType)
{
    expectScaled<unsigned char>(Data::UNSIGNED_BYTE, {0, 10, 60, 110, 200}, 10, 110, {0, 0, 128, 255, 255});
    expectScaled<unsigned short>(Data::UNSIGNED_SHORT, {0, 4095, 1365}, 0, 4095, {0, 65535, 21845});
    expectScaled<float>(Data::FLOAT, {-5, 0, 5, 10, 20}, 0, 10, {0, 0, 0.5f, 1, 1});
    expectScaled<unsigned int>(Data::UNSIGNED_INT, {0, 1, 2}, 0, 2, {0, 2147483648u, 4294967295u});
}

TEST(ScaleRangeTest, signedTypesMapToTheirPositiveHalf)
{
    expectScaled<signed char>(Data::BYTE, {-128, -100, 0, 100}, -100, 100, {0, 0, 64, 127});
    expectScaled<short>(Data::SHORT, {-1024, 3071, -2000}, -1024, 3071, {0, 32767, 0});
    expectScaled<int>(Data::INT, {-7, 7, 0}, -7, 7, {0, INT_MAX, 1073741824});
}

TEST(ScaleRangeTest, emptyRangeLeavesVoxelsAndReferencesAlone)
{
    const auto brick = rowWith<unsigned char>({1, 2, 3}, External::LUMINANCE, Data::UNSIGNED_BYTE);
    float low = -1, high = -1;
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick.get(), low, high), 0);
    EXPECT_EQ(low, -1);
    EXPECT_EQ(high, -1);
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick.get(), 5.0, 4.0), 0);
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick.get(), -1, -1), 0);
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick.get(), std::nan(""), 4.0), 0);
    EXPECT_EQ(valuesOf<unsigned char>(*brick), (Bytes{1, 2, 3}));
    low = 1;
    high = 3;
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick.get(), low, high), 0);
    EXPECT_EQ(low, 1);
    EXPECT_EQ(high, 3);
    EXPECT_EQ(valuesOf<unsigned char>(*brick), (Bytes{0, 128, 255}));
    expectNoError();
}

TEST(ScaleRangeTest, whatCannotBeScaledIsRefused)
{
    EXPECT_NE(voAppearanceActions::dataScaleRange(NULL, 0.0, 1.0), 0);
    expectBadValue("texture is NULL");
    EXPECT_NE(voAppearanceActions::dataScaleRange(rowOf(4, External::LUMINANCE, Data::FLOAT).get(), 0.0, 1.0),
              0);
    expectBadValue("no voxels");
    const auto packed = rowWith<unsigned short>({1, 2}, External::RGBA, Data::UNSIGNED_SHORT_4_4_4_4_EXT);
    EXPECT_NE(voAppearanceActions::dataScaleRange(packed.get(), 0.0, 1.0), 0);
    expectUnsupported("packed");
    const auto floats = rowWith<float>({1, 2}, External::LUMINANCE, Data::FLOAT);
    EXPECT_NE(voAppearanceActions::dataScaleRange(floats.get(), -HUGE_VAL, HUGE_VAL), 0);
    expectBadValue("without end");
    EXPECT_EQ(valuesOf<float>(*floats), (std::vector<float>{1, 2}));
}

// dataConvert.

Bytes converted(const Bytes& disk, voExternalFormatType from, voExternalFormatType to, int voxels)
{
    const auto brick = rowOf(voxels, to, Data::UNSIGNED_BYTE);
    voAppearanceActions::dataAlloc(brick.get());
    Bytes copy = disk;
    EXPECT_EQ(voAppearanceActions::dataConvert(brick.get(), copy.data(), from), 0);
    const Bytes apart = valuesOf<unsigned char>(*brick);
    EXPECT_EQ(copy, disk);

    voAppearanceActions::dataAlloc(brick.get());
    std::memcpy(brick->getDataPtr(), disk.data(), disk.size());
    EXPECT_EQ(voAppearanceActions::dataConvert(brick.get(), brick->getDataPtr(), from), 0);
    EXPECT_EQ(valuesOf<unsigned char>(*brick), apart) << "in place";
    return apart;
}

TEST(DataConvertTest, readsTheDiskFormatAndWritesTheExternalOne)
{
    const Bytes one{10, 20, 255};
    EXPECT_EQ(converted(one, External::LUMINANCE, External::INTENSITY, 3), one);
    EXPECT_EQ(converted(one, External::INTENSITY, External::LUMINANCE_ALPHA, 3),
              (Bytes{10, 10, 20, 20, 255, 255}));
    EXPECT_EQ(converted({7}, External::LUMINANCE, External::RGBA, 1), (Bytes{7, 7, 7, 7}));
    EXPECT_EQ(converted({1, 2, 3, 4}, External::RGBA, External::ABGR_EXT, 1), (Bytes{4, 3, 2, 1}));
    EXPECT_EQ(converted({4, 3, 2, 1}, External::ABGR_EXT, External::RGBA, 1), (Bytes{1, 2, 3, 4}));
    EXPECT_EQ(converted({100, 100, 100, 9}, External::RGBA, External::LUMINANCE_ALPHA, 1), (Bytes{100, 9}));
    EXPECT_EQ(converted({255, 0, 0, 9}, External::RGBA, External::LUMINANCE, 1), (Bytes{77}));
}

TEST(DataConvertTest, longRowsGrowInPlace)
{
    Bytes disk(5000), expected;
    for (std::size_t i = 0; i < disk.size(); ++i) {
        disk[i] = static_cast<unsigned char>(i * 7);
        expected.insert(expected.end(), 4, disk[i]);
    }
    EXPECT_EQ(converted(disk, External::LUMINANCE, External::RGBA, 5000), expected);
}

TEST(DataConvertTest, otherNumberTypesKeepNormalisedValues)
{
    const auto shorts = rowOf(3, External::LUMINANCE, Data::UNSIGNED_SHORT);
    voAppearanceActions::dataAlloc(shorts.get());
    Bytes bytes{0, 128, 255};
    EXPECT_EQ(voAppearanceActions::dataConvert(shorts.get(), bytes.data(), Data::UNSIGNED_BYTE), 0);
    EXPECT_EQ(valuesOf<unsigned short>(*shorts), (std::vector<unsigned short>{0, 128 * 257, 65535}));

    const auto floats = rowWith<float>({0.25f, 1}, External::LUMINANCE, Data::FLOAT);
    const unsigned short disk[] = {0, 65535};
    std::memcpy(floats->getDataPtr(), disk, sizeof disk);
    EXPECT_EQ(voAppearanceActions::dataConvert(floats.get(), floats->getDataPtr(), Data::UNSIGNED_SHORT), 0);
    EXPECT_EQ(valuesOf<float>(*floats), (std::vector<float>{0, 1}));
}

TEST(DataConvertTest, packedVoxelsConvertToOthers)
{
    const auto brick = rowOf(1, External::RGBA, Data::UNSIGNED_BYTE);
    voAppearanceActions::dataAlloc(brick.get());
    unsigned short packed = 0xF0A5;
    EXPECT_EQ(voAppearanceActions::dataConvert(brick.get(), &packed, Data::UNSIGNED_SHORT_4_4_4_4_EXT), 0);
    EXPECT_EQ(valuesOf<unsigned char>(*brick), (Bytes{255, 0, 170, 85}));
}

TEST(DataConvertTest, badArgumentsAreRefused)
{
    Bytes data(64);
    const auto brick = rowOf(4, External::LUMINANCE, Data::UNSIGNED_BYTE);
    EXPECT_NE(voAppearanceActions::dataConvert(NULL, data.data(), External::RGBA), 0);
    expectBadValue("texture is NULL");
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), data.data(), External::RGBA), 0);
    expectBadValue("no voxels");
    voAppearanceActions::dataAlloc(brick.get());
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), NULL, External::RGBA), 0);
    expectBadValue("data is NULL");
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), NULL, Data::FLOAT), 0);
    expectBadValue("data is NULL");
    EXPECT_NE(
        voAppearanceActions::dataConvert(brick.get(), data.data(), static_cast<voExternalFormatType>(9)), 0);
    expectBadEnum();
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), data.data(), static_cast<voDataType>(-4)), 0);
    expectBadEnum();
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), data.data(), Data::UNSIGNED_BYTE_3_3_2_EXT), 0);
    expectUnsupported("packed");
}

TEST(DataConvertTest, storageSmallerThanTheSizesIsBadValue)
{
    Bytes data(64 * 16);
    const auto brick = rowOf(4, External::LUMINANCE, Data::UNSIGNED_BYTE);
    voAppearanceActions::dataAlloc(brick.get());
    brick->setBrickSizes(0, 0, 0, 64, 1, 1);
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), data.data(), External::LUMINANCE), 0);
    expectBadValue("bytes of voxels");
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), data.data(), Data::FLOAT), 0);
    expectBadValue("bytes of voxels");
    brick->setBrickSizes(0, 0, 0, 8, 1, 1);
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), brick->getDataPtr(), External::RGBA), 0);
    expectBadValue("too small");
    EXPECT_NE(voAppearanceActions::dataConvert(brick.get(), brick->getDataPtr(), Data::FLOAT), 0);
    expectBadValue("too small");
    EXPECT_EQ(voAppearanceActions::dataScaleRange(brick.get(), 0.0, 1.0), 0);
}

// Volumes.

unsigned char voxelAt(int x, int y, int z)
{
    return static_cast<unsigned char>(1 + x + 6 * y + 36 * z);
}

/// Calls visit(voxel reference, x, y, z) for each voxel of a set inside a volume of 6^3.
template <class Visit>
void forVoxels(voBrickSet& set, Visit visit)
{
    voBrickSetIterator bricks(&set);
    for (voBrick* brick; (brick = bricks());) {
        int o[3], s[3];
        brick->getBrickSizes(o[0], o[1], o[2], s[0], s[1], s[2]);
        auto* voxel = static_cast<unsigned char*>(brick->getDataPtr());
        ASSERT_NE(voxel, nullptr);
        for (int z = o[2]; z < o[2] + s[2]; ++z)
            for (int y = o[1]; y < o[1] + s[1]; ++y)
                for (int x = o[0]; x < o[0] + s[0]; ++x, ++voxel)
                    visit(*voxel, x, y, z);
    }
}

TEST(TransposeTest, fillsTheOtherStacksFromTheXyStack)
{
    for (const int brickSize : {3, 4, 8})
        for (const bool allocateAll : {true, false}) {
            const auto volume = byteVolume(6, brickSize, Interpolation::_2D);
            volume->setCurrentBrickSet(Plane::XY);
            for (int i = 0; i < (allocateAll ? 3 : 1); ++i)
                voAppearanceActions::dataAlloc(volume->getBrickSet(i));
            const auto outside = [](int x, int y, int z) { return x > 5 || y > 5 || z > 5; };
            forVoxels(*volume->getCurrentBrickSet(), [&](unsigned char& voxel, int x, int y, int z) {
                voxel = outside(x, y, z) ? 0 : voxelAt(x, y, z);
            });
            EXPECT_EQ(voAppearanceActions::volumeMakeTransposed(volume.get()), 0);
            for (int stack = 1; stack < 3; ++stack)
                forVoxels(*volume->getBrickSet(stack), [&](unsigned char& voxel, int x, int y, int z) {
                    EXPECT_EQ(voxel, outside(x, y, z) ? 0 : voxelAt(x, y, z));
                });
        }
    expectNoError();
}

TEST(TransposeTest, doesNothingToThreeDimensionalVolumes)
{
    const auto volume = byteVolume(6, 6);
    EXPECT_EQ(voAppearanceActions::volumeMakeTransposed(volume.get()), 0);
    EXPECT_EQ(volume->getCurrentBrickSet()->getBrick(0)->getDataPtr(), nullptr);
    EXPECT_NE(voAppearanceActions::volumeMakeTransposed(NULL), 0);
    expectBadValue("volume is NULL");
}

TEST(OptimizeTest, withoutAContextItIsDeferredAndRepeatable)
{
    const auto volume = byteVolume(6, 6);
    voAppearanceActions::dataAlloc(volume->getCurrentBrickSet());
    using O = voOptimizeVolumeTypeScope;
    for (const int flags : {int{O::BEST_PERFORMANCE}, int{O::PRE_TRANSPOSE}, int{O::NONE},
                            int{O::BEST | O::PRE_TRANSPOSE}, int{O::INTERLEAVE}}) {
        EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), flags), 0);
        EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), flags), 0);
    }
    EXPECT_EQ(voAppearanceActions::volumeUnoptimize(volume.get()), 0);
    EXPECT_EQ(voAppearanceActions::volumeUnoptimize(volume.get()), 0);
    expectNoError();
}

TEST(OptimizeTest, badArgumentsAreRefused)
{
    const auto volume = byteVolume(6, 6);
    for (const int flags : {8, -1, INT_MIN}) {
        EXPECT_NE(voAppearanceActions::volumeOptimize(volume.get(), flags), 0);
        expectBadEnum("flags");
    }
    EXPECT_NE(voAppearanceActions::volumeOptimize(NULL, 0), 0);
    expectBadValue("volume is NULL");
    EXPECT_NE(voAppearanceActions::volumeUnoptimize(NULL), 0);
    expectBadValue("volume is NULL");
}

// Textures without a context.

TEST(TextureActionsTest, needAContext)
{
    const auto volume = byteVolume(6, 6);
    voBrick* brick = volume->getCurrentBrickSet()->getBrick(0);
    voAppearanceActions::dataAlloc(brick);
    voAppearanceActions::textureEnable(Interpolation::_3D);
    expectUnsupported("no OpenGL context");
    voAppearanceActions::textureDisable(Interpolation::DEFAULT);
    expectUnsupported("no OpenGL context");
    voAppearanceActions::texgenEnable();
    expectUnsupported("no OpenGL context");
    voAppearanceActions::texgenDisable();
    expectUnsupported("no OpenGL context");
    voAppearanceActions::texgenSetEquation(brick);
    expectUnsupported("no OpenGL context");
    EXPECT_NE(voAppearanceActions::textureBind(brick), 0);
    expectUnsupported("no OpenGL context");
    EXPECT_NE(voAppearanceActions::textureLoad(brick), 0);
    expectUnsupported("no OpenGL context");
}

TEST(TextureActionsTest, badArgumentsAreNamed)
{
    voAppearanceActions::textureEnable(static_cast<voInterpolationType>(5));
    expectBadEnum();
    voAppearanceActions::textureDisable(static_cast<voInterpolationType>(-2));
    expectBadEnum();
    voAppearanceActions::texgenSetEquation(NULL);
    expectBadValue("brick is NULL");
    EXPECT_NE(voAppearanceActions::textureBind(NULL), 0);
    expectBadValue("texture is NULL");
    EXPECT_NE(voAppearanceActions::textureLoad(NULL), 0);
    expectBadValue("texture is NULL");
}

// Interleaving is remembered, and no more.

TEST(InterleaveTest, twoAlikeTexturesMakeAClique)
{
    for (const voExternalFormatType format :
         {External::INTENSITY, External::LUMINANCE, External::LUMINANCE_ALPHA}) {
        const auto one = rowOf(4, format, Data::FLOAT), other = rowOf(4, format, Data::FLOAT),
                   third = rowOf(4, format, Data::FLOAT);
        EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), other.get()), VO_FALSE);
        EXPECT_EQ(voAppearanceActions::textureInterleave(one.get(), other.get()), 0);
        EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), other.get()), VO_TRUE);
        EXPECT_EQ(voAppearanceActions::cliqueTest(other.get(), one.get()), VO_TRUE);
        EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), one.get()), VO_FALSE);
        EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), third.get()), VO_FALSE);
        EXPECT_EQ(voAppearanceActions::textureInterleave(other.get(), one.get()), 0) << "twice";
        expectNoError();
        EXPECT_NE(voAppearanceActions::textureInterleave(one.get(), third.get()), 0);
        expectBadValue("already");
        EXPECT_NE(voAppearanceActions::textureInterleave(third.get(), one.get()), 0);
        expectBadValue("already");
        EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), other.get()), VO_TRUE);
    }
}

TEST(InterleaveTest, unlikeTexturesAreRefused)
{
    const auto one = rowOf(4, External::LUMINANCE, Data::FLOAT);
    const auto longer = rowOf(5, External::LUMINANCE, Data::FLOAT);
    const auto otherFormat = rowOf(4, External::INTENSITY, Data::FLOAT);
    const auto otherType = rowOf(4, External::LUMINANCE, Data::UNSIGNED_INT);
    voTexture3D otherInternal(Internal::LUMINANCE8_EXT, External::LUMINANCE, Data::FLOAT);
    otherInternal.setSizes(4, 1, 1);
    for (voTexture3D* other : std::initializer_list<voTexture3D*>{longer.get(), otherFormat.get(),
                                                                  otherType.get(), &otherInternal}) {
        EXPECT_NE(voAppearanceActions::textureInterleave(one.get(), other), 0);
        expectBadValue("differ");
        EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), other), VO_FALSE);
    }
    const auto rgba = rowOf(4, External::RGBA, Data::FLOAT), more = rowOf(4, External::RGBA, Data::FLOAT);
    EXPECT_NE(voAppearanceActions::textureInterleave(rgba.get(), more.get()), 0);
    expectBadValue("four channels");
    EXPECT_NE(voAppearanceActions::textureInterleave(one.get(), one.get()), 0);
    expectBadValue("one texture");
    EXPECT_NE(voAppearanceActions::textureInterleave(NULL, one.get()), 0);
    expectBadValue("texture1 is NULL");
    EXPECT_NE(voAppearanceActions::textureInterleave(one.get(), NULL), 0);
    expectBadValue("texture2 is NULL");
    EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), NULL), VO_FALSE);
    expectBadValue("texture2 is NULL");
}

TEST(InterleaveTest, cliqueEndsWithOneOfItsTexturesOrSizes)
{
    const auto one = rowOf(4, External::LUMINANCE, Data::FLOAT),
               third = rowOf(4, External::LUMINANCE, Data::FLOAT);
    auto other = rowOf(4, External::LUMINANCE, Data::FLOAT);
    EXPECT_EQ(voAppearanceActions::textureInterleave(one.get(), other.get()), 0);
    other.reset();
    EXPECT_EQ(voAppearanceActions::textureInterleave(one.get(), third.get()), 0);
    EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), third.get()), VO_TRUE);
    third->setSizes(4, 1, 1);
    EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), third.get()), VO_TRUE) << "still its size";
    third->setSizes(4, 2, 1);
    EXPECT_EQ(voAppearanceActions::cliqueTest(one.get(), third.get()), VO_FALSE);
    other = rowOf(4, External::LUMINANCE, Data::FLOAT);
    EXPECT_EQ(voAppearanceActions::textureInterleave(one.get(), other.get()), 0);
    expectNoError();

    voBrick brick(Internal::DEFAULT, External::LUMINANCE, Data::FLOAT);
    voBrick second(Internal::DEFAULT, External::LUMINANCE, Data::FLOAT);
    EXPECT_EQ(voAppearanceActions::textureInterleave(&brick, &second), 0);
    brick.setBrickSizes(7, 7, 7, 1, 1, 1);
    EXPECT_EQ(voAppearanceActions::cliqueTest(&brick, &second), VO_TRUE) << "bricks may lie anywhere";
    brick.setBrickSizes(7, 7, 7, 2, 1, 1);
    EXPECT_EQ(voAppearanceActions::cliqueTest(&brick, &second), VO_FALSE);
    expectNoError();
}

int partnersOf(voBrickSet& set, int brick)
{
    int partners = 0;
    for (int i = 0; i < set.getBrickCount(); ++i)
        partners += voAppearanceActions::cliqueTest(set.getBrick(brick), set.getBrick(i));
    return partners;
}

TEST(InterleaveTest, optimizePairsBricksAndUnoptimizeTakesThemApart)
{
    using O = voOptimizeVolumeTypeScope;
    for (const voInterpolationType type : {Interpolation::_3D, Interpolation::_2D}) {
        // 27 bricks of 5^3 voxels, or three sets of 13 x 9 slices.
        const auto volume = byteVolume(13, 5, type);
        EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), O::PRE_TRANSPOSE), 0);
        EXPECT_EQ(partnersOf(*volume->getBrickSet(0), 0), 0);
        for (int twice = 0; twice < 2; ++twice) {
            EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), O::INTERLEAVE), 0);
            for (int s = 0; s < volume->getBrickSetCount(); ++s) {
                voBrickSet& set = *volume->getBrickSet(s);
                int paired = 0;
                for (int b = 0; b < set.getBrickCount(); ++b) {
                    EXPECT_LE(partnersOf(set, b), 1);
                    paired += partnersOf(set, b);
                }
                EXPECT_EQ(paired, set.getBrickCount() / 2 * 2);
            }
        }
        EXPECT_EQ(voAppearanceActions::volumeUnoptimize(volume.get()), 0);
        for (int s = 0; s < volume->getBrickSetCount(); ++s)
            for (int b = 0; b < volume->getBrickSet(s)->getBrickCount(); ++b)
                EXPECT_EQ(partnersOf(*volume->getBrickSet(s), b), 0);
        EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), O::BEST_PERFORMANCE), 0);
        EXPECT_EQ(partnersOf(*volume->getBrickSet(0), 0), 1);
    }
    expectNoError();
}

TEST(InterleaveTest, optimizePairsBricksOfOneSize)
{
    // Bricks of 8 and, at the ends, of 4 and 2 voxels: no two of the latter alike but by symmetry.
    const auto volume = std::make_unique<voBrickSetCollection>(
        18, 18, 9, 8, 8, 8, voPartialBrickTypeScope::AUGMENT_TIGHT, 1, Internal::DEFAULT, External::LUMINANCE,
        Data::UNSIGNED_BYTE, Interpolation::_3D);
    voBrickSet& set = *volume->getBrickSet(0);
    EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), voOptimizeVolumeTypeScope::INTERLEAVE), 0);
    int paired = 0;
    for (int a = 0; a < set.getBrickCount(); ++a)
        for (int b = 0; b < set.getBrickCount(); ++b) {
            if (!voAppearanceActions::cliqueTest(set.getBrick(a), set.getBrick(b))) continue;
            int size[2][3];
            set.getBrick(a)->getSizes(size[0][0], size[0][1], size[0][2]);
            set.getBrick(b)->getSizes(size[1][0], size[1][1], size[1][2]);
            EXPECT_TRUE(std::equal(size[0], size[0] + 3, size[1]));
            ++paired;
        }
    EXPECT_GT(paired, 0);
    EXPECT_LT(paired, set.getBrickCount());
    expectNoError();
}

TEST(InterleaveTest, optimizeKeepsPairsOfTheApplication)
{
    const auto volume = byteVolume(13, 5);
    voBrickSet& set = *volume->getBrickSet(0);
    EXPECT_EQ(voAppearanceActions::textureInterleave(set.getBrick(0), set.getBrick(9)), 0);
    EXPECT_EQ(voAppearanceActions::volumeOptimize(volume.get(), voOptimizeVolumeTypeScope::INTERLEAVE), 0);
    EXPECT_EQ(voAppearanceActions::cliqueTest(set.getBrick(0), set.getBrick(9)), VO_TRUE);
    EXPECT_EQ(voAppearanceActions::cliqueTest(set.getBrick(1), set.getBrick(2)), VO_TRUE);
    expectNoError();
}

TEST(InterleaveTest, optimizeLeavesColoursAlone)
{
    voBrickSetCollection volume(8, 8, 8, 4, 4, 4, voPartialBrickTypeScope::AUGMENT, 0, Internal::DEFAULT,
                                External::RGBA, Data::UNSIGNED_BYTE, Interpolation::_3D);
    EXPECT_EQ(voAppearanceActions::volumeOptimize(&volume, voOptimizeVolumeTypeScope::INTERLEAVE), 0);
    for (int b = 0; b < 8; ++b)
        EXPECT_EQ(partnersOf(*volume.getBrickSet(0), b), 0);
    expectNoError();
}

// The texture matrix.

TEST(TextureMatrixTest, takesVoxelsToTextureCoordinates)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    brick.setBrickSizes(10, 20, 30, 4, 5, 8);
    float m[16];
    voAppearanceActions::textureMakeMatrix(&brick, m);
    const float voxel[4] = {11, 25, 26, 1};
    const float expected[4] = {0.25f, 1.0f, -0.5f, 1.0f};
    for (int row = 0; row < 4; ++row) {
        float sum = 0;
        for (int column = 0; column < 4; ++column)
            sum += m[4 * column + row] * voxel[column];
        EXPECT_FLOAT_EQ(sum, expected[row]) << row;
    }
    expectNoError();
}

TEST(TextureMatrixTest, isTheTransformOfXfmVox2TexCoords)
{
    for (const voInterpolationType type : {Interpolation::_3D, Interpolation::_2D}) {
        const auto volume = byteVolume(13, 5, type);
        for (int s = 0; s < volume->getBrickSetCount(); ++s) {
            voBrick* brick = volume->getBrickSet(s)->getBrick(volume->getBrickSet(s)->getBrickCount() - 2);
            voIndexedFaceSet faces(0, 6, 0);
            float records[] = {7.5f, 8.25f, 9.75f, 0, 0, 0, 1, 2, 3, 1, 0, 0, 4, 5, 6, 0, 1, 0};
            faces.appendPoly(records, 3);
            voAppearanceActions::xfmVox2TexCoords(brick, &faces, Format::T3F_V3F,
                                                  volume->getBrickSet(s)->getOrientation());
            float m[16];
            voAppearanceActions::textureMakeMatrix(brick, m);
            for (int row = 0; row < 3; ++row)
                EXPECT_FLOAT_EQ(m[row] * 7.5f + m[4 + row] * 8.25f + m[8 + row] * 9.75f + m[12 + row],
                                (*faces.getVertexData())[0][row])
                    << "set " << s << ", row " << row;
        }
    }
    expectNoError();
}

TEST(TextureMatrixTest, badArgumentsAreRefused)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    float m[16] = {77};
    voAppearanceActions::textureMakeMatrix(NULL, m);
    expectBadValue("brick is NULL");
    EXPECT_EQ(m[0], 77);
    voAppearanceActions::textureMakeMatrix(&brick, NULL);
    expectBadValue("matrix is NULL");
}

// What the guide prints on this class, too.

TEST(ForwardsTest, clipAndSampleAreThoseOfTheGeometryActions)
{
    voVertexData square(4, 3);
    const float corners[4][3] = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}};
    for (int i = 0; i < 4; ++i)
        std::copy_n(corners[i], 3, square[i]);
    square.setCount(4);
    float lower[3] = {1, 1, 0}, upper[3] = {3, 9, 9};
    float planes[8] = {1, 0, 0, -1, -1, 0, 0, 3};
    const auto extent = [](voIndexedFaceSet& faces) {
        float low[2] = {9, 9}, high[2] = {-9, -9};
        for (int i = 0; i < faces.getVertexData()->getCount(); ++i)
            for (int axis = 0; axis < 2; ++axis) {
                low[axis] = std::min(low[axis], (*faces.getVertexData())[i][axis]);
                high[axis] = std::max(high[axis], (*faces.getVertexData())[i][axis]);
            }
        return std::array{low[0], low[1], high[0], high[1]};
    };
    voIndexedFaceSet boxed(0, 3, 0), plainBoxed(0, 3, 0), halved(0, 3, 0);
    EXPECT_EQ(voAppearanceActions::clip(&square, Format::V3F, lower, upper, &boxed), 0);
    EXPECT_EQ(extent(boxed), (std::array{1.0f, 1.0f, 3.0f, 4.0f}));
    EXPECT_EQ(voAppearanceActions::clip(&square, lower, upper, &plainBoxed), 0);
    EXPECT_EQ(extent(plainBoxed), (std::array{1.0f, 1.0f, 3.0f, 4.0f}));
    EXPECT_EQ(voAppearanceActions::clip(&square, Format::V3F, planes, 2, &halved), 0);
    EXPECT_EQ(extent(halved), (std::array{1.0f, 0.0f, 3.0f, 4.0f}));

    float tetra[4][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, plane[4] = {0, 0, 1, -1};
    voVertexData polygon(4, 3);
    EXPECT_EQ(voAppearanceActions::sample(tetra, plane, &polygon), 0);
    ASSERT_EQ(polygon.getCount(), 3);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(polygon[i][2], 1.0f);
    expectNoError();
    EXPECT_NE(voAppearanceActions::clip(NULL, lower, upper, &boxed), 0);
    expectBadValue("polygon is NULL");
}

// Explicit texture coordinates.

/// A triangle of T3F_V3F records whose texture coordinates are the given voxel coordinates.
void appendTriangle(voIndexedFaceSet& faces, float a, float b, float c)
{
    const float records[3][6] = {{a, a, a, 0, 0, 0}, {b, b, b, 0, 0, 0}, {c, c, c, 0, 0, 0}};
    faces.appendPoly(const_cast<float*>(&records[0][0]), 3);
}

TEST(VoxelCoordinatesTest, becomeTheBricksTextureCoordinates)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    brick.setBrickSizes(10, 20, 30, 10, 20, 40);
    voIndexedFaceSet faces(0, 6, 0);
    // Edge-based: the brick spans [origin, origin + size], voxel i is centred at i + 0.5.
    appendTriangle(faces, 10, 20, 30.5f);
    voAppearanceActions::xfmVox2TexCoords(&brick, &faces, Format::T3F_V3F, Plane::UNSPECIFIED);
    const float* first = (*faces.getVertexData())[0];
    const float* second = (*faces.getVertexData())[1];
    const float* third = (*faces.getVertexData())[2];
    EXPECT_FLOAT_EQ(first[0], 0);
    EXPECT_FLOAT_EQ(second[0], 1);
    EXPECT_FLOAT_EQ(second[1], 0);
    EXPECT_NEAR(third[2], 0.5f / 40, 1e-7f);
    EXPECT_EQ(third[3], 0); // positions stay
    expectNoError();
}

TEST(VoxelCoordinatesTest, sharedVerticesAreTransformedOnce)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    brick.setBrickSizes(0, 0, 0, 2, 2, 2);
    voIndexedFaceSet faces(0, 6, 0);
    appendTriangle(faces, 1, 1, 1);
    // A second polygon of the same vertices.
    voIndices& indices = *faces.getIndices();
    ASSERT_GE(indices.getCountMax(), 4);
    faces.appendPoly(NULL, 3);
    for (int i = 0; i < 3; ++i)
        indices[5 + i] = i;
    voAppearanceActions::xfmVox2TexCoords(&brick, &faces, Format::T3F_V3F, Plane::XY);
    EXPECT_FLOAT_EQ((*faces.getVertexData())[0][0], 0.5f);
}

TEST(VoxelCoordinatesTest, ofASetFollowEachBrick)
{
    const auto volume = byteVolume(8, 4, Interpolation::_3D, 0);
    const int bricks = volume->getCurrentBrickSet()->getBrickCount();
    FaceSets faces(bricks, 2, 6);
    for (int b = 0; b < bricks; ++b)
        for (int s = 0; s < 2; ++s)
            appendTriangle(faces.at(b, s), 4, 5, 6);
    voAppearanceActions::xfmVox2TexCoords(volume->getCurrentBrickSet(), 2, faces, Format::T3F_V3F);
    for (int b = 0; b < bricks; ++b)
        for (int s = 0; s < 2; ++s) {
            const float* record = faces.at(b, s)[2]; // entry 0 is the count
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_FLOAT_EQ(record[axis], b >> axis & 1 ? 0.25f : 1.25f);
        }
    expectNoError();
}

TEST(VoxelCoordinatesTest, badArgumentsAreRefused)
{
    voBrick brick(Internal::DEFAULT, External::DEFAULT, Data::DEFAULT);
    voIndexedFaceSet faces(0, 6, 0);
    appendTriangle(faces, 1, 1, 1);
    const auto xfm = [&](voBrick* b, voIndexedFaceSet* f, int format) {
        voAppearanceActions::xfmVox2TexCoords(b, f, static_cast<voInterleavedArrayType>(format), Plane::XY);
    };
    xfm(NULL, &faces, Format::T3F_V3F);
    expectBadValue("brick is NULL");
    xfm(&brick, NULL, Format::T3F_V3F);
    expectBadValue("faceSet is NULL");
    xfm(&brick, &faces, Format::V3F);
    expectBadValue("T3F");
    xfm(&brick, &faces, Format::T3F_C4F_V3F);
    expectBadValue("10 values");
    xfm(&brick, &faces, 12);
    expectBadEnum();
    for (const int entry : {-1, INT_MIN, 4, INT_MAX}) {
        (*faces.getIndices())[0] = entry;
        xfm(&brick, &faces, Format::T3F_V3F);
        expectBadValue("groups");
    }
    (*faces.getIndices())[0] = 3;
    for (const int vertex : {-1, 3, INT_MAX}) {
        (*faces.getIndices())[2] = vertex;
        xfm(&brick, &faces, Format::T3F_V3F);
        expectBadValue("vertex");
    }
    EXPECT_EQ((*faces.getVertexData())[0][0], 1);

    const auto volume = byteVolume(8, 8);
    FaceSets none(1, 1, 6);
    voIndexedFaceSet* row[] = {NULL};
    voIndexedFaceSet** sets[] = {row};
    voAppearanceActions::xfmVox2TexCoords(NULL, 1, none, Format::T3F_V3F);
    expectBadValue("brickSet is NULL");
    voAppearanceActions::xfmVox2TexCoords(volume->getCurrentBrickSet(), 1, NULL, Format::T3F_V3F);
    expectBadValue("polygonSet is NULL");
    voAppearanceActions::xfmVox2TexCoords(volume->getCurrentBrickSet(), 1, sets, Format::T3F_V3F);
    expectBadValue("NULL");
    sets[0] = NULL;
    voAppearanceActions::xfmVox2TexCoords(volume->getCurrentBrickSet(), 1, sets, Format::T3F_V3F);
    expectBadValue("NULL");
    voAppearanceActions::xfmVox2TexCoords(volume->getCurrentBrickSet(), -5, none, Format::T3F_V3F);
    expectNoError();
}

} // namespace
