#pragma once

#include "core/invertible.h"
#include "style/styled_scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <utility>

namespace vo {

/// What a pixel sees, in eye space or another: the point at eye depth d is origin + direction * d.
struct DepthRay
{
    glm::dvec3 origin{0.0}, direction{0.0, 0.0, -1.0};

    glm::dvec3 at(double depth) const { return origin + direction * depth; }
};

/// Part of a ray, in eye depth; empty where begin is above end.
struct RayPart
{
    double begin = 0.0, end = 0.0;

    bool empty() const { return !(begin <= end); }
    /// Keeps the part where value + slope * depth is not negative.
    void cut(double value, double slope);
};

/// The rays of a scene's pixels.
class SceneRays
{
public:
    /// Nothing for matrices that are singular or not finite, and for pictures without pixels.
    static std::optional<SceneRays> of(const StyledScene& scene);

    /// Of a point of the picture in pixels from its left and lower edge, in eye space.
    DepthRay ray(double x, double y) const;
    /// Eye depth of a normalised device coordinate z under such a point.
    double depthAt(double x, double y, double z) const;
    /// From the near to the far plane, both of which lie across the view.
    const RayPart& depths() const { return depths_; }
    const glm::dmat4& worldFromEye() const { return worldFromEye_; }
    /// edgeShift() of the scene.
    const glm::dmat4& shift() const { return shift_; }

private:
    glm::dmat4 worldFromEye_{1.0}, eyeFromClip_{1.0}, shift_{1.0};
    glm::dvec2 pixel_{1.0};
    RayPart depths_;
};

/// Where a point of eye space stands in the picture: pixels from its left and lower edge times w, and w.
glm::dvec3 windowOf(const StyledScene& scene, const glm::dvec4& eye);

/// The ray in another space.
DepthRay transformed(const glm::dmat4& matrix, const DepthRay& ray);

} // namespace vo
