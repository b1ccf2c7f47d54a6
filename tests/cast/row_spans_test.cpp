// Which pixels a polygon has.

#include "cast/row_spans.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace {

using vo::PixelBox;
using vo::RowSpan;
using vo::SnappedVertex;

constexpr int kWidth = 40, kHeight = 30;
using Count = std::array<std::array<int, kWidth>, kHeight>;

void add(const std::vector<SnappedVertex>& polygon, Count& count)
{
    std::vector<RowSpan> rows;
    int layers = 0;
    const PixelBox box = vo::appendRowSpans(polygon, kWidth, kHeight, rows, layers);
    ASSERT_EQ(rows.size(), static_cast<std::size_t>(layers) * static_cast<std::size_t>(box.y1 - box.y0));
    for (int layer = 0; layer < layers; ++layer)
        for (int y = box.y0; y < box.y1; ++y) {
            const RowSpan& span = rows[static_cast<std::size_t>(layer * (box.y1 - box.y0) + y - box.y0)];
            if (span.left < span.right) {
                EXPECT_GE(span.left, box.x0);
                EXPECT_LE(span.right, box.x1);
            }
            for (int x = span.left; x < span.right; ++x)
                ++count[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        }
}

/// Twice the area of a triangle, above 0 counterclockwise.
std::int64_t area(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c)
{
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

TEST(RowSpans, pixelsWhoseCentresAreInsideAreThePolygons)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> x(-2000, 256 * kWidth + 2000), y(-2000, 256 * kHeight + 2000);
    for (int i = 0; i < 300; ++i) {
        std::vector<SnappedVertex> t{{x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}};
        if (area(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
        Count count{};
        add(t, count);
        for (int row = 0; row < kHeight; ++row)
            for (int column = 0; column < kWidth; ++column) {
                const SnappedVertex centre{256 * column + 128, 256 * row + 128};
                std::int64_t least = INT64_MAX;
                for (std::size_t edge = 0; edge < 3; ++edge)
                    least = std::min(least, area(t[edge], t[(edge + 1) % 3], centre));
                const int drawn = count[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
                if (least == 0) continue;
                EXPECT_EQ(drawn, least > 0 ? 1 : 0) << column << ", " << row;
            }
    }
}

/// A fan of triangles round a point, whose corners often lie on the centres of pixels.
TEST(RowSpans, neighboursShareNoPixelAndMissNone)
{
    std::mt19937 random(8);
    std::uniform_int_distribution<int> x(1, kWidth - 2), y(1, kHeight - 2), coarse(0, 4);
    const int right = 256 * kWidth + 300, top = 256 * kHeight + 300;
    const std::vector<SnappedVertex> frame{{-300, -300}, {1000, -300}, {right, -300}, {right, 5000},
                                           {right, top}, {6000, top},  {-300, top},   {-300, 4000}};
    for (int i = 0; i < 200; ++i) {
        const SnappedVertex middle{256 * x(random) + 64 * coarse(random),
                                   256 * y(random) + 64 * coarse(random)};
        Count count{};
        for (std::size_t k = 0; k < frame.size(); ++k) {
            std::vector<SnappedVertex> triangle{middle, frame[k], frame[(k + 1) % frame.size()]};
            if (i % 2) std::swap(triangle[0], triangle[2]);
            add(triangle, count);
        }
        for (const auto& row : count)
            for (const int drawn : row)
                EXPECT_EQ(drawn, 1);
    }
}

TEST(RowSpans, anEdgeThroughCentresGivesThemToTheRightAndTheUpperPolygon)
{
    Count count{};
    add({{128, 128}, {1408, 128}, {1408, 1408}, {128, 1408}}, count);
    EXPECT_EQ(count[0][0], 1);
    EXPECT_EQ(count[4][4], 1);
    EXPECT_EQ(count[0][5], 0) << "on the right edge";
    EXPECT_EQ(count[5][0], 0) << "on the upper edge";
}

TEST(RowSpans, whatCrossesItselfHasLayers)
{
    // Two parts in its upper rows, which reach to the sides.
    const std::vector<SnappedVertex> polygon{
        {256, 256}, {2560, 256}, {2560, 2560}, {1408, 1000}, {256, 2560}};
    Count count{};
    add(polygon, count);
    EXPECT_EQ(count[8][1], 1);
    EXPECT_EQ(count[8][5], 0);
    EXPECT_EQ(count[8][9], 1);
    EXPECT_EQ(count[2][5], 1);
}

TEST(RowSpans, whatIsOutsideOrFlatHasNone)
{
    Count count{};
    add({{-900, -900}, {-200, -900}, {-200, -200}}, count);
    add({{128, 128}, {1408, 128}, {2000, 128}}, count);
    add({{256, 0}, {256, 5000}, {256, 9000}}, count);
    add({{130, 130}, {250, 130}, {250, 250}}, count);
    add({{0, 0}, {2560, 2560}}, count);
    for (const auto& row : count)
        for (const int drawn : row)
            EXPECT_EQ(drawn, 0);
}

TEST(RowSpans, farCornersLeaveTheirEdgesExact)
{
    constexpr int kFar = 1 << 28; // 2^20 pixels
    Count count{};
    // Both halves of all there is, cut along a line of slope 1 through centres.
    add({{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}}, count);
    for (std::size_t y = 0; y < kHeight; ++y)
        for (std::size_t x = 0; x < kWidth; ++x)
            EXPECT_EQ(count[y][x], x >= y ? 1 : 0) << x << ", " << y;
    add({{-kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}}, count);
    for (const auto& row : count)
        for (const int drawn : row)
            EXPECT_EQ(drawn, 1);
}

} // namespace
