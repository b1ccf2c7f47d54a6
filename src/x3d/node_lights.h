#pragma once

#include "style/style.h"
#include "x3d/scene.h"
#include "x3d/view_messages.h"

#include <glm/mat4x4.hpp>

namespace vo {

/// A light node in the world.
StyleLight worldLight(const Node& node, const glm::dmat4& worldFromLocal);

/// A light of the world in a local space: lengths go by the mean scale of the matrix.
StyleLight localLight(const StyleLight& light, const glm::dmat4& localFromWorld);

/// Keeps the first kMostLights; says so of the node that they shine on.
void limitLights(const Node& node, std::vector<StyleLight>& lights, ViewMessages& messages);

/// One that shines from the eye the way it looks.
StyleLight headlight(const glm::dmat4& eyeFromWorld);

} // namespace vo
