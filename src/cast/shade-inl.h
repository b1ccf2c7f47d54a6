// Fragments of samples, one a lane. Included once for each target of Highway.

#if defined(VO_CAST_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VO_CAST_SHADE_INL_H
#undef VO_CAST_SHADE_INL_H
#else
#define VO_CAST_SHADE_INL_H
#endif

#include "cast/sample-inl.h"
#include "cast/shading_plan.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {

/// A shading plan's functions of one value. `rawUnit` is the sampler's answer that stands for 1.
class LinearShade
{
public:
    LinearShade(const ShadingPlan& plan, float rawUnit)
    {
        for (std::size_t c = 0; c < 4; ++c) {
            slope_[c] = plan.slope[c] / rawUnit;
            base_[c] = plan.base[c];
        }
    }

    struct Key
    {
        Floats raw;
    };
    HWY_INLINE Key key(Floats raw) const { return {raw}; }
    HWY_INLINE Mask mayBeSeen(Floats) const { return hn::FirstN(kFloats, kLanes); }
    HWY_INLINE Floats component(const Key& key, std::size_t c) const
    {
        return hn::MulAdd(key.raw, hn::Set(kFloats, slope_[c]), hn::Set(kFloats, base_[c]));
    }

private:
    float slope_[4];
    float base_[4];
};

/// Where a sample falls in a table of `last` + 1 entries, or of so many steps for each of them.
class TablePlace
{
public:
    TablePlace(const ShadingPlan& plan, float rawUnit, int steps = 1)
        : scale_(static_cast<float>(plan.last * steps) / rawUnit),
          last_(static_cast<float>(plan.last * steps)),
          clearEnd_(plan.clearEntries() > 0 ? static_cast<float>((plan.clearEntries() - 1) * steps)
                                            : -std::numeric_limits<float>::infinity())
    {
    }

    /// False only where alpha is 0.
    HWY_INLINE Mask mayBeSeen(Floats raw) const
    {
        // The same arithmetic as a key's. Written so that a NaN may be seen.
        return hn::Not(raw * hn::Set(kFloats, scale_) <= hn::Set(kFloats, clearEnd_));
    }

    struct Key
    {
        Ints entry;
        Floats weight; ///< of the next one
    };
    HWY_INLINE Key key(Floats raw) const
    {
        // Written so that a NaN counts as 0.
        const Floats zero = hn::Zero(kFloats);
        const Floats scaled = hn::Min(raw * hn::Set(kFloats, scale_), hn::Set(kFloats, last_));
        const Floats place = hn::IfThenElseZero(raw > zero, scaled);
        const Ints entry = toLower(place);
        return {entry, place - hn::ConvertTo(kFloats, entry)};
    }

private:
    float scale_;
    float last_;
    float clearEnd_; ///< the place up to which alpha is 0
};

class TableShade : public TablePlace
{
public:
    TableShade(const ShadingPlan& plan, float rawUnit) : TablePlace(plan, rawUnit)
    {
        for (std::size_t c = 0; c < 4; ++c)
            entries_[c] = plan.entries[c].data();
    }

    HWY_INLINE Floats component(const Key& key, std::size_t c) const
    {
        const Ints number = key.entry + key.entry;
        const Floats entry = gather(entries_[c], number);
        const Floats difference = gather(entries_[c] + 1, number);
        return hn::MulAdd(key.weight, difference, entry);
    }

private:
    const float* entries_[4];
};

/// Of packed entries.
class PackedShade : public TablePlace
{
public:
    PackedShade(const ShadingPlan& plan, float rawUnit)
        : TablePlace(plan, rawUnit), redAlpha_(plan.redAlpha.data()), greenBlue_(plan.greenBlue.data())
    {
        for (std::size_t c = 0; c < 4; ++c) {
            entryScale_[c] = plan.entryScale[c];
            differenceScale_[c] = plan.differenceScale[c];
        }
    }

    HWY_INLINE IntPairs redAlpha(const Key& key) const { return gatherPairs(redAlpha_, key.entry); }
    HWY_INLINE IntPairs greenBlue(const Key& key) const { return gatherPairs(greenBlue_, key.entry); }

    /// Of its number of the pairs.
    HWY_INLINE Floats component(const Key& key, Ints packed, std::size_t c) const
    {
        const Ints upper = hn::BitCast(kInts, hn::ShiftRight<16>(hn::BitCast(kUints, packed)));
        const Floats entry = hn::ConvertTo(kFloats, upper) * hn::Set(kFloats, entryScale_[c]);
        const Floats difference = hn::ConvertTo(kFloats, hn::ShiftRight<16>(hn::ShiftLeft<16>(packed)));
        return hn::MulAdd(key.weight * hn::Set(kFloats, differenceScale_[c]), difference, entry);
    }

private:
    const ShadingPlan::PackedPair *redAlpha_, *greenBlue_;
    float entryScale_[4], differenceScale_[4];
};

/// Of smooth entries: one read a sample.
class SmoothShade : public TablePlace
{
public:
    SmoothShade(const ShadingPlan& plan, float rawUnit)
        : TablePlace(plan, rawUnit, plan.smoothSteps), entries_(plan.smooth.data()),
          alphaScale_(plan.entryScale[3]), differenceScale_(plan.smoothDifferenceScale),
          scale_(plan.smoothScale)
    {
    }

    HWY_INLINE IntPairs read(const Key& key) const { return gatherPairs(entries_, key.entry); }

    HWY_INLINE Floats alpha(const Key& key, Ints packed) const
    {
        const Ints upper = hn::BitCast(kInts, hn::ShiftRight<16>(hn::BitCast(kUints, packed)));
        const Floats entry = hn::ConvertTo(kFloats, upper) * hn::Set(kFloats, alphaScale_);
        const Floats difference = hn::ConvertTo(kFloats, hn::ShiftRight<16>(hn::ShiftLeft<16>(packed)));
        return hn::MulAdd(key.weight * hn::Set(kFloats, differenceScale_), difference, entry);
    }
    /// Colours as they are stored, to be scaled when they are summed up.
    HWY_INLINE Floats red(Ints color) const
    {
        const auto number = hn::ShiftRight<21>(hn::BitCast(kUints, color));
        return hn::ConvertTo(kFloats, hn::BitCast(kInts, number));
    }
    HWY_INLINE Floats green(Ints color) const
    {
        return hn::ConvertTo(kFloats, hn::And(hn::ShiftRight<10>(color), hn::Set(kInts, 0x7ff)));
    }
    HWY_INLINE Floats blue(Ints color) const
    {
        return hn::ConvertTo(kFloats, hn::And(color, hn::Set(kInts, 0x3ff)));
    }
    HWY_INLINE float colorScale(std::size_t c) const { return scale_[c]; }

private:
    const ShadingPlan::SmoothEntry* entries_;
    float alphaScale_, differenceScale_;
    std::array<float, 3> scale_;
};

/// 1 - (1 - alpha)^units.
HWY_INLINE Floats opacityOver(Floats alpha, Floats units)
{
    const Floats one = hn::Set(kFloats, 1.0f);
    const auto set = [](float value) { return hn::Set(kFloats, value); };
    const Floats clear = one - hn::Min(hn::Max(alpha, hn::Zero(kFloats)), set(1.0f - 1e-7f));
    // The logarithm: exponent, and a series in (m - 1) / (m + 1) for the mantissa m in [0.7, 1.4].
    const Ints bits = hn::BitCast(kInts, clear);
    const Ints exponent = hn::ShiftRight<23>(bits - hn::Set(kInts, 0x3f3504f3));
    const Floats m = hn::BitCast(kFloats, bits - hn::ShiftLeft<23>(exponent));
    const Floats t = (m - one) / (m + one);
    const Floats square = t * t;
    Floats series = hn::MulAdd(square, set(2.8853901f / 9.0f), set(2.8853901f / 7.0f));
    series = hn::MulAdd(series, square, set(2.8853901f / 5.0f));
    series = hn::MulAdd(series, square, set(2.8853901f / 3.0f));
    series = hn::MulAdd(series, square, set(2.8853901f));
    const Floats logarithm = hn::MulAdd(series, t, hn::ConvertTo(kFloats, exponent));
    // The power of 2: Taylor's series of the fraction.
    const Floats wanted = hn::Max(logarithm * units, set(-126.0f));
    const Floats whole = hn::Round(wanted);
    const Floats f = (wanted - whole) * set(0.69314718f);
    Floats power = hn::MulAdd(f, set(1.0f / 720.0f), set(1.0f / 120.0f));
    power = hn::MulAdd(power, f, set(1.0f / 24.0f));
    power = hn::MulAdd(power, f, set(1.0f / 6.0f));
    power = hn::MulAdd(power, f, set(0.5f));
    power = hn::MulAdd(power, f, one);
    power = hn::MulAdd(power, f, one);
    const Ints scaled = hn::BitCast(kInts, power) + hn::ShiftLeft<23>(hn::NearestInt(whole));
    // The opaque stays opaque, over any length.
    return hn::IfThenElse(alpha >= one, one, one - hn::BitCast(kFloats, scaled));
}

/// opacityOver for many samples of the same lengths. Small opacities, of which most samples are, take five
/// terms of the binomial series.
class LengthOfSamples
{
public:
    explicit LengthOfSamples(Floats units)
        : units_(units), second_(units * (units - number(1)) * number(-1.0f / 2)),
          third_(second_ * (units - number(2)) * number(-1.0f / 3)),
          fourth_(third_ * (units - number(3)) * number(-1.0f / 4)),
          fifth_(fourth_ * (units - number(4)) * number(-1.0f / 5)),
          small_(hn::IfThenElseZero(units < number(kLongest), number(kSmall))),
          isShort_(hn::AllTrue(kFloats, units < number(kLongest)))
    {
    }

    HWY_INLINE Floats opacity(Floats alpha) const
    {
        if (!hn::AllTrue(kFloats, hn::And(alpha >= hn::Zero(kFloats), alpha < small_)))
            return opacityOver(alpha, units_);
        return series(alpha);
    }

    /// Of opacities that are known to be from 0 to kMostSmoothAlpha.
    HWY_INLINE Floats opacityOfSmooth(Floats alpha) const
    {
        static_assert(kMostSmoothAlpha < kSmall);
        return isShort_ ? series(alpha) : opacityOver(alpha, units_);
    }

private:
    /// The sixth term is at most 0.015 times the sixth power of alpha: less than 5e-6.
    static constexpr float kSmall = 0.26f, kLongest = 4.0f;

    static HWY_INLINE Floats number(float value) { return hn::Set(kFloats, value); }

    HWY_INLINE Floats series(Floats alpha) const
    {
        Floats sum = hn::MulAdd(fifth_, alpha, fourth_);
        sum = hn::MulAdd(sum, alpha, third_);
        sum = hn::MulAdd(sum, alpha, second_);
        return alpha * hn::MulAdd(sum, alpha, units_);
    }

    Floats units_, second_, third_, fourth_, fifth_;
    Floats small_;
    bool isShort_;
};

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#endif
