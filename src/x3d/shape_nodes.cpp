#include "x3d/shape_nodes.h"

#include "x3d/face_set_mesh.h"
#include "x3d/node_lights.h"
#include "x3d/node_material.h"
#include "x3d/node_values.h"
#include "x3d/solid_meshes.h"

#include <string>

namespace vo {
namespace {

/// Shines from everywhere, so that what it falls on has the colour that it is given.
StyleLight evenLight()
{
    StyleLight light;
    light.intensity = 0.0f;
    light.ambientIntensity = 1.0f;
    return light;
}

} // namespace

const ShapeNodes::Kept* ShapeNodes::geometryOf(const Node& shape)
{
    const Node* const geometry = nodeOf(shape, "geometry");
    if (!geometry) return nullptr;
    std::vector<std::pair<const Node*, std::uint64_t>> state{{geometry, geometry->revision()}};
    for (const char* const field : {"coord", "color", "normal"})
        if (const Node* const below = nodeOf(*geometry, field)) state.emplace_back(below, below->revision());
    Kept& kept = kept_[geometry];
    if (kept.state == state) return &kept;
    kept.state = std::move(state);
    const bool isFaces = isOf(geometry, "X3DComposedGeometryNode");
    kept.mesh = isFaces ? faceSetMesh(*geometry, messages_) : solidMesh(*geometry);
    kept.box = {};
    for (const glm::vec3& position : kept.mesh.positions)
        kept.box.add(glm::dvec3(position));
    return &kept;
}

ViewBox ShapeNodes::boxOf(const Node& shape)
{
    const Kept* const kept = geometryOf(shape);
    return kept ? kept->box : ViewBox{};
}

std::optional<StyledSurface> ShapeNodes::of(const ShownNode& shown)
{
    const Kept* const kept = geometryOf(*shown.node);
    if (!kept || kept->mesh.triangles.empty()) return {};
    StyledSurface surface;
    surface.worldFromLocal = shown.worldFromLocal;
    surface.positions = kept->mesh.positions;
    surface.normals = kept->mesh.normals;
    surface.triangles = kept->mesh.triangles;
    surface.solid = kept->mesh.solid;
    surface.clipPlanes = shown.clipPlanes;
    surface.lights = shown.lights;
    limitLights(*shown.node, surface.lights, messages_);
    applyMaterial(*shown.node, kept->mesh, surface);
    return surface;
}

/// Without a Material a Shape is not lit, and white if it has no colours.
void ShapeNodes::applyMaterial(const Node& shape, const SurfaceMesh& mesh, StyledSurface& surface)
{
    const Node* const appearance = nodeOf(shape, "appearance");
    const Node* const material = appearance ? nodeOf(*appearance, "material") : nullptr;
    if (appearance) tellOfTextures(*appearance);
    if (material) {
        readMaterial(*material, surface);
    } else if (mesh.colors.empty()) {
        surface.lit = false;
        surface.emissive = glm::vec3(1.0f);
    } else {
        surface.ambientIntensity = 1.0f;
        surface.lights = {evenLight()};
    }
    applyColors(mesh, surface);
}

void ShapeNodes::applyColors(const SurfaceMesh& mesh, StyledSurface& surface) const
{
    surface.colors = mesh.colors;
    for (glm::vec4& color : surface.colors)
        if (!mesh.colorsHaveAlpha) color.a = 1.0f - surface.transparency;
}

void ShapeNodes::tellOfTextures(const Node& appearance)
{
    for (const char* const field : {"texture", "backMaterial"})
        if (nodeOf(appearance, field))
            messages_.warn(appearance, std::string("Appearance.") + field + " is not drawn");
    const Node* const material = nodeOf(appearance, "material");
    for (const char* const field : {"ambientTexture", "diffuseTexture", "emissiveTexture", "normalTexture",
                                    "occlusionTexture", "shininessTexture", "specularTexture"})
        if (material && nodeOf(*material, field))
            messages_.warn(*material, std::string("Material.") + field + " is not drawn");
}

} // namespace vo
