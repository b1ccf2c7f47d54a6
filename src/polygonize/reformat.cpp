#include "polygonize/reformat.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// A vertex that makes a polygon concave by less than this, relative to its area, is rounding.
constexpr double kFlat = 1e-7;

Box hullOf(std::span<const Box> boxes)
{
    Box hull = boxes.front();
    for (const Box& box : boxes)
        hull = {glm::min(hull.lower, box.lower), glm::max(hull.upper, box.upper)};
    return hull;
}

glm::dvec3 positionOf(const CutPolygon& polygon, int i)
{
    const double* p = polygon.position(i);
    return {p[0], p[1], p[2]};
}

void writeRecord(const glm::dvec3& p, const RecordLayout& layout, double* record)
{
    std::fill_n(record, layout.values, 0.0);
    for (int channel = 0; channel < layout.colorChannels; ++channel)
        record[layout.color + channel] = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (layout.texCoord >= 0) record[layout.texCoord + axis] = p[axis];
        record[layout.position() + axis] = p[axis];
    }
}

/// Twice the area vector.
glm::dvec3 areaVector(const CutPolygon& polygon)
{
    glm::dvec3 sum(0.0);
    for (int i = 1; i + 1 < polygon.count; ++i)
        sum += glm::cross(positionOf(polygon, i) - positionOf(polygon, 0),
                          positionOf(polygon, i + 1) - positionOf(polygon, 0));
    return sum;
}

/// Cuts ears off until triangles are left.
class EarCutter
{
public:
    explicit EarCutter(const CutPolygon& polygon) : polygon_(polygon), normal_(areaVector(polygon))
    {
        for (int i = 0; i < polygon.count; ++i)
            left_.push_back(i);
    }

    bool isConvex() const
    {
        // A star polygon turns one way everywhere, too, but more than once round.
        double turned = 0.0;
        for (std::size_t i = 0; i < left_.size(); ++i) {
            if (isReflex(i)) return false;
            const glm::dvec3 in = at(i) - at(before(i)), out = at(after(i)) - at(i);
            turned += std::atan2(turnAt(i) / glm::length(normal_), glm::dot(in, out));
        }
        return turned < 3.0 * std::acos(-1.0);
    }

    /// Two edges that do not share a vertex meet.
    bool crossesItself() const
    {
        for (std::size_t i = 0; i < left_.size(); ++i)
            for (std::size_t j = i + 2; j < left_.size(); ++j) {
                if (after(j) == i) continue;
                const glm::dvec3 a = at(i), b = at(after(i)), c = at(j), d = at(after(j));
                if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) return true;
            }
        return false;
    }

    std::optional<std::vector<CutPolygon>> cut()
    {
        std::vector<CutPolygon> triangles;
        while (left_.size() > 3) {
            std::size_t ear = 0;
            while (ear < left_.size() && !isEar(ear))
                ++ear;
            if (ear == left_.size()) return std::nullopt;
            triangles.push_back(triangle(ear));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        if (isReflex(1)) return std::nullopt;
        triangles.push_back(triangle(1));
        return triangles;
    }

private:
    std::size_t before(std::size_t i) const { return (i + left_.size() - 1) % left_.size(); }
    std::size_t after(std::size_t i) const { return (i + 1) % left_.size(); }
    glm::dvec3 at(std::size_t i) const { return positionOf(polygon_, left_[i]); }
    double side(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) const
    {
        return glm::dot(normal_, glm::cross(b - a, p - a));
    }
    double turnAt(std::size_t i) const { return side(at(before(i)), at(i), at(after(i))); }

    bool isReflex(std::size_t i) const { return turnAt(i) < -kFlat * glm::dot(normal_, normal_); }

    bool isEar(std::size_t i) const
    {
        if (isReflex(i)) return false;
        const glm::dvec3 a = at(before(i)), b = at(i), c = at(after(i));
        for (std::size_t j = 0; j < left_.size(); ++j) {
            const glm::dvec3 p = at(j);
            if (p == a || p == b || p == c) continue;
            if (side(a, b, p) >= 0.0 && side(b, c, p) >= 0.0 && side(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    CutPolygon triangle(std::size_t i) const
    {
        CutPolygon result;
        result.clear(polygon_.values, polygon_.voxelColumn);
        for (const std::size_t corner : {before(i), i, after(i)})
            result.push(polygon_.record(left_[corner]));
        return result;
    }

    const CutPolygon& polygon_;
    glm::dvec3 normal_;
    std::vector<int> left_;
};

/// A part of a brick of a stack, between the middles of two slices or beyond the outermost.
struct Band
{
    int brick;
    double middle; ///< of the brick's slice
    bool constant; ///< weight 1 everywhere
};

/// Multiplies colours by the weight of a band's slice, and sends the part on to the band's brick.
class WeightingSink final : public FaceSink
{
public:
    WeightingSink(std::span<const Band> bands, const ReformatRequest& request, FaceSink& target)
        : bands_(bands), layout_(request.layout), target_(target)
    {
        voxel_ = (layout_.texCoord >= 0 ? layout_.texCoord : layout_.position()) + request.stackAxis;
    }

    bool append(int number, int sample, std::span<const float> records) override
    {
        const Band& band = bands_[static_cast<std::size_t>(number)];
        if (band.constant) return target_.append(band.brick, sample, records);
        weighted_.assign(records.begin(), records.end());
        bool visible = false;
        for (auto record = weighted_.begin(); record < weighted_.end(); record += layout_.values) {
            const double distance = std::abs(static_cast<double>(record[voxel_]) - band.middle);
            const auto weight = static_cast<float>(std::max(0.0, 1.0 - distance));
            visible = visible || weight > 0.0f;
            for (int channel = 0; channel < layout_.colorChannels; ++channel)
                record[layout_.color + channel] *= weight;
        }
        return !visible || target_.append(band.brick, sample, weighted_);
    }

private:
    std::span<const Band> bands_;
    RecordLayout layout_;
    FaceSink& target_;
    int voxel_;
    std::vector<float> weighted_;
};

/// Two boxes a brick: from the middle of its slice to those of the neighbours, or to the end of the stack.
void findBands(std::span<const Box> boxes, int axis, std::vector<Band>& bands, std::vector<Box>& parts)
{
    const Box hull = hullOf(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double lower = boxes[i].lower[axis], upper = boxes[i].upper[axis];
        const double middle = 0.5 * (lower + upper);
        const bool first = lower == hull.lower[axis], last = upper == hull.upper[axis];
        const auto add = [&](double from, double to, bool constant) {
            Box part = boxes[i];
            part.lower[axis] = from;
            part.upper[axis] = to;
            parts.push_back(part);
            bands.push_back({static_cast<int>(i), middle, constant});
        };
        if (first && last) {
            add(lower, upper, true);
            continue;
        }
        add(first ? lower : middle - 1.0, middle, first);
        add(middle, last ? upper : middle + 1.0, last);
    }
}

} // namespace

CutPolygon planeThroughBoxes(const glm::dvec4& plane, std::span<const Box> boxes, const RecordLayout& layout)
{
    CutPolygon square;
    square.clear(layout.values, layout.texCoord);
    if (boxes.empty()) return square;
    const Box hull = hullOf(boxes);
    const double scale = std::max({std::abs(plane.x), std::abs(plane.y), std::abs(plane.z)});
    const glm::dvec3 direction = glm::dvec3(plane) / scale;
    const double length = glm::length(direction);
    const glm::dvec3 normal = direction / length;
    const glm::dvec3 centre = 0.5 * (hull.lower + hull.upper);
    const double distance = glm::dot(normal, centre) + plane.w / scale / length;
    const double reach = glm::length(hull.upper - hull.lower);
    if (!(std::abs(distance) <= reach)) return square;

    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(other, normal));
    const glm::dvec3 v = glm::cross(normal, u);
    const glm::dvec3 middle = centre - distance * normal;
    for (const glm::dvec3& corner : {-u - v, u - v, u + v, v - u})
        writeRecord(middle + reach * corner, layout, square.grow());
    return square;
}

std::optional<std::vector<CutPolygon>> convexParts(const CutPolygon& polygon)
{
    CutPolygon distinct;
    distinct.clear(polygon.values, polygon.voxelColumn);
    for (int i = 0; i < polygon.count; ++i) {
        distinct.push(polygon.record(i));
        distinct.dropRepeat();
    }
    distinct.close();
    if (distinct.count < 3 || !(glm::length(areaVector(distinct)) > 0.0)) return std::vector<CutPolygon>{};
    EarCutter cutter(distinct);
    if (cutter.isConvex()) return std::vector<CutPolygon>{distinct};
    return cutter.crossesItself() ? std::nullopt : cutter.cut();
}

bool reformat(CutPolygon polygon, const ReformatRequest& request, BoxCutter& cutter, FaceSink& sink)
{
    if (request.stackAxis < 0 || request.clipBoxes.empty()) {
        cutter.assign(request.clipBoxes);
        return cutter.cut(polygon, 0, sink);
    }
    assert(request.layout.color >= 0);
    std::vector<Band> bands;
    std::vector<Box> parts;
    findBands(request.clipBoxes, request.stackAxis, bands, parts);
    cutter.assign(parts);
    WeightingSink weighting(bands, request, sink);
    return cutter.cut(polygon, 0, weighting);
}

} // namespace vo
