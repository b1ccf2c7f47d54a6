#include "polygonize/slice_cutter.h"

#include "polygonize/tetra_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {

namespace {

constexpr double kMargin = BoxLattice::kMargin;
constexpr std::size_t kFewFaces = 8;

template <std::size_t kValues>
bool samePosition(const std::array<double, kValues>& a, const std::array<double, kValues>& b)
{
    return a[kValues - 3] == b[kValues - 3] && a[kValues - 2] == b[kValues - 2] &&
           a[kValues - 1] == b[kValues - 1];
}

/// By position, then by the rest.
template <std::size_t kValues>
bool comesBefore(const std::array<double, kValues>& a, const std::array<double, kValues>& b)
{
    for (std::size_t i = kValues - 3; i < kValues; ++i)
        if (a[i] != b[i]) return a[i] < b[i];
    return std::lexicographical_compare(a.begin(), a.end() - 3, b.begin(), b.end() - 3);
}

/// cutEdge for ends in order.
template <std::size_t kValues>
std::array<double, kValues> pointBetween(const std::array<double, kValues>& from,
                                         const std::array<double, kValues>& to, double fromDistance,
                                         double toDistance)
{
    const double s = fromDistance / (fromDistance - toDistance);
    if (s == 0.0) return from;
    if (s == 1.0) return to;
    std::array<double, kValues> point;
    for (std::size_t i = 0; i < kValues; ++i)
        point[i] = from[i] + s * (to[i] - from[i]);
    return point;
}

} // namespace

/// Bare positions may repeat until they are rounded: nothing else tells vertices apart.
template <int kValues>
void SliceCutter<kValues>::Polygon::push(const Record& record)
{
    if (kValues > 3 && count > 0 && samePosition(record, at[count - 1])) return;
    at[count++] = record;
}

template <int kValues>
void SliceCutter<kValues>::Polygon::close()
{
    if (kValues == 3) return;
    while (count > 1 && samePosition(at[count - 1], at[0]))
        --count;
}

/// Where an edge meets a plane across an axis, if it does.
template <int kValues>
void SliceCutter<kValues>::meet(const Record& from, const Record& to, std::size_t column, double plane,
                                Polygon& out) const
{
    const double a = from[column] - plane, b = to[column] - plane;
    if (!((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))) return;
    Record point = comesBefore(to, from) ? pointBetween(to, from, b, a) : pointBetween(from, to, a, b);
    point[column] = plane;
    out.push(point);
}

/// clipToSlab.
template <int kValues>
void SliceCutter<kValues>::clip(const Polygon& polygon, std::size_t axis, double lower, double upper,
                                Polygon& out) const
{
    const std::size_t column = voxelColumn_ + axis;
    out.count = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Record &from = polygon.at[i], &to = polygon.at[i + 1 < polygon.count ? i + 1 : 0];
        const double a = from[column], b = to[column];
        if (a >= lower && a <= upper) out.push(from);
        if (a < b) {
            meet(from, to, column, lower, out);
            meet(from, to, column, upper, out);
        } else if (b < a) {
            meet(from, to, column, upper, out);
            meet(from, to, column, lower, out);
        }
    }
    out.close();
}

template <int kValues>
void SliceCutter<kValues>::cut(const TetraInBoxes<kValues>& tetra, const PlaneFamily& planes, int begin,
                               CutSections& sections)
{
    sections_ = &sections;
    voxelColumn_ = kValues == 3 ? 0 : tetra.voxelColumn;
    for (int axis = 0; axis < 3; ++axis)
        findNear(tetra, axis);
    BoxesNearby boxes;
    const bool few = kValues == 3 && describeNear(boxes) && describeBoxes(boxes);
    const TetraSections of{tetra.corners[0].data(), tetra.offsets.data(), tetra.firstInFront.data(),
                           tetra.mirrored};
    const int end = std::ranges::max(tetra.firstInFront);
    for (sample_ = begin; sample_ < end; ++sample_) {
        if (few) sample_ = cutSections(of, boxes, planes, sample_, end, sections);
        if (sample_ == end) break;
        unsigned mask = 0;
        for (unsigned corner = 0; corner < 4; ++corner)
            mask |= (tetra.firstInFront[corner] <= sample_ ? 1u : 0u) << corner;
        slice(tetra, planes.offset(sample_), mask);
        if (polygons_[3].count > 2) cutAlong(0, polygons_[3]);
    }
}

/// False: there are too many faces, or some too close together.
template <int kValues>
bool SliceCutter<kValues>::describeNear(BoxesNearby& boxes) const
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Near& near = near_[axis];
        BoxesNearby::Axis& found = boxes.axes[axis];
        found = {near.cuts, 0, 1, {}, {}};
        if (!near.cuts) continue;
        const auto intervals = lattice_.intervals(static_cast<int>(axis));
        found.faceCount = near.faces.size();
        found.intervalCount = static_cast<std::size_t>(near.endInterval - near.firstInterval);
        if (found.faceCount > BoxesNearby::kMostFaces || found.intervalCount > BoxesNearby::kMostIntervals)
            return false;
        std::ranges::copy(near.faces, found.faces.begin());
        if (found.faceCount == 2 && !(found.faces[1] - found.faces[0] > kMargin)) return false;
        const auto faceAt = [&](double coordinate) {
            const auto face = std::ranges::find(near.faces, coordinate);
            return face == near.faces.end() ? -1 : static_cast<int>(face - near.faces.begin());
        };
        for (std::size_t i = 0; i < found.intervalCount; ++i) {
            const auto [lower, upper, next] = intervals[static_cast<std::size_t>(near.firstInterval) + i];
            if (!(lower < upper) || upper < near.low - kMargin || lower > near.high + kMargin) return false;
            found.intervals[i] = {faceAt(lower), faceAt(upper)};
        }
    }
    return true;
}

/// False: several boxes are equal.
template <int kValues>
bool SliceCutter<kValues>::describeBoxes(BoxesNearby& boxes) const
{
    std::array<std::size_t, 3> at;
    const auto count = [&](std::size_t axis) { return boxes.axes[axis].intervalCount; };
    for (at[0] = 0; at[0] < count(0); ++at[0])
        for (at[1] = 0; at[1] < count(1); ++at[1])
            for (at[2] = 0; at[2] < count(2); ++at[2]) {
                BoxLattice::Cell cell = cell_;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (near_[axis].cuts) cell[axis] = near_[axis].firstInterval + static_cast<int>(at[axis]);
                const auto found = lattice_.boxes(cell);
                if (found.size() > 1) return false;
                boxes.boxAt(at[0], at[1], at[2]) = found.empty() ? -1 : found.front().box;
            }
    return true;
}

template <int kValues>
void SliceCutter<kValues>::findNear(const TetraInBoxes<kValues>& tetra, int axis)
{
    const auto a = static_cast<std::size_t>(axis);
    Near& near = near_[a];
    near.cuts = tetra.interval[a] < 0;
    if (!near.cuts) {
        cell_[a] = tetra.interval[a];
        inUpperFace_[a] = false;
        return;
    }
    const auto at = [&](std::size_t corner) { return tetra.corners[corner][voxelColumn_ + a]; };
    const auto [low, high] = std::minmax({at(0), at(1), at(2), at(3)});
    const auto faces = lattice_.faces(axis);
    const auto first = std::ranges::lower_bound(faces, low - kMargin);
    near.faces = {first, std::upper_bound(first, faces.end(), high + kMargin)};
    const auto intervals = lattice_.intervals(axis);
    const auto count = static_cast<int>(intervals.size());
    const auto interval = [&](int i) { return intervals[static_cast<std::size_t>(i)]; };
    near.firstInterval = 0;
    while (near.firstInterval < count && interval(near.firstInterval).upper < low - kMargin)
        ++near.firstInterval;
    near.low = low;
    near.high = high;
    near.endInterval = near.firstInterval;
    while (near.endInterval < count && interval(near.endInterval).lower <= high + kMargin)
        ++near.endInterval;
}

template <int kValues>
double SliceCutter<kValues>::snapped(const Near& near, double coordinate) const
{
    double nearest = coordinate, distance = BoxLattice::kSnapDistance;
    for (const double face : near.faces) {
        if (std::abs(face - coordinate) > distance) continue;
        distance = std::abs(face - coordinate);
        nearest = face;
    }
    return nearest;
}

template <int kValues>
void SliceCutter<kValues>::slice(const TetraInBoxes<kValues>& tetra, double offset, unsigned mask)
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
    polygon.close();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Near& near = near_[axis];
        if (!near.cuts) continue;
        for (std::size_t i = 0; i < polygon.count; ++i) {
            double& coordinate = polygon.at[i][voxelColumn_ + axis];
            coordinate = near.faces.size() <= kFewFaces
                             ? snapped(near, coordinate)
                             : lattice_.snapped(static_cast<int>(axis), coordinate);
        }
    }
}

/// Cuts the polygon to each interval of an axis that it meets, and what is left along the next axis.
template <int kValues>
void SliceCutter<kValues>::cutAlong(std::size_t axis, const Polygon& polygon)
{
    if (axis == 3) {
        emitTo(polygon);
        return;
    }
    const Near& near = near_[axis];
    if (!near.cuts) {
        cutAlong(axis + 1, polygon);
        return;
    }
    const std::size_t column = voxelColumn_ + axis;
    double low = polygon.at[0][column], high = low;
    for (std::size_t i = 1; i < polygon.count; ++i) {
        low = std::min(low, polygon.at[i][column]);
        high = std::max(high, polygon.at[i][column]);
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
        if (inside || cut.count > 2) cutAlong(axis + 1, inside ? polygon : cut);
    }
}

/// In single precision, without the vertices that fall on the one before.
template <int kValues>
void SliceCutter<kValues>::emitTo(const Polygon& polygon)
{
    const auto boxes = lattice_.boxes(cell_);
    if (boxes.empty() || lattice_.belongsToNext(cell_, inUpperFace_)) return;
    float* const first = face_.data();
    float* end = first;
    const auto same = [](const float* a, const float* b) {
        return (a[kValues - 3] == b[kValues - 3]) & (a[kValues - 2] == b[kValues - 2]) &
               (a[kValues - 1] == b[kValues - 1]);
    };
    for (std::size_t i = 0; i < polygon.count; ++i) {
        for (std::size_t value = 0; value < kValues; ++value)
            end[value] = static_cast<float>(polygon.at[i][value]);
        if (end == first || !same(end, end - kValues)) end += kValues;
    }
    while (end - first > kValues && same(end - kValues, first))
        end -= kValues;
    if (end - first < 3 * kValues) return;
    for (const auto& [cell, box] : boxes)
        sections_->append(box, sample_, {first, end});
}

template class SliceCutter<3>;
template class SliceCutter<6>;
template class SliceCutter<7>;
template class SliceCutter<9>;
template class SliceCutter<10>;

} // namespace vo
