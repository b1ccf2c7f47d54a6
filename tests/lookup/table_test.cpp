#include "lookup/table.h"
#include "lookup/visible_values.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace {

using vo::Table;

/// Entry i holds i, 10 i, 100 i, 1000 i, over the largest of each.
Table distinctColumns(int size)
{
    Table table;
    for (int i = 0; i < size; ++i)
        for (const int power : {1, 2, 3, 4})
            table.rgba.push_back(static_cast<float>(std::pow(static_cast<double>(i) / (size - 1), power)));
    return table;
}

TEST(LinearRamp, risesOverItsWidthInAllComponents)
{
    const Table ramp = vo::linearRamp(256, 128, 64);
    ASSERT_EQ(ramp.size(), 256);
    for (int i = 0; i < 256; ++i) {
        const double expected = i <= 96 ? 0.0 : i >= 160 ? 1.0 : (i - 96) / 64.0;
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_FLOAT_EQ(ramp.rgba[4 * static_cast<std::size_t>(i) + c], static_cast<float>(expected))
                << i;
    }
}

TEST(LinearRamp, widthBelowOneIsAStep)
{
    for (const double width : {1.0, 0.5, 0.0, -10.0}) {
        const Table ramp = vo::linearRamp(16, 8, width);
        EXPECT_EQ(ramp.rgba[4 * 7], 0.0f);
        EXPECT_EQ(ramp.rgba[4 * 8], 0.5f);
        EXPECT_EQ(ramp.rgba[4 * 9], 1.0f);
    }
}

TEST(LinearRamp, centreMayLieOutside)
{
    EXPECT_EQ(vo::linearRamp(16, -100, 10).rgba.front(), 1.0f);
    EXPECT_EQ(vo::linearRamp(16, 100, 10).rgba.back(), 0.0f);
}

TEST(ApplyTable, eachComponentReadsItsOwnColumn)
{
    const Table table = distinctColumns(5);
    std::array<float, 4> voxel{0.5f, 0.5f, 0.5f, 0.5f};
    vo::applyTable(table, voxel.data(), 1);
    EXPECT_EQ(voxel, (std::array<float, 4>{0.5f, 0.25f, 0.125f, 0.0625f}));
}

TEST(ApplyTable, entriesAreMetExactly)
{
    for (const int size : {2, 3, 64, 256, 4096}) {
        const Table table = distinctColumns(size);
        for (int i = 0; i < size; ++i) {
            const float value = static_cast<float>(i) / static_cast<float>(size - 1);
            std::array<float, 4> voxel{value, value, value, value};
            vo::applyTable(table, voxel.data(), 1);
            for (std::size_t c = 0; c < 4; ++c)
                EXPECT_NEAR(voxel[c], table.rgba[4 * static_cast<std::size_t>(i) + c], 2e-6f);
        }
    }
}

TEST(ApplyTable, betweenEntriesIsLinear)
{
    Table table;
    table.rgba = {0, 0, 0, 0, 1, 0.5f, 0.25f, 0.125f, 0, 0, 0, 0};
    std::array<float, 8> voxels{0.25f, 0.25f, 0.25f, 0.25f, 0.75f, 0.75f, 0.75f, 0.75f};
    vo::applyTable(table, voxels.data(), 2);
    EXPECT_EQ(voxels, (std::array<float, 8>{0.5f, 0.25f, 0.125f, 0.0625f, 0.5f, 0.25f, 0.125f, 0.0625f}));
}

TEST(ApplyTable, valuesOutsideAreClamped)
{
    const Table table = vo::linearRamp(256, 127.5, 255);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    std::array<float, 8> voxels{
        -1.0f, -kInfinity, std::numeric_limits<float>::quiet_NaN(), -0.0f, 1.0f, 2.0f, kInfinity, 1e30f};
    vo::applyTable(table, voxels.data(), 2);
    EXPECT_EQ(voxels, (std::array<float, 8>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(ApplyTable, oneEntryIsAConstant)
{
    Table table;
    table.rgba = {0.1f, 0.2f, 0.3f, 0.4f};
    std::array<float, 8> voxels{0, 0, 0, 0, 1, 1, 1, 1};
    vo::applyTable(table, voxels.data(), 2);
    EXPECT_EQ(voxels, (std::array<float, 8>{0.1f, 0.2f, 0.3f, 0.4f, 0.1f, 0.2f, 0.3f, 0.4f}));
}

/// Opaque from entry 10 to entry 20 of 256.
vo::VisibleValues opaqueFrom10To20()
{
    Table table;
    for (int i = 0; i < 256; ++i)
        table.rgba.insert(table.rgba.end(), {1.0f, 1.0f, 1.0f, i >= 10 && i <= 20 ? 0.5f : 0.0f});
    return vo::VisibleValues(table);
}

float entry(double number)
{
    return static_cast<float>(number / 255.0);
}

TEST(VisibleValues, withoutATableOnlyZeroIsClear)
{
    const vo::VisibleValues values;
    EXPECT_FALSE(values.any(0.0f, 0.0f));
    EXPECT_TRUE(values.any(0.0f, 1e-30f));
    EXPECT_TRUE(values.any(-0.5f, 0.0f));
}

TEST(VisibleValues, entriesOfATableAreSeenAsFarAsTheirNeighbours)
{
    const vo::VisibleValues values = opaqueFrom10To20();
    EXPECT_FALSE(values.any(entry(0), entry(9)));
    EXPECT_TRUE(values.any(entry(0), entry(9.01)));
    EXPECT_TRUE(values.any(entry(12), entry(13)));
    EXPECT_TRUE(values.any(entry(20.99), entry(200)));
    EXPECT_FALSE(values.any(entry(21), entry(255)));
    EXPECT_TRUE(values.any(entry(0), entry(255)));
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(values.any(entry(i), entry(i)), i >= 10 && i <= 20) << i;
}

TEST(VisibleValues, outsideValuesAreThoseOfTheEndsAndNoneMeansNothing)
{
    Table table;
    table.rgba = {0, 0, 0, 1, 0, 0, 0, 0};
    const vo::VisibleValues values(table);
    EXPECT_TRUE(values.any(-5.0f, -3.0f));
    EXPECT_FALSE(values.any(1.0f, 7.0f));
    EXPECT_FALSE(values.any(1.0f, 0.0f));
    EXPECT_TRUE(values.any(std::numeric_limits<float>::quiet_NaN(), 1.0f));
}

} // namespace
