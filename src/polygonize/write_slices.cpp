#include "polygonize/write_slices.h"

// Targets that add nothing here to those that are kept, and vectors of unknown length.
#define HWY_DISABLED_TARGETS                                                                                 \
    (HWY_AVX3_DL | HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "polygonize/write_slices.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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

/// Planes that go together.
constexpr int kBlock = 8;
/// Edges by their two corners.
constexpr int kEdges = 6;
constexpr int kEdgeOf[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};

struct CutLine
{
    const float* from; ///< the end that comes first, by position, then by the rest
    const float* to;
    double fromOffset, toOffset;
    int begin, end; ///< planes between the ends
};

HWY_INLINE bool comesBefore(const float* a, const float* b, int values)
{
    for (int i = values - 3; i < values; ++i)
        if (a[i] != b[i]) return a[i] < b[i];
    for (int i = 0; i < values - 3; ++i)
        if (a[i] != b[i]) return a[i] < b[i];
    return false;
}

HWY_INLINE int findLines(const TetraToSlice& tetra, const PlaneFamily& planes, CutLine* lines)
{
    double offsets[4];
    for (std::size_t i = 0; i < 4; ++i) {
        const float* p = tetra.corners[i] + tetra.values - 3;
        offsets[i] = planes.normal.x * p[0] + planes.normal.y * p[1] + planes.normal.z * p[2];
    }
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = a + 1; b < 4; ++b) {
            const bool swapped = comesBefore(tetra.corners[b], tetra.corners[a], tetra.values);
            const std::size_t from = swapped ? b : a, to = swapped ? a : b;
            lines[kEdgeOf[a][b]] = {tetra.corners[from],
                                    tetra.corners[to],
                                    offsets[from],
                                    offsets[to],
                                    std::min(tetra.firstInFront[a], tetra.firstInFront[b]),
                                    std::max(tetra.firstInFront[a], tetra.firstInFront[b])};
        }
    return kEdges;
}

/// Where a line meets kBlock planes from `first` on, value by value.
template <int kValues>
HWY_INLINE void cutLine(const CutLine& line, const PlaneFamily& planes, int first, int values, float* out)
{
    const Doubles from = hn::Set(kDoubles, line.fromOffset), to = hn::Set(kDoubles, line.toOffset);
    const Doubles one = hn::Set(kDoubles, 1.0), zero = hn::Zero(kDoubles);
    const int count = kValues > 0 ? kValues : values;
    for (int lane = 0; lane < kBlock; lane += kLanes) {
        const Doubles number = hn::Iota(kDoubles, static_cast<double>(first + lane));
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
                       out + value * kBlock + lane);
        }
    }
}

/// The polygon of one plane of a block.
template <int kValues>
HWY_INLINE void writePolygon(const TetraSection& section, const float* cuts, int lane, int values,
                             std::size_t plane, const SliceTarget& target)
{
    const int count = kValues > 0 ? kValues : values;
    std::uint32_t& nextRecord = target.nextRecord[plane * target.stride];
    std::size_t& nextIndex = target.nextIndex[plane * target.stride];
    const std::uint32_t first = nextRecord;
    float* record = target.records + static_cast<std::size_t>(first) * static_cast<std::size_t>(count);
    for (int vertex = 0; vertex < section.count; ++vertex, record += count) {
        const auto [a, b] = section.edges[static_cast<std::size_t>(vertex)];
        const float* cut = cuts + kEdgeOf[a][b] * count * kBlock + lane;
        for (int value = 0; value < count; ++value)
            record[value] = cut[value * kBlock];
    }
    std::uint32_t* index = target.indices + nextIndex;
    index[0] = first + 1;
    index[1] = first + 2;
    index[2] = first;
    if (section.count == 4) {
        index[3] = first + 2;
        index[4] = first + 3;
        index[5] = first;
    }
    nextRecord = first + static_cast<std::uint32_t>(section.count);
    nextIndex += section.count == 4 ? 6 : 3;
}

template <int kValues>
HWY_INLINE void writeAll(const TetraToSlice& tetra, const PlaneFamily& planes, const SliceTarget& target,
                         float* cuts)
{
    CutLine lines[kEdges];
    findLines(tetra, planes, lines);
    const auto [begin, end] = std::minmax_element(tetra.firstInFront.begin(), tetra.firstInFront.end());
    for (int block = *begin; block < *end; block += kBlock) {
        const int last = std::min(block + kBlock, *end);
        for (int edge = 0; edge < kEdges; ++edge)
            if (lines[edge].begin < last && lines[edge].end > block)
                cutLine<kValues>(lines[edge], planes, block, tetra.values,
                                 cuts + edge * tetra.values * kBlock);
        for (int k = block; k < last; ++k) {
            unsigned mask = 0;
            for (unsigned corner = 0; corner < 4; ++corner)
                mask |= (tetra.firstInFront[corner] <= k ? 1u : 0u) << corner;
            writePolygon<kValues>(kTetraSections[mask], cuts, k - block, tetra.values,
                                  static_cast<std::size_t>(k), target);
        }
    }
}

void writeSlicesOfTarget(const TetraToSlice& tetra, const PlaneFamily& planes, const SliceTarget& target,
                         std::vector<float>& scratch)
{
    if (tetra.values == 3) {
        float cuts[kEdges * 3 * kBlock];
        writeAll<3>(tetra, planes, target, cuts);
        return;
    }
    const std::size_t needed =
        static_cast<std::size_t>(kEdges * kBlock) * static_cast<std::size_t>(tetra.values);
    if (scratch.size() < needed) scratch.resize(needed);
    writeAll<0>(tetra, planes, target, scratch.data());
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

HWY_EXPORT(writeSlicesOfTarget);

void writeSlices(const TetraToSlice& tetra, const PlaneFamily& planes, const SliceTarget& target,
                 std::vector<float>& scratch)
{
    HWY_DYNAMIC_DISPATCH(writeSlicesOfTarget)(tetra, planes, target, scratch);
}

} // namespace vo
#endif
