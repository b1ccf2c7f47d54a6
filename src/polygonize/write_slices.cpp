#include "polygonize/write_slices.h"

#include "core/highway_targets.h"

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "polygonize/write_slices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "polygonize/interleave-inl.h"
#include "polygonize/split_section-inl.h"
#include "polygonize/tetra_sections.h"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<DoubleTag>;
constexpr DoubleTag kDoubles;
constexpr hn::Rebind<float, DoubleTag> kFloats;
constexpr int kLanes = static_cast<int>(HWY_LANES(double) < 8 ? HWY_LANES(double) : 8);

/// Planes that are dealt with before the next ones; edges may be cut by a few more.
constexpr int kBlock = 64;
constexpr int kRow = kBlock + 8;
/// Edges by their two corners.
constexpr int kEdges = 6;
constexpr int kEdgeOf[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};

struct CutLine
{
    const float* from; ///< the end that comes first
    const float* to;
    double fromOffset, toOffset;
};

HWY_INLINE CutLine lineBetween(const TetraToSlice& tetra, std::size_t from, std::size_t to)
{
    return {tetra.corners[from], tetra.corners[to], tetra.places[from]->offset, tetra.places[to]->offset};
}

/// Where a line meets the planes from `begin` to `end`, and some more, in a row for each value.
template <int kValues>
HWY_INLINE void cutLine(const CutLine& line, const PlaneFamily& planes, int begin, int end, int values,
                        float* rows)
{
    const Doubles from = hn::Set(kDoubles, line.fromOffset), to = hn::Set(kDoubles, line.toOffset);
    const Doubles one = hn::Set(kDoubles, 1.0), zero = hn::Zero(kDoubles);
    const int count = kValues > 0 ? kValues : values;
    for (int plane = begin; plane < end; plane += kLanes) {
        const Doubles number = hn::Iota(kDoubles, static_cast<double>(plane));
        const Doubles offset =
            hn::Sub(hn::Set(kDoubles, planes.first), hn::Mul(number, hn::Set(kDoubles, planes.spacing)));
        const Doubles a = hn::Sub(from, offset), b = hn::Sub(to, offset);
        const Doubles s = hn::Div(a, hn::Sub(a, b));
        const auto atEnd = hn::Eq(s, one);
        for (int value = 0; value < count; ++value) {
            // -0 and 0 are one place
            const Doubles p = hn::Add(hn::Set(kDoubles, static_cast<double>(line.from[value])), zero);
            const Doubles q = hn::Add(hn::Set(kDoubles, static_cast<double>(line.to[value])), zero);
            const Doubles met = hn::Add(p, hn::Mul(s, hn::Sub(q, p)));
            hn::StoreU(hn::DemoteTo(kFloats, hn::IfThenElse(atEnd, q, met)), kFloats,
                       rows + value * kRow + plane - begin);
        }
    }
}

/// The place of a polygon; the next one of this plane comes after it.
template <int kVertices>
HWY_INLINE StackCount take(const SliceTarget& target, std::size_t bin)
{
    const StackCount place = target.next[bin];
    target.next[bin] = place + countOfPolygon(kVertices);
    return place;
}

/// The polygons of planes that meet the same edges. `cuts` holds the rows of each edge, from plane `block`
/// on.
template <int kValues, int kVertices>
HWY_INLINE void writeRun(const TetraSection& section, bool mirrored, const float* cuts, int block, int begin,
                         int end, int values, const SliceTarget& target)
{
    const int count = kValues > 0 ? kValues : values;
    const float* edges[kVertices];
    for (int vertex = 0; vertex < kVertices; ++vertex) {
        const int edge = mirrored ? kVertices - 1 - vertex : vertex;
        const auto [a, b] = section.edges[static_cast<std::size_t>(edge)];
        edges[vertex] = cuts + kEdgeOf[a][b] * count * kRow - block;
    }
    for (int k = begin; k < end; ++k) {
        const StackCount place = take<kVertices>(target, static_cast<std::size_t>(k));
        const std::uint32_t first = recordsOf(place);
        float* record = target.records + static_cast<std::size_t>(first) * static_cast<std::size_t>(count);
        for (int vertex = 0; vertex < kVertices; ++vertex)
            for (int value = 0; value < count; ++value)
                *record++ = edges[vertex][value * kRow + k];
        std::uint32_t* index = target.indices + std::size_t{3} * trianglesOf(place);
        for (std::uint32_t triangle = 1; triangle + 1 < kVertices; ++triangle) {
            *index++ = first + triangle;
            *index++ = first + triangle + 1;
            *index++ = first;
        }
    }
}

HWY_INLINE void sortFour(std::array<int, 4>& k)
{
    const auto order = [&](std::size_t a, std::size_t b) {
        const int low = std::min(k[a], k[b]), high = std::max(k[a], k[b]);
        k[a] = low;
        k[b] = high;
    };
    order(0, 1);
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
}

/// Between the planes at which one corner more comes in front the same edges are met.
template <int kValues>
HWY_INLINE void writeAll(const TetraToSlice& tetra, const PlaneFamily& planes, const SliceTarget& target,
                         float* cuts)
{
    const std::array<int, 4>& first = tetra.firstInFront;
    std::array<int, 4> changes = first;
    sortFour(changes);
    for (int block = changes[0]; block < changes[3]; block += kBlock) {
        const int last = std::min(block + kBlock, changes[3]);
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = a + 1; b < 4; ++b) {
                const int begin = std::max(std::min(first[a], first[b]), block);
                const int end = std::min(std::max(first[a], first[b]), last);
                if (begin < end)
                    cutLine<kValues>(lineBetween(tetra, a, b), planes, begin, end, tetra.values,
                                     cuts + kEdgeOf[a][b] * tetra.values * kRow + begin - block);
            }
        for (std::size_t i = 0; i < 3; ++i) {
            const int begin = std::max(changes[i], block), end = std::min(changes[i + 1], last);
            if (begin >= end) continue;
            unsigned mask = 0;
            for (unsigned corner = 0; corner < 4; ++corner)
                mask |= (first[corner] <= begin ? 1u : 0u) << corner;
            if (i == 1)
                writeRun<kValues, 4>(kTetraSections[mask], tetra.mirrored, cuts, block, begin, end,
                                     tetra.values, target);
            else
                writeRun<kValues, 3>(kTetraSections[mask], tetra.mirrored, cuts, block, begin, end,
                                     tetra.values, target);
        }
    }
}

/// Planes are too many streams for the processor to read ahead of writing.
constexpr std::size_t kAhead = 32;

#if HWY_MAX_BYTES >= 32
constexpr hn::FixedTag<double, 2> kTwo;
constexpr hn::FixedTag<std::uint32_t, 8> kEightNumbers;

/// A value of each of four corners, or of one end of each of four edges.
struct FourPlaces
{
    Four x, y, z, offset;
};

HWY_INLINE FourPlaces placesOf(const TetraToSlice& tetra)
{
    const auto row = [&](std::size_t i)
                         HWY_ATTR { return hn::LoadU(kFourFloats, tetra.places[i]->position.data()); };
    const auto a = row(0), b = row(1), c = row(2), d = row(3);
    const auto ab = hn::InterleaveLower(kFourFloats, a, b), cd = hn::InterleaveLower(kFourFloats, c, d);
    const auto abNext = hn::InterleaveUpper(kFourFloats, a, b),
               cdNext = hn::InterleaveUpper(kFourFloats, c, d);
    const auto offset = [&](std::size_t i) HWY_ATTR { return hn::LoadU(kTwo, &tetra.places[i]->offset); };
    const auto low = hn::InterleaveLower(kTwo, offset(0), offset(1));
    const auto high = hn::InterleaveLower(kTwo, offset(2), offset(3));
    return {hn::PromoteTo(kFour, hn::ConcatLowerLower(kFourFloats, cd, ab)),
            hn::PromoteTo(kFour, hn::ConcatUpperUpper(kFourFloats, cd, ab)),
            hn::PromoteTo(kFour, hn::ConcatLowerLower(kFourFloats, cdNext, abNext)),
            hn::Combine(kFour, high, low)};
}

HWY_INLINE FourPlaces pick(const FourPlaces& corners, const std::array<std::int64_t, 4>& numbers)
{
    const auto from = hn::SetTableIndices(kFour, numbers.data());
    return {hn::TableLookupLanes(corners.x, from), hn::TableLookupLanes(corners.y, from),
            hn::TableLookupLanes(corners.z, from), hn::TableLookupLanes(corners.offset, from)};
}

/// A polygon's records and triangles, by whether it has four vertices.
struct PolygonSize
{
    StackCount count;
    std::size_t lastRecords; ///< of the last four numbers of four records, those that are its own
    std::size_t indices;
};
constexpr PolygonSize kSizes[2] = {{countOfPolygon(3), 1, 3}, {countOfPolygon(4), 4, 6}};

HWY_INLINE void writePolygon(const FourPlaces& met, bool quad, const SliceTarget& target, std::size_t bin)
{
    const PolygonSize& size = kSizes[quad];
    const StackCount place = target.next[bin];
    target.next[bin] = place + size.count;
    const std::uint32_t first = recordsOf(place);
    float* record = target.records + std::size_t{3} * first;
    std::uint32_t* index = target.indices + std::size_t{3} * trianglesOf(place);
    hwy::Prefetch(record + kAhead);
    hwy::Prefetch(index + kAhead);
    const auto x = hn::DemoteTo(kFourFloats, met.x), y = hn::DemoteTo(kFourFloats, met.y),
               z = hn::DemoteTo(kFourFloats, met.z);
#if HWY_MAX_BYTES >= 64
    hn::BlendedStore(rowsOfFour(x, y, z), hn::FirstN(kRowFloats, 8 + size.lastRecords), kRowFloats, record);
#else
    alignas(16) float records[12];
    hn::StoreInterleaved3(x, y, z, kFourFloats, records);
    hn::StoreU(hn::Load(kFourFloats, records), kFourFloats, record);
    hn::StoreU(hn::Load(kFourFloats, records + 4), kFourFloats, record + 4);
    hn::BlendedStore(hn::Load(kFourFloats, records + 8), hn::FirstN(kFourFloats, size.lastRecords),
                     kFourFloats, record + 8);
#endif
    alignas(32) constexpr std::uint32_t kFan[8] = {1, 2, 0, 2, 3, 0, 0, 0};
    hn::BlendedStore(hn::Add(hn::Set(kEightNumbers, first), hn::Load(kEightNumbers, kFan)),
                     hn::FirstN(kEightNumbers, size.indices), kEightNumbers, index);
}

/// Of four edges, where each meets the planes.
struct FourEdges
{
    FourPlaces from;
    Four x, y, z; ///< to the other end
    FourPlaces to;

    HWY_INLINE FourEdges(const FourPlaces& corners, const EdgeEnds& edges)
        : from(pick(corners, edges.from)), to(pick(corners, edges.to))
    {
        x = hn::Sub(to.x, from.x);
        y = hn::Sub(to.y, from.y);
        z = hn::Sub(to.z, from.z);
    }
    HWY_INLINE FourPlaces meet(double plane) const
    {
        const Four offset = hn::Set(kFour, plane);
        const Four a = hn::Sub(from.offset, offset), b = hn::Sub(to.offset, offset);
        const Four s = hn::Div(a, hn::Sub(a, b));
        const auto atEnd = hn::Eq(s, hn::Set(kFour, 1.0));
        const auto met = [&](Four p, Four q, Four edge)
                             HWY_ATTR { return hn::IfThenElse(atEnd, q, hn::Add(p, hn::Mul(s, edge))); };
        return {met(from.x, to.x, x), met(from.y, to.y, y), met(from.z, to.z, z), s};
    }
};

/// Below so many planes, looking for those that meet the same edges costs more than it spares.
constexpr int kFewPlanes = 12;

HWY_INLINE int nextChange(const std::array<int, 4>& firstInFront, int plane, int end)
{
    for (const int change : firstInFront)
        end = change > plane ? std::min(end, change) : end;
    return end;
}

/// writeAll for records that are positions.
HWY_INLINE void writePositionsOf(const TetraToSlice& tetra, const PlaneFamily& planes,
                                 const SliceTarget& target)
{
    const FourPlaces corners = placesOf(tetra);
    const auto first = hn::LoadU(kFourInts, tetra.firstInFront.data());
    const int begin = hn::GetLane(hn::MinOfLanes(kFourInts, first));
    const int end = hn::GetLane(hn::MaxOfLanes(kFourInts, first));
    const bool few = end - begin < kFewPlanes;
    for (int k = begin; k < end;) {
        std::uint8_t mask[8];
        hn::StoreMaskBits(kFourInts, hn::Lt(first, hn::Set(kFourInts, k + 1)), mask);
        const FourEdges edges(corners, kEdgeEnds[tetra.mirrored][mask[0]]);
        const bool quad = kTetraSections[mask[0]].count == 4;
        const int stop = few ? k + 1 : nextChange(tetra.firstInFront, k, end);
        do
            writePolygon(edges.meet(planes.offset(k)), quad, target, static_cast<std::size_t>(k));
        while (++k < stop);
    }
}
#endif

HWY_INLINE void findPlaces(const PlacedVertex* places, const int* vertices, std::uint8_t order,
                           TetraToSlice& tetra)
{
    for (std::size_t i = 0; i < 4; ++i) {
        tetra.places[i] = places + vertices[cornerAt(order, i)];
        tetra.firstInFront[i] = tetra.places[i]->firstInFront;
    }
}

/// Triangles of fans.
constexpr std::size_t kMostOfFan = 24;
struct Fan
{
    alignas(64) std::array<std::uint32_t, 32> numbers{};
    constexpr Fan()
    {
        for (std::uint32_t i = 0; i < kMostOfFan / 3; ++i) {
            numbers[3 * i] = i + 1;
            numbers[3 * i + 1] = i + 2;
        }
    }
};
constexpr Fan kFans;

/// Writes the first `count` of at most kMostOfFan numbers: seldom more than one vector has.
template <class Number, class Value>
HWY_INLINE void writeFirst(const Value& valueAt, std::size_t count, Number* to)
{
    constexpr hn::CappedTag<Number, 16> kTag;
    constexpr std::size_t kStep = HWY_LANES(Number) < 16 ? HWY_LANES(Number) : 16;
    std::size_t i = 0;
    for (; i + kStep < count; i += kStep)
        hn::StoreU(valueAt(kTag, i), kTag, to + i);
    hn::BlendedStore(valueAt(kTag, i), hn::FirstN(kTag, count - i), kTag, to + i);
}

/// Triangles of a polygon of so many vertices, at most kMostOfFan numbers.
HWY_INLINE void writeFan(std::uint32_t first, std::size_t vertices, std::uint32_t* index)
{
    writeFirst(
        [first](auto tag, std::size_t i)
            HWY_ATTR { return hn::Add(hn::Set(tag, first), hn::LoadU(tag, kFans.numbers.data() + i)); },
        3 * (vertices - 2), index);
}

void writeSectionsOfTarget(std::span<const CutSections::Section> sections, const float* records,
                           std::size_t toNextBox, const SliceTarget& target)
{
    for (const CutSections::Section& section : sections) {
        const std::size_t count = section.records;
        StackCount& next = target.next[static_cast<std::size_t>(section.box) * toNextBox +
                                       static_cast<std::size_t>(section.sample)];
        const std::uint32_t first = recordsOf(next);
        float* record = target.records + std::size_t{3} * first;
        std::uint32_t* index = target.indices + std::size_t{3} * trianglesOf(next);
        next += countOfPolygon(count);
        hwy::Prefetch(record + kAhead);
        hwy::Prefetch(index + kAhead);
        if (3 * count <= kMostOfFan) {
            writeFirst([records](auto tag, std::size_t i) HWY_ATTR { return hn::LoadU(tag, records + i); },
                       3 * count, record);
            writeFan(first, count, index);
        } else {
            std::copy_n(records, 3 * count, record);
            for (std::uint32_t i = 1; i + 1 < count; ++i)
                for (const std::uint32_t corner : {i, i + 1, 0u})
                    *index++ = first + corner;
        }
        records += 3 * count;
    }
}

#if HWY_MAX_BYTES >= 32
/// Writes the slices of a tetrahedron and the parts of those that a face across kAxis parts.
template <std::size_t kAxis>
class HalvesWriter
{
public:
    HWY_INLINE HalvesWriter(const HalvedTetra& half, const SliceTarget& target, std::size_t toNextBox)
        : face_(half.face), target_(target)
    {
        for (std::size_t side = 0; side < 2; ++side) {
            wanted_[side] = half.boxes[side] >= 0;
            if (wanted_[side])
                next_[side] = target.next + static_cast<std::size_t>(half.boxes[side]) * toNextBox;
        }
    }

    /// Which slices the face parts nobody foresees: all of a batch are made before any is written.
    HWY_INLINE void write(const TetraToSlice& tetra, const PlaneFamily& planes, int end)
    {
        const FourPlaces corners = placesOf(tetra);
        const auto first = hn::LoadU(kFourInts, tetra.firstInFront.data());
        FourEdges edges(corners, kEdgeEnds[0][0]);
        unsigned last = 0;
        for (int begin = hn::GetLane(hn::MinOfLanes(kFourInts, first)); begin < end; begin += kBatch) {
            const int stop = std::min(begin + kBatch, end);
            for (int k = begin; k < stop; ++k) {
                std::uint8_t mask[8];
                hn::StoreMaskBits(kFourInts, hn::Lt(first, hn::Set(kFourInts, k + 1)), mask);
                if (mask[0] != last) edges = FourEdges(corners, kEdgeEnds[tetra.mirrored][mask[0]]);
                last = mask[0];
                slice(edges.meet(planes.offset(k)), static_cast<unsigned>(kTetraSections[last].count),
                      batch_[k - begin]);
            }
            for (int k = begin; k < stop; ++k)
                writeSlice(batch_[k - begin], static_cast<std::size_t>(k));
        }
    }

private:
    struct Slice
    {
        FourPlaces at;
        unsigned count;
        unsigned less; ///< a bit for each vertex below the face
    };

    HWY_INLINE void slice(const FourPlaces& met, unsigned count, Slice& slice) const
    {
        const Four& x = kAxis == 0 ? met.x : kAxis == 1 ? met.y : met.z;
        slice = {met, count, ((1u << count) - 1) & bitsOfFour(hn::Lt(x, hn::Set(kFour, face_)))};
    }

    HWY_INLINE void writeSlice(const Slice& slice, std::size_t plane) const
    {
        const unsigned all = (1u << slice.count) - 1;
        if (slice.less == 0 || slice.less == all) {
            const std::size_t side = slice.less == 0;
            if (!wanted_[side]) return;
            writePolygon(slice.at, slice.count == 4, {target_.records, target_.indices, next_[side]}, plane);
            return;
        }
        const Four at[kAxes] = {slice.at.x, slice.at.y, slice.at.z};
        const SplitSection split(at, slice.count, kAxis, face_);
        for (std::size_t side = 0; side < 2; ++side)
            if (wanted_[side])
                writePart(split, kSplits[slice.count - 3][slice.less][side], next_[side][plane]);
    }

    HWY_INLINE void writePart(const SplitSection& split, const SplitPart& part, StackCount& next) const
    {
        const std::size_t count = part.count;
        const std::uint32_t first = recordsOf(next);
        float* const record = target_.records + std::size_t{3} * first;
        std::uint32_t* const index = target_.indices + std::size_t{3} * trianglesOf(next);
        next += countOfPolygon(count);
        hwy::Prefetch(record + kAhead);
        hwy::Prefetch(index + kAhead);
#if HWY_MAX_BYTES >= 64
        hn::BlendedStore(split.row(part), hn::FirstN(kRowFloats, 3 * count), kRowFloats, record);
#else
        alignas(32) float row[3 * kMostVertices];
        split.store(part, row);
        writeFirst([&row](auto tag, std::size_t i) HWY_ATTR { return hn::LoadU(tag, row + i); }, 3 * count,
                   record);
#endif
        writeFan(first, count, index);
    }

    static constexpr int kBatch = 16;
    double face_;
    const SliceTarget& target_;
    std::array<bool, 2> wanted_;
    std::array<StackCount*, 2> next_{};
    Slice batch_[kBatch];
};
#endif

template <std::size_t kAxis>
HWY_NOINLINE void
writeHalf([[maybe_unused]] const TetraSource& source, [[maybe_unused]] const HalvedTetra& half,
          [[maybe_unused]] const PlaneFamily& planes, [[maybe_unused]] const SliceTarget& target)
{
#if HWY_MAX_BYTES >= 32
    TetraToSlice tetra{{}, 3, {}, {}, half.mirrored};
    findPlaces(source.places, source.vertices + std::size_t{4} * half.tetra, half.order, tetra);
    HalvesWriter<kAxis>(half, target, source.toNextBox).write(tetra, planes, half.end);
#endif
}

void writeHalvesOfTarget(std::span<const HalvedTetra> tetras, const TetraSource& source,
                         const PlaneFamily& planes, const SliceTarget& target)
{
    for (const HalvedTetra& half : tetras) {
        switch (half.axis) {
        case 0: writeHalf<0>(source, half, planes, target); break;
        case 1: writeHalf<1>(source, half, planes, target); break;
        default: writeHalf<2>(source, half, planes, target); break;
        }
    }
}

void writePositionsOfTarget(std::span<const SlicedTetra> tetras, const TetraSource& source,
                            const PlaneFamily& planes, const SliceTarget& target)
{
    for (const SlicedTetra& item : tetras) {
        TetraToSlice tetra{{}, 3, {}, {}, item.mirrored};
        findPlaces(source.places, source.vertices + std::size_t{4} * item.tetra, item.order, tetra);
        SliceTarget ofBox = target;
        ofBox.next += static_cast<std::size_t>(item.box) * source.toNextBox;
#if HWY_MAX_BYTES >= 32
        writePositionsOf(tetra, planes, ofBox);
#else
        for (std::size_t i = 0; i < 4; ++i)
            tetra.corners[i] = tetra.places[i]->position.data();
        float cuts[kEdges * 3 * kRow];
        writeAll<3>(tetra, planes, ofBox, cuts);
#endif
    }
}

void writeSlicesOfTarget(const TetraToSlice& tetra, const PlaneFamily& planes, const SliceTarget& target,
                         std::vector<float>& scratch)
{
    const std::size_t needed =
        static_cast<std::size_t>(kEdges * kRow) * static_cast<std::size_t>(tetra.values);
    if (scratch.size() < needed) scratch.resize(needed);
    writeAll<0>(tetra, planes, target, scratch.data());
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

HWY_EXPORT(writeSlicesOfTarget);
HWY_EXPORT(writePositionsOfTarget);
HWY_EXPORT(writeSectionsOfTarget);
HWY_EXPORT(writeHalvesOfTarget);

void writeSlices(const TetraToSlice& tetra, const PlaneFamily& planes, const SliceTarget& target,
                 std::vector<float>& scratch)
{
    HWY_DYNAMIC_DISPATCH(writeSlicesOfTarget)(tetra, planes, target, scratch);
}

void writePositions(std::span<const SlicedTetra> tetras, const TetraSource& from, const PlaneFamily& planes,
                    const SliceTarget& target)
{
    HWY_DYNAMIC_DISPATCH(writePositionsOfTarget)(tetras, from, planes, target);
}

void writeHalves(std::span<const HalvedTetra> tetras, const TetraSource& from, const PlaneFamily& planes,
                 const SliceTarget& target)
{
    HWY_DYNAMIC_DISPATCH(writeHalvesOfTarget)(tetras, from, planes, target);
}

void writeSections(std::span<const CutSections::Section> sections, const float* records,
                   std::size_t toNextBox, const SliceTarget& target)
{
    HWY_DYNAMIC_DISPATCH(writeSectionsOfTarget)(sections, records, toNextBox, target);
}

} // namespace vo
#endif
