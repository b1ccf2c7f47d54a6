// Numbers side by side, one a lane, and how they are read from anywhere. Included once for each target of
// Highway.

#if defined(VO_CORE_GATHER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VO_CORE_GATHER_INL_H
#undef VO_CORE_GATHER_INL_H
#else
#define VO_CORE_GATHER_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::RebindToSigned<FloatTag>;
using UintTag = hn::RebindToUnsigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using Mask = hn::Mask<FloatTag>;
constexpr FloatTag kFloats;
constexpr IntTag kInts;
constexpr UintTag kUints;
constexpr int kLanes = static_cast<int>(HWY_LANES(float) < 16 ? HWY_LANES(float) : 16);

/// Highway's gathers leave what was in the target register before as an input, and GCC then makes each wait
/// for the sample before: with an explicit zero, samples overlap.
#if HWY_TARGET == HWY_AVX3
HWY_INLINE Ints gatherAtByte(const std::int32_t* base, Ints offset)
{
    return Ints{_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xffff, offset.raw, base, 1)};
}
HWY_INLINE Ints gather(const std::int32_t* base, Ints index)
{
    return Ints{_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xffff, index.raw, base, 4)};
}
HWY_INLINE Floats gather(const float* base, Ints index)
{
    return Floats{_mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xffff, index.raw, base, 4)};
}
/// Two numbers that lie side by side in memory.
struct IntPairs
{
    Ints first, second;
};
/// Pair number `index`: reads of eight bytes take no longer than those of four.
HWY_INLINE IntPairs gatherPairs(const void* base, Ints index)
{
    const auto pairs = [&](__m256i half) {
        return _mm512_mask_i32gather_epi64(_mm512_setzero_si512(), 0xff, half, base, 8);
    };
    const __m512i lower = pairs(_mm512_castsi512_si256(index.raw));
    const __m512i upper = pairs(_mm512_extracti64x4_epi64(index.raw, 1));
    const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    const __m512i odd = _mm512_or_si512(even, _mm512_set1_epi32(1));
    return {Ints{_mm512_permutex2var_epi32(lower, even, upper)},
            Ints{_mm512_permutex2var_epi32(lower, odd, upper)}};
}
/// Highway's conversions also saturate, which costs three operations more; numbers here are far smaller.
HWY_INLINE Ints toNearest(Floats v)
{
    return Ints{_mm512_cvtps_epi32(v.raw)};
}
HWY_INLINE Ints toLower(Floats v)
{
    return Ints{_mm512_cvttps_epi32(v.raw)};
}
#else
HWY_INLINE Ints toNearest(Floats v)
{
    return hn::NearestInt(v);
}
HWY_INLINE Ints toLower(Floats v)
{
    return hn::ConvertTo(kInts, v);
}
HWY_INLINE Ints gatherAtByte(const std::int32_t* base, Ints offset)
{
    return hn::GatherOffset(kInts, base, offset);
}
HWY_INLINE Ints gather(const std::int32_t* base, Ints index)
{
    return hn::GatherIndex(kInts, base, index);
}
HWY_INLINE Floats gather(const float* base, Ints index)
{
    return hn::GatherIndex(kFloats, base, index);
}
struct IntPairs
{
    Ints first, second;
};
HWY_INLINE IntPairs gatherPairs(const void* base, Ints index)
{
    const auto* numbers = static_cast<const std::int32_t*>(base);
    return {gather(numbers, index + index), gather(numbers + 1, index + index)};
}
#endif

HWY_INLINE Floats between(Floats a, Floats b, Floats weight)
{
    return hn::MulAdd(weight, b - a, a);
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#endif
