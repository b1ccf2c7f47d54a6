// Samples of a grid, one a lane. Included once for each target of Highway.

#if defined(VO_CAST_SAMPLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VO_CAST_SAMPLE_INL_H
#undef VO_CAST_SAMPLE_INL_H
#else
#define VO_CAST_SAMPLE_INL_H
#endif

#include "cast/voxel_grid.h"
#include "core/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {

/// Places in a grid are numbers of 1/32768 voxel.
constexpr int kPlaceBits = 15;
constexpr float kPlaceUnit = 32768.0f;

/// Where samples lie: the cell's number and the weights of the neighbours in +x, +y and +z, of 32768.
struct Place
{
    Ints cell;
    Ints x, y, z;
};

/// A grid's numbers, one a lane.
class GridLanes
{
public:
    explicit GridLanes(const GridView& grid)
        : rowPitch_(hn::Set(kInts, static_cast<std::int32_t>(grid.rowPitch))),
          slicePitch_(hn::Set(kInts, static_cast<std::int32_t>(grid.slicePitch))),
          lastCell_(hn::Set(kUints, grid.lastCell)), weightX_(weight(grid, 0)), weightY_(weight(grid, 1)),
          weightZ_(weight(grid, 2))
    {
    }

    /// Of grid coordinates (times kPlaceUnit). Whatever they are, the cell is one that can be read.
    HWY_INLINE Place place(Floats x, Floats y, Floats z) const
    {
        return place(toNearest(x), toNearest(y), toNearest(z));
    }

    HWY_INLINE Place place(Ints x, Ints y, Ints z) const
    {
        const Ints cell = hn::ShiftRight<kPlaceBits>(x) + hn::ShiftRight<kPlaceBits>(y) * rowPitch_ +
                          hn::ShiftRight<kPlaceBits>(z) * slicePitch_;
        const Ints inside = hn::BitCast(kInts, hn::Min(hn::BitCast(kUints, cell), lastCell_));
        return {inside, hn::And(x, weightX_), hn::And(y, weightY_), hn::And(z, weightZ_)};
    }

private:
    /// Takes the weight out of a coordinate; nothing of one that is not interpolated.
    static Ints weight(const GridView& grid, int axis)
    {
        return hn::Set(kInts, grid.thinAxis == axis ? 0 : (1 << kPlaceBits) - 1);
    }

    Ints rowPitch_, slicePitch_;
    hn::Vec<UintTag> lastCell_;
    Ints weightX_, weightY_, weightZ_;
};

HWY_INLINE Floats weightOf(Ints weight)
{
    return hn::ConvertTo(kFloats, weight) * hn::Set(kFloats, 1.0f / kPlaceUnit);
}

/// Bytes. Answers with 128 for each 1; never beyond the voxels around, and exactly them where they are equal.
struct ByteSampler
{
    static constexpr int kChannels = 1;
    static constexpr bool kIsNumber = true; ///< no answer is a NaN
    static constexpr std::size_t kCellBytes = 2;

    explicit ByteSampler(const GridView& grid)
        : cells_(reinterpret_cast<const std::int32_t*>(grid.cells)),
          above_(reinterpret_cast<const std::int32_t*>(grid.cells + std::size_t{2} * grid.slicePitch))
    {
    }

    HWY_INLINE Floats value(const Place& at, int = 0) const
    {
        const Ints offset = at.cell + at.cell;
        const Ints lower = gatherAtByte(cells_, offset);
        const Ints upper = gatherAtByte(above_, offset);
        const Ints both = columns(lower, upper, at.y, at.z);
        const Floats left = hn::ConvertTo(kFloats, hn::And(both, hn::Set(kInts, 0xffff)));
        const Floats right = hn::ConvertTo(kFloats, hn::ShiftRight<16>(both));
        return between(left, right, weightOf(at.x));
    }

private:
    /// From (v(x, y), v(x, y + 1), v(x + 1, y), v(x + 1, y + 1)) at z and z + 1 to the values at x and x + 1,
    /// 7 bits up, in the halves of a lane.
    static HWY_INLINE Ints columns(Ints lower, Ints upper, Ints weightY, Ints weightZ)
    {
#if HWY_TARGET == HWY_SCALAR
        const auto column = [&](auto&& corner) {
            const auto mixed = [&](Ints a, Ints b, Ints weight) {
                return a + hn::ShiftRight<15>((b - a) * weight + hn::Set(kInts, 1 << 14));
            };
            return mixed(mixed(corner(lower, 0), corner(lower, 1), weightY),
                         mixed(corner(upper, 0), corner(upper, 1), weightY), weightZ);
        };
        const auto byte = [](Ints v) { return hn::ShiftLeft<7>(hn::And(v, hn::Set(kInts, 0xff))); };
        const Ints left = column([&](Ints v, int above) { return byte(above ? hn::ShiftRight<8>(v) : v); });
        const Ints right = column(
            [&](Ints v, int above) { return byte(above ? hn::ShiftRight<24>(v) : hn::ShiftRight<16>(v)); });
        return hn::Or(left, hn::ShiftLeft<16>(right));
#else
        const hn::Repartition<std::int16_t, IntTag> shorts;
        const auto twice = [&](Ints weight) {
            return hn::BitCast(shorts, hn::Or(weight, hn::ShiftLeft<16>(weight)));
        };
        const auto mixed = [](auto a, auto b, auto weight) { return a + hn::MulFixedPoint15(b - a, weight); };
        const Ints part = hn::Set(kInts, 0x7f807f80);
        const auto layer = [&](Ints corners) {
            return mixed(hn::BitCast(shorts, hn::And(hn::ShiftLeft<7>(corners), part)),
                         hn::BitCast(shorts, hn::And(hn::ShiftRight<1>(corners), part)), twice(weightY));
        };
        return hn::BitCast(kInts, mixed(layer(lower), layer(upper), twice(weightZ)));
#endif
    }

    const std::int32_t* cells_;
    const std::int32_t* above_;
};

/// Numbers of 16 bits, answered as they are stored.
struct ShortSampler
{
    static constexpr int kChannels = 1;
    static constexpr bool kIsNumber = true;
    static constexpr std::size_t kCellBytes = 4;

    explicit ShortSampler(const GridView& grid)
        : cells_(reinterpret_cast<const std::int32_t*>(grid.cells)), slicePitch_(grid.slicePitch)
    {
    }

    HWY_INLINE Floats value(const Place& at, int = 0) const
    {
        const Floats y = weightOf(at.y), x = weightOf(at.x);
        const auto row = [&](const std::int32_t* cells) {
            return between(column(gather(cells, at.cell), y), column(gather(cells + 1, at.cell), y), x);
        };
        return between(row(cells_), row(cells_ + slicePitch_), weightOf(at.z));
    }

private:
    static HWY_INLINE Floats column(Ints pair, Floats weight)
    {
        const Ints upper = hn::BitCast(kInts, hn::ShiftRight<16>(hn::BitCast(kUints, pair)));
        return between(hn::ConvertTo(kFloats, hn::And(pair, hn::Set(kInts, 0xffff))),
                       hn::ConvertTo(kFloats, upper), weight);
    }

    const std::int32_t* cells_;
    std::size_t slicePitch_;
};

/// Floats, 1 or 4 of them a voxel.
template <int kNumbers>
struct FloatSampler
{
    static constexpr int kChannels = kNumbers;
    static constexpr bool kIsNumber = false;
    static constexpr std::size_t kCellBytes = std::size_t{4} * kNumbers;

    explicit FloatSampler(const GridView& grid)
        : cells_(reinterpret_cast<const float*>(grid.cells)),
          rowPitch_(std::size_t{kNumbers} * grid.rowPitch),
          slicePitch_(std::size_t{kNumbers} * grid.slicePitch)
    {
    }

    HWY_INLINE Floats value(const Place& at, int channel = 0) const
    {
        const Ints number = kNumbers == 1 ? at.cell : hn::ShiftLeft<2>(at.cell);
        const Floats x = weightOf(at.x), y = weightOf(at.y);
        const auto row = [&](const float* cells) {
            return between(gather(cells, number), gather(cells + kNumbers, number), x);
        };
        const auto slice = [&](const float* cells) { return between(row(cells), row(cells + rowPitch_), y); };
        const float* cells = cells_ + channel;
        return between(slice(cells), slice(cells + slicePitch_), weightOf(at.z));
    }

private:
    const float* cells_;
    std::size_t rowPitch_, slicePitch_;
};

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#endif
