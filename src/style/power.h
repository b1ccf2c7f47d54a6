#pragma once

#include <cmath>

namespace vo {

/// base^exponent for exponents from 0 on; bases below 0, which rounding makes, count as 0.
inline float raised(float base, float exponent)
{
    return base > 0.0f ? std::pow(base, exponent) : exponent > 0.0f ? 0.0f : 1.0f;
}

/// The same, which GLSL's pow leaves undefined at 0.
inline constexpr const char* kRaisedGlsl = R"(
float raised(float base, float exponent)
{
    return base > 0.0 ? pow(base, exponent) : exponent > 0.0 ? 0.0 : 1.0;
}
)";

} // namespace vo
