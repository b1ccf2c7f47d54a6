#include "cast/row_spans.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <climits>
#include <utility>

namespace vo {

namespace {

constexpr std::int64_t kHalf = kSubpixels / 2;

std::int64_t floorQuotient(std::int64_t a, std::int64_t b)
{
    const std::int64_t q = a / b;
    return q - (a % b < 0 ? 1 : 0);
}

/// The first row whose centre is not below y.
int rowFrom(std::int32_t y)
{
    return static_cast<int>(floorQuotient(y + kHalf - 1, kSubpixels));
}

/// Where an edge crosses the centres of rows: the first pixel whose centre is not to the left of it. Exact,
/// and the same from either end.
class EdgeWalk
{
public:
    EdgeWalk(SnappedVertex a, SnappedVertex b)
    {
        if (a.y > b.y) std::swap(a, b);
        low_ = a;
        rise_ = std::int64_t{b.y} - a.y;
        run_ = std::int64_t{b.x} - a.x;
        firstRow = rowFrom(a.y);
        endRow = rowFrom(b.y);
    }

    /// Only when there are rows.
    void start(int row)
    {
        divisor_ = kSubpixels * rise_;
        const std::int64_t place =
            (low_.x - kHalf) * rise_ + run_ * (std::int64_t{kSubpixels} * row + kHalf - low_.y);
        pixel_ = floorQuotient(place + divisor_ - 1, divisor_);
        rest_ = place + divisor_ - 1 - pixel_ * divisor_;
        pixelStep_ = floorQuotient(run_, rise_);
        restStep_ = kSubpixels * (run_ - pixelStep_ * rise_);
    }
    int pixel() const { return static_cast<int>(pixel_); }
    void next()
    {
        pixel_ += pixelStep_;
        rest_ += restStep_;
        if (rest_ < divisor_) return;
        rest_ -= divisor_;
        ++pixel_;
    }

    int firstRow = 0;
    int endRow = 0;

private:
    SnappedVertex low_{};
    std::int64_t rise_ = 0, run_ = 0, divisor_ = 1;
    std::int64_t pixel_ = 0, rest_ = 0, pixelStep_ = 0, restStep_ = 0;
};

constexpr std::int16_t kNone = INT16_MIN;

PixelBox rowsOf(std::span<const SnappedVertex> polygon, int height)
{
    PixelBox box;
    const auto [low, high] = std::ranges::minmax(polygon, {}, &SnappedVertex::y);
    box.y0 = std::max(rowFrom(low.y), 0);
    box.y1 = std::min(rowFrom(high.y), height);
    return box;
}

/// Two crossings a row, in any order; false when there are more.
bool convexSpans(std::span<const SnappedVertex> polygon, const PixelBox& box, int width,
                 std::span<RowSpan> rows)
{
    std::ranges::fill(rows, RowSpan{kNone, kNone});
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        EdgeWalk edge(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]);
        const int first = std::max(edge.firstRow, box.y0), end = std::min(edge.endRow, box.y1);
        if (first >= end) continue;
        edge.start(first);
        for (int row = first; row < end; ++row, edge.next()) {
            RowSpan& span = rows[static_cast<std::size_t>(row - box.y0)];
            const auto x = static_cast<std::int16_t>(std::clamp(edge.pixel(), 0, width));
            if (span.left == kNone)
                span.left = x;
            else if (span.right == kNone)
                span.right = x;
            else
                return false;
        }
    }
    for (RowSpan& span : rows)
        if (span.left > span.right) std::swap(span.left, span.right);
    return true;
}

/// Any number of crossings: every second part of a row is inside.
int layeredSpans(std::span<const SnappedVertex> polygon, const PixelBox& box, int width,
                 std::vector<RowSpan>& rows, std::size_t first)
{
    const auto height = static_cast<std::size_t>(box.y1 - box.y0);
    std::vector<std::vector<std::int16_t>> crossings(height);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        EdgeWalk edge(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]);
        const int from = std::max(edge.firstRow, box.y0), end = std::min(edge.endRow, box.y1);
        if (from >= end) continue;
        edge.start(from);
        for (int row = from; row < end; ++row, edge.next())
            crossings[static_cast<std::size_t>(row - box.y0)].push_back(
                static_cast<std::int16_t>(std::clamp(edge.pixel(), 0, width)));
    }
    std::size_t layers = 1;
    for (std::vector<std::int16_t>& row : crossings) {
        std::ranges::sort(row);
        layers = std::max(layers, row.size() / 2);
    }
    rows.resize(first + layers * height, RowSpan{0, 0});
    std::fill(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end(), RowSpan{0, 0});
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t i = 0; i + 1 < crossings[row].size(); i += 2)
            rows[first + i / 2 * height + row] = {crossings[row][i], crossings[row][i + 1]};
    return static_cast<int>(layers);
}

} // namespace

PixelBox appendRowSpans(std::span<const SnappedVertex> polygon, int width, int height,
                        std::vector<RowSpan>& rows, int& layers)
{
    assert(width <= INT16_MAX && height <= INT16_MAX);
    layers = 0;
    PixelBox box = rowsOf(polygon, height);
    if (polygon.size() < 3 || box.y0 >= box.y1) return {};
    const std::size_t first = rows.size();
    rows.resize(first + static_cast<std::size_t>(box.y1 - box.y0));
    layers = 1;
    if (!convexSpans(polygon, box, width, std::span(rows).subspan(first)))
        layers = layeredSpans(polygon, box, width, rows, first);
    box.x0 = width;
    box.x1 = 0;
    for (const RowSpan& span : std::span(rows).subspan(first)) {
        if (span.left >= span.right) continue;
        box.x0 = std::min<int>(box.x0, span.left);
        box.x1 = std::max<int>(box.x1, span.right);
    }
    if (!box.empty()) return box;
    rows.resize(first);
    layers = 0;
    return {};
}

} // namespace vo
