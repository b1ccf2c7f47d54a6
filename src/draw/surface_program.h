#pragma once

#include "draw/scene_programs.h"
#include "style/styled_scene.h"

#include <cstddef>

namespace vo {

/// Where the parts of a vertex record of a surface lie. Plane and depths are those of its triangle: the plane
/// in eye space, dot(plane, (p, 1)) = 0; the least and the greatest eye depth, and how far beyond a slab
/// it is drawn before pixels are looked at one by one.
enum SurfaceAttribute : unsigned {
    kSurfacePosition = 0,
    kSurfaceNormal = 1,
    kSurfaceColor = 2,
    kSurfacePlane = 3,
    kSurfaceDepths = 4
};

/// What of a surface is drawn: all, or the part of it that lies between two depths (uniform `slab`: the
/// nearest, and the farthest, which belongs to what is behind; no pixel twice), or the next hit of each pixel
/// (draw/ray_hits.h: uniforms `reached`, `windowDepths`, `source`, and `firstTriangle`, how many come
/// before).
enum class SurfacePart { whole, slab, hit };

/// A surface's program, in use and with all that it knows of the scene.
SceneProgram& useSurfaceProgram(const StyledScene& scene, const StyledSurface& surface, SurfacePart part,
                                ScenePrograms& programs);

} // namespace vo
