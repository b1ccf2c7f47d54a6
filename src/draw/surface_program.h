#pragma once

#include "draw/scene_programs.h"
#include "style/styled_scene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>

namespace vo {

/// Where the parts of a vertex record of a surface lie. Plane and depths are those of its triangle: the plane
/// in eye space, dot(plane, (p, 1)) = 0; the least and the greatest eye depth, and how far beyond a slab
/// it is drawn before pixels are looked at one by one; windowPlane() of what shares its plane.
enum SurfaceAttribute : unsigned {
    kSurfacePosition = 0,
    kSurfaceNormal = 1,
    kSurfaceColor = 2,
    kSurfacePlane = 3,
    kSurfaceDepths = 4,
    kSurfaceWindowPlane = 5
};

/// What of a surface is drawn: all, or the part of it that lies between two depths (uniform `slab`: the
/// nearest, and the farthest, which belongs to what is behind; no pixel twice), or the next hit of each pixel
/// (draw/ray_hits.h: uniforms `reached`, `windowDepths`, `source`, and `firstTriangle`, how many come
/// before).
enum class SurfacePart { whole, slab, hit };

/// Where the depth of a triangle's pixels comes from: its corners, or the plane that it shares with others,
/// so that they have one depth. Of whole surfaces the uniform `windowPlane` has it.
enum class SurfaceDepths { ofCorners, ofPlane };

struct SurfaceRequest
{
    SurfacePart part = SurfacePart::whole;
    SurfaceDepths depths = SurfaceDepths::ofCorners;
    std::uint32_t uncut = 0; ///< uncutPlanes() of what is drawn
};

/// A surface's program, in use and with all that it knows of the scene.
SceneProgram& useSurfaceProgram(const StyledScene& scene, const StyledSurface& surface,
                                const SurfaceRequest& request, ScenePrograms& programs);

/// Of a plane of eye space: (a, b, c, 1), the window's depth being a * x + b * y + c in normalised device
/// coordinates and from 0 to 1; 0 for a plane that is seen from its edge.
glm::vec4 windowPlane(const glm::dvec4& eyePlane, const glm::dmat4& clipFromEye);

} // namespace vo
