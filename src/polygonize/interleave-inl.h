// Vertices in rows, from vectors of their coordinates. Included once for each set of instructions.

#if defined(VO_POLYGONIZE_INTERLEAVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VO_POLYGONIZE_INTERLEAVE_INL_H
#undef VO_POLYGONIZE_INTERLEAVE_INL_H
#else
#define VO_POLYGONIZE_INTERLEAVE_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 64
constexpr hwy::HWY_NAMESPACE::FixedTag<float, 16> kRowFloats;

/// x, y and z of four vertices, one vertex after the other; the last four numbers are anything.
template <class FourFloats>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<decltype(kRowFloats)> rowsOfFour(FourFloats x, FourFloats y, FourFloats z)
{
    namespace hn = hwy::HWY_NAMESPACE;
    constexpr hn::FixedTag<float, 8> kHalf;
    alignas(64) constexpr std::int32_t kFrom[16] = {0, 4, 8, 1, 5, 9, 2, 6, 10, 3, 7, 11, 0, 0, 0, 0};
    const auto columns = hn::Combine(kRowFloats, hn::ZeroExtendVector(kHalf, z), hn::Combine(kHalf, y, x));
    return hn::TableLookupLanes(columns, hn::SetTableIndices(kRowFloats, kFrom));
}
#endif

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#endif
