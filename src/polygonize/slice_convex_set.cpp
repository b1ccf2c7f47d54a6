#include "polygonize/slice_convex_set.h"

#include "polygonize/slice_tetra.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {

namespace {

/// Planes that leave the plane across an axis by no more than this within the set lie in it: the distance at
/// which boxes draw coordinates to their faces.
constexpr double kHeadOn = 1e-5;

int axisOf(const glm::dvec4& plane)
{
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(plane[axis]) == 1.0) return axis;
    return -1;
}

bool comesBefore(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::lexicographical_compare(&a.x, &a.x + 3, &b.x, &b.x + 3);
}

} // namespace

void ConvexSlicer::slice(const ConvexSet& set, const Box& bounds, const PlaneFamily& planes, double nearest,
                         const BoxLattice& boxes, PolygonStack& stack)
{
    stack.clear();
    stack_ = &stack;
    boxes_ = &boxes;
    planes_ = planes;
    nearest_ = nearest;
    beginPlane_ = 0;
    endPlane_ = planes.count;
    if (planes.count == 0) return;
    makeBody(set, bounds);
    if (body_.empty()) return;
    findHeadOn(bounds);
    cutAlong(0, body_);
    std::ranges::sort(stack.runs, {}, &PolygonStack::Run::brick);
}

void ConvexSlicer::makeBody(const ConvexSet& set, const Box& bounds)
{
    const glm::dvec3 margin = 0.01 * (bounds.upper - bounds.lower);
    cutter_.makeBox({bounds.lower - margin, bounds.upper + margin}, body_);
    for (const glm::dvec4& plane : set.planes) {
        distances_.clear();
        for (const glm::dvec3& p : body_.corners)
            distances_.push_back(-(glm::dot(glm::dvec3(plane), p) + plane.w));
        const int axis = axisOf(plane);
        cutter_.split(body_, distances_, axis, axis < 0 ? 0.0 : -plane.w * plane[axis], unused_, spare_);
        std::swap(body_, spare_);
    }
}

void ConvexSlicer::findHeadOn(const Box& bounds)
{
    headOn_ = -1;
    const glm::dvec3 middle = 0.5 * (bounds.lower + bounds.upper);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 aside = planes_.normal / planes_.normal[axis];
        aside[axis] = 0.0;
        if (!(glm::dot(glm::abs(aside), bounds.upper - bounds.lower) <= kHeadOn)) continue;
        headOn_ = axis;
        planeLevels_.clear();
        onFace_.clear();
        for (int k = 0; k < planes_.count; ++k) {
            const double level = planes_.offset(k) / planes_.normal[axis] - glm::dot(aside, middle);
            planeLevels_.push_back(boxes_->snapped(axis, level));
            onFace_.push_back(planeLevels_.back() != level);
        }
        return;
    }
}

void ConvexSlicer::cutAlong(int axis, const ConvexBody& body)
{
    if (axis == 3) {
        for (const auto& [cell, box] : boxes_->boxes(cell_))
            sliceInto(box, body);
        return;
    }
    if (axis == headOn_) {
        cutAcross(axis, body);
        return;
    }
    Level& level = levels_[static_cast<std::size_t>(axis)];
    const Box bounds = body.bounds();
    const ConvexBody* rest = &body;
    const auto intervals = boxes_->intervals(axis);
    for (std::size_t i = 0; i < intervals.size() && !rest->empty(); ++i) {
        const auto [lower, upper, next] = intervals[i];
        if (lower >= upper || upper <= bounds.lower[axis] || lower >= bounds.upper[axis]) continue;
        cell_[static_cast<std::size_t>(axis)] = static_cast<int>(i);
        measure(*rest, axis, lower);
        cutter_.split(*rest, distances_, axis, lower, level.unused, level.spare);
        measure(level.spare, axis, upper);
        cutter_.split(level.spare, distances_, axis, upper, level.part, level.rest);
        rest = &level.rest;
        if (!level.part.empty()) cutAlong(axis + 1, level.part);
    }
}

void ConvexSlicer::measure(const ConvexBody& body, int axis, double coordinate)
{
    distances_.clear();
    for (const glm::dvec3& p : body.corners)
        distances_.push_back(p[axis] - coordinate);
}

/// Along the axis that all planes are across they are dealt out whole.
void ConvexSlicer::cutAcross(int axis, const ConvexBody& body)
{
    const auto intervals = boxes_->intervals(axis);
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const auto inside = [&](double level) {
            return level >= intervals[i].lower && level <= intervals[i].upper;
        };
        const auto first = std::ranges::find_if(planeLevels_, inside);
        const auto last = std::find_if_not(first, planeLevels_.end(), inside);
        beginPlane_ = static_cast<int>(first - planeLevels_.begin());
        endPlane_ = static_cast<int>(last - planeLevels_.begin());
        cell_[static_cast<std::size_t>(axis)] = static_cast<int>(i);
        if (beginPlane_ < endPlane_) cutAlong(axis + 1, body);
    }
    beginPlane_ = 0;
    endPlane_ = planes_.count;
}

/// Upper faces of boxes where another one begins are the other one's.
bool ConvexSlicer::belongsToNext(int plane) const
{
    if (headOn_ < 0) return false;
    const auto axis = static_cast<std::size_t>(headOn_);
    const auto [lower, upper, next] = boxes_->intervals(headOn_)[static_cast<std::size_t>(cell_[axis])];
    if (next < 0 || lower == upper || planeLevels_[static_cast<std::size_t>(plane)] != upper) return false;
    BoxLattice::Cell neighbour = cell_;
    neighbour[axis] = next;
    return !boxes_->boxes(neighbour).empty();
}

void ConvexSlicer::sliceInto(int box, const ConvexBody& body)
{
    int begin = beginPlane_, end = endPlane_;
    while (begin < end && belongsToNext(begin))
        ++begin;
    while (begin < end && belongsToNext(end - 1))
        --end;
    const std::size_t first = stack_->indices.size();
    slicePlanes(body, begin, end);
    if (stack_->indices.size() > first) stack_->runs.push_back({box, first, stack_->indices.size() - first});
}

/// Between two planes at which corners come in front, the same edges are cut.
void ConvexSlicer::slicePlanes(const ConvexBody& body, int begin, int end)
{
    offsets_.clear();
    firstInFront_.clear();
    for (const glm::dvec3& p : body.corners) {
        offsets_.push_back(glm::dot(planes_.normal, p));
        firstInFront_.push_back(firstPlaneInFront(planes_, nearest_, offsets_.back()));
    }
    changes_.clear();
    for (const int k : firstInFront_)
        changes_.push_back(std::clamp(k, begin, end));
    changes_.push_back(begin);
    changes_.push_back(end);
    std::ranges::sort(changes_);
    changes_.erase(std::unique(changes_.begin(), changes_.end()), changes_.end());

    for (std::size_t i = 0; i + 1 < changes_.size(); ++i) {
        inFront_.clear();
        for (const int k : firstInFront_)
            inFront_.push_back(k <= changes_[i]);
        sectionOf(body, inFront_, edges_);
        lines_.clear();
        for (const auto& [front, behind] : edges_) {
            lines_.push_back({body.corners[front], body.corners[behind], offsets_[front], offsets_[behind]});
            Line& line = lines_.back();
            if (!comesBefore(line.to, line.from)) continue;
            std::swap(line.from, line.to);
            std::swap(line.fromOffset, line.toOffset);
        }
        for (int k = changes_[i]; k < changes_[i + 1] && !lines_.empty(); ++k)
            append(polygonAt(k));
    }
}

/// In single precision, without the vertices that fall on the one before.
std::span<const float> ConvexSlicer::polygonAt(int plane)
{
    polygon_.resize(3 * lines_.size());
    const double offset = planes_.offset(plane);
    const bool moved = headOn_ >= 0 && onFace_[static_cast<std::size_t>(plane)];
    float* const first = polygon_.data();
    float* end = first;
    for (const Line& line : lines_) {
        const double a = line.fromOffset - offset, b = line.toOffset - offset;
        const double s = a / (a - b);
        glm::dvec3 p = s == 1.0 ? line.to : line.from + s * (line.to - line.from);
        if (moved) p[headOn_] = planeLevels_[static_cast<std::size_t>(plane)];
        for (int axis = 0; axis < 3; ++axis)
            end[axis] = static_cast<float>(p[axis]);
        if (end == first || !std::equal(end, end + 3, end - 3)) end += 3;
    }
    while (end - first > 3 && std::equal(end - 3, end, first))
        end -= 3;
    return {first, end};
}

void ConvexSlicer::append(std::span<const float> polygon)
{
    const std::size_t count = polygon.size() / 3;
    if (count < 3) return;
    const auto first = static_cast<std::uint32_t>(stack_->records.size() / 3);
    std::ranges::copy(polygon, stack_->records.grow(polygon.size()));
    std::uint32_t* index = stack_->indices.grow(3 * (count - 2));
    for (std::uint32_t i = 1; i + 1 < count; ++i) {
        *index++ = first + i;
        *index++ = first + i + 1;
        *index++ = first;
    }
}

} // namespace vo
