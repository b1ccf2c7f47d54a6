#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <optional>

namespace vo {

/// The viewer in object space, from OpenGL's matrices.
struct Camera
{
    bool perspective = false;
    glm::dvec3 eye{0.0};            ///< perspective only
    glm::dvec3 direction{0, 0, -1}; ///< unit vector from the viewer along the middle of the view
    /// Unit normal of planes parallel to the viewport, away from the viewer; exactly along an axis where
    /// rounding to single precision would explain the rest.
    glm::dvec3 depthNormal{0, 0, -1};
    double nearDepth = 0.0; ///< dot(depthNormal, p) on the near plane of the view volume, in its middle
    double farDepth = 0.0;  ///< and on the far plane; infinite for a view volume without end
    /// Corners of the view volume: bit 0 of the index is right, bit 1 is top, bit 2 is far.
    std::array<glm::dvec3, 8> corners{};

    /// Unit direction in which the viewer sees `point`; `direction` when it is the eye itself or
    /// orthographic.
    glm::dvec3 towards(const glm::dvec3& point) const;
};

/// The camera of model-view and projection matrices, column by column. Nothing for singular or non-finite
/// ones. The visible side is the one with positive clip w (perspective), or the way from z = -1 to z = 1 in
/// normalised device coordinates (orthographic).
std::optional<Camera> findCamera(const glm::dmat4& model, const glm::dmat4& projection);

} // namespace vo
