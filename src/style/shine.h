#pragma once

#include "style/style.h"

namespace vo {

/// What a light does at samples.
struct Shine
{
    BatchVectors L;       ///< unit vectors to the light; 0 0 0 at the light itself
    BatchFloats strength; ///< attenuation and spot, 0 beyond its radius
};

/// Needs positions for point and spot lights.
void shineOf(const StyleLight& light, const SampleBatch& samples, Shine& shine);
/// Of shineOf the directions alone.
void directionsTo(const StyleLight& light, const SampleBatch& samples, BatchVectors& L);

/// The same: vec3 directionTo(StyleLight light, vec3 position) and float strengthOf(StyleLight light, vec3 L,
/// vec3 position).
extern const char* const kDirectionToGlsl;
extern const char* const kStrengthOfGlsl;
/// What a light adds to the colour of what it falls on: vec3 litBy(StyleLight light, vec3 position, vec3 n,
/// vec3 V, vec3 CD, vec3 CS, float Ca, float exponent, float through). After the two before and kRaisedGlsl.
extern const char* const kLitByGlsl;

} // namespace vo
