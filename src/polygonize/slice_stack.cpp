#include "polygonize/slice_stack.h"

#include "core/parallel.h"
#include "polygonize/box_cutter.h"
#include "polygonize/box_lattice.h"
#include "polygonize/count_halves.h"
#include "polygonize/look_at_tetras.h"
#include "polygonize/slice_cutter.h"
#include "polygonize/slice_tetra.h"
#include "polygonize/write_slices.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace vo {

namespace {

/// Parts of the work that threads take one by one; the same for any number of them.
constexpr std::size_t kTetrasInPart = 2048;
constexpr std::size_t kMostParts = 64;
constexpr std::size_t kVerticesInPart = 8192;
/// Counters of all parts together; one thread goes through them.
constexpr std::size_t kMostCounters = std::size_t{1} << 20;

/// Of each axis: what intervalAt() says of a vertex.
using Intervals = std::array<std::int32_t, 3>;

glm::dvec3 positionOf(const PlacedVertex& vertex)
{
    return {vertex.position[0], vertex.position[1], vertex.position[2]};
}

/// A plane for each of four corners.
using Planes = std::array<std::int32_t, 4>;

/// A tetrahedron's corners, in order.
struct Corners
{
    std::array<std::int32_t, 4> vertices;
    std::array<const PlacedVertex*, 4> places;
    Planes firstInFront;
    bool mirrored; ///< in this order
};

struct Part
{
    std::size_t firstTetra = 0, endTetra = 0;
    KeptArray<SlicedTetra> items;
    KeptArray<HalvedTetra> halved;
    CutSections aside; ///< where boxes have cut slices, until the place of all is known
    /// A row for each box, of one counter more than there are planes: first by how much a plane has more than
    /// the one before, then how much it has, then the place of the next polygon. Behind these, how much each
    /// plane has in `aside`. Rows of boxes without polygons are not touched.
    std::vector<StackCount> counts;
    std::vector<std::uint8_t> hasPolygons; ///< of each box

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
    PolygonStack* stack = nullptr;        ///< where they are written
    const PlacedVertex* places = nullptr; ///< all vertices
    const Intervals* intervals = nullptr; ///< of all vertices

    /// Of counters, from a box to the next.
    std::size_t row() const { return toAside() + samples; }
    std::size_t toAside() const { return samples + 1; }
    StackCount* rowOf(Part& part, int box) const
    {
        return part.counts.data() + static_cast<std::size_t>(box) * row();
    }
    PlaneFamily planesOf(std::size_t tetra) const
    {
        return own ? primitivePlanes(tetras, static_cast<int>(tetra), *ownAxis, *own) : planes;
    }
    /// The first plane in front of each corner.
    void findPlanes(std::size_t tetra, const std::array<const PlacedVertex*, 4>& corners,
                    Planes& firstInFront) const
    {
        for (std::size_t i = 0; i < 4; ++i)
            firstInFront[i] = corners[i]->firstInFront;
        if (!own) return;
        const PlaneFamily of = planesOf(tetra);
        for (std::size_t i = 0; i < 4; ++i)
            firstInFront[i] = firstPlaneInFront(of, nearest, corners[i]->offset);
    }
    /// That of all these vertices, or BoxLattice::kNearFace.
    std::int32_t commonInterval(const std::array<std::int32_t, 4>& vertices, std::size_t axis) const
    {
        const auto at = [&](std::size_t i) { return intervals[static_cast<std::size_t>(vertices[i])][axis]; };
        return (at(0) == at(1)) & (at(0) == at(2)) & (at(0) == at(3)) ? at(0) : BoxLattice::kNearFace;
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
        part_.halved.clear();
        part_.aside.clear(job_.tetras.valuesPerVertex);
        part_.counts.resize(job_.boxes.size() * job_.row() + kCountsBeyond);
        part_.hasPolygons.assign(job_.boxes.size(), 0);
        for (std::size_t tetra = part_.firstTetra; tetra < part_.endTetra; tetra += TetraLooks::kMost)
            lookAtSome(tetra, std::min(TetraLooks::kMost, part_.endTetra - tetra));
        part_.aside.end();
        for (std::size_t box = 0; box < job_.boxes.size(); ++box)
            if (part_.hasPolygons[box] != 0) sumUp(job_.rowOf(part_, static_cast<int>(box)));
    }

private:
    struct LookedAt
    {
        std::uint32_t tetra;
        std::uint8_t order;
        bool mirrored;
    };

    void lookAtSome(std::size_t first, std::size_t count)
    {
        const std::span<const int> vertices = job_.tetras.indices.subspan(4 * first, 4 * count);
        lookAtTetras(job_.places, vertices, looks_);
        for (std::size_t i = 0; i < count; ++i) {
            if (looks_.solid[i] == 0) continue;
            Planes changes{looks_.changes[0][i], looks_.changes[1][i], looks_.changes[2][i],
                           looks_.changes[3][i]};
            const LookedAt tetra{static_cast<std::uint32_t>(first + i),
                                 static_cast<std::uint8_t>(looks_.order[i]), looks_.mirrored[i] != 0};
            const std::int32_t box = looks_.box[i];
            if (box < 0 || job_.own)
                addCut(tetra, box, changes);
            else if (changes[0] != changes[3])
                addWhole(tetra, box, changes);
        }
    }

    void addWhole(const LookedAt& tetra, std::int32_t box, const Planes& changes)
    {
        addTo(box, changes);
        *part_.items.grow(1) = {tetra.tetra, box, 0, tetra.order, tetra.mirrored};
    }

    /// What needs its corners, because faces are near or planes its own.
    void addCut(const LookedAt& tetra, std::int32_t box, Planes& changes)
    {
        Corners corners{{}, {}, {}, tetra.mirrored};
        findCorners(tetra, corners);
        if (job_.own) {
            changes = corners.firstInFront;
            std::ranges::sort(changes);
        }
        if (changes[0] == changes[3]) return;
        if (box >= 0) {
            addWhole(tetra, box, changes);
            return;
        }
        const int begin = addHalved(tetra, corners, changes[0]);
        if (begin == changes[3] || !reachesBoxes(corners)) return;
        cutAside(tetra.tetra, corners, begin);
        *part_.items.grow(1) = {tetra.tetra, SlicedTetra::kCut,
                                static_cast<std::uint32_t>(part_.aside.sections.size()), tetra.order,
                                tetra.mirrored};
    }

    void findCorners(const LookedAt& tetra, Corners& corners) const
    {
        for (std::size_t i = 0; i < 4; ++i) {
            corners.vertices[i] =
                job_.tetras.indices[std::size_t{4} * tetra.tetra + cornerAt(tetra.order, i)];
            corners.places[i] = job_.places + corners.vertices[i];
        }
        job_.findPlanes(tetra.tetra, corners.places, corners.firstInFront);
    }

    bool reachesBoxes(const Corners& corners) const
    {
        BoxLattice::Cell cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            cell[axis] = job_.commonInterval(corners.vertices, axis);
            if (cell[axis] == BoxLattice::kBelow || cell[axis] == BoxLattice::kAbove) return false;
        }
        const bool inside = std::ranges::all_of(cell, [](int interval) { return interval >= 0; });
        return !inside || !lattice_.boxes(cell).empty();
    }

    void sumUp(StackCount* row) const
    {
        StackCount sum = 0;
        for (std::size_t sample = 0; sample < job_.samples; ++sample) {
            sum += row[sample];
            row[sample] = sum + row[job_.toAside() + sample];
        }
    }

    StackCount* countersOf(int box)
    {
        StackCount* const row = job_.rowOf(part_, box);
        std::uint8_t& has = part_.hasPolygons[static_cast<std::size_t>(box)];
        if (has == 0) std::fill_n(row, job_.row(), StackCount{0});
        has = 1;
        return row;
    }

    void addTo(int box, const Planes& changes)
    {
        StackCount* const counts = countersOf(box);
        counts[changes[0]] += countOfPolygon(3);
        counts[changes[1]] += countOfPolygon(4) - countOfPolygon(3);
        counts[changes[2]] -= countOfPolygon(4) - countOfPolygon(3);
        counts[changes[3]] -= countOfPolygon(3);
    }

    /// What face parts it, if all others are far.
    std::optional<HalvedTetra> halvesOf(const LookedAt& tetra, const Corners& corners) const
    {
        HalvedTetra half{tetra.tetra, tetra.order, tetra.mirrored, 3, 0, 0.0, {-1, -1}};
        BoxLattice::Cell cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            cell[axis] = job_.commonInterval(corners.vertices, axis);
            if (cell[axis] >= 0) continue;
            if (half.axis < 3) return {};
            half.axis = static_cast<std::uint8_t>(axis);
        }
        if (half.axis == 3 || !findFace(corners, half, cell)) return {};
        for (std::size_t side = 0; side < 2; ++side, ++cell[half.axis]) {
            const auto boxes = lattice_.boxes(cell);
            if (boxes.size() > 1) return {};
            if (!boxes.empty()) half.boxes[side] = boxes.front().box;
        }
        return half;
    }

    /// The face between the intervals that hold the corners; `cell` gets the lower one.
    bool findFace(const Corners& corners, HalvedTetra& half, BoxLattice::Cell& cell) const
    {
        const std::size_t axis = half.axis;
        const auto interval = [&](std::size_t i) {
            return job_.intervals[static_cast<std::size_t>(corners.vertices[i])][axis];
        };
        const auto [low, high] = std::minmax({interval(0), interval(1), interval(2), interval(3)});
        if (low < 0 || high != low + 1) return false;
        const auto intervals = lattice_.intervals(static_cast<int>(axis));
        const auto &lower = intervals[static_cast<std::size_t>(low)],
                   &upper = intervals[static_cast<std::size_t>(high)];
        if (lower.next != high) return false;
        half.face = lower.upper;
        cell[axis] = low;
        return std::ranges::all_of(corners.places, [&](const PlacedVertex* vertex) {
            const double x = vertex->position[axis];
            return x > lower.lower + BoxLattice::kMargin && x < upper.upper - BoxLattice::kMargin &&
                   std::abs(x - half.face) > BoxLattice::kMargin;
        });
    }

    /// Counts what one face makes of it. Returns the first plane that is left to do.
    int addHalved(const LookedAt& tetra, const Corners& corners, int begin)
    {
        if (job_.own || job_.tetras.valuesPerVertex != 3) return begin;
        std::optional<HalvedTetra> half = halvesOf(tetra, corners);
        if (!half) return begin;
        std::array<StackCount*, 2> counts{};
        for (std::size_t side = 0; side < 2; ++side)
            if (half->boxes[side] >= 0) counts[side] = countersOf(half->boxes[side]) + job_.toAside();
        half->end = countHalves(corners.places, *half, job_.planes, counts);
        if (half->end == begin) return begin;
        *part_.halved.grow(1) = *half;
        *part_.items.grow(1) = {tetra.tetra, SlicedTetra::kHalved, 0, tetra.order, tetra.mirrored};
        return half->end;
    }

    /// Slices it with the planes from `begin` on.
    void cutAside(std::size_t tetra, const Corners& corners, int begin)
    {
        const std::size_t first = part_.aside.sections.size();
        const PlaneFamily planes = job_.planesOf(tetra);
        switch (job_.tetras.valuesPerVertex) {
        case 3: cutWith<3>(corners, planes, begin); break;
        case 6: cutWith<6>(corners, planes, begin); break;
        case 7: cutWith<7>(corners, planes, begin); break;
        case 9: cutWith<9>(corners, planes, begin); break;
        case 10: cutWith<10>(corners, planes, begin); break;
        default: cutRecords(corners, planes); break;
        }
        for (const CutSections::Section& section : part_.aside.sections.all().subspan(first)) {
            StackCount* const counts = countersOf(section.box) + job_.toAside();
            counts[section.sample] += countOfPolygon(section.records);
        }
    }

    template <int kValues>
    void cutWith(const Corners& corners, const PlaneFamily& planes, int begin)
    {
        const int column = job_.tetras.voxelColumn;
        TetraInBoxes<kValues> tetra{{},
                                    static_cast<std::size_t>(column < 0 ? kValues - 3 : column),
                                    {},
                                    corners.firstInFront,
                                    corners.mirrored,
                                    {}};
        for (std::size_t i = 0; i < 4; ++i) {
            const float* source = job_.tetras.record(corners.vertices[i]);
            for (std::size_t value = 0; value < kValues; ++value)
                tetra.corners[i][value] = static_cast<double>(source[value]) + 0.0; // -0 and 0 are one place
            tetra.offsets[i] = corners.places[i]->offset;
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            tetra.interval[axis] = job_.commonInterval(corners.vertices, axis);
        SliceCutter<kValues>(lattice_).cut(tetra, planes, begin, part_.aside);
    }

    /// Slices it plane by plane and lets the boxes cut the slices.
    void cutRecords(Corners corners, const PlaneFamily& planes)
    {
        const int values = job_.tetras.valuesPerVertex;
        const auto size = static_cast<std::size_t>(values);
        if (part_.corners.size() < 4 * size) part_.corners.resize(4 * size);
        std::array<const double*, 4> records;
        std::array<double, 4> offsets;
        if (corners.mirrored) {
            std::swap(corners.vertices[0], corners.vertices[1]);
            std::swap(corners.firstInFront[0], corners.firstInFront[1]);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const float* source = job_.tetras.record(corners.vertices[i]);
            double* record = part_.corners.data() + i * size;
            for (std::size_t value = 0; value < size; ++value)
                record[value] = static_cast<double>(source[value]) + 0.0; // -0 and 0 are one place
            records[i] = record;
            offsets[i] =
                glm::dot(planes.normal, glm::dvec3(record[size - 3], record[size - 2], record[size - 1]));
        }
        const auto [begin, end] = std::ranges::minmax(corners.firstInFront);
        for (int k = begin; k < end; ++k) {
            std::array<double, 4> distances;
            unsigned mask = 0;
            for (unsigned i = 0; i < 4; ++i) {
                distances[i] = offsets[i] - planes.offset(k);
                mask |= (corners.firstInFront[i] <= k ? 1u : 0u) << i;
            }
            sliceTetra(records.data(), distances.data(), mask, values, part_.slice, job_.tetras.voxelColumn);
            part_.cutter.cut(part_.slice, k, part_.aside);
        }
    }

    const Job& job_;
    const BoxLattice& lattice_;
    Part& part_;
    TetraLooks looks_;
};

void placeVertex(const Job& job, const BoxLattice& lattice, std::size_t vertex, PlacedVertex& place,
                 Intervals& intervals)
{
    const float* record = job.tetras.record(static_cast<int>(vertex));
    const float* p = record + job.tetras.valuesPerVertex - 3;
    const float* voxel = job.tetras.voxelColumn >= 0 ? record + job.tetras.voxelColumn : p;
    place.position = {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};
    place.offset = glm::dot(job.planes.normal, positionOf(place));
    place.firstInFront = firstPlaneInFront(job.planes, job.nearest, place.offset);
    for (int axis = 0; axis < 3; ++axis)
        intervals[static_cast<std::size_t>(axis)] = lattice.intervalAt(axis, voxel[axis]);
    place.box = -1;
    if (std::ranges::any_of(intervals, [](std::int32_t interval) { return interval < 0; })) return;
    const auto boxes = lattice.boxes(intervals);
    if (boxes.size() == 1) place.box = boxes.front().box;
}

/// Sections and their records, from where they are on.
struct AsidePlace
{
    std::size_t section = 0;
    const float* records;
};

void writeAside(const Job& job, Part& part, AsidePlace& from, std::size_t end)
{
    PolygonStack& stack = *job.stack;
    const auto values = static_cast<std::size_t>(job.tetras.valuesPerVertex);
    if (values == 3) {
        const auto sections = part.aside.sections.all().subspan(from.section, end - from.section);
        const SliceTarget target{stack.records.data(), stack.indices.data(), part.counts.data()};
        writeSections(sections, from.records, job.row(), target);
        for (const CutSections::Section& section : sections)
            from.records += 3 * section.records;
        from.section = end;
        return;
    }
    for (; from.section < end; ++from.section) {
        const CutSections::Section section = part.aside.sections[from.section];
        StackCount& next = job.rowOf(part, section.box)[section.sample];
        const StackCount place = std::exchange(next, next + countOfPolygon(section.records));
        const std::uint32_t first = recordsOf(place);
        std::copy_n(from.records, section.records * values, stack.records.data() + first * values);
        from.records += section.records * values;
        std::uint32_t* index = stack.indices.data() + std::size_t{3} * trianglesOf(place);
        for (std::uint32_t i = 1; i + 1 < section.records; ++i) {
            *index++ = first + i;
            *index++ = first + i + 1;
            *index++ = first;
        }
    }
}

/// Tetrahedra that a box holds.
void writeTetras(const Job& job, Part& part, std::span<const SlicedTetra> items)
{
    PolygonStack& stack = *job.stack;
    const SliceTarget target{stack.records.data(), stack.indices.data(), part.counts.data()};
    if (job.tetras.valuesPerVertex == 3 && !job.own) {
        writePositions(items, {job.places, job.tetras.indices.data(), job.row()}, job.planes, target);
        return;
    }
    for (const SlicedTetra& item : items) {
        TetraToSlice tetra{{}, job.tetras.valuesPerVertex, {}, {}, item.mirrored};
        for (std::size_t i = 0; i < 4; ++i) {
            const int vertex = job.tetras.indices[std::size_t{4} * item.tetra + cornerAt(item.order, i)];
            tetra.corners[i] = job.tetras.record(vertex);
            tetra.places[i] = job.places + vertex;
        }
        job.findPlanes(item.tetra, tetra.places, tetra.firstInFront);
        SliceTarget ofBox = target;
        ofBox.next = job.rowOf(part, item.box);
        writeSlices(tetra, job.planesOf(item.tetra), ofBox, part.scratch);
    }
}

void writePart(const Job& job, Part& part)
{
    std::span<const SlicedTetra> items = part.items.all();
    std::span<const HalvedTetra> halved = part.halved.all();
    AsidePlace aside{0, part.aside.records.data()};
    const SliceTarget target{job.stack->records.data(), job.stack->indices.data(), part.counts.data()};
    while (!items.empty()) {
        const std::int32_t kind = std::min(items.front().box, 0);
        const auto other = std::ranges::find_if(
            items, [kind](const SlicedTetra& item) { return std::min(item.box, 0) != kind; });
        const auto run = items.first(static_cast<std::size_t>(other - items.begin()));
        items = items.subspan(run.size());
        if (kind == SlicedTetra::kCut)
            writeAside(job, part, aside, run.back().endAside);
        else if (kind == SlicedTetra::kHalved) {
            const TetraSource from{job.places, job.tetras.indices.data(), job.row()};
            writeHalves(halved.first(run.size()), from, job.planes, target);
            halved = halved.subspan(run.size());
        } else
            writeTetras(job, part, run);
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

namespace {

/// The parts' rows of counters of each box that have any polygons.
struct CounterRows
{
    std::vector<StackCount*> rows; ///< one box after the other
    std::vector<std::size_t> ends; ///< behind those of each box

    void collect(const Job& job, std::span<const std::unique_ptr<Part>> parts)
    {
        rows.clear();
        ends.clear();
        for (std::size_t box = 0; box < job.boxes.size(); ++box) {
            for (const auto& part : parts)
                if (part->hasPolygons[box] != 0) rows.push_back(job.rowOf(*part, static_cast<int>(box)));
            ends.push_back(rows.size());
        }
    }
    std::span<StackCount* const> of(std::size_t box) const
    {
        const std::size_t begin = box == 0 ? 0 : ends[box - 1];
        return std::span(rows).subspan(begin, ends[box] - begin);
    }
};

} // namespace

struct StackSlicer::Private
{
    BoxLattice lattice;
    std::vector<std::unique_ptr<Part>> parts;

    KeptArray<PlacedVertex> places;
    KeptArray<Intervals> intervals;
    CounterRows counters;

    PolygonizeResult slice(Job& job, int threads, PolygonStack& stack);

    void placeVertices(Job& job, int threads)
    {
        places.resize(job.tetras.records.size() / static_cast<std::size_t>(job.tetras.valuesPerVertex));
        intervals.resize(places.size());
        job.places = places.data();
        job.intervals = intervals.data();
        const std::size_t vertices = places.size();
        parallelFor((vertices + kVerticesInPart - 1) / kVerticesInPart, threads,
                    [this, &job](std::size_t part) {
                        const std::size_t end = std::min((part + 1) * kVerticesInPart, places.size());
                        for (std::size_t vertex = part * kVerticesInPart; vertex < end; ++vertex)
                            placeVertex(job, lattice, vertex, places[vertex], intervals[vertex]);
                    });
    }
    std::span<const std::unique_ptr<Part>> divide(const Job& job)
    {
        const auto tetras = static_cast<std::size_t>(job.tetras.tetraCount());
        const std::size_t wanted = std::clamp<std::size_t>(tetras / kTetrasInPart, 1, kMostParts);
        const std::size_t count =
            std::clamp<std::size_t>(kMostCounters / (job.boxes.size() * job.row()), 1, wanted);
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

/// Records and triangles so far.
struct StackSize
{
    std::uint64_t records = 0, triangles = 0;

    /// Counters of the same box and plane become places, part by part.
    void place(std::span<StackCount* const> rows, std::size_t sample)
    {
        for (StackCount* const row : rows) {
            const StackCount count = std::exchange(row[sample], stackCount(records, triangles));
            records += recordsOf(count);
            triangles += trianglesOf(count);
        }
    }
    void endRun(std::size_t box, std::uint64_t first, PolygonStack& stack) const
    {
        if (triangles != first)
            stack.runs.push_back({static_cast<int>(box), 3 * first, 3 * (triangles - first)});
    }
};

/// Turns what the parts counted into places, in the order of the stack. False: too many records.
bool findPlaces(const Job& job, const CounterRows& counters, PolygonStack& stack)
{
    StackSize size;
    if (job.order == StackOrder::byBrick) {
        for (std::size_t box = 0; box < job.boxes.size(); ++box) {
            const std::uint64_t first = size.triangles;
            for (std::size_t sample = 0; sample < job.samples; ++sample)
                size.place(counters.of(box), sample);
            size.endRun(box, first, stack);
        }
    } else {
        for (std::size_t sample = 0; sample < job.samples; ++sample)
            for (std::size_t box = 0; box < job.boxes.size(); ++box) {
                const std::uint64_t first = size.triangles;
                size.place(counters.of(box), sample);
                size.endRun(box, first, stack);
            }
    }
    const auto [records, triangles] = size;
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
    if (job.boxes.empty() || job.samples == 0) return result;
    lattice.assign(job.boxes);
    const auto used = divide(job);
    placeVertices(job, threads);
    // Closures of two words: others would be put into memory of their own.
    parallelFor(used.size(), threads, [this, &job](std::size_t i) {
        parts[i]->cutter.assign(job.boxes);
        Looker(job, lattice, *parts[i]).lookAtAll();
    });
    job.stack = &stack;
    counters.collect(job, used);
    result.complete = findPlaces(job, counters, stack);
    if (result.complete)
        parallelFor(used.size(), threads, [this, &job](std::size_t i) { writePart(job, *parts[i]); });
    return result;
}

} // namespace vo
