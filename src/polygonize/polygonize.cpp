#include "polygonize/polygonize.h"

#include "polygonize/box_lattice.h"
#include "polygonize/clip_polygon.h"
#include "polygonize/slice_tetra.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vo {

struct PolygonizeWorkspace::Private
{
    BoxLattice lattice;
    std::vector<double> corners; ///< the records of one tetrahedron
    CutPolygon slice;
    std::array<CutPolygon, 3> cuts; ///< what an interval of each axis left
    std::vector<float> face;
};

PolygonizeWorkspace::PolygonizeWorkspace() : d(std::make_unique<Private>()) {}
PolygonizeWorkspace::~PolygonizeWorkspace() = default;

namespace {

/// One tetrahedron, read from the caller's floats: positively oriented, or flat.
struct Corners
{
    std::array<const double*, 4> records;
    std::array<double, 4> offsets; ///< dot(normal, position)
    bool flat;
};

glm::dvec3 positionOf(const double* record, int values)
{
    return {record[values - 3], record[values - 2], record[values - 1]};
}

Corners readTetra(const TetraView& tetras, int tetra, const glm::dvec3& normal, std::vector<double>& storage)
{
    const int values = tetras.valuesPerVertex;
    const auto size = static_cast<std::size_t>(values);
    if (storage.size() < 4 * size) storage.resize(4 * size);
    Corners corners;
    std::array<glm::dvec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
        const float* source = tetras.record(tetras.indices[static_cast<std::size_t>(tetra) * 4 + i]);
        double* record = storage.data() + i * size;
        for (std::size_t value = 0; value < size; ++value)
            record[value] = static_cast<double>(source[value]) + 0.0; // -0 and 0 are one place
        p[i] = positionOf(record, values);
        corners.records[i] = record;
        corners.offsets[i] = glm::dot(normal, p[i]);
    }
    const double volume = glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0]));
    corners.flat = !(std::abs(volume) > 0.0) || !std::isfinite(volume);
    if (volume < 0.0) {
        std::swap(corners.records[0], corners.records[1]);
        std::swap(corners.offsets[0], corners.offsets[1]);
    }
    return corners;
}

class Polygonizer
{
public:
    Polygonizer(const TetraView& tetras, const DepthRange& set, PolygonizeWorkspace::Private& memory,
                FaceSink& sink)
        : tetras_(tetras), nearest_(set.nearest), memory_(memory), sink_(sink)
    {
    }

    /// False: the sink had no room.
    bool sliceWithPlanes(int tetra, const PlaneFamily& planes)
    {
        const Corners corners = readTetra(tetras_, tetra, planes.normal, memory_.corners);
        if (corners.flat) return true;
        const auto [low, high] = std::minmax_element(corners.offsets.begin(), corners.offsets.end());
        // A plane more at either end than rounding may miss; slicing tells which ones meet the tetrahedron.
        const double begin = std::ceil((planes.first - *high) / planes.spacing - 1e-6);
        const double end = std::floor((planes.first - *low) / planes.spacing + 1e-6);
        const int firstPlane = begin > 0.0 ? static_cast<int>(std::min<double>(begin, planes.count)) : 0;
        const int lastPlane = end < planes.count ? static_cast<int>(std::max(end, -1.0)) : planes.count - 1;
        for (int k = firstPlane; k <= lastPlane; ++k) {
            slice(corners, planes.offset(k));
            if (memory_.slice.count == 0) continue;
            memory_.lattice.snap(memory_.slice);
            sample_ = k;
            if (!cutAlong(0, memory_.slice)) return false;
        }
        return true;
    }

private:
    /// Of two tetrahedra that share a face, the one before the plane (nearer the viewer) yields it. Nothing
    /// lies before the set's nearest plane: there the one behind does.
    void slice(const Corners& corners, double offset)
    {
        auto records = corners.records;
        std::array<double, 4> distances;
        for (std::size_t i = 0; i < 4; ++i)
            distances[i] = corners.offsets[i] - offset;
        if (offset <= nearest_) {
            for (double& distance : distances)
                distance = -distance;
            std::swap(records[0], records[1]);
            std::swap(distances[0], distances[1]);
        }
        sliceTetra(records.data(), distances.data(), tetras_.valuesPerVertex, memory_.slice);
    }

    /// Cuts the polygon to each interval of an axis that it meets, and what is left along the next axis.
    bool cutAlong(int axis, const CutPolygon& polygon)
    {
        if (axis == 3) return emitTo(polygon);
        const auto [low, high] = extent(polygon, axis);
        const auto intervals = memory_.lattice.intervals(axis);
        CutPolygon& cut = memory_.cuts[static_cast<std::size_t>(axis)];
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

    static std::pair<double, double> extent(const CutPolygon& polygon, int axis)
    {
        double low = polygon.position(0)[axis];
        double high = low;
        for (int i = 1; i < polygon.count; ++i) {
            const double c = polygon.position(i)[axis];
            low = std::min(low, c);
            high = std::max(high, c);
        }
        return {low, high};
    }

    /// True when the polygon lies in an upper face that is a lower face of another box.
    bool belongsToNext() const
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!inUpperFace_[axis]) continue;
            BoxLattice::Cell neighbour = cell_;
            neighbour[axis] =
                memory_.lattice.intervals(static_cast<int>(axis))[static_cast<std::size_t>(cell_[axis])].next;
            if (!memory_.lattice.boxes(neighbour).empty()) return true;
        }
        return false;
    }

    bool emitTo(const CutPolygon& polygon)
    {
        const auto boxes = memory_.lattice.boxes(cell_);
        if (boxes.empty() || belongsToNext()) return true;
        const std::span<const float> face = rounded(polygon);
        for (const auto& [cell, box] : boxes)
            if (!face.empty() && !sink_.append(box, sample_, face)) return false;
        return true;
    }

    /// The polygon in single precision, without the vertices that fall on the one before.
    std::span<const float> rounded(const CutPolygon& polygon)
    {
        const auto size = static_cast<std::size_t>(polygon.values);
        const std::size_t needed = static_cast<std::size_t>(polygon.count) * size;
        if (memory_.face.size() < needed) memory_.face.resize(std::max(needed, 16 * size));
        float* const first = memory_.face.data();
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

    const TetraView& tetras_;
    double nearest_;
    PolygonizeWorkspace::Private& memory_;
    FaceSink& sink_;
    int sample_ = 0;
    BoxLattice::Cell cell_{};
    std::array<bool, 3> inUpperFace_{};
};

} // namespace

PolygonizeResult polygonize(const TetraView& tetras, std::span<const Box> clipBoxes, const Camera& camera,
                            const SamplingRequest& request, PolygonizeWorkspace& workspace, FaceSink& sink)
{
    workspace.d->lattice.assign(clipBoxes);
    const SamplingAxis axis = samplingAxis(tetras, camera, request);
    const PlaneFamily planes = samplingPlanes(tetras, axis, camera, request);
    PolygonizeResult result{planes.count, planes.spacing, true};

    Polygonizer polygonizer(tetras, axis.set, *workspace.d, sink);
    for (int tetra = 0; tetra < tetras.tetraCount() && result.complete; ++tetra) {
        const bool own = request.space == SamplingSpace::primitive;
        result.complete =
            polygonizer.sliceWithPlanes(tetra, own ? primitivePlanes(tetras, tetra, axis, request) : planes);
    }
    return result;
}

} // namespace vo
