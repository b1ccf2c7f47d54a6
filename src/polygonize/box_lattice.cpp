#include "polygonize/box_lattice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>

namespace vo {

namespace {

constexpr std::uint64_t kMostStarts = std::uint64_t{1} << 20;

bool before(const BoxLattice::Interval& a, const BoxLattice::Interval& b)
{
    return std::tie(a.lower, a.upper) < std::tie(b.lower, b.upper);
}

double nearestFace(double value, const std::vector<double>& faces)
{
    const auto above = std::lower_bound(faces.begin(), faces.end(), value);
    double nearest = value;
    double distance = BoxLattice::kSnapDistance;
    for (auto face = above == faces.begin() ? above : above - 1; face != faces.end() && face <= above;
         ++face) {
        if (std::abs(*face - value) > distance) continue;
        distance = std::abs(*face - value);
        nearest = *face;
    }
    return nearest;
}

} // namespace

void BoxLattice::assign(std::span<const Box> boxes)
{
    const auto same = [](const Box& a, const Box& b) { return a.lower == b.lower && a.upper == b.upper; };
    if (std::equal(boxes.begin(), boxes.end(), boxes_.begin(), boxes_.end(), same)) return;
    boxes_.assign(boxes.begin(), boxes.end());
    for (int axis = 0; axis < 3; ++axis)
        findIntervals(axis);

    entries_.clear();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Cell cell{intervalOf(0, boxes_[i]), intervalOf(1, boxes_[i]), intervalOf(2, boxes_[i])};
        entries_.push_back({number(cell), static_cast<int>(i)});
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.cell, a.box) < std::tie(b.cell, b.box);
    });
    findStarts();
}

void BoxLattice::findStarts()
{
    starts_.clear();
    double cells = 1;
    for (const auto& intervals : intervals_)
        cells *= static_cast<double>(intervals.size());
    if (cells > static_cast<double>(kMostStarts)) return;
    starts_.assign(static_cast<std::size_t>(cells) + 1, 0);
    for (const Entry& entry : entries_)
        ++starts_[static_cast<std::size_t>(entry.cell) + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
}

void BoxLattice::findIntervals(int axis)
{
    auto& intervals = intervals_[static_cast<std::size_t>(axis)];
    auto& faces = faces_[static_cast<std::size_t>(axis)];
    intervals.clear();
    faces.clear();
    for (const Box& box : boxes_) {
        intervals.push_back({box.lower[axis], box.upper[axis], -1});
        faces.push_back(box.lower[axis]);
        faces.push_back(box.upper[axis]);
    }
    std::sort(intervals.begin(), intervals.end(), before);
    const auto equal = [](const Interval& a, const Interval& b) {
        return a.lower == b.lower && a.upper == b.upper;
    };
    intervals.erase(std::unique(intervals.begin(), intervals.end(), equal), intervals.end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    auto& overlapping = overlapping_[static_cast<std::size_t>(axis)];
    overlapping = false;
    for (std::size_t i = 0; i + 1 < intervals.size(); ++i)
        overlapping = overlapping || intervals[i + 1].lower < intervals[i].upper;

    for (std::size_t i = 0; i < intervals.size(); ++i)
        for (std::size_t j = i + 1; j < intervals.size() && intervals[i].next < 0; ++j)
            if (intervals[j].lower == intervals[i].upper) intervals[i].next = static_cast<int>(j);
}

int BoxLattice::intervalOf(int axis, const Box& box) const
{
    const auto& intervals = intervals_[static_cast<std::size_t>(axis)];
    const Interval wanted{box.lower[axis], box.upper[axis], -1};
    return static_cast<int>(std::lower_bound(intervals.begin(), intervals.end(), wanted, before) -
                            intervals.begin());
}

std::uint64_t BoxLattice::number(const Cell& cell) const
{
    return (static_cast<std::uint64_t>(cell[0]) * intervals_[1].size() +
            static_cast<std::uint64_t>(cell[1])) *
               intervals_[2].size() +
           static_cast<std::uint64_t>(cell[2]);
}

std::span<const BoxLattice::Entry> BoxLattice::boxes(const Cell& cell) const
{
    if (!starts_.empty()) {
        const auto cellNumber = static_cast<std::size_t>(number(cell));
        return std::span(entries_).subspan(starts_[cellNumber],
                                           starts_[cellNumber + 1] - starts_[cellNumber]);
    }
    const auto byCell = [](const Entry& a, const Entry& b) { return a.cell < b.cell; };
    const auto [first, last] =
        std::equal_range(entries_.begin(), entries_.end(), Entry{number(cell), 0}, byCell);
    return {first, last};
}

bool BoxLattice::belongsToNext(const Cell& cell, const std::array<bool, 3>& inUpperFace) const
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        if (!inUpperFace[a]) continue;
        Cell neighbour = cell;
        neighbour[a] = intervals(axis)[static_cast<std::size_t>(cell[a])].next;
        if (!boxes(neighbour).empty()) return true;
    }
    return false;
}

void BoxLattice::snap(CutPolygon& polygon) const
{
    for (int i = 0; i < polygon.count; ++i) {
        double* voxel = polygon.record(i) + polygon.voxelColumn;
        for (std::size_t axis = 0; axis < 3; ++axis)
            voxel[axis] = nearestFace(voxel[axis], faces_[axis]);
    }
}

bool BoxLattice::standApart() const
{
    return std::ranges::none_of(overlapping_, std::identity{});
}

double BoxLattice::snapped(int axis, double coordinate) const
{
    return nearestFace(coordinate, faces_[static_cast<std::size_t>(axis)]);
}

int BoxLattice::intervalAt(int axis, double coordinate) const
{
    const auto& faces = faces_[static_cast<std::size_t>(axis)];
    const auto& intervals = intervals_[static_cast<std::size_t>(axis)];
    if (faces.empty() || coordinate < faces.front() - kSnapDistance) return kBelow;
    if (coordinate > faces.back() + kSnapDistance) return kAbove;
    if (overlapping_[static_cast<std::size_t>(axis)]) return kNearFace;
    for (std::size_t i = 0; i < intervals.size() && intervals[i].lower < coordinate; ++i)
        if (intervals[i].lower < coordinate - kSnapDistance &&
            intervals[i].upper > coordinate + kSnapDistance)
            return static_cast<int>(i);
    return kNearFace;
}

} // namespace vo
