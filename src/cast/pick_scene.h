#pragma once

#include "style/styled_scene.h"

#include <limits>

namespace vo {

/// What a ray through a picture meets first.
struct SceneHit
{
    enum class Kind { nothing, surface, bounds, voxel };
    Kind kind = Kind::nothing;
    int id = 0; ///< of the volume or the surface
    glm::dvec3 world{0.0}, local{0.0};
    glm::dvec3 place{0.0};                                  ///< of a volume: S, T and R
    glm::vec3 normal{0.0f};                                 ///< local, unit; 0 0 0 where there is none
    float opacity = 0.0f;                                   ///< of a voxel: of a unit of length
    double depth = std::numeric_limits<double>::infinity(); ///< in eye space
};

/// What is met first at a point of the picture, in pixels from its left and lower edge: surfaces,
/// isosurfaces, and of volumes the first sample with more than the opacity `threshold` after its styles;
/// below 0 their bounds. Of projections it is the sample that is shown (of a mean the one that adds most to
/// it), which stands where standingDepth() says; of stipples, which are opaque, the point of the pixel
/// or else the nearest one up to 3 pixels from it.
SceneHit pickScene(const StyledScene& scene, double x, double y, float threshold);

} // namespace vo
