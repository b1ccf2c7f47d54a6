#include "x3d/node_lights.h"

#include "x3d/node_values.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace vo {

StyleLight localLight(const StyleLight& light, const glm::dmat4& localFromWorld)
{
    StyleLight moved = light;
    moved.position = glm::vec3(localFromWorld * glm::dvec4(light.position, 1.0));
    const glm::dvec3 direction(localFromWorld * glm::dvec4(light.direction, 0.0));
    const double length = glm::length(direction);
    moved.direction = glm::vec3(length > 0.0 ? direction / length : glm::dvec3(0, 0, -1));
    const auto scale = static_cast<float>(std::cbrt(std::abs(glm::determinant(glm::dmat3(localFromWorld)))));
    moved.radius *= scale;
    if (scale > 0.0f) moved.attenuation /= glm::vec3(1.0f, scale, scale * scale);
    return moved;
}

StyleLight worldLight(const Node& node, const glm::dmat4& worldFromLocal)
{
    StyleLight light;
    light.kind = isOf(&node, "DirectionalLight") ? StyleLight::Kind::directional
                 : isOf(&node, "SpotLight")      ? StyleLight::Kind::spot
                                                 : StyleLight::Kind::point;
    light.color = vec3Of(node, "color", light.color);
    light.intensity = floatOf(node, "intensity", light.intensity);
    light.ambientIntensity = floatOf(node, "ambientIntensity", light.ambientIntensity);
    light.position = vec3Of(node, "location", light.position);
    light.direction = vec3Of(node, "direction", light.direction);
    if (light.direction == glm::vec3(0.0f)) light.direction = {0, 0, -1};
    light.attenuation = vec3Of(node, "attenuation", light.attenuation);
    light.radius = floatOf(node, "radius", light.radius);
    light.beamWidth = floatOf(node, "beamWidth", light.beamWidth);
    light.cutOffAngle = floatOf(node, "cutOffAngle", light.cutOffAngle);
    return localLight(light, worldFromLocal);
}

void limitLights(const Node& node, std::vector<StyleLight>& lights, ViewMessages& messages)
{
    if (lights.size() <= kMostLights) return;
    messages.warn(node, "expected at most " + std::to_string(kMostLights) + " lights, found " +
                            std::to_string(lights.size()) + ": the first shine on it");
    lights.resize(kMostLights);
}

StyleLight headlight(const glm::dmat4& eyeFromWorld)
{
    StyleLight light;
    light.direction = glm::vec3(-glm::transpose(glm::dmat3(eyeFromWorld))[2]);
    return light;
}

} // namespace vo
