#include "expect_error.h"
#include "face_scene.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <type_traits>

namespace {

using namespace vo::test;
using Internal = voInternalFormatTypeScope;
using External = voExternalFormatTypeScope;
using Data = voDataTypeScope;
using Type = voLookupTableTypeScope;

TEST(LookupTableTest, isAbstractAndHasTheNamesOfTheGuide)
{
    EXPECT_TRUE(std::is_abstract_v<voLookupTable>);
    EXPECT_TRUE(std::has_virtual_destructor_v<voLookupTable>);
    EXPECT_TRUE((std::is_same_v<voTextureLookup, voLookupTable>));
    EXPECT_TRUE((std::is_same_v<voTextureLookupPre, voLookupTablePre>));
    EXPECT_TRUE((std::is_same_v<voTextureLookupPost, voLookupTablePost>));
    EXPECT_EQ(voTextureLookup::LINEAR, voLookupTableShapeScope::LINEAR);
}

TEST(LookupTableTest, typeSaysWhenItIsApplied)
{
    voLookupTablePre pre(Internal::RGBA8_EXT, 256, External::RGBA, Data::FLOAT);
    voLookupTablePost post(Internal::RGBA8_EXT, 256, External::RGBA, Data::FLOAT);
    EXPECT_EQ(pre.getType(), Type::PRE_INTERPOLATION);
    EXPECT_EQ(static_cast<voLookupTable&>(post).getType(), Type::POST_INTERPOLATION);
    expectNoError();
}

TEST(LookupTableTest, takesEnumerationsAndOpenGlConstants)
{
    unsigned short entries[8] = {};
    const GLenum formats[][3] = {
        {Internal::RGBA8_EXT, External::RGBA, Data::UNSIGNED_BYTE},
        {Internal::LUMINANCE8_ALPHA8_EXT, External::LUMINANCE_ALPHA, Data::UNSIGNED_SHORT},
        {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
        {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, GL_UNSIGNED_SHORT},
        {GL_LUMINANCE_ALPHA, External::LUMINANCE_ALPHA, GL_SHORT},
        {GL_RGBA, External::ABGR_EXT, Data::BYTE}};
    for (const auto& format : formats) {
        voLookupTablePost table(format[0], 2, format[1], format[2], entries);
        table.load();
        expectNoError();
    }
}

TEST(LookupTableTest, otherFormatsAreUnsupportedAtLoad)
{
    float entries[64] = {};
    const GLenum formats[][3] = {
        {Internal::INTENSITY8_EXT, External::RGBA, Data::FLOAT},
        {Internal::DEFAULT, External::RGBA, Data::FLOAT},
        {99, External::RGBA, Data::FLOAT},
        {Internal::RGBA8_EXT, External::LUMINANCE, Data::FLOAT},
        {Internal::RGBA8_EXT, GL_LUMINANCE, Data::FLOAT},
        {Internal::RGBA8_EXT, External::RGBA, GL_UNSIGNED_SHORT_4_4_4_4},
        {Internal::RGBA8_EXT, External::LUMINANCE_ALPHA, Data::UNSIGNED_BYTE_3_3_2_EXT},
        {Internal::RGBA8_EXT, External::ABGR_EXT, Data::UNSIGNED_BYTE_3_3_2_EXT}};
    for (const auto& format : formats) {
        voLookupTablePost table(format[0], 4, format[1], format[2], entries);
        expectNoError();
        table.load();
        expectUnsupported();
    }
    const std::pair<GLenum, GLenum> outside[] = {{50, Data::FLOAT}, {External::RGBA, 60}};
    for (const auto& format : outside) {
        voLookupTablePost table(Internal::RGBA8_EXT, 4, format.first, format.second, entries);
        table.load();
        expectBadEnum();
    }
}

TEST(LookupTableTest, loadNeedsEntriesOrAShape)
{
    voLookupTablePost table(Internal::RGBA8_EXT, 256, External::RGBA, Data::FLOAT);
    table.load();
    expectBadValue("no entries");
    table.set(voLookupTableShapeScope::LINEAR, 128, 50);
    table.load();
    expectNoError();
}

TEST(LookupTableTest, setTakesIntsAndFloats)
{
    voLookupTablePre table(Internal::LUMINANCE8_ALPHA8_EXT, 256, External::LUMINANCE_ALPHA, Data::FLOAT);
    const int center = 195, width = 50;
    table.set(voTextureLookup::LINEAR, center, width);
    table.set(voLookupTableShapeScope::LINEAR, 1.5f, 0.0f);
    table.set(voLookupTableShapeScope::LINEAR, -1e30f, -5);
    table.load();
    expectNoError();
    table.set(static_cast<voLookupTableShape>(4), 1, 1);
    expectBadEnum();
    for (const float bad : {std::nanf(""), HUGE_VALF}) {
        table.set(voLookupTableShapeScope::LINEAR, bad, 1);
        expectBadValue("not a number");
        table.set(voLookupTableShapeScope::LINEAR, 1, bad);
        expectBadValue("not a number");
    }
}

TEST(LookupTableTest, widthsOutsideAreBadValue)
{
    for (const int width : {1, 0, -1, INT_MIN, INT_MAX, 16385}) {
        voLookupTablePost table(Internal::RGBA8_EXT, width, External::RGBA, Data::FLOAT);
        expectBadValue("entries");
        table.set(voLookupTableShapeScope::LINEAR, 1, 1);
        table.load();
        expectBadValue("entries");
        table.enable();
        table.disable();
        voError::getErrorNumber();
        voError::getErrorString();
    }
}

TEST(LookupTableTest, switchesWithoutAContextAreRememberedSilently)
{
    float entries[8] = {};
    voLookupTablePost post(Internal::RGBA8_EXT, 2, External::RGBA, Data::FLOAT, entries);
    voLookupTablePre pre(Internal::RGBA8_EXT, 2, External::RGBA, Data::FLOAT, entries);
    for (voLookupTable* table : {static_cast<voLookupTable*>(&post), static_cast<voLookupTable*>(&pre)}) {
        table->disable();
        table->enable();
        table->load();
        table->enable();
        table->disable();
    }
    expectNoError();
}

TEST(LookupTableTest, mayBeDeletedWhileEnabled)
{
    float entries[8] = {};
    for (int i = 0; i < 3; ++i) {
        voLookupTable* table =
            new voLookupTablePost(Internal::RGBA8_EXT, 2, External::RGBA, Data::FLOAT, entries);
        table->load();
        table->enable();
        delete table;
    }
    expectNoError();
}

TEST(LookupTableTest, bestParametersFollowTheMode)
{
    const auto volume = byteVolume(8, 8);
    voInternalFormatType internal;
    voExternalFormatType external;
    voDataType data;
    voLookupTableType type = Type::DEFAULT;
    EXPECT_EQ(voLookupTable::getBestParameters(volume.get(), voRenderingModeScope::COLOR, 256, type, internal,
                                               external, data),
              0);
    EXPECT_EQ(type, Type::POST_INTERPOLATION);
    EXPECT_EQ(internal, Internal::RGBA8_EXT);
    EXPECT_EQ(external, External::RGBA);
    EXPECT_EQ(data, Data::FLOAT);
    type = Type::PRE_INTERPOLATION;
    EXPECT_EQ(voTextureLookupPost::getBestParameters(volume.get(), voRenderingModeScope::MONOCHROME, 256,
                                                     type, internal, external, data),
              0);
    EXPECT_EQ(type, Type::PRE_INTERPOLATION);
    EXPECT_EQ(internal, Internal::LUMINANCE8_ALPHA8_EXT);
    EXPECT_EQ(external, External::LUMINANCE_ALPHA);
    expectNoError();
}

TEST(LookupTableTest, bestParametersRefuseBadArguments)
{
    voInternalFormatType internal = Internal::RGB8_EXT;
    voExternalFormatType external = External::INTENSITY;
    voDataType data = Data::SHORT;
    voLookupTableType type = Type::DEFAULT;
    const auto call = [&](int mode, int length) {
        return voLookupTable::getBestParameters(NULL, static_cast<voRenderingMode>(mode), length, type,
                                                internal, external, data);
    };
    EXPECT_NE(call(7, 256), 0);
    expectBadEnum();
    for (const int length : {1, -3, INT_MAX}) {
        EXPECT_NE(call(0, length), 0);
        expectBadValue("entries");
    }
    type = static_cast<voLookupTableType>(3);
    EXPECT_NE(call(0, 256), 0);
    expectBadEnum();
    EXPECT_EQ(internal, Internal::RGB8_EXT);
    EXPECT_EQ(data, Data::SHORT);
}

} // namespace
