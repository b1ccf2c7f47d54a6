#pragma once

#include "x3d/scene.h"
#include "x3d/surface_mesh.h"
#include "x3d/view_messages.h"

namespace vo {

/// An IndexedFaceSet or an IndexedTriangleSet. Faces that name points which are not there are left out, with
/// a message.
SurfaceMesh faceSetMesh(const Node& node, ViewMessages& messages);

} // namespace vo
