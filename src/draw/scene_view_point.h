#pragma once

#include "style/styled_scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace vo {

/// Eye depths, along the view, between which the projection shows something.
struct DepthsSeen
{
    double nearest, farthest;
};
DepthsSeen depthsSeen(const glm::dmat4& clipFromEye);

bool isPerspective(const glm::dmat4& clipFromEye);

/// What pixels see, in eye space: the point at eye depth d is origin + d * direction. Columns are both at the
/// middle of the picture, and their change to its right and its upper edge.
struct EyeRays
{
    glm::dmat3 origin, direction;
};
EyeRays eyeRays(const glm::dmat4& clipFromEye);

/// The eye in a space of the scene (w 1), or the way of rays over a unit of eye depth (w 0).
glm::dvec4 viewerIn(const StyledScene& scene, const glm::dmat4& worldFromSpace);

/// dot(row, point) is the eye depth of a point of that space.
glm::dvec4 depthRowOf(const StyledScene& scene, const glm::dmat4& worldFromSpace);

} // namespace vo
