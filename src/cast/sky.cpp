#include "cast/sky.h"

#include <glm/gtc/constants.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace vo {

namespace {

/// The colour at an angle from the pole; nothing past the last angle, if the colours end there.
std::optional<glm::vec3> colorAt(std::span<const glm::vec3> colors, std::span<const float> angles,
                                 float angle, bool ends)
{
    if (colors.empty()) return std::nullopt;
    const std::size_t steps = std::min(colors.size() - 1, angles.size());
    float below = 0.0f;
    for (std::size_t i = 0; i < steps; ++i) {
        if (angle <= angles[i]) {
            const float width = angles[i] - below;
            return glm::mix(colors[i], colors[i + 1], width > 0.0f ? (angle - below) / width : 1.0f);
        }
        below = angles[i];
    }
    if (ends) return std::nullopt;
    return colors[steps];
}

} // namespace

Sky::Sky(const SkyColors& colors, const glm::dmat4& worldFromEye)
    : colors_(colors),
      backgroundFromEye_(glm::inverse(colors.worldFromBackground) * glm::dmat3(worldFromEye)),
      opacity_(std::clamp(colors.opacity, 0.0f, 1.0f))
{
}

glm::vec4 Sky::at(const glm::dvec3& direction) const
{
    const glm::dvec3 local = backgroundFromEye_ * direction;
    const double length = glm::length(local);
    const auto up = static_cast<float>(length > 0.0 ? local.y / length : 0.0);
    const float fromZenith = std::acos(std::clamp(up, -1.0f, 1.0f));
    std::optional<glm::vec3> color =
        colorAt(colors_.ground, colors_.groundAngles, glm::pi<float>() - fromZenith, true);
    if (!color) color = colorAt(colors_.sky, colors_.skyAngles, fromZenith, false);
    return {color.value_or(glm::vec3(0.0f)) * opacity_, opacity_};
}

} // namespace vo
