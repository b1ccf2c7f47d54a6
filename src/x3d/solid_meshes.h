#pragma once

#include "x3d/scene.h"
#include "x3d/surface_mesh.h"

namespace vo {

/// A Box, Sphere, Cone or Cylinder; what is round has 48 sides.
SurfaceMesh solidMesh(const Node& node);

} // namespace vo
