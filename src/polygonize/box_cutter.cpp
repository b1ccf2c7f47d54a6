#include "polygonize/box_cutter.h"

#include "polygonize/clip_polygon.h"

#include <algorithm>

namespace vo {

namespace {

std::pair<double, double> extent(const CutPolygon& polygon, int axis)
{
    double low = polygon.voxel(0)[axis];
    double high = low;
    for (int i = 1; i < polygon.count; ++i) {
        const double c = polygon.voxel(i)[axis];
        low = std::min(low, c);
        high = std::max(high, c);
    }
    return {low, high};
}

} // namespace

bool BoxCutter::cut(CutPolygon& polygon, int sample, FaceSink& sink)
{
    if (polygon.count < 3) return true;
    lattice_.snap(polygon);
    sample_ = sample;
    sink_ = &sink;
    return cutAlong(0, polygon);
}

/// Cuts the polygon to each interval of an axis that it meets, and what is left along the next axis.
bool BoxCutter::cutAlong(int axis, const CutPolygon& polygon)
{
    if (axis == 3) return emitTo(polygon);
    const auto [low, high] = extent(polygon, axis);
    const auto intervals = lattice_.intervals(axis);
    CutPolygon& cut = cuts_[static_cast<std::size_t>(axis)];
    for (std::size_t i = 0; i < intervals.size() && intervals[i].lower <= high; ++i) {
        const auto [lower, upper, next] = intervals[i];
        if (low < high ? (high <= lower || low >= upper) : (low < lower || low > upper)) continue;
        cell_[static_cast<std::size_t>(axis)] = static_cast<int>(i);
        inUpperFace_[static_cast<std::size_t>(axis)] = low == upper && lower < upper && next >= 0;
        const bool inside = low >= lower && high <= upper;
        if (!inside) clipToSlab(polygon, axis, lower, upper, cut);
        if ((inside || cut.count > 0) && !cutAlong(axis + 1, inside ? polygon : cut)) return false;
    }
    return true;
}

bool BoxCutter::emitTo(const CutPolygon& polygon)
{
    const auto boxes = lattice_.boxes(cell_);
    if (boxes.empty() || lattice_.belongsToNext(cell_, inUpperFace_)) return true;
    const std::span<const float> face = rounded(polygon);
    for (const auto& [cell, box] : boxes)
        if (!face.empty() && !sink_->append(box, sample_, face)) return false;
    return true;
}

/// The polygon in single precision, without the vertices that fall on the one before.
std::span<const float> BoxCutter::rounded(const CutPolygon& polygon)
{
    const auto size = static_cast<std::size_t>(polygon.values);
    const std::size_t needed = static_cast<std::size_t>(polygon.count) * size;
    if (face_.size() < needed) face_.resize(std::max(needed, 16 * size));
    float* const first = face_.data();
    float* end = first;
    const auto same = [size](const float* a, const float* b) {
        return std::equal(a + size - 3, a + size, b + size - 3);
    };
    for (int i = 0; i < polygon.count; ++i) {
        std::transform(polygon.record(i), polygon.record(i) + size, end,
                       [](double value) { return static_cast<float>(value); });
        if (end == first || !same(end, end - size)) end += size;
    }
    while (end - first > static_cast<std::ptrdiff_t>(size) && same(end - size, first))
        end -= size;
    if (end - first < static_cast<std::ptrdiff_t>(3 * size)) return {};
    return {first, end};
}

} // namespace vo
