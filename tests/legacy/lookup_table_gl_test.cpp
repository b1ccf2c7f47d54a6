#include "square_screen.h"

#include <gtest/gtest.h>

#include <tuple>

namespace {

using namespace vo::test;
using Internal = voInternalFormatTypeScope;
using External = voExternalFormatTypeScope;
using Data = voDataTypeScope;

struct LookupTableGL : testing::Test
{
    /// The square under a volume of `value`.
    std::pair<float, float> shown(unsigned char value)
    {
        const auto volume = SquareScreen::constantVolume(value);
        return screen.drawSquare(*volume);
    }
    SquareScreen screen;
};

/// Two entries (grey, alpha): 0 is (1, 0.25), 255 is (0.5, 0.75).
std::vector<float> twoEntries()
{
    return {1, 0.25f, 0.5f, 0.75f};
}

template <class Table>
struct LookupTableOfEachKindGL : LookupTableGL
{
};
using Kinds = testing::Types<voLookupTablePre, voLookupTablePost>;
TYPED_TEST_SUITE(LookupTableOfEachKindGL, Kinds);

TYPED_TEST(LookupTableOfEachKindGL, entriesMayBeFilledAfterConstruction)
{
    std::vector<float> entries(4, 0.0f);
    TypeParam table(Internal::LUMINANCE8_ALPHA8_EXT, 2, External::LUMINANCE_ALPHA, Data::FLOAT,
                    entries.data());
    std::ranges::copy(twoEntries(), entries.begin());
    table.load();
    table.enable();
    auto [grey, alpha] = this->shown(0);
    EXPECT_NEAR(grey, 1.0f, 1e-4f);
    EXPECT_NEAR(alpha, 0.25f, 1e-4f);
    std::tie(grey, alpha) = this->shown(255);
    EXPECT_NEAR(grey, 0.5f, 1e-4f);
    EXPECT_NEAR(alpha, 0.75f, 1e-4f);
    expectNoError();
}

TYPED_TEST(LookupTableOfEachKindGL, entriesCountAsTheyWereAtLoad)
{
    std::vector<float> entries = twoEntries();
    TypeParam table(Internal::LUMINANCE8_ALPHA8_EXT, 2, External::LUMINANCE_ALPHA, Data::FLOAT,
                    entries.data());
    table.load();
    table.enable();
    entries.assign(4, 0.0f);
    EXPECT_NEAR(this->shown(0).first, 1.0f, 1e-4f);
    table.load();
    EXPECT_NEAR(this->shown(0).first, 0.0f, 1e-4f);
}

TYPED_TEST(LookupTableOfEachKindGL, disableOnAnyTableSwitchesTheKindOff)
{
    std::vector<float> entries = twoEntries();
    TypeParam table(Internal::LUMINANCE8_ALPHA8_EXT, 2, External::LUMINANCE_ALPHA, Data::FLOAT,
                    entries.data());
    TypeParam other(Internal::LUMINANCE8_ALPHA8_EXT, 2, External::LUMINANCE_ALPHA, Data::FLOAT,
                    entries.data());
    table.load();
    table.enable();
    EXPECT_NEAR(this->shown(0).first, 1.0f, 1e-4f);
    other.disable();
    EXPECT_EQ(this->shown(0).first, 0.0f);
    expectNoError();
}

TYPED_TEST(LookupTableOfEachKindGL, deletingTheEnabledTableSwitchesItOff)
{
    std::vector<float> entries = twoEntries();
    {
        TypeParam table(Internal::LUMINANCE8_ALPHA8_EXT, 2, External::LUMINANCE_ALPHA, Data::FLOAT,
                        entries.data());
        table.load();
        table.enable();
        EXPECT_NEAR(this->shown(0).first, 1.0f, 1e-4f);
    }
    EXPECT_EQ(this->shown(0).first, 0.0f);
}

TYPED_TEST(LookupTableOfEachKindGL, linearShapeIsAGreyRamp)
{
    TypeParam table(Internal::RGBA8_EXT, 256, External::RGBA, Data::FLOAT);
    table.set(voLookupTable::LINEAR, 128, 64);
    table.load();
    table.enable();
    for (const auto& [value, expected] : {std::pair(0, 0.0f),
                                          {96, 0.0f},
                                          {112, 0.25f},
                                          {128, 0.5f},
                                          {144, 0.75f},
                                          {160, 1.0f},
                                          {255, 1.0f}}) {
        const auto [grey, alpha] = this->shown(static_cast<unsigned char>(value));
        EXPECT_NEAR(grey, expected, 1e-3f) << value;
        EXPECT_NEAR(alpha, expected, 1e-3f) << value;
    }
    expectNoError();
}

TEST_F(LookupTableGL, enabledButNeverLoadedChangesNothing)
{
    voLookupTablePost table(Internal::RGBA8_EXT, 256, External::RGBA, Data::FLOAT);
    table.enable();
    EXPECT_NEAR(shown(255).first, 1.0f, 1e-4f);
    table.load();
    expectBadValue("no entries");
    EXPECT_NEAR(shown(255).first, 1.0f, 1e-4f);
}

TEST_F(LookupTableGL, changedPreTableReclassifiesAResidentVolume)
{
    const auto volume = SquareScreen::constantVolume(255);
    std::vector<float> entries = twoEntries();
    voLookupTablePre table(Internal::LUMINANCE8_ALPHA8_EXT, 2, External::LUMINANCE_ALPHA, Data::FLOAT,
                           entries.data());
    EXPECT_NEAR(screen.drawSquare(*volume).first, 1.0f, 1e-4f);
    table.load();
    table.enable();
    EXPECT_NEAR(screen.drawSquare(*volume).first, 0.5f, 1e-4f);
    entries[2] = 0.125f;
    table.load();
    EXPECT_NEAR(screen.drawSquare(*volume).first, 0.125f, 1e-4f);
    table.disable();
    EXPECT_NEAR(screen.drawSquare(*volume).first, 1.0f, 1e-4f);
}

TEST_F(LookupTableGL, widestTableWorks)
{
    std::vector<float> entries(2 * 16384, 0.5f);
    voLookupTablePost table(Internal::LUMINANCE8_ALPHA8_EXT, 16384, External::LUMINANCE_ALPHA, Data::FLOAT,
                            entries.data());
    table.load();
    table.enable();
    EXPECT_NEAR(shown(77).first, 0.5f, 1e-4f);
    EXPECT_EQ(screen.gl().GetError(), GLenum{GL_NO_ERROR});
    expectNoError();
}

} // namespace
