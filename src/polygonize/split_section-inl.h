// Slices of three or four vertices that a face parts. Included once for each set of instructions.

#if defined(VO_POLYGONIZE_SPLIT_SECTION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VO_POLYGONIZE_SPLIT_SECTION_INL_H
#undef VO_POLYGONIZE_SPLIT_SECTION_INL_H
#else
#define VO_POLYGONIZE_SPLIT_SECTION_INL_H
#endif

#include "polygonize/interleave-inl.h"

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_MAX_BYTES >= 32
/// Vertices that a polygon may have here.
constexpr std::size_t kMostVertices = 8;
constexpr std::size_t kAxes = 3;
using Places = std::array<std::int64_t, kMostVertices>;

/// The vertex after each, by how many there are.
constexpr std::array<Places, kMostVertices + 1> kNext = [] {
    std::array<Places, kMostVertices + 1> next{};
    for (std::size_t count = 1; count <= kMostVertices; ++count)
        for (std::size_t i = 0; i < kMostVertices; ++i)
            next[count][i] = static_cast<std::int64_t>(i + 1 < count ? i + 1 : 0);
    return next;
}();

/// The points where edges from `p` to `q`, of these distances, meet a plane.
template <class Values>
HWY_INLINE void meet(const Values* p, const Values* q, Values a, Values b, Values* met)
{
    const Values s = hn::Div(a, hn::Sub(a, b));
    const auto atEnd = hn::Eq(s, hn::Set(hn::DFromV<Values>(), 1.0));
    for (std::size_t axis = 0; axis < kAxes; ++axis)
        met[axis] = hn::IfThenElse(atEnd, q[axis], hn::Add(p[axis], hn::Mul(s, hn::Sub(q[axis], p[axis]))));
}

/// Turns edges so that they leave the end that comes first.
template <class Values>
HWY_INLINE void inOrder(const Values* p, const Values* q, Values* from, Values* to)
{
    const auto sameX = hn::Eq(q[0], p[0]), sameY = hn::And(sameX, hn::Eq(q[1], p[1]));
    const auto swapped = hn::Or(
        hn::Lt(q[0], p[0]), hn::Or(hn::And(sameX, hn::Lt(q[1], p[1])), hn::And(sameY, hn::Lt(q[2], p[2]))));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        from[axis] = hn::IfThenElse(swapped, q[axis], p[axis]);
        to[axis] = hn::IfThenElse(swapped, p[axis], q[axis]);
    }
}

constexpr hn::FixedTag<double, 4> kFour;
constexpr hn::FixedTag<float, 4> kFourFloats;
constexpr hn::FixedTag<std::int32_t, 4> kFourInts;
constexpr hn::FixedTag<float, 8> kEightFloats;
using Four = hn::Vec<decltype(kFour)>;

template <class Mask>
HWY_INLINE unsigned bitsOfFour(Mask mask)
{
    std::uint8_t bits[8];
    hn::StoreMaskBits(kFour, mask, bits);
    return bits[0];
}

/// What one side of a face has of a slice: 0 to 3 are its vertices, 4 to 7 the cuts of the edges that begin
/// there.
struct SplitPart
{
    alignas(32) std::array<std::int32_t, kMostVertices> places{};
    unsigned count = 0;
    /// Of the numbers of the first five vertices: the place, 8 more for y.
    alignas(64) std::array<std::int32_t, 16> numbers{};
};
/// By how many vertices there are but three, and a bit for each that is below the face: the parts below and
/// above.
constexpr std::array<std::array<std::array<SplitPart, 2>, 16>, 2> kSplits = [] {
    std::array<std::array<std::array<SplitPart, 2>, 16>, 2> splits{};
    for (unsigned count = 3; count <= 4; ++count)
        for (unsigned less = 0; less < 1u << count; ++less)
            for (unsigned side = 0; side < 2; ++side) {
                SplitPart& part = splits[count - 3][less][side];
                for (unsigned i = 0; i < count; ++i) {
                    const bool below = less >> i & 1u, nextBelow = less >> (i + 1) % count & 1u;
                    if (below == (side == 0)) part.places[part.count++] = static_cast<std::int32_t>(i);
                    if (below != nextBelow) part.places[part.count++] = static_cast<std::int32_t>(4 + i);
                }
                for (std::size_t i = 0; i < 15; ++i)
                    part.numbers[i] = static_cast<std::int32_t>(i % 3 == 1 ? 8 : 0) + part.places[i / 3];
            }
    return splits;
}();

/// The vertices of a slice and the points where its edges meet a face.
class SplitSection
{
public:
    HWY_INLINE SplitSection(const Four* vertices, unsigned count, std::size_t axis, double face)
    {
        Four next[kAxes], from[kAxes], to[kAxes], met[kAxes];
        const auto after = hn::SetTableIndices(kFour, kNext[count].data());
        for (std::size_t i = 0; i < kAxes; ++i)
            next[i] = hn::TableLookupLanes(vertices[i], after);
        inOrder(vertices, next, from, to);
        const Four at = hn::Set(kFour, face);
        meet(from, to, hn::Sub(from[axis], at), hn::Sub(to[axis], at), met);
        met[axis] = at;
        for (std::size_t i = 0; i < kAxes; ++i)
            all_[i] = hn::Combine(kEightFloats, hn::DemoteTo(kFourFloats, met[i]),
                                  hn::DemoteTo(kFourFloats, vertices[i]));
    }

#if HWY_MAX_BYTES >= 64
    /// The part's records, and behind them anything.
    HWY_INLINE hn::Vec<decltype(kRowFloats)> row(const SplitPart& part) const
    {
        constexpr std::uint8_t kThird[8] = {0x24, 0x49};
        const auto numbers = hn::SetTableIndices(kRowFloats, part.numbers.data());
        return hn::IfThenElse(hn::LoadMaskBits(kRowFloats, kThird),
                              hn::TableLookupLanes(hn::ZeroExtendVector(kRowFloats, all_[2]), numbers),
                              hn::TableLookupLanes(hn::Combine(kRowFloats, all_[1], all_[0]), numbers));
    }
#endif

    /// For `to` there is room for kMostVertices.
    HWY_INLINE void store(const SplitPart& part, float* to) const
    {
#if HWY_MAX_BYTES >= 64
        hn::StoreU(row(part), kRowFloats, to);
#else
        const auto places = hn::SetTableIndices(kEightFloats, part.places.data());
        hn::StoreInterleaved3(hn::TableLookupLanes(all_[0], places), hn::TableLookupLanes(all_[1], places),
                              hn::TableLookupLanes(all_[2], places), kEightFloats, to);
#endif
    }

private:
    hn::Vec<decltype(kEightFloats)> all_[kAxes]; ///< vertices, then points
};
#endif

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#endif
