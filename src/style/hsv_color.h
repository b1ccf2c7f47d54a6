#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

/// Hue (0 to 6: red, yellow, green ...), saturation and value of red, green and blue.
inline glm::dvec3 hsvOf(const glm::dvec3& rgb)
{
    const double most = std::max({rgb.r, rgb.g, rgb.b}), range = most - std::min({rgb.r, rgb.g, rgb.b});
    if (range <= 0.0) return {0.0, 0.0, most};
    const double hue = most == rgb.r   ? (rgb.g - rgb.b) / range
                       : most == rgb.g ? 2.0 + (rgb.b - rgb.r) / range
                                       : 4.0 + (rgb.r - rgb.g) / range;
    return {hue < 0.0 ? hue + 6.0 : hue, range / most, most};
}

/// Back again; of hues from 0 on.
inline glm::dvec3 rgbOf(const glm::dvec3& hsv)
{
    const auto channel = [&](double shift) {
        const double place = std::fmod(hsv.x + shift, 6.0);
        return hsv.z * std::lerp(1.0, std::clamp(std::abs(place - 3.0) - 1.0, 0.0, 1.0), hsv.y);
    };
    return {channel(0.0), channel(4.0), channel(2.0)};
}

/// What lies between two colours, 0 to 1: hues go the shorter way, and a grey, which has none, takes the
/// other's.
struct HsvRamp
{
    glm::dvec3 from, to; ///< hue, saturation, value; hues at most 3 apart

    HsvRamp(const glm::dvec3& fromRgb, const glm::dvec3& toRgb) : from(hsvOf(fromRgb)), to(hsvOf(toRgb))
    {
        if (from.y <= 0.0) from.x = to.x;
        if (to.y <= 0.0) to.x = from.x;
        if (to.x - from.x > 3.0) from.x += 6.0;
        if (from.x - to.x > 3.0) to.x += 6.0;
    }
    glm::dvec3 rgbAt(double part) const { return rgbOf(glm::mix(from, to, part)); }
};

} // namespace vo
