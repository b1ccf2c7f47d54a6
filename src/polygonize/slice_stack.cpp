#include "polygonize/slice_stack.h"

#include "core/parallel.h"
#include "polygonize/box_cutter.h"
#include "polygonize/box_lattice.h"
#include "polygonize/slice_cutter.h"
#include "polygonize/slice_tetra.h"
#include "polygonize/write_slices.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace vo {

namespace {

/// Parts of the work that threads take one by one; the same for any number of them.
constexpr std::size_t kTetrasInPart = 2048;
constexpr std::size_t kMostParts = 64;
constexpr std::size_t kVerticesInPart = 8192;
/// Counters of all parts together.
constexpr std::size_t kMostCounters = std::size_t{1} << 23;

/// What is known of a tetrahedron after it was looked at.
struct Item
{
    std::uint32_t tetra;
    std::int32_t box;                  ///< that holds all of it; -1: the polygons are those kept aside
    std::array<std::uint8_t, 4> order; ///< of its corners, as TetraToSlice has them
    bool mirrored;                     ///< in this order
    std::array<std::int32_t, 4> firstInFront;
    std::uint32_t firstAside; ///< of the part's polygons kept aside
    std::uint32_t asideCount;
};

/// What is known of a vertex: the planes, and the interval of boxes on each axis or what intervalAt() says.
struct VertexPlace
{
    PlacedVertex at;
    std::int32_t firstInFront;
    std::array<std::int32_t, 3> interval;

    glm::dvec3 position() const { return {at.position[0], at.position[1], at.position[2]}; }
};

struct AsidePolygon
{
    int box;
    int sample;
    std::size_t first; ///< of the values
    std::uint32_t records;
};

/// Polygons that boxes have cut wait here until their place is known.
class Aside final : public FaceSink
{
public:
    explicit Aside(int values) : values_(static_cast<std::size_t>(values)) {}

    bool append(int brick, int sample, std::span<const float> records) override
    {
        const std::size_t first = data.size();
        std::ranges::copy(records, data.grow(records.size()));
        polygons.push_back({brick, sample, first, static_cast<std::uint32_t>(records.size() / values_)});
        return true;
    }
    void clear(int values)
    {
        values_ = static_cast<std::size_t>(values);
        data.clear();
        polygons.clear();
    }

    KeptArray<float> data;
    std::vector<AsidePolygon> polygons;

private:
    std::size_t values_;
};

struct Part
{
    std::size_t firstTetra = 0, endTetra = 0;
    KeptArray<Item> items;
    Aside aside{3};
    /// One a box and plane, in the end of what comes next: first by how much it has more than the plane
    /// before, then how much it has, then the place of the next polygon. One plane more than there are.
    std::vector<StackCount> counts;

    BoxCutter cutter;
    std::vector<double> corners;
    CutPolygon slice;
    std::vector<float> scratch;
};

struct Job
{
    const TetraView& tetras;
    std::span<const Box> boxes;
    StackOrder order;
    PlaneFamily planes;
    double nearest;                        ///< of the set
    const SamplingRequest* own = nullptr;  ///< each tetrahedron has its own planes
    const SamplingAxis* ownAxis = nullptr; ///< of these
    std::size_t samples = 0;
    PolygonStack* stack = nullptr;       ///< where they are written
    const VertexPlace* places = nullptr; ///< of all vertices

    std::size_t bins() const { return boxes.size() * samples; }
    std::size_t bin(int box, int sample) const
    {
        const auto b = static_cast<std::size_t>(box), s = static_cast<std::size_t>(sample);
        return order == StackOrder::byBrick ? b * samples + s : s * boxes.size() + b;
    }
    std::size_t stride() const { return order == StackOrder::byBrick ? 1 : boxes.size(); }
    PlaneFamily planesOf(std::size_t tetra) const
    {
        return own ? primitivePlanes(tetras, static_cast<int>(tetra), *ownAxis, *own) : planes;
    }
    const float* corner(std::size_t tetra, std::size_t i) const
    {
        return tetras.record(tetras.indices[4 * tetra + i]);
    }
};

/// Looks at the tetrahedra of a part: what planes and boxes meet each, and how much that will make.
class Looker
{
public:
    Looker(const Job& job, const BoxLattice& lattice, Part& part) : job_(job), lattice_(lattice), part_(part)
    {
    }

    void lookAtAll()
    {
        part_.items.clear();
        part_.aside.clear(job_.tetras.valuesPerVertex);
        const std::size_t stride = job_.stride(), bins = job_.bins();
        part_.counts.assign(bins + stride, 0);
        for (std::size_t tetra = part_.firstTetra; tetra < part_.endTetra; ++tetra)
            lookAt(tetra);
        StackCount* const counts = part_.counts.data();
        for (std::size_t bin = stride; bin < bins; ++bin)
            counts[bin] += counts[bin - stride];
    }

private:
    void lookAt(std::size_t tetra)
    {
        Item item{static_cast<std::uint32_t>(tetra), -1, {}, false, {}, 0, 0};
        std::array<const VertexPlace*, 4> places;
        for (std::size_t i = 0; i < 4; ++i)
            places[i] = job_.places + job_.tetras.indices[4 * tetra + i];
        const std::array<glm::dvec3, 4> p{places[0]->position(), places[1]->position(), places[2]->position(),
                                          places[3]->position()};
        const bool odd = orderCorners(tetra, places, item);
        for (std::size_t i = 0; i < 4; ++i)
            item.firstInFront[i] = places[i]->firstInFront;
        if (job_.own) findOwnPlanes(tetra, places, item);
        const auto [begin, end] = std::ranges::minmax(item.firstInFront);
        if (begin == end || !findBox(places, item)) return;
        const double volume = glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0]));
        if (!(std::abs(volume) > 0.0) || !std::isfinite(volume)) return;
        item.mirrored = (volume < 0.0) != odd;
        if (item.box >= 0)
            count(item);
        else
            cutAside(tetra, places, item);
        *part_.items.grow(1) = item;
    }

    /// Sorts the corners. True: an odd number of them changed places.
    bool orderCorners(std::size_t tetra, std::array<const VertexPlace*, 4>& places, Item& item) const
    {
        std::array<unsigned, 4> rank{};
        unsigned odd = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = i + 1; j < 4; ++j) {
                const unsigned swapped = comesBefore(tetra, j, i, places) ? 1 : 0;
                rank[i] += swapped;
                rank[j] += 1 - swapped;
                odd ^= swapped;
            }
        const std::array<const VertexPlace*, 4> given = places;
        for (std::size_t i = 0; i < 4; ++i) {
            places[rank[i]] = given[i];
            item.order[rank[i]] = static_cast<std::uint8_t>(i);
        }
        return odd != 0;
    }

    bool comesBefore(std::size_t tetra, std::size_t a, std::size_t b,
                     const std::array<const VertexPlace*, 4>& places) const
    {
        const auto &p = places[a]->at.position, &q = places[b]->at.position;
        const bool sameX = p[0] == q[0], sameY = p[1] == q[1];
        if (sameX & sameY & (p[2] == q[2])) [[unlikely]] {
            const std::ptrdiff_t rest = job_.tetras.valuesPerVertex - 3;
            const float *r = job_.corner(tetra, a), *s = job_.corner(tetra, b);
            return std::lexicographical_compare(r, r + rest, s, s + rest);
        }
        return (p[0] < q[0]) | (sameX & ((p[1] < q[1]) | (sameY & (p[2] < q[2]))));
    }

    void findOwnPlanes(std::size_t tetra, const std::array<const VertexPlace*, 4>& places, Item& item) const
    {
        const PlaneFamily planes = job_.planesOf(tetra);
        for (std::size_t i = 0; i < 4; ++i)
            item.firstInFront[i] = firstPlaneInFront(planes, job_.nearest, places[i]->at.offset);
    }

    /// False: the tetrahedron is outside of all boxes.
    bool findBox(const std::array<const VertexPlace*, 4>& places, Item& item)
    {
        BoxLattice::Cell cell{};
        bool inside = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t interval = places[0]->interval[axis];
            const bool same = (places[1]->interval[axis] == interval) &
                              (places[2]->interval[axis] == interval) &
                              (places[3]->interval[axis] == interval);
            if (same && (interval == BoxLattice::kBelow || interval == BoxLattice::kAbove)) return false;
            inside = inside && same && interval >= 0;
            cell[axis] = interval;
        }
        if (!inside) return true;
        if (cell != cell_) {
            const auto boxes = lattice_.boxes(cell);
            cell_ = cell;
            boxesInCell_ = boxes.size();
            box_ = boxes.empty() ? -1 : boxes.front().box;
        }
        if (boxesInCell_ == 1) item.box = box_;
        return boxesInCell_ > 0;
    }

    void count(const Item& item)
    {
        std::array<std::int32_t, 4> changes = item.firstInFront;
        std::ranges::sort(changes);
        StackCount* const counts = part_.counts.data() + job_.bin(item.box, 0);
        const auto change = [&](std::size_t i) -> StackCount& {
            return counts[static_cast<std::size_t>(changes[i]) * job_.stride()];
        };
        change(0) += countOfPolygon(3);
        change(1) += countOfPolygon(4) - countOfPolygon(3);
        change(2) -= countOfPolygon(4) - countOfPolygon(3);
        change(3) -= countOfPolygon(3);
    }

    void cutAside(std::size_t tetra, const std::array<const VertexPlace*, 4>& places, Item& item)
    {
        item.firstAside = static_cast<std::uint32_t>(part_.aside.polygons.size());
        const PlaneFamily planes = job_.planesOf(tetra);
        switch (job_.tetras.valuesPerVertex) {
        case 3: cutWith<3>(tetra, places, planes, item); break;
        case 6: cutWith<6>(tetra, places, planes, item); break;
        case 7: cutWith<7>(tetra, places, planes, item); break;
        case 9: cutWith<9>(tetra, places, planes, item); break;
        case 10: cutWith<10>(tetra, places, planes, item); break;
        default: cutRecords(tetra, planes, item); break;
        }
        item.asideCount = static_cast<std::uint32_t>(part_.aside.polygons.size()) - item.firstAside;
        for (const AsidePolygon& polygon :
             std::span(part_.aside.polygons).subspan(item.firstAside, item.asideCount)) {
            StackCount* const count = part_.counts.data() + job_.bin(polygon.box, polygon.sample);
            count[0] += countOfPolygon(polygon.records);
            count[job_.stride()] -= countOfPolygon(polygon.records);
        }
    }

    template <int kValues>
    void cutWith(std::size_t number, const std::array<const VertexPlace*, 4>& places,
                 const PlaneFamily& planes, const Item& item)
    {
        const int column = job_.tetras.voxelColumn;
        TetraInBoxes<kValues> tetra{{},
                                    static_cast<std::size_t>(column < 0 ? kValues - 3 : column),
                                    {},
                                    item.firstInFront,
                                    item.mirrored,
                                    {}};
        for (std::size_t i = 0; i < 4; ++i) {
            const float* source = job_.corner(number, item.order[i]);
            for (std::size_t value = 0; value < kValues; ++value)
                tetra.corners[i][value] = static_cast<double>(source[value]) + 0.0; // -0 and 0 are one place
            tetra.offsets[i] = places[i]->at.offset;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t interval = places[0]->interval[axis];
            const bool same = std::ranges::all_of(
                places, [&](const VertexPlace* place) { return place->interval[axis] == interval; });
            tetra.interval[axis] = same ? interval : BoxLattice::kNearFace;
        }
        SliceCutter<kValues>(lattice_).cut(tetra, planes, part_.aside);
    }

    /// Slices it plane by plane and lets the boxes cut the slices.
    void cutRecords(std::size_t tetra, const PlaneFamily& planes, Item& item)
    {
        const int values = job_.tetras.valuesPerVertex;
        const auto size = static_cast<std::size_t>(values);
        if (part_.corners.size() < 4 * size) part_.corners.resize(4 * size);
        std::array<const double*, 4> records;
        std::array<double, 4> offsets;
        if (item.mirrored) {
            std::swap(item.order[0], item.order[1]);
            std::swap(item.firstInFront[0], item.firstInFront[1]);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const float* source = job_.corner(tetra, item.order[i]);
            double* record = part_.corners.data() + i * size;
            for (std::size_t value = 0; value < size; ++value)
                record[value] = static_cast<double>(source[value]) + 0.0; // -0 and 0 are one place
            records[i] = record;
            offsets[i] =
                glm::dot(planes.normal, glm::dvec3(record[size - 3], record[size - 2], record[size - 1]));
        }
        const auto [begin, end] = std::ranges::minmax(item.firstInFront);
        for (int k = begin; k < end; ++k) {
            std::array<double, 4> distances;
            unsigned mask = 0;
            for (unsigned i = 0; i < 4; ++i) {
                distances[i] = offsets[i] - planes.offset(k);
                mask |= (item.firstInFront[i] <= k ? 1u : 0u) << i;
            }
            sliceTetra(records.data(), distances.data(), mask, values, part_.slice, job_.tetras.voxelColumn);
            part_.cutter.cut(part_.slice, k, part_.aside);
        }
    }

    const Job& job_;
    const BoxLattice& lattice_;
    Part& part_;
    BoxLattice::Cell cell_{-1, -1, -1}; ///< the last one asked for
    std::size_t boxesInCell_ = 0;
    int box_ = -1;
};

void placeVertex(const Job& job, const BoxLattice& lattice, std::size_t vertex, VertexPlace& place)
{
    const float* record = job.tetras.record(static_cast<int>(vertex));
    const float* p = record + job.tetras.valuesPerVertex - 3;
    const float* voxel = job.tetras.voxelColumn >= 0 ? record + job.tetras.voxelColumn : p;
    place.at.position = {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
    place.at.offset = glm::dot(job.planes.normal, place.position());
    place.firstInFront = firstPlaneInFront(job.planes, job.nearest, place.at.offset);
    for (int axis = 0; axis < 3; ++axis)
        place.interval[static_cast<std::size_t>(axis)] = lattice.intervalAt(axis, voxel[axis]);
}

void writeAside(const Job& job, Part& part, const Item& item)
{
    PolygonStack& stack = *job.stack;
    const auto values = static_cast<std::size_t>(job.tetras.valuesPerVertex);
    for (const AsidePolygon& polygon :
         std::span(part.aside.polygons).subspan(item.firstAside, item.asideCount)) {
        const std::size_t bin = job.bin(polygon.box, polygon.sample);
        const StackCount place =
            std::exchange(part.counts[bin], part.counts[bin] + countOfPolygon(polygon.records));
        const std::uint32_t first = recordsOf(place);
        std::copy_n(part.aside.data.data() + polygon.first, polygon.records * values,
                    stack.records.data() + first * values);
        std::uint32_t* index = stack.indices.data() + std::size_t{3} * trianglesOf(place);
        for (std::uint32_t i = 1; i + 1 < polygon.records; ++i) {
            *index++ = first + i;
            *index++ = first + i + 1;
            *index++ = first;
        }
    }
}

void writePart(const Job& job, Part& part)
{
    PolygonStack& stack = *job.stack;
    for (const Item& item : part.items.all()) {
        if (item.box < 0) {
            writeAside(job, part, item);
            continue;
        }
        TetraToSlice tetra{{}, job.tetras.valuesPerVertex, {}, item.firstInFront, item.mirrored};
        for (std::size_t i = 0; i < 4; ++i) {
            const int vertex = job.tetras.indices[std::size_t{4} * item.tetra + item.order[i]];
            tetra.corners[i] = job.tetras.record(vertex);
            tetra.places[i] = &job.places[vertex].at;
        }
        const std::size_t bin = job.bin(item.box, 0);
        const SliceTarget target{stack.records.data(), stack.indices.data(), part.counts.data() + bin,
                                 job.stride()};
        writeSlices(tetra, job.planesOf(item.tetra), target, part.scratch);
    }
}

/// Planes of the tetrahedron that has most of them.
std::size_t sampleCount(const Job& job)
{
    int most = job.planes.count;
    if (job.own)
        for (int tetra = 0; tetra < job.tetras.tetraCount(); ++tetra)
            most = std::max(most, job.planesOf(static_cast<std::size_t>(tetra)).count);
    return static_cast<std::size_t>(most);
}

} // namespace

struct StackSlicer::Private
{
    BoxLattice lattice;
    std::vector<std::unique_ptr<Part>> parts;

    KeptArray<VertexPlace> places;

    PolygonizeResult slice(Job& job, int threads, PolygonStack& stack);

    void placeVertices(Job& job, int threads)
    {
        places.resize(job.tetras.records.size() / static_cast<std::size_t>(job.tetras.valuesPerVertex));
        job.places = places.data();
        const std::size_t vertices = places.size();
        parallelFor((vertices + kVerticesInPart - 1) / kVerticesInPart, threads,
                    [this, &job](std::size_t part) {
                        const std::size_t end = std::min((part + 1) * kVerticesInPart, places.size());
                        for (std::size_t vertex = part * kVerticesInPart; vertex < end; ++vertex)
                            placeVertex(job, lattice, vertex, places[vertex]);
                    });
    }
    std::span<const std::unique_ptr<Part>> divide(const Job& job)
    {
        const auto tetras = static_cast<std::size_t>(job.tetras.tetraCount());
        const std::size_t wanted = std::clamp<std::size_t>(tetras / kTetrasInPart, 1, kMostParts);
        const std::size_t count =
            std::clamp<std::size_t>(kMostCounters / std::max<std::size_t>(job.bins(), 1), 1, wanted);
        while (parts.size() < count)
            parts.push_back(std::make_unique<Part>());
        for (std::size_t i = 0; i < count; ++i) {
            parts[i]->firstTetra = tetras * i / count;
            parts[i]->endTetra = tetras * (i + 1) / count;
        }
        return std::span(parts).first(count);
    }
};

StackSlicer::StackSlicer() : d(std::make_unique<Private>()) {}
StackSlicer::~StackSlicer() = default;

namespace {

/// Turns what the parts counted into places: box by box and plane by plane, in each part by part. False: too
/// many records.
bool findPlaces(const Job& job, std::span<const std::unique_ptr<Part>> parts, PolygonStack& stack)
{
    std::uint64_t records = 0, triangles = 0;
    const std::size_t inner = job.order == StackOrder::byBrick ? job.samples : job.boxes.size();
    for (std::size_t bin = 0; bin < job.bins(); ++bin) {
        const std::uint64_t before = triangles;
        for (const auto& part : parts) {
            const StackCount count = std::exchange(part->counts[bin], stackCount(records, triangles));
            records += recordsOf(count);
            triangles += trianglesOf(count);
        }
        if (triangles == before) continue;
        const int brick = static_cast<int>(job.order == StackOrder::byBrick ? bin / inner : bin % inner);
        const bool goesOn =
            job.order == StackOrder::byBrick && !stack.runs.empty() && stack.runs.back().brick == brick;
        if (!goesOn) stack.runs.push_back({brick, 3 * before, 0});
        stack.runs.back().count = 3 * triangles - stack.runs.back().first;
    }
    if (records > UINT32_MAX) {
        stack.clear();
        return false;
    }
    stack.records.resize(static_cast<std::size_t>(records) *
                         static_cast<std::size_t>(job.tetras.valuesPerVertex));
    stack.indices.resize(3 * triangles);
    return true;
}

} // namespace

PolygonizeResult StackSlicer::slice(const TetraView& tetras, std::span<const Box> clipBoxes,
                                    const Camera& camera, const SamplingRequest& request, StackOrder order,
                                    int threads, PolygonStack& stack)
{
    const SamplingAxis axis = samplingAxis(tetras, camera, request);
    Job job{tetras, clipBoxes, order, samplingPlanes(tetras, axis, camera, request), axis.set.nearest};
    if (request.space == SamplingSpace::primitive) {
        job.own = &request;
        job.ownAxis = &axis;
    }
    return d->slice(job, threads, stack);
}

PolygonizeResult StackSlicer::slice(const TetraView& tetras, std::span<const Box> clipBoxes,
                                    const PlaneFamily& planes, StackOrder order, int threads,
                                    PolygonStack& stack)
{
    Job job{tetras, clipBoxes, order, planes, rangeOfSet(tetras, planes.normal).nearest};
    return d->slice(job, threads, stack);
}

PolygonizeResult StackSlicer::Private::slice(Job& job, int threads, PolygonStack& stack)
{
    stack.clear();
    job.samples = sampleCount(job);
    PolygonizeResult result{job.planes.count, job.planes.spacing, true};
    if (job.bins() == 0) return result;
    lattice.assign(job.boxes);
    const auto used = divide(job);
    placeVertices(job, threads);
    // Closures of two words: others would be put into memory of their own.
    parallelFor(used.size(), threads, [this, &job](std::size_t i) {
        parts[i]->cutter.assign(job.boxes);
        Looker(job, lattice, *parts[i]).lookAtAll();
    });
    job.stack = &stack;
    result.complete = findPlaces(job, used, stack);
    if (result.complete)
        parallelFor(used.size(), threads, [this, &job](std::size_t i) { writePart(job, *parts[i]); });
    return result;
}

} // namespace vo
