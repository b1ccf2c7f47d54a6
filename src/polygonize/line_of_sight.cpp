#include "polygonize/line_of_sight.h"

#include "polygonize/box_lattice.h"
#include "polygonize/sampling_shells.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace vo {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A clip w below this, relative to the near plane's: the far plane lies at infinity.
constexpr double kEndless = 1e-12;

/// A vertex as the line sees it. The line is the origin of (u, v).
struct LineVertex
{
    glm::dvec3 position{0.0};
    double u = 0.0;
    double v = 0.0;
    double offset = 0.0; ///< dot(normal of the planes, position)
    const float* record = nullptr;
};

bool before(const LineVertex& a, const LineVertex& b)
{
    const glm::dvec3 &p = a.position, &q = b.position;
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

/// On which side of an edge the line passes. It counts as moved by (e, e^2) for an e smaller than any number,
/// so that it meets no edge whose ends it sees apart.
struct EdgeSide
{
    double area = 0.0;
    int sign = 0;
};

EdgeSide edgeSide(const LineVertex& from, const LineVertex& to)
{
    EdgeSide side;
    side.area = from.u * to.v - to.u * from.v;
    const auto signOf = [](double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; };
    side.sign = signOf(side.area);
    if (side.area == 0.0) side.sign = signOf(from.v - to.v);
    if (side.area == 0.0 && side.sign == 0) side.sign = signOf(to.u - from.u);
    return side;
}

/// Where the line passes through a face.
struct Crossing
{
    double offset = 0.0;
    std::array<double, 4> weights{}; ///< of the tetrahedron's vertices, in the order of their positions
};

/// One tetrahedron with its vertices in the order of their positions: neighbours compute the same bits for
/// the face that they share.
class LineTetra
{
public:
    explicit LineTetra(std::array<LineVertex, 4> vertices) : vertices_(vertices)
    {
        std::sort(vertices_.begin(), vertices_.end(), before);
    }

    /// The crossings in and out, the one with the smaller offset first. False: the line passes by.
    bool cross(Crossing& low, Crossing& high) const
    {
        int found = 0;
        for (std::size_t left = 0; left < 4 && found < 2; ++left) {
            Crossing crossing;
            if (crossFace((left + 1) % 4, (left + 2) % 4, (left + 3) % 4, crossing))
                (found++ == 0 ? low : high) = crossing;
        }
        if (found < 2) return false;
        if (high.offset < low.offset) std::swap(low, high);
        return true;
    }

    void blend(const Crossing& low, const Crossing& high, double offset, std::span<double> record) const
    {
        const double place = (offset - low.offset) / (high.offset - low.offset);
        std::fill(record.begin(), record.end(), 0.0);
        for (std::size_t i = 0; i < 4; ++i) {
            const double weight = low.weights[i] + place * (high.weights[i] - low.weights[i]);
            if (weight == 0.0) continue;
            for (std::size_t value = 0; value < record.size(); ++value)
                record[value] += weight * static_cast<double>(vertices_[i].record[value]);
        }
    }

private:
    bool crossFace(std::size_t i, std::size_t j, std::size_t k, Crossing& crossing) const
    {
        std::array<std::size_t, 3> corner{i, j, k};
        std::sort(corner.begin(), corner.end());
        const LineVertex &a = vertices_[corner[0]], &b = vertices_[corner[1]], &c = vertices_[corner[2]];
        const EdgeSide ab = edgeSide(a, b), bc = edgeSide(b, c), ac = edgeSide(a, c);
        if (ab.sign == 0 || ab.sign != bc.sign || ab.sign != -ac.sign) return false;
        const double sum = bc.area - ac.area + ab.area;
        if (!(std::abs(sum) > 0.0)) return false;
        const std::array<double, 3> weight{bc.area / sum, -ac.area / sum, ab.area / sum};
        for (std::size_t n = 0; n < 3; ++n)
            crossing.weights[corner[n]] = weight[n];
        const auto [low, high] = std::minmax({a.offset, b.offset, c.offset});
        crossing.offset =
            std::clamp(weight[0] * a.offset + weight[1] * b.offset + weight[2] * c.offset, low, high);
        return std::isfinite(crossing.offset);
    }

    std::array<LineVertex, 4> vertices_;
};

/// Two unit vectors across the line.
std::array<glm::dvec3, 2> across(const glm::dvec3& direction)
{
    const glm::dvec3 size = glm::abs(direction);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(direction, other));
    return {u, glm::cross(direction, u)};
}

class LineSampler
{
public:
    LineSampler(const TetraView& tetras, std::span<const Box> boxes, const PlaneFamily& planes,
                double nearest, const LineOfSight& line)
        : tetras_(tetras), planes_(planes), nearest_(nearest), line_(line), across_(across(line.direction)),
          start_(glm::dot(planes.normal, line.start)), slope_(glm::dot(planes.normal, line.direction))
    {
        lattice_.assign(boxes);
        record_.clear(tetras.valuesPerVertex, tetras.voxelColumn);
        record_.grow();
    }

    LineSamples run()
    {
        LineSamples result;
        if (!(std::abs(slope_) > 0.0) || planes_.count == 0) return result;
        for (int tetra = 0; tetra < tetras_.tetraCount(); ++tetra)
            sampleTetra(tetra);
        std::stable_sort(found_.begin(), found_.end(),
                         [](const Found& a, const Found& b) { return a.distance < b.distance; });
        const auto values = static_cast<std::size_t>(tetras_.valuesPerVertex);
        for (const Found& f : found_) {
            result.places.push_back(f.place);
            const auto first = records_.begin() + static_cast<std::ptrdiff_t>(f.record * values);
            result.records.insert(result.records.end(), first, first + static_cast<std::ptrdiff_t>(values));
        }
        result.step = planes_.spacing / std::abs(slope_);
        return result;
    }

private:
    struct Found
    {
        double distance; ///< from the line's start
        LineSamples::Place place;
        std::size_t record; ///< number
    };

    LineVertex vertex(int tetra, std::size_t corner) const
    {
        const int number = tetras_.indices[static_cast<std::size_t>(tetra) * 4 + corner];
        LineVertex v;
        v.position = tetras_.position(number) + 0.0; // -0 and 0 are one place
        v.u = glm::dot(across_[0], v.position - line_.start);
        v.v = glm::dot(across_[1], v.position - line_.start);
        v.offset = glm::dot(planes_.normal, v.position);
        v.record = tetras_.record(number);
        return v;
    }

    void sampleTetra(int tetra)
    {
        const LineTetra t({vertex(tetra, 0), vertex(tetra, 1), vertex(tetra, 2), vertex(tetra, 3)});
        Crossing low, high;
        if (!t.cross(low, high)) return;
        const double begin = std::ceil((planes_.first - high.offset) / planes_.spacing - 1e-6);
        const double end = std::floor((planes_.first - low.offset) / planes_.spacing + 1e-6);
        const int last = static_cast<int>(std::clamp(end, -1.0, planes_.count - 1.0));
        for (int k = static_cast<int>(std::clamp(begin, 0.0, double(planes_.count))); k <= last; ++k) {
            const double offset = planes_.offset(k);
            // A plane in the face of two tetrahedra belongs to the one before it; see polygonize.
            const bool inside = offset <= nearest_ ? low.offset <= offset && offset < high.offset
                                                   : low.offset < offset && offset <= high.offset;
            const double distance = (offset - start_) / slope_;
            if (!inside || !(distance >= 0.0 && distance <= line_.length)) continue;
            t.blend(low, high, offset, {record_.record(0), static_cast<std::size_t>(record_.values)});
            placeRecord(distance);
            yield(k, distance);
        }
    }

    /// The position is that on the line itself.
    void placeRecord(double distance)
    {
        const glm::dvec3 p = line_.start + distance * line_.direction;
        for (int axis = 0; axis < 3; ++axis)
            record_.record(0)[record_.values - 3 + axis] = p[axis];
        lattice_.snap(record_);
    }

    /// To the boxes that hold the record's voxel: lower faces included, upper ones where no other box begins.
    void yield(int surface, double distance)
    {
        std::array<std::vector<int>, 3> holding;
        for (int axis = 0; axis < 3; ++axis) {
            const auto intervals = lattice_.intervals(axis);
            const double c = record_.voxel(0)[axis];
            for (std::size_t i = 0; i < intervals.size() && intervals[i].lower <= c; ++i)
                if (c <= intervals[i].upper)
                    holding[static_cast<std::size_t>(axis)].push_back(static_cast<int>(i));
        }
        for (const int x : holding[0])
            for (const int y : holding[1])
                for (const int z : holding[2])
                    for (const auto& [cell, box] : lattice_.boxes({x, y, z}))
                        if (!belongsToNext({x, y, z})) keep(box, surface, distance);
    }

    bool belongsToNext(const BoxLattice::Cell& cell) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& [lower, upper, next] =
                lattice_.intervals(static_cast<int>(axis))[static_cast<std::size_t>(cell[axis])];
            const bool inUpperFace = record_.voxel(0)[axis] == upper && lower < upper;
            if (!inUpperFace || next < 0) continue;
            BoxLattice::Cell neighbour = cell;
            neighbour[axis] = next;
            if (!lattice_.boxes(neighbour).empty()) return true;
        }
        return false;
    }

    void keep(int box, int surface, double distance)
    {
        found_.push_back({distance, {box, surface}, found_.size()});
        for (int value = 0; value < record_.values; ++value)
            records_.push_back(static_cast<float>(record_.record(0)[value]));
    }

    const TetraView& tetras_;
    const PlaneFamily& planes_;
    double nearest_;
    LineOfSight line_;
    std::array<glm::dvec3, 2> across_;
    double start_; ///< offset of the line's start
    double slope_; ///< offset for each unit along the line
    BoxLattice lattice_;
    CutPolygon record_; ///< of one vertex
    std::vector<Found> found_;
    std::vector<float> records_;
};

bool finite(const glm::dvec4& p)
{
    return std::isfinite(p.x + p.y + p.z + p.w);
}

} // namespace

std::optional<LineOfSight> lineOfSight(const glm::dmat4& model, const glm::dmat4& projection,
                                       const glm::dvec2& device)
{
    if (!findCamera(model, projection)) return std::nullopt;
    const glm::dmat4 fromClip = glm::inverse(projection * model);
    const glm::dvec4 near = fromClip * glm::dvec4(device, -1.0, 1.0);
    const glm::dvec4 far = fromClip * glm::dvec4(device, 1.0, 1.0);
    if (!finite(near) || !finite(far) || near.w == 0.0) return std::nullopt;
    LineOfSight line;
    line.start = glm::dvec3(near) / near.w;
    line.direction = glm::normalize(glm::dvec3(far) * near.w - glm::dvec3(near) * far.w);
    const bool ends = far.w / near.w > kEndless;
    line.length = ends ? glm::length(glm::dvec3(far) / far.w - line.start) : kInfinity;
    return finite(glm::dvec4(line.start + line.direction, 0.0)) ? std::optional(line) : std::nullopt;
}

std::optional<glm::dmat3> sampleGauge(const TetraView& tetras, const Camera& camera,
                                      const SamplingRequest& request)
{
    if (request.space == SamplingSpace::primitive) return std::nullopt;
    glm::dmat3 gauge(0.0);
    if (request.mode == SamplingMode::spherical && camera.perspective) {
        const ShellFamily shells = samplingShells(tetras, camera, request);
        for (int axis = 0; axis < 3; ++axis)
            gauge[axis][axis] = 1.0 / (shells.scale[axis] * shells.spacing);
        return shells.count > 0 ? std::optional(gauge) : std::nullopt;
    }
    const PlaneFamily planes = samplingPlanes(tetras, camera, request);
    for (int axis = 0; axis < 3; ++axis) // one row
        gauge[axis][0] = planes.normal[axis] / planes.spacing;
    return planes.count > 0 ? std::optional(gauge) : std::nullopt;
}

LineSamples sampleLine(const TetraView& tetras, std::span<const Box> clipBoxes, const Camera& camera,
                       const SamplingRequest& request, const LineOfSight& line)
{
    const SamplingAxis axis = samplingAxis(tetras, camera, request);
    const PlaneFamily planes = samplingPlanes(tetras, axis, camera, request);
    return LineSampler(tetras, clipBoxes, planes, axis.set.nearest, line).run();
}

} // namespace vo
