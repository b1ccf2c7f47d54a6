#include "polygonize/cut_sections.h"

#include "core/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "polygonize/cut_sections.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "polygonize/box_lattice.h"
#include "polygonize/interleave-inl.h"
#include "polygonize/split_section-inl.h"
#include "polygonize/tetra_sections.h"

#include <algorithm>
#include <bit>
#include <tuple>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_MAX_BYTES >= 32
using DoubleTag = hn::CappedTag<double, kMostVertices>;
constexpr DoubleTag kDoubles;
constexpr hn::Rebind<float, DoubleTag> kFloats;
constexpr hn::Rebind<std::int64_t, DoubleTag> kNumbers;
constexpr std::size_t kLanes = HWY_LANES(double) < kMostVertices ? HWY_LANES(double) : kMostVertices;
constexpr std::size_t kParts = kMostVertices / kLanes;

/// A value of each vertex.
struct Eight
{
    hn::Vec<DoubleTag> part[kParts];
};

/// A bit for each vertex of which `test` is true.
template <class Test, class... Values>
HWY_INLINE unsigned bitsOf(const Test& test, const Values&... values)
{
    unsigned bits = 0;
    for (std::size_t i = 0; i < kParts; ++i) {
        std::uint8_t ofPart[8];
        hn::StoreMaskBits(kDoubles, test(values.part[i]...), ofPart);
        bits |= static_cast<unsigned>(ofPart[0]) << i * kLanes;
    }
    return bits;
}

/// `yes` where a bit is set, elsewhere `no`.
HWY_INLINE Eight choose(unsigned bits, const Eight& yes, const Eight& no)
{
    Eight result;
    for (std::size_t i = 0; i < kParts; ++i) {
        const std::uint8_t ofPart[8] = {static_cast<std::uint8_t>(bits >> i * kLanes)};
        result.part[i] = hn::IfThenElse(hn::LoadMaskBits(kDoubles, ofPart), yes.part[i], no.part[i]);
    }
    return result;
}

/// values[from[i]] at i.
HWY_INLINE Eight pick(const Eight& values, const Places& from)
{
    Eight result;
#if HWY_MAX_BYTES >= 64
    result.part[0] = hn::TableLookupLanes(values.part[0], hn::SetTableIndices(kDoubles, from.data()));
#else
    alignas(64) double table[kMostVertices];
    for (std::size_t i = 0; i < kParts; ++i)
        hn::Store(values.part[i], kDoubles, table + i * kLanes);
    for (std::size_t i = 0; i < kParts; ++i)
        result.part[i] = hn::GatherIndex(kDoubles, table, hn::LoadU(kNumbers, from.data() + i * kLanes));
#endif
    return result;
}

/// 0 to 7 are vertices, 8 to 15 the cuts of the edges that begin there.
class Picked
{
public:
    /// What has a bit of these, in order round the polygon.
    HWY_INLINE Picked(unsigned vertices, unsigned cuts)
    {
        const unsigned chosen = kSpread[vertices] | kSpread[cuts] << 1u;
#if HWY_MAX_BYTES >= 64
        constexpr hn::FixedTag<std::uint32_t, 16> kSlots;
        alignas(64) constexpr std::uint32_t kSlotNumbers[16] = {0, 8,  1, 9,  2, 10, 3, 11,
                                                                4, 12, 5, 13, 6, 14, 7, 15};
        const std::uint8_t bits[8] = {static_cast<std::uint8_t>(chosen),
                                      static_cast<std::uint8_t>(chosen >> 8u)};
        const auto slots = hn::Compress(hn::Load(kSlots, kSlotNumbers), hn::LoadMaskBits(kSlots, bits));
        const auto numbers = hn::BitCast(
            kNumbers, hn::PromoteTo(hn::Rebind<std::uint64_t, DoubleTag>(), hn::LowerHalf(slots)));
        const auto seven = hn::Set(kNumbers, 7);
        fromCuts_ = hn::RebindMask(kDoubles, hn::Gt(numbers, seven));
        numbers_ = hn::IndicesFromVec(kDoubles, hn::And(numbers, seven));
#else
        std::size_t count = 0;
        for (unsigned left = chosen; left != 0 && count < kMostVertices; left &= left - 1) {
            const int slot = std::countr_zero(left);
            numbers_[count++] = slot / 2 + slot % 2 * 8;
        }
        for (; count < kMostVertices; ++count)
            numbers_[count] = 0;
#endif
    }

    HWY_INLINE Eight of(const Eight& vertices, const Eight& cuts) const
    {
        Eight result;
#if HWY_MAX_BYTES >= 64
        result.part[0] = hn::IfThenElse(fromCuts_, hn::TableLookupLanes(cuts.part[0], numbers_),
                                        hn::TableLookupLanes(vertices.part[0], numbers_));
#else
        alignas(64) double table[2 * kMostVertices];
        for (std::size_t i = 0; i < kParts; ++i) {
            hn::Store(vertices.part[i], kDoubles, table + i * kLanes);
            hn::Store(cuts.part[i], kDoubles, table + kMostVertices + i * kLanes);
        }
        for (std::size_t i = 0; i < kParts; ++i)
            result.part[i] =
                hn::GatherIndex(kDoubles, table, hn::LoadU(kNumbers, numbers_.data() + i * kLanes));
#endif
        return result;
    }

private:
    /// Bit i at 2 i.
    static constexpr std::array<std::uint16_t, 256> kSpread = [] {
        std::array<std::uint16_t, 256> spread{};
        for (unsigned bits = 0; bits < 256; ++bits)
            for (unsigned i = 0; i < 8; ++i)
                spread[bits] = static_cast<std::uint16_t>(spread[bits] | (bits >> i & 1u) << 2 * i);
        return spread;
    }();
#if HWY_MAX_BYTES >= 64
    decltype(hn::IndicesFromVec(kDoubles, hn::Zero(kNumbers))) numbers_;
    hn::Mask<DoubleTag> fromCuts_;
#else
    Places numbers_;
#endif
};

/// Bits of the vertices after each.
HWY_INLINE unsigned bitsOfNext(unsigned bits, unsigned count)
{
    return bits >> 1u | (bits & 1u) << (count - 1);
}

struct Polygon
{
    Eight at[kAxes];
    unsigned count;
};

class SectionCutter
{
public:
    HWY_INLINE SectionCutter(const TetraSections& tetra, const BoxesNearby& boxes, CutSections& sections)
        : tetra_(tetra), boxes_(boxes), sections_(sections)
    {
        alignas(32) double column[4];
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            findRegions(axis);
            for (std::size_t corner = 0; corner < 4; ++corner)
                column[corner] = tetra.corners[corner * kAxes + axis];
            corners_[axis] = hn::Load(kFour, column);
        }
        offsets_ = hn::LoadU(kFour, tetra.offsets);
        firstInFront_ = hn::LoadU(kFourInts, tetra.firstInFront);
    }

    HWY_INLINE int cut(const PlaneFamily& planes, int begin, int end)
    {
        switch (axisOfOnlyFace()) {
        case 0: return cutBatches<0>(planes, begin, end);
        case 1: return cutBatches<1>(planes, begin, end);
        case 2: return cutBatches<2>(planes, begin, end);
        default: return cutBatches<kAxes>(planes, begin, end);
        }
    }

private:
    /// Or kAxes: several faces are near, or none.
    HWY_INLINE std::size_t axisOfOnlyFace() const
    {
        std::size_t cutting = 0, only = kAxes;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            if (!boxes_.axes[axis].cuts) continue;
            ++cutting;
            only = axis;
        }
        return cutting == 1 && boxes_.axes[only].faceCount == 1 && !overlap_ ? only : kAxes;
    }

    /// All slices of a batch are made before any is cut: which boxes they meet nobody foresees, and the
    /// processor would wait for the divisions each time. kOnlyAxis: of the only face that is near, or kAxes.
    template <std::size_t kOnlyAxis>
    HWY_NOINLINE int cutBatches(const PlaneFamily& planes, int begin, int end)
    {
        for (; begin < end; begin += kBatch) {
            const int last = std::min(begin + kBatch, end);
            for (int sample = begin; sample < last; ++sample)
                slice<kOnlyAxis>(planes, sample, batch_[sample - begin]);
            makeRoom();
            bool good = true;
            for (sample_ = begin; sample_ < last && good; ++sample_) {
                CutSections::Section* const section = section_;
                float* const record = record_;
                good = kOnlyAxis < kAxes ? cutAtFace<kOnlyAxis % kAxes>(batch_[sample_ - begin])
                                         : cutSection(batch_[sample_ - begin]);
                if (good) continue;
                section_ = section;
                record_ = record;
            }
            sections_.sections.resize(static_cast<std::size_t>(section_ - sections_.sections.data()));
            sections_.records.resize(static_cast<std::size_t>(record_ - sections_.records.data()));
            if (!good) return sample_ - 1;
        }
        return end;
    }

    /// The ends of the edges that planes meet.
    HWY_INLINE void findEdges(unsigned mask)
    {
        const EdgeEnds& edges = kEdgeEnds[tetra_.mirrored][mask];
        count_ = static_cast<unsigned>(kTetraSections[mask].count);
        const auto from = hn::SetTableIndices(kFour, edges.from.data());
        const auto to = hn::SetTableIndices(kFour, edges.to.data());
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            from_[axis] = hn::TableLookupLanes(corners_[axis], from);
            to_[axis] = hn::TableLookupLanes(corners_[axis], to);
        }
        fromOffset_ = hn::TableLookupLanes(offsets_, from);
        toOffset_ = hn::TableLookupLanes(offsets_, to);
    }

    /// A slice, and on which sides of the faces near it its vertices lie: a bit for each.
    struct Section
    {
        Four at[kAxes];
        unsigned count;
        std::array<std::array<std::uint8_t, BoxesNearby::kMostFaces>, kAxes> less, greater;
    };

    template <std::size_t kOnlyAxis>
    HWY_INLINE void slice(const PlaneFamily& planes, int sample, Section& section)
    {
        std::uint8_t inFront[8];
        hn::StoreMaskBits(kFourInts, hn::Lt(firstInFront_, hn::Set(kFourInts, sample + 1)), inFront);
        const unsigned mask = inFront[0];
        if (mask != mask_) findEdges(mask);
        mask_ = mask;
        const Four offset = hn::Set(kFour, planes.offset(sample));
        section.count = count_;
        meet(from_, to_, hn::Sub(fromOffset_, offset), hn::Sub(toOffset_, offset), section.at);
        const unsigned all = (1u << count_) - 1;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            if (kOnlyAxis < kAxes ? axis != kOnlyAxis : !boxes_.axes[axis].cuts) continue;
            const Four x = snapped(boxes_.axes[axis], section.at[axis]);
            section.at[axis] = x;
            const std::size_t faceCount = kOnlyAxis < kAxes ? 1 : boxes_.axes[axis].faceCount;
            for (std::size_t face = 0; face < faceCount; ++face) {
                const Four at = hn::Set(kFour, boxes_.axes[axis].faces[face]);
                section.less[axis][face] = static_cast<std::uint8_t>(all & bitsOfFour(hn::Lt(x, at)));
                section.greater[axis][face] = static_cast<std::uint8_t>(all & bitsOfFour(hn::Gt(x, at)));
            }
        }
    }

    HWY_INLINE Four snapped(const BoxesNearby::Axis& axis, Four x) const
    {
        for (std::size_t face = 0; face < axis.faceCount; ++face) {
            const Four at = hn::Set(kFour, axis.faces[face]);
            const auto near = hn::Le(hn::Abs(hn::Sub(at, x)), hn::Set(kFour, BoxLattice::kSnapDistance));
            x = hn::IfThenElse(near, at, x);
        }
        return x;
    }

    /// The intervals between the faces of an axis.
    HWY_INLINE void findRegions(std::size_t axis)
    {
        const BoxesNearby::Axis& near = boxes_.axes[axis];
        for (std::size_t region = 0; region <= BoxesNearby::kMostFaces; ++region) {
            std::int32_t& found = regions_[axis][region];
            found = near.cuts ? kNoInterval : 0;
            for (std::size_t i = 0; near.cuts && i < near.intervalCount; ++i) {
                const auto [lower, upper] = near.intervals[i];
                const int r = static_cast<int>(region);
                if (r <= lower || (upper >= 0 && r > upper)) continue;
                if (found != kNoInterval) overlap_ = true;
                found = static_cast<std::int32_t>(i);
            }
        }
    }

    HWY_INLINE std::int32_t boxAt(const std::array<std::size_t, 3>& regions) const
    {
        std::int32_t cell = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t interval = regions_[axis][regions[axis]];
            if (interval == kNoInterval) return -1;
            cell = cell * static_cast<std::int32_t>(BoxesNearby::kMostIntervals) + interval;
        }
        return boxes_.box[static_cast<std::size_t>(cell)];
    }

    /// False: not to be done here.
    HWY_INLINE bool cutSection(const Section& section)
    {
        const unsigned all = (1u << section.count) - 1;
        std::array<std::size_t, kAxes> regions{};
        std::size_t crossed = 0, crossedAxis = 0;
        bool onFace = overlap_;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            if (!boxes_.axes[axis].cuts) continue;
            for (std::size_t face = 0; face < boxes_.axes[axis].faceCount; ++face) {
                const unsigned less = section.less[axis][face], greater = section.greater[axis][face];
                onFace = onFace || (less | greater) != all;
                regions[axis] += greater == all;
                const bool crosses = less != 0 && greater != 0;
                crossed += crosses;
                crossedAxis = crosses ? axis : crossedAxis;
            }
        }
        if (onFace || crossed > 1) return cutAlong<0>(polygonOf(section), 0);
        if (crossed == 0)
            emitWhole(section, boxAt(regions));
        else
            splitAt(section, crossedAxis, regions);
        return true;
    }

    /// cutSection where one face is near.
    template <std::size_t kAxis>
    HWY_INLINE bool cutAtFace(const Section& section)
    {
        const unsigned all = (1u << section.count) - 1;
        const unsigned less = section.less[kAxis][0], greater = section.greater[kAxis][0];
        if ((less | greater) != all) return cutAlong<0>(polygonOf(section), 0);
        std::array<std::size_t, kAxes> regions{};
        if (less != 0 && greater != 0) {
            splitAt(section, kAxis, regions);
            return true;
        }
        regions[kAxis] = greater != 0;
        emitWhole(section, boxAt(regions));
        return true;
    }

    HWY_INLINE Polygon polygonOf(const Section& section) const
    {
        Polygon polygon;
        polygon.count = section.count;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            alignas(64) double column[kMostVertices] = {};
            hn::Store(section.at[axis], kFour, column);
            for (std::size_t i = 0; i < kParts; ++i)
                polygon.at[axis].part[i] = hn::Load(kDoubles, column + i * kLanes);
        }
        return polygon;
    }

    HWY_INLINE void emitWhole(const Section& section, std::int32_t box)
    {
        if (box < 0) return;
        const auto x = hn::DemoteTo(kFourFloats, section.at[0]), y = hn::DemoteTo(kFourFloats, section.at[1]),
                   z = hn::DemoteTo(kFourFloats, section.at[2]);
#if HWY_MAX_BYTES >= 64
        hn::StoreU(rowsOfFour(x, y, z), kRowFloats, append(box, section.count));
#else
        hn::StoreInterleaved3(x, y, z, kFourFloats, append(box, section.count));
#endif
    }

    /// Parts it at the only face that it crosses, which begins the region above.
    HWY_INLINE void splitAt(const Section& section, std::size_t axis, std::array<std::size_t, kAxes> regions)
    {
        const double face = boxes_.axes[axis].faces[regions[axis]];
        const unsigned less = section.less[axis][regions[axis]];
        const SplitSection split(section.at, section.count, axis, face);
        for (const SplitPart& part : kSplits[section.count - 3][less]) {
            const std::int32_t box = boxAt(regions);
            ++regions[axis];
            if (box < 0) continue;
            split.store(part, append(box, part.count));
        }
    }

    /// What a face cuts of a polygon.
    struct FaceCut
    {
        unsigned less, greater; ///< vertices
        bool known;
        unsigned crossing; ///< edges
        Eight at[kAxes];   ///< the points on them
    };

    HWY_INLINE void cutWithFace(const Polygon& polygon, std::size_t column, double face, FaceCut& cut) const
    {
        if (cut.known) return;
        cut.known = true;
        cut.crossing = (cut.less & bitsOfNext(cut.greater, polygon.count)) |
                       (cut.greater & bitsOfNext(cut.less, polygon.count));
        Eight next[kAxes];
        for (std::size_t axis = 0; axis < kAxes; ++axis)
            next[axis] = pick(polygon.at[axis], kNext[polygon.count]);
        for (std::size_t i = 0; i < kParts; ++i) {
            hn::Vec<DoubleTag> p[kAxes], q[kAxes], a[kAxes], b[kAxes];
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
                p[axis] = polygon.at[axis].part[i];
                q[axis] = next[axis].part[i];
            }
            inOrder(p, q, a, b);
            const auto at = hn::Set(kDoubles, face);
            hn::Vec<DoubleTag> met[kAxes];
            meet(a, b, hn::Sub(a[column], at), hn::Sub(b[column], at), met);
            met[column] = at;
            for (std::size_t axis = 0; axis < kAxes; ++axis)
                cut.at[axis].part[i] = met[axis];
        }
    }

    /// Cuts to each interval of an axis, and what is left along the next axis. False: not to be done here.
    template <std::size_t kAxis>
    HWY_INLINE bool cutAlong(const Polygon& polygon, std::size_t cell)
    {
        if constexpr (kAxis == 3) {
            emit(polygon, boxes_.box[cell]);
            return true;
        } else {
            cell *= BoxesNearby::kMostIntervals;
            const BoxesNearby::Axis& axis = boxes_.axes[kAxis];
            if (!axis.cuts) return cutAlong<kAxis + 1>(polygon, cell);
            return cutToIntervals<kAxis>(polygon, cell);
        }
    }

    template <std::size_t kAxis>
    HWY_NOINLINE bool cutToIntervals(const Polygon& polygon, std::size_t cell)
    {
        const BoxesNearby::Axis& axis = boxes_.axes[kAxis];
        constexpr std::size_t column = kAxis;
        const unsigned all = (1u << polygon.count) - 1;
        FaceCut cuts[BoxesNearby::kMostFaces];
        for (std::size_t face = 0; face < axis.faceCount; ++face) {
            const auto at = hn::Set(kDoubles, axis.faces[face]);
            const Eight& x = polygon.at[column];
            cuts[face].less = all & bitsOf([at](auto a) HWY_ATTR { return hn::Lt(a, at); }, x);
            cuts[face].greater = all & bitsOf([at](auto a) HWY_ATTR { return hn::Gt(a, at); }, x);
            cuts[face].known = false;
            if ((cuts[face].less | cuts[face].greater) == 0) return false;
        }
        for (std::size_t i = 0; i < axis.intervalCount; ++i) {
            const auto [lower, upper] = axis.intervals[i];
            const unsigned below = lower < 0 ? 0 : cuts[lower].less;
            const unsigned above = upper < 0 ? 0 : cuts[upper].greater;
            if ((lower >= 0 && cuts[lower].greater == 0) || (upper >= 0 && cuts[upper].less == 0)) continue;
            if ((below | above) == 0) {
                if (!cutAlong<kAxis + 1>(polygon, cell + i)) return false;
                continue;
            }
            Polygon part;
            if (below != 0)
                cutWithFace(polygon, column, axis.faces[static_cast<std::size_t>(lower)], cuts[lower]);
            if (above != 0)
                cutWithFace(polygon, column, axis.faces[static_cast<std::size_t>(upper)], cuts[upper]);
            if (!take(polygon, all & ~(below | above), below ? &cuts[lower] : nullptr,
                      above ? &cuts[upper] : nullptr, part))
                return false;
            if (part.count > 2 && !cutAlong<kAxis + 1>(part, cell + i)) return false;
        }
        return true;
    }

    /// The vertices that stay, and the cuts of one face or two.
    HWY_INLINE bool take(const Polygon& polygon, unsigned stay, const FaceCut* lower, const FaceCut* upper,
                         Polygon& part) const
    {
        const FaceCut& cut = lower ? *lower : *upper;
        unsigned crossing = cut.crossing;
        Eight both[kAxes];
        const Eight* met = cut.at;
        if (lower && upper) {
            if ((lower->crossing & upper->crossing) != 0) return false;
            crossing |= upper->crossing;
            for (std::size_t axis = 0; axis < kAxes; ++axis)
                both[axis] = choose(upper->crossing, upper->at[axis], lower->at[axis]);
            met = both;
        }
        part.count = static_cast<unsigned>(std::popcount(stay) + std::popcount(crossing));
        if (part.count > kMostVertices) return false;
        const Picked picked(stay, crossing);
        for (std::size_t axis = 0; axis < kAxes; ++axis)
            part.at[axis] = picked.of(polygon.at[axis], met[axis]);
        return true;
    }

    HWY_INLINE void emit(const Polygon& polygon, std::int32_t box)
    {
        if (box < 0) return;
        float* const records = append(box, polygon.count);
        const auto rounded = [&](std::size_t axis, std::size_t part)
                                 HWY_ATTR { return hn::DemoteTo(kFloats, polygon.at[axis].part[part]); };
        for (std::size_t i = 0; i < kParts; ++i)
            hn::StoreInterleaved3(rounded(0, i), rounded(1, i), rounded(2, i), kFloats,
                                  records + kAxes * i * kLanes);
    }

    /// For all that a batch may give.
    HWY_INLINE void makeRoom()
    {
        constexpr std::size_t kMostParts = kBatch * std::tuple_size_v<decltype(BoxesNearby::box)>;
        section_ = sections_.sections.grow(kMostParts);
        record_ = sections_.records.grow(kMostParts * kAxes * kMostVertices);
    }

    /// Where a section's records go; there is room for those of kMostVertices.
    HWY_INLINE float* append(std::int32_t box, unsigned count)
    {
        *section_++ = {box, sample_, count};
        float* const records = record_;
        record_ += kAxes * count;
        return records;
    }

    const TetraSections& tetra_;
    const BoxesNearby& boxes_;
    CutSections& sections_;
    static constexpr std::int32_t kNoInterval = -1;
    std::array<std::array<std::int32_t, BoxesNearby::kMostFaces + 1>, 3> regions_; ///< their intervals
    bool overlap_ = false;                                                         ///< of intervals
    CutSections::Section* section_ = nullptr;                                      ///< the next one
    float* record_ = nullptr;                                                      ///< and its records
    int sample_ = 0;
    unsigned mask_ = 0;  ///< the corners in front, whose
    unsigned count_ = 0; ///< edges are these
    Four corners_[kAxes], offsets_;
    hn::Vec<decltype(kFourInts)> firstInFront_;
    Four from_[kAxes], to_[kAxes], fromOffset_, toOffset_;
    static constexpr int kBatch = 16;
    Section batch_[kBatch];
};
#endif

int cutSectionsOfTarget([[maybe_unused]] const TetraSections& tetra,
                        [[maybe_unused]] const BoxesNearby& boxes, [[maybe_unused]] const PlaneFamily& planes,
                        int begin, [[maybe_unused]] int end, [[maybe_unused]] CutSections& sections)
{
#if HWY_MAX_BYTES >= 32
    return SectionCutter(tetra, boxes, sections).cut(planes, begin, end);
#else
    return begin;
#endif
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

HWY_EXPORT(cutSectionsOfTarget);

int cutSections(const TetraSections& tetra, const BoxesNearby& boxes, const PlaneFamily& planes, int begin,
                int end, CutSections& sections)
{
    return HWY_DYNAMIC_DISPATCH(cutSectionsOfTarget)(tetra, boxes, planes, begin, end, sections);
}

} // namespace vo
#endif
