#pragma once

#include "core/invertible.h"
#include "x3d/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace vo {

/// The matrix of an axis and an angle in radians; no rotation where there is no axis.
glm::dmat4 rotationMatrix(const glm::vec4& axisAngle);

/// Of a Transform: from the space of its children to the space that it stands in.
glm::dmat4 transformMatrix(const Node& transform);

/// The axes of a matrix without scales and shear, right-handed: -z stays where it was, y is as near as can
/// be.
glm::dmat3 rigidAxes(const glm::dmat4& matrix);

/// The smallest factor by which lengths change.
double smallestScale(const glm::dmat4& matrix);

} // namespace vo
