#include "polygonize/count_halves.h"

#include "core/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "polygonize/count_halves.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "polygonize/box_lattice.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_MAX_BYTES >= 32
using DoubleTag = hn::CappedTag<double, kCountsBeyond>;
using Doubles = hn::Vec<DoubleTag>;
using Mask = hn::Mask<DoubleTag>;
constexpr DoubleTag kDoubles;
constexpr hn::Rebind<std::uint64_t, DoubleTag> kNumbers;
using Numbers = hn::Vec<decltype(kNumbers)>;
constexpr int kLanes =
    static_cast<int>(HWY_LANES(double) < kCountsBeyond ? HWY_LANES(double) : kCountsBeyond);

/// An edge of the tetrahedron, and on which side of the face planes meet it.
class Edge
{
public:
    HWY_INLINE void assign(const PlacedVertex& from, const PlacedVertex& to, std::size_t axis)
    {
        const auto place = [axis](const PlacedVertex& vertex) {
            return static_cast<double>(vertex.position[axis]);
        };
        begin_ = std::min(from.firstInFront, to.firstInFront);
        end_ = std::max(from.firstInFront, to.firstInFront);
        fromOffset_ = from.offset;
        toOffset_ = to.offset;
        from_ = place(from);
        to_ = place(to);
    }

    /// Where the edge is met, farther from the face than coordinates are drawn to it.
    struct Sides
    {
        Mask less, greater;
        Mask neither;
    };
    HWY_INLINE Sides sides(Doubles plane, Doubles offset, double face) const
    {
        const Doubles from = hn::Set(kDoubles, from_), to = hn::Set(kDoubles, to_);
        const Doubles a = hn::Sub(hn::Set(kDoubles, fromOffset_), offset);
        const Doubles b = hn::Sub(hn::Set(kDoubles, toOffset_), offset);
        const Doubles s = hn::Div(a, hn::Sub(a, b));
        const Doubles x = hn::IfThenElse(hn::Eq(s, hn::Set(kDoubles, 1.0)), to,
                                         hn::Add(from, hn::Mul(s, hn::Sub(to, from))));
        const Doubles below = hn::Sub(hn::Set(kDoubles, face), x);
        const Mask met =
            hn::And(hn::Ge(plane, hn::Set(kDoubles, begin_)), hn::Lt(plane, hn::Set(kDoubles, end_)));
        const Mask less = hn::And(met, hn::Gt(below, hn::Set(kDoubles, BoxLattice::kSnapDistance)));
        const Mask greater = hn::And(met, hn::Lt(below, hn::Set(kDoubles, -BoxLattice::kSnapDistance)));
        return {less, greater, hn::AndNot(hn::Or(less, greater), met)};
    }

private:
    double begin_, end_; ///< of the planes that meet it
    double from_, to_;
    double fromOffset_, toOffset_;
};

/// How many vertices slices have on either side of the face.
struct Halves
{
    Numbers less, greater;
    Mask bothLess, bothGreater; ///< two opposite edges
    Mask odd;                   ///< vertices too close to the face

    HWY_INLINE Halves()
        : less(hn::Zero(kNumbers)), greater(less), bothLess(hn::MaskFromVec(hn::Zero(kDoubles))),
          bothGreater(bothLess), odd(bothLess)
    {
    }
    HWY_INLINE void add(const Edge::Sides& edge, const Edge::Sides& opposite)
    {
        bothLess = hn::Or(bothLess, hn::And(edge.less, opposite.less));
        bothGreater = hn::Or(bothGreater, hn::And(edge.greater, opposite.greater));
        for (const Edge::Sides* sides : {&edge, &opposite}) {
            less = hn::Sub(less, hn::VecFromMask(kNumbers, hn::RebindMask(kNumbers, sides->less)));
            greater = hn::Sub(greater, hn::VecFromMask(kNumbers, hn::RebindMask(kNumbers, sides->greater)));
            odd = hn::Or(odd, sides->neither);
        }
    }
    /// Slices whose vertices lie on both sides in turns are none of a plane's, but for rounding.
    HWY_INLINE bool good() const
    {
        return hn::AllFalse(kDoubles, hn::Or(odd, hn::And(bothLess, bothGreater)));
    }
    /// Of polygons of `own` vertices, and two more where the face parts a slice.
    HWY_INLINE Numbers counts(Numbers own) const
    {
        const Numbers zero = hn::Zero(kNumbers), two = hn::Set(kNumbers, 2);
        const auto parted = hn::And(hn::Ne(less, zero), hn::Ne(greater, zero));
        const Numbers vertices = hn::Add(own, hn::IfThenElseZero(parted, two));
        const Numbers counts = hn::Add(vertices, hn::ShiftLeft<32>(hn::Sub(vertices, two)));
        return hn::IfThenElseZero(hn::Ne(own, zero), counts);
    }
};

HWY_INLINE void addTo(StackCount* counts, Numbers more)
{
    if (counts) hn::StoreU(hn::Add(hn::LoadU(kNumbers, counts), more), kNumbers, counts);
}

/// Opposite edges.
constexpr std::size_t kPairs[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
#endif

int countHalvesOfTarget(const std::array<const PlacedVertex*, 4>& corners,
                        [[maybe_unused]] const HalvedTetra& tetra, [[maybe_unused]] const PlaneFamily& planes,
                        [[maybe_unused]] const std::array<StackCount*, 2>& counts)
{
    const auto first = [&](std::size_t i) { return corners[i]->firstInFront; };
    const auto [begin, end] = std::minmax({first(0), first(1), first(2), first(3)});
#if HWY_MAX_BYTES >= 32
    Edge edges[3][2];
    for (std::size_t pair = 0; pair < 3; ++pair)
        for (std::size_t i = 0; i < 2; ++i)
            edges[pair][i].assign(*corners[kPairs[pair][2 * i]], *corners[kPairs[pair][2 * i + 1]],
                                  tetra.axis);
    for (int k = begin; k < end; k += kLanes) {
        const Doubles plane = hn::Iota(kDoubles, static_cast<double>(k));
        const Doubles offset =
            hn::Sub(hn::Set(kDoubles, planes.first), hn::Mul(plane, hn::Set(kDoubles, planes.spacing)));
        Halves halves;
        for (const auto& pair : edges)
            halves.add(pair[0].sides(plane, offset, tetra.face), pair[1].sides(plane, offset, tetra.face));
        if (!halves.good()) return k;
        addTo(counts[0] ? counts[0] + k : nullptr, halves.counts(halves.less));
        addTo(counts[1] ? counts[1] + k : nullptr, halves.counts(halves.greater));
    }
    return end;
#else
    return begin;
#endif
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

HWY_EXPORT(countHalvesOfTarget);

int countHalves(const std::array<const PlacedVertex*, 4>& corners, const HalvedTetra& tetra,
                const PlaneFamily& planes, const std::array<StackCount*, 2>& counts)
{
    return HWY_DYNAMIC_DISPATCH(countHalvesOfTarget)(corners, tetra, planes, counts);
}

} // namespace vo
#endif
