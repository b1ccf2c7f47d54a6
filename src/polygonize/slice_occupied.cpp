#include "polygonize/slice_occupied.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// As in docs/frames.md.
constexpr double kSnapDistance = 1e-5;
/// Rows are so many voxels high: a polygon costs as much as a few hundred fragments.
constexpr int kRowHeight = 16;
/// Empty pieces between two occupied ones that are drawn rather than cut out.
constexpr std::size_t kBridgedPieces = 1;

bool isContiguous(std::span<const BoxLattice::Interval> intervals)
{
    for (std::size_t i = 0; i + 1 < intervals.size(); ++i)
        if (intervals[i].upper != intervals[i + 1].lower) return false;
    return !intervals.empty();
}

/// Whether a corner lies within an edge: in a fan from another corner of that edge it would belong to no
/// triangle of any area.
template <typename Corners>
bool hasStraightCorner(const Corners& polygon)
{
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i)
        if (polygon[i].u == polygon[(i + 1) % count].u && polygon[i].u == polygon[(i + 2) % count].u)
            return true;
    return false;
}

} // namespace

bool OccupiedSlicer::slice(const Box& domain, std::span<const Box> clipBoxes, const OccupiedCells& cells,
                           const PlaneFamily& planes, OccupiedSlices& slices)
{
    lattice_.assign(clipBoxes);
    for (int axis = 0; axis < 3; ++axis)
        if (!isContiguous(lattice_.intervals(axis))) return false;
    slices_ = &slices;
    slices.positions.clear();
    slices.indices.clear();
    slices.runs.clear();
    slices.area = slices.perimeter = slices.wholeArea = 0.0;
    normal_ = planes.normal;
    w_ = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(normal_[axis]) > std::abs(normal_[w_])) w_ = axis;
    u_ = (w_ + 1) % 3;
    v_ = (w_ + 2) % 3;
    if (!findBounds(domain)) return true;

    cellSide_ = cells.side;
    rows_ = breaksAlong(u_, kRowHeight, kRowHeight / 4);
    columns_ = breaksAlong(v_, cellSide_, cellSide_ / 4);
    countOccupied(cells);
    indices_.resize(clipBoxes.size());
    for (auto& indices : indices_)
        indices.clear();
    for (int k = 0; k < planes.count; ++k) {
        offset_ = planes.offset(k);
        slicePlane();
    }
    for (std::size_t brick = 0; brick < indices_.size(); ++brick) {
        if (indices_[brick].empty()) continue;
        slices.runs.push_back({static_cast<int>(brick), slices.indices.size(), indices_[brick].size()});
        slices.indices.insert(slices.indices.end(), indices_[brick].begin(), indices_[brick].end());
    }
    measure(planes);
    return true;
}

void OccupiedSlicer::measure(const PlaneFamily& planes)
{
    OccupiedSlices& s = *slices_;
    const auto corner = [&s](std::uint32_t vertex) {
        const float* p = s.positions.data() + 3 * std::size_t{vertex};
        return glm::dvec3(p[0], p[1], p[2]);
    };
    for (std::size_t i = 0; i < s.indices.size(); i += 3) {
        const glm::dvec3 a = corner(s.indices[i]), b = corner(s.indices[i + 1]), c = corner(s.indices[i + 2]);
        s.area += 0.5 * glm::length(glm::cross(b - a, c - a));
        s.perimeter += glm::distance(a, b) + glm::distance(b, c) + glm::distance(c, a);
    }
    // Slabs of one plane each fill the box.
    const glm::dvec3 size = upper_ - lower_;
    s.wholeArea = size.x * size.y * size.z * glm::length(planes.normal) / planes.spacing;
}

/// False: the domain and the boxes do not meet.
bool OccupiedSlicer::findBounds(const Box& domain)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto intervals = lattice_.intervals(axis);
        lower_[axis] = std::max(domain.lower[axis], intervals.front().lower);
        upper_[axis] = std::min(domain.upper[axis], intervals.back().upper);
        if (!(lower_[axis] < upper_[axis])) return false;
    }
    return true;
}

/// The bounds, the faces of bricks between them, and multiples of `step` that keep `leastGap` from both.
OccupiedSlicer::Breaks OccupiedSlicer::breaksAlong(int axis, int step, double leastGap) const
{
    Breaks breaks;
    const auto intervals = lattice_.intervals(axis);
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const double lower = std::max(intervals[i].lower, lower_[axis]);
        const double upper = std::min(intervals[i].upper, upper_[axis]);
        if (!(lower < upper)) continue;
        breaks.at.push_back(lower);
        breaks.interval.push_back(static_cast<int>(i));
        for (double at = std::ceil((lower + leastGap) / step) * step; at <= upper - leastGap; at += step) {
            breaks.at.push_back(at);
            breaks.interval.push_back(static_cast<int>(i));
        }
    }
    breaks.at.push_back(upper_[axis]);
    return breaks;
}

void OccupiedSlicer::countOccupied(const OccupiedCells& cells)
{
    const std::array<std::size_t, 3> strides = {1, static_cast<std::size_t>(cells.count.x),
                                                static_cast<std::size_t>(cells.count.x) *
                                                    static_cast<std::size_t>(cells.count.y)};
    const auto stride = [&](int axis) { return strides[static_cast<std::size_t>(axis)]; };
    cellsAlong_ = cells.count[w_];
    const auto along = static_cast<std::size_t>(cellsAlong_);
    occupied_.assign(rows_.pieces() * columns_.pieces() * (along + 1), 0);
    const auto cellsOf = [&](const Breaks& breaks, std::size_t piece, int axis) {
        const int last = cells.count[axis] - 1;
        const int first = static_cast<int>(breaks.at[piece]) / cells.side;
        const int end = static_cast<int>(std::ceil(breaks.at[piece + 1] / cells.side)) - 1;
        return std::pair(static_cast<std::size_t>(std::clamp(first, 0, last)),
                         static_cast<std::size_t>(std::clamp(end, 0, last)));
    };
    std::uint32_t* counts = occupied_.data();
    for (std::size_t row = 0; row < rows_.pieces(); ++row)
        for (std::size_t column = 0; column < columns_.pieces(); ++column, counts += along + 1) {
            const auto [u0, u1] = cellsOf(rows_, row, u_);
            const auto [v0, v1] = cellsOf(columns_, column, v_);
            for (std::size_t w = 0; w < along; ++w) {
                std::uint8_t any = 0;
                for (std::size_t u = u0; u <= u1; ++u)
                    for (std::size_t v = v0; v <= v1; ++v)
                        any |= cells.occupied[u * stride(u_) + v * stride(v_) + w * stride(w_)];
                counts[w + 1] = counts[w] + any;
            }
        }
}

/// Of a piece of a row, whether a plane that runs through it from `low` to `high` along w meets anything.
bool OccupiedSlicer::isOccupied(std::size_t row, std::size_t column, double low, double high) const
{
    const double from = std::max(low, lower_[w_]) - kSnapDistance;
    const double to = std::min(high, upper_[w_]) + kSnapDistance;
    if (from > to) return false;
    const int last = cellsAlong_ - 1;
    const auto first = static_cast<std::size_t>(std::clamp(static_cast<int>(from / cellSide_), 0, last));
    const auto end = static_cast<std::size_t>(std::clamp(static_cast<int>(to / cellSide_), 0, last)) + 1;
    const std::uint32_t* counts =
        occupied_.data() + (row * columns_.pieces() + column) * (static_cast<std::size_t>(cellsAlong_) + 1);
    return counts[end] != counts[first];
}

double OccupiedSlicer::depthAt(double u, double v) const
{
    double w = (offset_ - normal_[u_] * u - normal_[v_] * v) / normal_[w_];
    const auto snap = [&w](double face) {
        if (std::abs(w - face) <= kSnapDistance) w = face;
    };
    for (const BoxLattice::Interval& interval : lattice_.intervals(w_)) {
        snap(interval.lower);
        snap(interval.upper);
    }
    snap(lower_[w_]);
    snap(upper_[w_]);
    return w;
}

void OccupiedSlicer::findStretches(std::size_t row, std::vector<Stretch>& stretches) const
{
    stretches.clear();
    const double slopeU = -normal_[u_] / normal_[w_], slopeV = -normal_[v_] / normal_[w_];
    const double fromU = rows_.at[row] * slopeU, toU = rows_.at[row + 1] * slopeU;
    const double low = offset_ / normal_[w_] + std::min(fromU, toU);
    const double high = offset_ / normal_[w_] + std::max(fromU, toU);
    for (std::size_t column = 0; column < columns_.pieces(); ++column) {
        const double fromV = columns_.at[column] * slopeV, toV = columns_.at[column + 1] * slopeV;
        if (!isOccupied(row, column, low + std::min(fromV, toV), high + std::max(fromV, toV))) continue;
        const bool goesOn = !stretches.empty() && column - stretches.back().end <= kBridgedPieces;
        if (!goesOn) stretches.push_back({column, column});
        stretches.back().end = column + 1;
    }
    // Bricks part them.
    for (std::size_t i = 0; i < stretches.size(); ++i)
        for (std::size_t at = stretches[i].first + 1; at < stretches[i].end; ++at)
            if (columns_.startsBrick(at)) {
                const Stretch rest{at, stretches[i].end};
                stretches[i].end = at;
                stretches.insert(stretches.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
            }
}

void OccupiedSlicer::findBands()
{
    bandCount_ = 0;
    for (std::size_t row = 0; row < rows_.pieces(); ++row) {
        findStretches(row, stretches_);
        if (bandCount_ > 0 && !rows_.startsBrick(row) && bands_[bandCount_ - 1].stretches == stretches_) {
            bands_[bandCount_ - 1].end = row + 1;
            continue;
        }
        if (bands_.size() == bandCount_) bands_.emplace_back();
        bands_[bandCount_] = {row, row + 1, {}};
        bands_[bandCount_++].stretches = stretches_;
    }
}

void OccupiedSlicer::slicePlane()
{
    findBands();
    for (std::size_t i = 0; i < bandCount_; ++i)
        for (const Stretch& stretch : bands_[i].stretches)
            sliceRectangle(bands_[i], stretch, i > 0 ? &bands_[i - 1] : nullptr,
                           i + 1 < bandCount_ ? &bands_[i + 1] : nullptr);
}

/// Where a neighbour's rectangles end on the edge at `u`, this one needs vertices as well.
void OccupiedSlicer::appendInserts(const Band* neighbour, double u, const Stretch& stretch, bool backwards)
{
    if (!neighbour) return;
    const auto insert = [&](std::size_t column) {
        if (column <= stretch.first || column >= stretch.end) return;
        const double v = columns_.at[column];
        if (outline_.back().u == u && outline_.back().v == v) return;
        outline_.push_back({u, v, depthAt(u, v)});
    };
    const std::size_t count = neighbour->stretches.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Stretch& other = neighbour->stretches[backwards ? count - 1 - i : i];
        insert(backwards ? other.end : other.first);
        insert(backwards ? other.first : other.end);
    }
}

void OccupiedSlicer::sliceRectangle(const Band& band, const Stretch& stretch, const Band* below,
                                    const Band* above)
{
    const double u0 = rows_.at[band.first], u1 = rows_.at[band.end];
    const double v0 = columns_.at[stretch.first], v1 = columns_.at[stretch.end];
    outline_.clear();
    outline_.push_back({u0, v0, depthAt(u0, v0)});
    appendInserts(below, u0, stretch, false);
    outline_.push_back({u0, v1, depthAt(u0, v1)});
    outline_.push_back({u1, v1, depthAt(u1, v1)});
    appendInserts(above, u1, stretch, true);
    outline_.push_back({u1, v0, depthAt(u1, v0)});

    const auto [least, most] =
        std::ranges::minmax(outline_, {}, [](const Corner& corner) { return corner.w; });
    const auto intervals = lattice_.intervals(w_);
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const double lower = std::max(intervals[i].lower, lower_[w_]);
        const double upper = std::min(intervals[i].upper, upper_[w_]);
        if (!(lower < upper)) continue;
        const bool flat = least.w == most.w;
        const bool meets =
            flat ? least.w >= lower && (least.w < upper || (least.w == upper && upper == upper_[w_]))
                 : most.w > lower && least.w < upper;
        if (!meets) continue;
        clipDepth(lower, true, outline_, cut_);
        clipDepth(upper, false, cut_, part_);
        emit(part_, band.first, stretch.first, static_cast<int>(i));
    }
}

/// Cuts edges where w reaches a face. The coordinate that an edge keeps and the face give the third,
/// whichever rectangle the edge is of.
void OccupiedSlicer::clipDepth(double face, bool keepAbove, const std::vector<Corner>& in,
                               std::vector<Corner>& out) const
{
    out.clear();
    const auto side = [&](const Corner& c) { return keepAbove ? c.w - face : face - c.w; };
    for (std::size_t i = 0; i < in.size(); ++i) {
        const Corner& a = in[i];
        const Corner& b = in[(i + 1) % in.size()];
        if (side(a) >= 0.0) out.push_back(a);
        if ((side(a) > 0.0 && side(b) < 0.0) || (side(a) < 0.0 && side(b) > 0.0)) {
            Corner c{a.u, a.v, face};
            if (a.u == b.u)
                c.v = (offset_ - normal_[u_] * a.u - normal_[w_] * face) / normal_[v_];
            else
                c.u = (offset_ - normal_[v_] * a.v - normal_[w_] * face) / normal_[u_];
            out.push_back(c);
        }
    }
}

void OccupiedSlicer::emit(const std::vector<Corner>& polygon, std::size_t row, std::size_t column,
                          int interval)
{
    BoxLattice::Cell cell{};
    cell[static_cast<std::size_t>(u_)] = rows_.interval[row];
    cell[static_cast<std::size_t>(v_)] = columns_.interval[column];
    cell[static_cast<std::size_t>(w_)] = interval;
    const auto boxes = lattice_.boxes(cell);
    if (boxes.empty()) return;
    std::vector<float>& positions = slices_->positions;
    vertices_.clear();
    std::array<float, 3> last{};
    const std::size_t start = positions.size();
    for (const Corner& corner : polygon) {
        std::array<float, 3> p{};
        p[static_cast<std::size_t>(u_)] = static_cast<float>(corner.u);
        p[static_cast<std::size_t>(v_)] = static_cast<float>(corner.v);
        p[static_cast<std::size_t>(w_)] = static_cast<float>(corner.w);
        if (!vertices_.empty() &&
            (p == last ||
             std::equal(p.begin(), p.end(), positions.begin() + static_cast<std::ptrdiff_t>(start))))
            continue;
        vertices_.push_back(static_cast<std::uint32_t>(positions.size() / 3));
        positions.insert(positions.end(), p.begin(), p.end());
        last = p;
    }
    if (vertices_.size() < 3) {
        positions.resize(start);
        return;
    }
    // Rectangles run clockwise as seen from far up the axis w; the normal points away from the viewer.
    if (normal_[w_] < 0.0) std::ranges::reverse(vertices_);
    const bool fan = !hasStraightCorner(polygon);
    const std::uint32_t apex = fan ? vertices_[0] : appendMiddle(vertices_);
    const std::size_t count = vertices_.size();
    for (const auto& [number, box] : boxes)
        for (std::size_t i = fan ? 1 : 0; i + (fan ? 1 : 0) < count; ++i)
            indices_[static_cast<std::size_t>(box)].insert(indices_[static_cast<std::size_t>(box)].end(),
                                                           {vertices_[i], vertices_[(i + 1) % count], apex});
}

std::uint32_t OccupiedSlicer::appendMiddle(std::span<const std::uint32_t> vertices)
{
    std::vector<float>& positions = slices_->positions;
    std::array<double, 3> middle{};
    for (const std::uint32_t vertex : vertices)
        for (std::size_t axis = 0; axis < 3; ++axis)
            middle[axis] += static_cast<double>(positions[3 * std::size_t{vertex} + axis]) /
                            static_cast<double>(vertices.size());
    for (const double coordinate : middle)
        positions.push_back(static_cast<float>(coordinate));
    return static_cast<std::uint32_t>(positions.size() / 3 - 1);
}

} // namespace vo
