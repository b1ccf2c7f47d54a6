#pragma once

#include "style/styled_scene.h"

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

/// The eye in a space of the scene (w 1), or the way of rays over a unit of eye depth (w 0).
glm::dvec4 viewerIn(const StyledScene& scene, const glm::dmat4& worldFromSpace);

/// dot(row, point) is the eye depth of a point of that space.
glm::dvec4 depthRowOf(const StyledScene& scene, const glm::dmat4& worldFromSpace);

} // namespace vo
