#pragma once

#include "style/styled_scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace vo {

/// The background of one picture. Borrows the colours.
class Sky
{
public:
    Sky(const SkyColors& colors, const glm::dmat4& worldFromEye);

    /// In a direction of eye space: colour multiplied by opacity, and opacity.
    glm::vec4 at(const glm::dvec3& direction) const;

private:
    const SkyColors& colors_;
    glm::dmat3 backgroundFromEye_;
    float opacity_;
};

} // namespace vo
