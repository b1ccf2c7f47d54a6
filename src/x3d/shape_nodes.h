#pragma once

#include "style/styled_scene.h"
#include "x3d/node_cameras.h"
#include "x3d/scene_walk.h"
#include "x3d/surface_mesh.h"
#include "x3d/view_messages.h"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace vo {

/// Makes surfaces of Shapes. Triangles of a geometry node are made once, until a value changes.
class ShapeNodes
{
public:
    explicit ShapeNodes(ViewMessages& messages) : messages_(messages) {}

    /// Local; empty where there is nothing.
    ViewBox boxOf(const Node& shape);
    /// Nothing where nothing of it is drawn. Lights are those that the node was found with.
    std::optional<StyledSurface> of(const ShownNode& shown);

private:
    struct Kept
    {
        std::vector<std::pair<const Node*, std::uint64_t>> state;
        SurfaceMesh mesh;
        ViewBox box;
    };
    const Kept* geometryOf(const Node& shape);
    void applyMaterial(const Node& shape, const SurfaceMesh& mesh, StyledSurface& surface);
    void applyColors(const SurfaceMesh& mesh, StyledSurface& surface) const;
    void tellOfTextures(const Node& appearance);

    ViewMessages& messages_;
    std::map<const Node*, Kept> kept_;
};

} // namespace vo
