// The instruction sets that files with vectors are compiled for: to be included before Highway's headers.

#pragma once

// Vectors of unknown length, and sets that add nothing here to those that are kept.
#define VO_UNUSED_TARGETS                                                                                    \
    (HWY_AVX3_DL | HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

// The sanitizers take minutes for each set: they look at a wide one and the one that is always there.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define VO_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define VO_ADDRESS_SANITIZER
#endif
#if defined(VO_ADDRESS_SANITIZER)
#define HWY_DISABLED_TARGETS (VO_UNUSED_TARGETS | HWY_AVX3 | HWY_SSE4)
#else
#define HWY_DISABLED_TARGETS VO_UNUSED_TARGETS
#endif
