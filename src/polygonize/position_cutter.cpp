#include "polygonize/position_cutter.h"

#include "polygonize/tetra_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {

namespace {

using Position = std::array<double, 3>;

/// Rounding leads a slice's vertices out of its tetrahedron by less than this and the distance at which faces
/// draw them.
constexpr double kMargin = 2 * BoxLattice::kSnapDistance;
constexpr std::size_t kFewFaces = 8;

/// cutEdge for ends in order.
Position pointBetween(const Position& from, const Position& to, double fromDistance, double toDistance)
{
    const double s = fromDistance / (fromDistance - toDistance);
    if (s == 1.0) return to;
    return {from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]),
            from[2] + s * (to[2] - from[2])};
}

/// Where an edge meets a plane across an axis, if it does.
template <class Polygon>
void meet(const Position& from, const Position& to, std::size_t axis, double plane, Polygon& out)
{
    const double a = from[axis] - plane, b = to[axis] - plane;
    if (!((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))) return;
    Position point = to < from ? pointBetween(to, from, b, a) : pointBetween(from, to, a, b);
    point[axis] = plane;
    out.push(point);
}

/// clipToSlab, but for vertices that repeat.
template <class Polygon>
void clip(const Polygon& polygon, std::size_t axis, double lower, double upper, Polygon& out)
{
    out.count = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Position &from = polygon.at[i], &to = polygon.at[i + 1 < polygon.count ? i + 1 : 0];
        const double a = from[axis], b = to[axis];
        if (a >= lower && a <= upper) out.push(from);
        if (a < b) {
            meet(from, to, axis, lower, out);
            meet(from, to, axis, upper, out);
        } else if (b < a) {
            meet(from, to, axis, upper, out);
            meet(from, to, axis, lower, out);
        }
    }
}

} // namespace

bool PositionCutter::cut(const TetraInBoxes& tetra, const PlaneFamily& planes, FaceSink& sink)
{
    sink_ = &sink;
    for (int axis = 0; axis < 3; ++axis)
        findNear(tetra, axis);
    const auto [begin, end] = std::ranges::minmax(tetra.firstInFront);
    for (sample_ = begin; sample_ < end; ++sample_) {
        unsigned mask = 0;
        for (unsigned corner = 0; corner < 4; ++corner)
            mask |= (tetra.firstInFront[corner] <= sample_ ? 1u : 0u) << corner;
        slice(tetra, planes.offset(sample_), mask);
        if (!cutAlong(0, polygons_[3])) return false;
    }
    return true;
}

void PositionCutter::findNear(const TetraInBoxes& tetra, int axis)
{
    const auto a = static_cast<std::size_t>(axis);
    Near& near = near_[a];
    near.cuts = tetra.interval[a] < 0;
    if (!near.cuts) {
        cell_[a] = tetra.interval[a];
        inUpperFace_[a] = false;
        return;
    }
    const auto [low, high] =
        std::minmax({tetra.corners[0][a], tetra.corners[1][a], tetra.corners[2][a], tetra.corners[3][a]});
    const auto faces = lattice_.faces(axis);
    const auto first = std::ranges::lower_bound(faces, low - kMargin);
    near.faces = {first, std::upper_bound(first, faces.end(), high + kMargin)};
    const auto intervals = lattice_.intervals(axis);
    const auto count = static_cast<int>(intervals.size());
    const auto interval = [&](int i) { return intervals[static_cast<std::size_t>(i)]; };
    near.firstInterval = 0;
    while (near.firstInterval < count && interval(near.firstInterval).upper < low - kMargin)
        ++near.firstInterval;
    near.endInterval = near.firstInterval;
    while (near.endInterval < count && interval(near.endInterval).lower <= high + kMargin)
        ++near.endInterval;
}

double PositionCutter::snapped(const Near& near, double coordinate) const
{
    double nearest = coordinate, distance = BoxLattice::kSnapDistance;
    for (const double face : near.faces) {
        if (std::abs(face - coordinate) > distance) continue;
        distance = std::abs(face - coordinate);
        nearest = face;
    }
    return nearest;
}

void PositionCutter::slice(const TetraInBoxes& tetra, double offset, unsigned mask)
{
    Polygon& polygon = polygons_[3];
    polygon.count = 0;
    const EdgeEnds& edges = kEdgeEnds[tetra.mirrored][mask];
    const auto count = static_cast<std::size_t>(kTetraSections[mask].count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto from = static_cast<std::size_t>(edges.from[i]), to = static_cast<std::size_t>(edges.to[i]);
        polygon.push(pointBetween(tetra.corners[from], tetra.corners[to], tetra.offsets[from] - offset,
                                  tetra.offsets[to] - offset));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Near& near = near_[axis];
        if (!near.cuts) continue;
        for (std::size_t i = 0; i < polygon.count; ++i) {
            double& coordinate = polygon.at[i][axis];
            coordinate = near.faces.size() <= kFewFaces
                             ? snapped(near, coordinate)
                             : lattice_.snapped(static_cast<int>(axis), coordinate);
        }
    }
}

/// Cuts the polygon to each interval of an axis that it meets, and what is left along the next axis.
bool PositionCutter::cutAlong(std::size_t axis, const Polygon& polygon)
{
    if (axis == 3) return emitTo(polygon);
    const Near& near = near_[axis];
    if (!near.cuts) return cutAlong(axis + 1, polygon);
    double low = polygon.at[0][axis], high = low;
    for (std::size_t i = 1; i < polygon.count; ++i) {
        low = std::min(low, polygon.at[i][axis]);
        high = std::max(high, polygon.at[i][axis]);
    }
    const auto intervals = lattice_.intervals(static_cast<int>(axis));
    Polygon& cut = polygons_[axis];
    for (int i = near.firstInterval; i < near.endInterval; ++i) {
        const auto [lower, upper, next] = intervals[static_cast<std::size_t>(i)];
        if (low < high ? (high <= lower || low >= upper) : (low < lower || low > upper)) continue;
        cell_[axis] = i;
        inUpperFace_[axis] = low == upper && lower < upper && next >= 0;
        const bool inside = low >= lower && high <= upper;
        if (!inside) clip(polygon, axis, lower, upper, cut);
        if ((inside || cut.count > 2) && !cutAlong(axis + 1, inside ? polygon : cut)) return false;
    }
    return true;
}

/// In single precision, without the vertices that fall on the one before.
bool PositionCutter::emitTo(const Polygon& polygon)
{
    const auto boxes = lattice_.boxes(cell_);
    if (boxes.empty() || lattice_.belongsToNext(cell_, inUpperFace_)) return true;
    float* const first = face_.data();
    float* end = first;
    const auto same = [](const float* a, const float* b) {
        return (a[0] == b[0]) & (a[1] == b[1]) & (a[2] == b[2]);
    };
    for (std::size_t i = 0; i < polygon.count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            end[axis] = static_cast<float>(polygon.at[i][axis]);
        if (end == first || !same(end, end - 3)) end += 3;
    }
    while (end - first > 3 && same(end - 3, first))
        end -= 3;
    if (end - first < 9) return true;
    for (const auto& [cell, box] : boxes)
        if (!sink_->append(box, sample_, {first, end})) return false;
    return true;
}

} // namespace vo
