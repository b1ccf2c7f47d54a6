#include "expect_error.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace {

using namespace vo::test;

template <class Enum>
void expectInOrder(std::initializer_list<Enum> values, int first = 0)
{
    for (const Enum value : values)
        EXPECT_EQ(static_cast<int>(value), first++);
}

TEST(EnumsTest, valuesCountUpInTheOrderOfDeclaration)
{
    using I = voInterpolationTypeScope;
    expectInOrder<voInterpolationType>({I::DEFAULT, I::_2D, I::_3D});
    using R = voRenderingModeScope;
    expectInOrder<voRenderingMode>({R::DEFAULT, R::MONOCHROME, R::COLOR});
    using D = voDataTypeScope;
    expectInOrder<voDataType>({D::DEFAULT, D::UNSIGNED_BYTE, D::BYTE, D::UNSIGNED_BYTE_3_3_2_EXT,
                               D::UNSIGNED_SHORT, D::SHORT, D::UNSIGNED_SHORT_4_4_4_4_EXT,
                               D::UNSIGNED_SHORT_5_5_5_1_EXT, D::UNSIGNED_INT, D::INT,
                               D::UNSIGNED_INT_8_8_8_8_EXT, D::UNSIGNED_INT_10_10_10_2_EXT, D::FLOAT});
    using F = voInternalFormatTypeScope;
    expectInOrder<voInternalFormatType>({F::DEFAULT, F::INTENSITY8_EXT, F::LUMINANCE8_EXT,
                                         F::LUMINANCE8_ALPHA8_EXT, F::RGBA8_EXT, F::RGB8_EXT, F::RGBA4_EXT,
                                         F::QUAD_LUMINANCE8_SGIS, F::DUAL_LUMINANCE_ALPHA8_SGIS, F::RGB4_EXT,
                                         F::DUAL_INTENSITY8_SGIS});
    using E = voExternalFormatTypeScope;
    expectInOrder<voExternalFormatType>(
        {E::DEFAULT, E::INTENSITY, E::LUMINANCE_ALPHA, E::LUMINANCE, E::RGBA, E::ABGR_EXT});
    using P = voPartialBrickTypeScope;
    expectInOrder<voPartialBrickType>({P::DEFAULT, P::TRUNCATE, P::AUGMENT, P::AUGMENT_TIGHT});
    using O = voPlaneOrientationScope;
    expectInOrder<voPlaneOrientation>({O::UNSPECIFIED, O::XY, O::XZ, O::YZ});
    using M = voSamplingModeScope;
    expectInOrder<voSamplingMode>({M::DEFAULT, M::VIEWPORT_ALIGNED, M::AXIS_ALIGNED, M::SPHERICAL});
    using S = voSamplingSpaceScope;
    expectInOrder<voSamplingSpace>({S::DEFAULT, S::VIEW_VOLUME, S::OBJECT, S::PRIMITIVE});
    using V = voErrorTypeScope;
    expectInOrder<voErrorType>({V::NO_ERROR, V::BAD_VALUE, V::BAD_ENUM, V::OUT_OF_MEMORY, V::UNSUPPORTED});
}

TEST(EnumsTest, interleavedArrayTypesStartAtMinusOne)
{
    using V = voInterleavedArrayTypeScope;
    expectInOrder<voInterleavedArrayType>(
        {V::DEFAULT, V::V3F, V::T3F_V3F, V::C3F_V3F, V::C4F_V3F, V::T3F_C3F_V3F, V::T3F_C4F_V3F, V::USER_V3F},
        -1);
}

TEST(EnumsTest, aliasesOfTheGuideAreTheSameValues)
{
    using F = voInternalFormatTypeScope;
    EXPECT_EQ(F::RGB88_EXT, F::RGBA8_EXT);
    EXPECT_EQ(F::RGB84_EXT, F::RGBA4_EXT);
    EXPECT_EQ(F::RGB44_EXT, F::RGB4_EXT);
    using D = voDataTypeScope;
    EXPECT_EQ(D::INT_8_8_8_8_EXT, D::UNSIGNED_INT_8_8_8_8_EXT);
    EXPECT_EQ(D::INT_10_10_10_2_EXT, D::UNSIGNED_INT_10_10_10_2_EXT);
    EXPECT_EQ(voSamplingModeScope::BEST_PERFORMANCE, voSamplingModeScope::DEFAULT);
    EXPECT_EQ(voOptimizeVolumeTypeScope::BEST, voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
}

TEST(EnumsTest, optimizeFlagsCombine)
{
    using O = voOptimizeVolumeTypeScope;
    EXPECT_EQ(O::BEST_PERFORMANCE, O::INTERLEAVE | O::TEXTURE_OBJECTS);
    const voOptimizeVolumeType both = O::BEST | O::PRE_TRANSPOSE;
    EXPECT_EQ(static_cast<int>(both), int{O::INTERLEAVE} + O::TEXTURE_OBJECTS + O::PRE_TRANSPOSE);
    EXPECT_EQ(static_cast<voOptimizeVolumeType>(static_cast<int>(both)), both);
}

TEST(EnumsTest, decorationFlagsCombine)
{
    using D = voDecorationFlagsScope;
    EXPECT_EQ(D::NONE, 0);
    EXPECT_EQ(D::ALL, D::BRICKS | D::TETRAS);
    EXPECT_NE(D::BRICKS, D::TETRAS);
}

TEST(EnumsTest, enumsConvertToIntPrintAndSwitch)
{
    std::ostringstream out;
    out << voDataTypeScope::SHORT;
    EXPECT_EQ(out.str(), "5");
    const int stored = voPlaneOrientationScope::XZ;
    bool matched = false;
    switch (static_cast<voPlaneOrientation>(stored)) {
    case voPlaneOrientationScope::XZ: matched = true; break;
    default: break;
    }
    EXPECT_TRUE(matched);
}

TEST(EnumsTest, lookupTableTypesDiffer)
{
    EXPECT_NE(voLookupTableTypeScope::PRE_INTERPOLATION, voLookupTableTypeScope::POST_INTERPOLATION);
    EXPECT_EQ(voLookupTable::LINEAR, voLookupTableShapeScope::LINEAR);
}

/// A collection of one 8 x 8 x 8 brick made with the given enumerations as integers.
void makeCollection(int partial, int internal, int external, int data, int interpolation)
{
    voBrickSetCollection(8, 8, 8, 8, 8, 8, static_cast<voPartialBrickType>(partial), 0,
                         static_cast<voInternalFormatType>(internal),
                         static_cast<voExternalFormatType>(external), static_cast<voDataType>(data),
                         static_cast<voInterpolationType>(interpolation));
}

TEST(EnumsTest, minusOneIsReadAsDefault)
{
    makeCollection(-1, -1, -1, -1, -1);
    expectNoError();
    EXPECT_EQ(getValuesPerVertex(static_cast<voInterleavedArrayType>(-1)), 3);
    expectNoError();
}

TEST(EnumsTest, valuesOutsideAreBadEnum)
{
    for (const int outside : {-2, 100, -2147483647 - 1, 2147483647}) {
        makeCollection(outside, 0, 0, 0, 0);
        expectBadEnum("voPartialBrickType has no value");
        makeCollection(0, outside, 0, 0, 0);
        expectBadEnum("voInternalFormatType has no value");
        makeCollection(0, 0, outside, 0, 0);
        expectBadEnum("voExternalFormatType has no value");
        makeCollection(0, 0, 0, outside, 0);
        expectBadEnum("voDataType has no value");
        makeCollection(0, 0, 0, 0, outside);
        expectBadEnum("voInterpolationType has no value");
    }
}

TEST(EnumsTest, formatsThatOpenGlLacksAreUnsupported)
{
    using F = voInternalFormatTypeScope;
    for (const int format :
         {F::QUAD_LUMINANCE8_SGIS, F::DUAL_LUMINANCE_ALPHA8_SGIS, F::DUAL_INTENSITY8_SGIS}) {
        makeCollection(0, format, 0, 0, 0);
        expectUnsupported("SGIS");
    }
}

TEST(EnumsTest, everyOtherFormatAndTypeMakesACollection)
{
    using F = voInternalFormatTypeScope;
    for (const int format : {F::DEFAULT, F::INTENSITY8_EXT, F::LUMINANCE8_EXT, F::LUMINANCE8_ALPHA8_EXT,
                             F::RGBA8_EXT, F::RGB8_EXT, F::RGBA4_EXT, F::RGB4_EXT})
        for (int external = 0; external <= voExternalFormatTypeScope::ABGR_EXT; ++external) {
            makeCollection(0, format, external, voDataTypeScope::FLOAT, 0);
            expectNoError();
        }
    for (int type = 0; type <= voDataTypeScope::FLOAT; ++type) {
        makeCollection(0, 0, voExternalFormatTypeScope::RGBA, type, 0);
        expectNoError();
    }
}

TEST(EnumsTest, packedTypesNeedFourChannels)
{
    using D = voDataTypeScope;
    for (const int type :
         {D::UNSIGNED_BYTE_3_3_2_EXT, D::UNSIGNED_SHORT_4_4_4_4_EXT, D::UNSIGNED_SHORT_5_5_5_1_EXT,
          D::UNSIGNED_INT_8_8_8_8_EXT, D::UNSIGNED_INT_10_10_10_2_EXT})
        for (const int format : {voExternalFormatTypeScope::LUMINANCE, voExternalFormatTypeScope::INTENSITY,
                                 voExternalFormatTypeScope::LUMINANCE_ALPHA}) {
            makeCollection(0, 0, format, type, 0);
            expectUnsupported("packed");
        }
}

TEST(EnumsTest, trueAndFalseAreOneAndZero)
{
    const voBool yes = VO_TRUE, fromComparison = 1 > 2;
    EXPECT_EQ(yes, 1);
    EXPECT_EQ(VO_FALSE, 0);
    EXPECT_EQ(fromComparison, VO_FALSE);
}

TEST(EnumsTest, versionIsStaticText)
{
    ASSERT_NE(voVersion(), nullptr);
    EXPECT_EQ(voVersion(), voVersion());
    EXPECT_GT(std::string(voVersion()).size(), 0u);
}

} // namespace
