#include "cast/sample_padded.h"

#include "core/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cast/sample_padded.cpp"
#include <hwy/foreach_target.h>

#include "core/gather-inl.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace {

/// Where samples lie: the first numbers of their cells of eight, and the weights of the others.
struct PaddedPlace
{
    Ints cell[3];
    Floats weight[3];

    HWY_INLINE PaddedPlace(const PaddedGrid& grid, const BatchVectors& place, std::size_t first)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto size = static_cast<float>(grid.size[static_cast<int>(axis)]);
            Floats p = hn::LoadU(kFloats, place[axis].data() + first);
            if (grid.repeats[axis]) p = p - hn::Floor(p);
            // Not-a-number becomes 0.
            p = hn::IfThenElseZero(p > hn::Zero(kFloats), p);
            p = hn::Min(p, hn::Set(kFloats, 1.0f)) * hn::Set(kFloats, size);
            p = grid.nearest ? hn::Min(hn::Floor(p), hn::Set(kFloats, size - 1.0f))
                             : p - hn::Set(kFloats, 0.5f);
            p = p + hn::Set(kFloats, static_cast<float>(PaddedGrid::kPadding));
            cell[axis] = toLower(p);
            weight[axis] = p - hn::ConvertTo(kFloats, cell[axis]);
        }
    }
};

/// Reads four bytes of each cell, so many from its first number on.
class NearNumbers
{
public:
    HWY_INLINE NearNumbers(const PaddedGrid& grid, const PaddedPlace& at, int numberBytes)
        : numbers_(grid.numbers)
    {
        const auto bytes = [&](std::ptrdiff_t pitch) {
            return hn::Set(kInts, static_cast<std::int32_t>(pitch * numberBytes));
        };
        offset_ = at.cell[0] * bytes(1) + at.cell[1] * bytes(grid.row) + at.cell[2] * bytes(grid.slice);
    }

    HWY_INLINE Ints word(std::ptrdiff_t from) const
    {
        return gatherAtByte(reinterpret_cast<const std::int32_t*>(numbers_ + from), offset_);
    }

private:
    const std::byte* numbers_;
    Ints offset_;
};

/// The same where offsets are beyond the 32 bits of gathers.
class FarNumbers
{
public:
    FarNumbers(const PaddedGrid& grid, const PaddedPlace& at, int numberBytes)
    {
        alignas(64) std::int32_t cell[3][kLanes];
        for (int axis = 0; axis < 3; ++axis)
            hn::Store(at.cell[axis], kInts, cell[axis]);
        for (int i = 0; i < kLanes; ++i)
            at_[i] =
                grid.numbers + (cell[0][i] + cell[1][i] * grid.row + cell[2][i] * grid.slice) * numberBytes;
    }

    Ints word(std::ptrdiff_t from) const
    {
        alignas(64) std::int32_t words[kLanes];
        for (int i = 0; i < kLanes; ++i)
            std::memcpy(&words[i], at_[i] + from, sizeof words[i]);
        return hn::Load(kInts, words);
    }

private:
    const std::byte* at_[kLanes];
};

/// Numbers that lie side by side along x: before the cell, its two, after it.
struct Pair
{
    Floats low, high;
};
struct Four
{
    Floats before, low, high, after;
};

/// Rows of cells, `numbers` from each cell's first number. All that is read lies in the row: the padding is
/// two numbers wide.
template <class T, class Numbers>
class Rows
{
public:
    HWY_INLINE Rows(const PaddedGrid& grid, const PaddedPlace& at) : numbers_(grid, at, sizeof(T)) {}

    HWY_INLINE Pair pair(std::ptrdiff_t numbers) const
    {
        if constexpr (std::is_same_v<T, std::uint8_t>) {
            const Ints bytes = word(numbers - 1);
            return {part<8>(bytes, 0xff), part<16>(bytes, 0xff)};
        } else if constexpr (std::is_same_v<T, std::uint16_t>) {
            return halves(word(numbers));
        } else {
            return {number(numbers), number(numbers + 1)};
        }
    }

    HWY_INLINE Four four(std::ptrdiff_t numbers) const
    {
        if constexpr (std::is_same_v<T, std::uint8_t>) {
            const Ints bytes = word(numbers - 1);
            return {part<0>(bytes, 0xff), part<8>(bytes, 0xff), part<16>(bytes, 0xff), part<24>(bytes, 0xff)};
        } else {
            const Pair first = pair(numbers - 1), second = pair(numbers + 1);
            return {first.low, first.high, second.low, second.high};
        }
    }

private:
    HWY_INLINE Ints word(std::ptrdiff_t numbers) const
    {
        return numbers_.word(numbers * static_cast<std::ptrdiff_t>(sizeof(T)));
    }
    HWY_INLINE Floats number(std::ptrdiff_t numbers) const { return hn::BitCast(kFloats, word(numbers)); }

    template <int kShift>
    static HWY_INLINE Floats part(Ints word, std::int32_t mask)
    {
        return hn::ConvertTo(kFloats, hn::And(hn::ShiftRight<kShift>(word), hn::Set(kInts, mask)));
    }
    static HWY_INLINE Pair halves(Ints word) { return {part<0>(word, 0xffff), part<16>(word, 0xffff)}; }

    Numbers numbers_;
};

HWY_INLINE Floats mixed(const Pair& pair, Floats weight)
{
    return between(pair.low, pair.high, weight);
}

template <class T, class Numbers>
void valuesOf(const PaddedGrid& grid, int count, const BatchVectors& place, BatchFloats& value)
{
    const Floats unit = hn::Set(kFloats, grid.unit);
    for (int i = 0; i < count; i += kLanes) {
        const auto first = static_cast<std::size_t>(i);
        const PaddedPlace at(grid, place, first);
        const Rows<T, Numbers> rows(grid, at);
        const auto& [x, y, z] = at.weight;
        const Floats low = between(mixed(rows.pair(0), x), mixed(rows.pair(grid.row), x), y);
        const Floats high =
            between(mixed(rows.pair(grid.slice), x), mixed(rows.pair(grid.slice + grid.row), x), y);
        hn::StoreU(between(low, high, z) * unit, kFloats, value.data() + first);
    }
}

/// A row of a cell: its value, and how much that changes along x.
struct RowSlope
{
    Floats value, change;

    HWY_INLINE RowSlope(const Four& row, Floats weight)
        : value(between(row.low, row.high, weight)),
          change(between(row.high - row.before, row.after - row.low, weight))
    {
    }
};

template <class T, class Numbers>
void changesOf(const PaddedGrid& grid, int count, const BatchVectors& place, BatchVectors& change)
{
    const Floats half = hn::Set(kFloats, 0.5f * grid.unit);
    for (int i = 0; i < count; i += kLanes) {
        const auto first = static_cast<std::size_t>(i);
        const PaddedPlace at(grid, place, first);
        const Rows<T, Numbers> rows(grid, at);
        const Floats x = at.weight[0], y = at.weight[1], z = at.weight[2];
        const std::ptrdiff_t up = grid.row, back = grid.slice;
        // The first digit says how far up a row is, the second how far back.
        const RowSlope row00(rows.four(0), x), row10(rows.four(up), x), row01(rows.four(back), x),
            row11(rows.four(up + back), x);
        const auto value = [&](std::ptrdiff_t row) { return mixed(rows.pair(row), x); };
        const Floats dx =
            between(between(row00.change, row10.change, y), between(row01.change, row11.change, y), z);
        const Floats dy =
            between(between(row10.value - value(-up), value(2 * up) - row00.value, y),
                    between(row11.value - value(back - up), value(back + 2 * up) - row01.value, y), z);
        const Floats dz =
            between(between(row01.value - value(-back), value(2 * back) - row00.value, z),
                    between(row11.value - value(up - back), value(up + 2 * back) - row10.value, z), y);
        hn::StoreU(dx * half, kFloats, change[0].data() + first);
        hn::StoreU(dy * half, kFloats, change[1].data() + first);
        hn::StoreU(dz * half, kFloats, change[2].data() + first);
    }
}

template <class T>
void valuesOfKind(const PaddedGrid& grid, int count, const BatchVectors& place, BatchFloats& value)
{
    grid.far ? valuesOf<T, FarNumbers>(grid, count, place, value)
             : valuesOf<T, NearNumbers>(grid, count, place, value);
}

template <class T>
void changesOfKind(const PaddedGrid& grid, int count, const BatchVectors& place, BatchVectors& change)
{
    grid.far ? changesOf<T, FarNumbers>(grid, count, place, change)
             : changesOf<T, NearNumbers>(grid, count, place, change);
}

} // namespace

void valuesOfTarget(const PaddedGrid& grid, int count, const BatchVectors& place, BatchFloats& value)
{
    switch (grid.kind) {
    case TexelKind::uint8: return valuesOfKind<std::uint8_t>(grid, count, place, value);
    case TexelKind::uint16: return valuesOfKind<std::uint16_t>(grid, count, place, value);
    case TexelKind::float32: return valuesOfKind<float>(grid, count, place, value);
    }
}

void changesOfTarget(const PaddedGrid& grid, int count, const BatchVectors& place, BatchVectors& change)
{
    switch (grid.kind) {
    case TexelKind::uint8: return changesOfKind<std::uint8_t>(grid, count, place, change);
    case TexelKind::uint16: return changesOfKind<std::uint16_t>(grid, count, place, change);
    case TexelKind::float32: return changesOfKind<float>(grid, count, place, change);
    }
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

HWY_EXPORT(valuesOfTarget);
HWY_EXPORT(changesOfTarget);

void sampleValues(const PaddedGrid& grid, int count, const BatchVectors& place, BatchFloats& value)
{
    HWY_DYNAMIC_DISPATCH(valuesOfTarget)(grid, count, place, value);
}

void sampleChanges(const PaddedGrid& grid, int count, const BatchVectors& place, BatchVectors& change)
{
    HWY_DYNAMIC_DISPATCH(changesOfTarget)(grid, count, place, change);
}

} // namespace vo
#endif
