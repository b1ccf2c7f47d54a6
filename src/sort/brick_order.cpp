#include "sort/brick_order.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace vo {

namespace {

using Interval = std::pair<double, double>;

std::vector<Interval> intervalsAlong(int axis, std::span<const Box> boxes)
{
    std::vector<Interval> intervals;
    intervals.reserve(boxes.size());
    for (const Box& box : boxes)
        intervals.emplace_back(box.lower[axis], box.upper[axis]);
    std::sort(intervals.begin(), intervals.end());
    intervals.erase(std::unique(intervals.begin(), intervals.end()), intervals.end());
    return intervals;
}

/// How many intervals a line of sight has passed, at least, when it enters the given one. It moves one way
/// along the axis, so this never falls along it.
int rankAlong(int axis, const std::vector<Interval>& intervals, std::ptrdiff_t index, const Camera& camera)
{
    const int number = static_cast<int>(index);
    if (!camera.perspective) {
        const double way = camera.direction[axis];
        return way > 0.0 ? number : way < 0.0 ? -number : 0;
    }
    const auto below = [&](const Interval& interval) { return interval.second <= camera.eye[axis]; };
    const auto own = std::partition_point(intervals.begin(), intervals.end(), below) - intervals.begin();
    return std::abs(number - static_cast<int>(own));
}

} // namespace

std::vector<int> backToFront(std::span<const Box> boxes, const Camera& camera)
{
    std::vector<std::array<int, 3>> ranks(boxes.size());
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<Interval> intervals = intervalsAlong(axis, boxes);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Interval own{boxes[i].lower[axis], boxes[i].upper[axis]};
            const auto index = std::lower_bound(intervals.begin(), intervals.end(), own) - intervals.begin();
            ranks[i][static_cast<std::size_t>(axis)] = rankAlong(axis, intervals, index, camera);
        }
    }
    // No rank falls along a line of sight, so a box that it enters later comes first here, whatever the axis
    // order.
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return ranks[static_cast<std::size_t>(a)] > ranks[static_cast<std::size_t>(b)];
    });
    return order;
}

} // namespace vo
