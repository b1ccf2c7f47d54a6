#include "polygonize/look_at_tetras.h"

#include "core/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "polygonize/look_at_tetras.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<DoubleTag>;
constexpr DoubleTag kDoubles;
constexpr hn::Rebind<float, DoubleTag> kFloats;
constexpr hn::Rebind<std::int32_t, DoubleTag> kNumbers;
using Floats = hn::Vec<decltype(kFloats)>;
using Numbers = hn::Vec<decltype(kNumbers)>;

/// Corners of all tetrahedra.
struct Places
{
    /// x, y, z and the bits of the first plane in front, of each of four corners.
    alignas(64) std::array<std::array<std::array<float, TetraLooks::kMost>, 4>, 4> of;
};

/// One corner of four tetrahedra, sixteen vertex numbers.
HWY_INLINE void gatherCorner(const PlacedVertex* places, const int* vertices, std::size_t corner,
                             std::size_t at, Places& out)
{
    auto& columns = out.of[corner];
#if HWY_MAX_BYTES >= 16
    constexpr hn::FixedTag<float, 4> kFour;
    const auto row = [&](std::size_t tetra) HWY_ATTR {
        return hn::LoadU(kFour, places[vertices[4 * tetra + corner]].position.data());
    };
    const auto a = row(0), b = row(1), c = row(2), d = row(3);
    const auto ab = hn::InterleaveLower(kFour, a, b), cd = hn::InterleaveLower(kFour, c, d);
    const auto abNext = hn::InterleaveUpper(kFour, a, b), cdNext = hn::InterleaveUpper(kFour, c, d);
    hn::Store(hn::ConcatLowerLower(kFour, cd, ab), kFour, columns[0].data() + at);
    hn::Store(hn::ConcatUpperUpper(kFour, cd, ab), kFour, columns[1].data() + at);
    hn::Store(hn::ConcatLowerLower(kFour, cdNext, abNext), kFour, columns[2].data() + at);
    hn::Store(hn::ConcatUpperUpper(kFour, cdNext, abNext), kFour, columns[3].data() + at);
#else
    for (std::size_t i = 0; i < 4; ++i) {
        const PlacedVertex& place = places[vertices[4 * i + corner]];
        for (std::size_t axis = 0; axis < 3; ++axis)
            columns[axis][at + i] = place.position[axis];
        columns[3][at + i] = std::bit_cast<float>(place.firstInFront);
    }
#endif
}

HWY_INLINE std::int32_t commonBox(const PlacedVertex* places, const int* vertices)
{
    const std::int32_t a = places[vertices[0]].box, b = places[vertices[1]].box;
    const std::int32_t c = places[vertices[2]].box, d = places[vertices[3]].box;
    return ((a ^ b) | (a ^ c) | (a ^ d)) == 0 ? a : -1;
}

/// What the positions of some tetrahedra's corners say.
class Order
{
public:
    HWY_INLINE Order(const Places& places, std::size_t at)
    {
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis)
                p_[corner][axis] = hn::Load(kFloats, places.of[corner][axis].data() + at);
        for (std::size_t i = 0; i < 4; ++i)
            rank_[i] = hn::Set(kNumbers, static_cast<std::int32_t>(i));
        odd_ = hn::Zero(kNumbers);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                compare(i, j);
    }

    HWY_INLINE void write(TetraLooks& looks, std::size_t at) const
    {
        const Doubles volume = this->volume();
        const auto good =
            hn::And(hn::Gt(hn::Abs(volume), hn::Zero(kDoubles)),
                    hn::Le(hn::Abs(volume), hn::Set(kDoubles, std::numeric_limits<double>::max())));
        const auto numbers = [](auto mask) HWY_ATTR {
            return hn::DemoteTo(kNumbers, hn::IfThenElseZero(mask, hn::Set(kDoubles, -1.0)));
        };
        hn::Store(numbers(good), kNumbers, looks.solid.data() + at);
        hn::Store(hn::Xor(odd_, numbers(hn::Lt(volume, hn::Zero(kDoubles)))), kNumbers,
                  looks.mirrored.data() + at);
        Numbers order = hn::Zero(kNumbers);
        for (std::size_t i = 1; i < 4; ++i)
            order = hn::Or(
                order, hn::Shl(hn::Set(kNumbers, static_cast<std::int32_t>(i)), hn::Add(rank_[i], rank_[i])));
        hn::Store(order, kNumbers, looks.order.data() + at);
    }

private:
    HWY_INLINE void compare(std::size_t i, std::size_t j)
    {
        const auto &p = p_[i], &q = p_[j];
        const auto sameX = hn::Eq(q[0], p[0]), sameY = hn::And(sameX, hn::Eq(q[1], p[1]));
        const auto before = hn::Or(hn::Lt(q[0], p[0]), hn::Or(hn::And(sameX, hn::Lt(q[1], p[1])),
                                                              hn::And(sameY, hn::Lt(q[2], p[2]))));
        const auto numbers = [](auto mask)
                                 HWY_ATTR { return hn::BitCast(kNumbers, hn::VecFromMask(kFloats, mask)); };
        const Numbers swapped = numbers(before);
        rank_[i] = hn::Sub(rank_[i], swapped);
        rank_[j] = hn::Add(rank_[j], swapped);
        odd_ = hn::Xor(odd_, swapped);
    }

    /// Six times the volume, below zero where the corners as they were given are negatively oriented.
    HWY_INLINE Doubles volume() const
    {
        const auto side = [this](std::size_t corner, std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::PromoteTo(kDoubles, p_[corner][axis]), hn::PromoteTo(kDoubles, p_[0][axis]));
        };
        const Doubles ax = side(1, 0), ay = side(1, 1), az = side(1, 2);
        const Doubles bx = side(2, 0), by = side(2, 1), bz = side(2, 2);
        const Doubles cx = side(3, 0), cy = side(3, 1), cz = side(3, 2);
        const Doubles x = hn::Sub(hn::Mul(by, cz), hn::Mul(cy, bz));
        const Doubles y = hn::Sub(hn::Mul(bz, cx), hn::Mul(cz, bx));
        const Doubles z = hn::Sub(hn::Mul(bx, cy), hn::Mul(cx, by));
        return hn::Add(hn::Add(hn::Mul(ax, x), hn::Mul(ay, y)), hn::Mul(az, z));
    }

    Floats p_[4][3];
    Numbers rank_[4];
    Numbers odd_;
};

/// Puts the first planes in front of corners in order.
HWY_INLINE void sortPlanes(const Places& places, std::size_t at, TetraLooks& looks)
{
    const auto first = [&](std::size_t corner) HWY_ATTR {
        return hn::BitCast(kNumbers, hn::Load(kFloats, places.of[corner][3].data() + at));
    };
    const Numbers low = hn::Min(first(0), first(1)), high = hn::Max(first(0), first(1));
    const Numbers nextLow = hn::Min(first(2), first(3)), nextHigh = hn::Max(first(2), first(3));
    const Numbers a = hn::Max(low, nextLow), b = hn::Min(high, nextHigh);
    hn::Store(hn::Min(low, nextLow), kNumbers, looks.changes[0].data() + at);
    hn::Store(hn::Min(a, b), kNumbers, looks.changes[1].data() + at);
    hn::Store(hn::Max(a, b), kNumbers, looks.changes[2].data() + at);
    hn::Store(hn::Max(high, nextHigh), kNumbers, looks.changes[3].data() + at);
}

void lookAtTetrasOfTarget(const PlacedVertex* places, const int* vertices, std::size_t count,
                          TetraLooks& looks)
{
    Places corners;
    std::array<int, 16> last;
    for (std::size_t at = 0; at < count; at += 4) {
        const int* four = vertices + 4 * at;
        if (at + 4 > count) {
            for (std::size_t i = 0; i < 16; ++i)
                last[i] = vertices[4 * std::min(at + i / 4, count - 1) + i % 4];
            four = last.data();
        }
        for (std::size_t corner = 0; corner < 4; ++corner)
            gatherCorner(places, four, corner, at, corners);
        for (std::size_t i = 0; i < 4; ++i)
            looks.box[at + i] = commonBox(places, four + 4 * i);
    }
    for (std::size_t at = 0; at < count; at += hn::Lanes(kDoubles)) {
        Order(corners, at).write(looks, at);
        sortPlanes(corners, at, looks);
    }
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

HWY_EXPORT(lookAtTetrasOfTarget);

void lookAtTetras(const PlacedVertex* places, std::span<const int> vertices, TetraLooks& looks)
{
    assert(vertices.size() <= 4 * TetraLooks::kMost);
    HWY_DYNAMIC_DISPATCH(lookAtTetrasOfTarget)(places, vertices.data(), vertices.size() / 4, looks);
}

} // namespace vo
#endif
