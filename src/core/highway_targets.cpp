// What Highway's headers ask of its library, for old versions of that: they measure the clock for some 10 ms
// when they are loaded, more than most programs take to start. Not visible outside.

#include <hwy/highway.h>

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace hwy {

namespace {

std::atomic<std::int64_t> chosenForTest{0};
std::atomic<std::int64_t> enabled{~std::int64_t{0}};

#if HWY_ARCH_X86
/// What not every compiler's builtin knows by name: a bit of ECX.
bool hasBit(unsigned leaf, unsigned bit)
{
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid_count(leaf, 0, &a, &b, &c, &d) != 0 && (c >> bit & 1u) != 0;
}
#endif

/// The processor and the system can do what the compiler may use for a target.
std::int64_t ofThisMachine()
{
    std::int64_t targets = HWY_STATIC_TARGET | HWY_ENABLED_BASELINE;
#if HWY_ARCH_X86
    __builtin_cpu_init();
    const auto has = [](auto... answers) { return (... && (answers != 0)); };
    const bool f16c = hasBit(1, 29), lzcnt = hasBit(0x80000001, 5), vaes = hasBit(7, 9);
    const bool ssse3 = has(__builtin_cpu_supports("ssse3"));
    const bool sse4 = ssse3 && has(__builtin_cpu_supports("sse4.1"), __builtin_cpu_supports("sse4.2"),
                                   __builtin_cpu_supports("aes"), __builtin_cpu_supports("pclmul"));
    const bool avx2 = sse4 && has(__builtin_cpu_supports("avx2"), __builtin_cpu_supports("fma"), f16c, lzcnt,
                                  __builtin_cpu_supports("bmi"), __builtin_cpu_supports("bmi2"));
    const bool avx3 = avx2 && has(__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512vl"),
                                  __builtin_cpu_supports("avx512dq"), __builtin_cpu_supports("avx512bw"),
                                  __builtin_cpu_supports("avx512cd"));
    const bool dl = avx3 && has(__builtin_cpu_supports("avx512vnni"), __builtin_cpu_supports("avx512vbmi"),
                                __builtin_cpu_supports("avx512vbmi2"), __builtin_cpu_supports("avx512bitalg"),
                                __builtin_cpu_supports("avx512vpopcntdq"), __builtin_cpu_supports("gfni"),
                                vaes, __builtin_cpu_supports("vpclmulqdq"));
    targets |= (ssse3 ? HWY_SSSE3 : 0) | (sse4 ? HWY_SSE4 : 0) | (avx2 ? HWY_AVX2 : 0) |
               (avx3 ? HWY_AVX3 : 0) | (dl ? HWY_AVX3_DL : 0);
#endif
    return targets;
}

} // namespace

ChosenTarget& GetChosenTarget()
{
    static ChosenTarget chosen;
    return chosen;
}

std::int64_t SupportedTargets()
{
    static const std::int64_t all = ofThisMachine();
    const std::int64_t wanted = chosenForTest ? chosenForTest.load() : all;
    const std::int64_t left = wanted & enabled;
    return left != 0 ? left : HWY_STATIC_TARGET;
}

void SetSupportedTargetsForTest(std::int64_t targets)
{
    chosenForTest = targets;
    GetChosenTarget().DeInit();
}

void DisableTargets(std::int64_t targets)
{
    enabled = ~(targets & ~std::int64_t{HWY_ENABLED_BASELINE});
    GetChosenTarget().DeInit();
}

void Abort(const char* file, int line, const char* format, ...)
{
    std::va_list arguments;
    va_start(arguments, format);
    std::fprintf(stderr, "%s:%d: ", file, line);
    std::vfprintf(stderr, format, arguments);
    va_end(arguments);
    std::abort();
}

} // namespace hwy
