#include "style/shine.h"

#include <algorithm>
#include <cmath>

namespace vo {

const char* const kDirectionToGlsl = R"(
vec3 directionTo(StyleLight light, vec3 position)
{
    if (light.kind == 0) return -light.direction;
    vec3 way = light.position - position;
    float size = length(way);
    return size > 0.0 ? way / size : vec3(0.0);
}
)";

const char* const kStrengthOfGlsl = R"(
float spotOf(StyleLight light, vec3 L)
{
    float angle = acos(clamp(-dot(L, light.direction), -1.0, 1.0));
    if (angle >= light.cutOffAngle) return 0.0;
    if (angle <= light.beamWidth) return 1.0;
    return (angle - light.cutOffAngle) / (light.beamWidth - light.cutOffAngle);
}
float strengthOf(StyleLight light, vec3 L, vec3 position)
{
    if (light.kind == 0) return 1.0;
    float d = distance(light.position, position);
    if (d > light.radius) return 0.0;
    float attenuation = 1.0 / max(dot(light.attenuation, vec3(1.0, d, d * d)), 1.0);
    return light.kind == 2 ? attenuation * spotOf(light, L) : attenuation;
}
)";

// att spot IL (Ia CD Ca + I T CD (N.L) + I T CS (N.H)^exponent), where products below 0 are 0. T is what of
// the light comes through.
const char* const kLitByGlsl = R"(
vec3 litBy(StyleLight light, vec3 position, vec3 n, vec3 V, vec3 CD, vec3 CS, float Ca, float exponent, float through)
{
    vec3 L = directionTo(light, position);
    vec3 H = L + V;
    float size = length(H);
    float nH = size > 0.0 ? dot(n, H) / size : 0.0;
    float specular = nH > 0.0 ? raised(nH, exponent) : 0.0;
    vec3 I = light.intensity * through * (max(dot(n, L), 0.0) * CD + specular * CS);
    return strengthOf(light, L, position) * light.color * (light.ambientIntensity * Ca * CD + I);
}
)";

namespace {

/// To a point, and how far that is.
void waysTo(const glm::vec3& point, const SampleBatch& samples, BatchVectors& L, BatchFloats& distance)
{
    const auto& [x, y, z] = samples.position;
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        const float dx = point.x - x[i];
        const float dy = point.y - y[i];
        const float dz = point.z - z[i];
        const float d = std::sqrt(dx * dx + dy * dy + dz * dz);
        const float scale = d > 0.0f ? 1.0f / d : 0.0f;
        distance[i] = d;
        L[0][i] = dx * scale;
        L[1][i] = dy * scale;
        L[2][i] = dz * scale;
    }
}

void fillDirections(const StyleLight& light, BatchVectors& L)
{
    for (int axis = 0; axis < 3; ++axis)
        L[static_cast<std::size_t>(axis)].fill(-light.direction[axis]);
}

float spotOf(const StyleLight& light, float cosine)
{
    const float angle = std::acos(std::clamp(cosine, -1.0f, 1.0f));
    if (angle >= light.cutOffAngle) return 0.0f;
    if (angle <= light.beamWidth) return 1.0f;
    return (angle - light.cutOffAngle) / (light.beamWidth - light.cutOffAngle);
}

} // namespace

void directionsTo(const StyleLight& light, const SampleBatch& samples, BatchVectors& L)
{
    BatchFloats distance;
    if (light.kind == StyleLight::Kind::directional)
        fillDirections(light, L);
    else
        waysTo(light.position, samples, L, distance);
}

void shineOf(const StyleLight& light, const SampleBatch& samples, Shine& shine)
{
    if (light.kind == StyleLight::Kind::directional) {
        fillDirections(light, shine.L);
        shine.strength.fill(1.0f);
        return;
    }
    BatchFloats distance;
    waysTo(light.position, samples, shine.L, distance);
    const glm::vec3& a = light.attenuation;
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        const float d = distance[i];
        const float attenuation = 1.0f / std::max(a.x + a.y * d + a.z * d * d, 1.0f);
        shine.strength[i] = d > light.radius ? 0.0f : attenuation;
    }
    if (light.kind != StyleLight::Kind::spot) return;
    const glm::vec3& to = light.direction;
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i)
        shine.strength[i] *=
            spotOf(light, -(shine.L[0][i] * to.x + shine.L[1][i] * to.y + shine.L[2][i] * to.z));
}

} // namespace vo
