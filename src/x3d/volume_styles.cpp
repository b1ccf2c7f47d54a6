#include "x3d/volume_styles.h"

#include "style/styles.h"
#include "x3d/fixed_opacity.h"
#include "x3d/gradient_color.h"
#include "x3d/node_material.h"
#include "x3d/node_values.h"

#include <string>
#include <string_view>

namespace vo {
namespace {

constexpr int kMostDepth = 50;

RayProjection::Type projectionType(std::string_view name)
{
    return name == "MIN"       ? RayProjection::Type::min
           : name == "AVERAGE" ? RayProjection::Type::average
                               : RayProjection::Type::max;
}

Blended::Weight weightFunction(std::string_view name)
{
    return name == "ALPHA0"             ? Blended::Weight::alpha0
           : name == "ALPHA1"           ? Blended::Weight::alpha1
           : name == "ONE_MINUS_ALPHA0" ? Blended::Weight::oneMinusAlpha0
           : name == "ONE_MINUS_ALPHA1" ? Blended::Weight::oneMinusAlpha1
           : name == "TABLE"            ? Blended::Weight::table
                                        : Blended::Weight::constant;
}

bool isSet(const Node& node, const char* field)
{
    const FieldRow* const row = node.field(field);
    return row && node.isSet(row->slot);
}

} // namespace

DrawnStyle VolumeStyles::of(const Node* style, Edition edition, const VoxelsToDraw& voxels)
{
    DrawnStyle drawn;
    if (style)
        add(*style, voxels, drawn, 0);
    else
        addMap(nullptr, edition == Edition::proposal2005, voxels, drawn);
    drawn.chain = effectiveChain(drawn.chain);
    return drawn;
}

void VolumeStyles::add(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn, int depth)
{
    if (depth > kMostDepth)
        return messages_.error(style, "expected styles at most " + std::to_string(kMostDepth) +
                                          " below each other, found more: left out");
    drawn.isEnabled = drawn.isEnabled && boolOf(style, "enabled", true);
    if (isOf(&style, "ComposedVolumeStyle")) {
        const bool isComposite = style.edition() == Edition::proposal2005;
        for (const Node* const each : nodesOf(style, isComposite ? "styles" : "renderStyle"))
            if (each) add(*each, voxels, drawn, depth + 1);
    } else if (isOf(&style, "OpacityMapVolumeStyle"))
        addMap(nodeOf(style, "transferFunction"), style.edition() == Edition::proposal2005, voxels, drawn);
    else if (isOf(&style, "BoundaryEnhancementVolumeStyle"))
        addBoundary(style, voxels, drawn);
    else if (isOf(&style, "CartoonVolumeStyle"))
        addCartoon(style, voxels, drawn);
    else if (isOf(&style, "EdgeEnhancementVolumeStyle"))
        addEdge(style, voxels, drawn);
    else if (isOf(&style, "SilhouetteEnhancementVolumeStyle"))
        addSilhouette(style, voxels, drawn);
    else if (isOf(&style, "ToneMappedVolumeStyle"))
        addToneMapped(style, voxels, drawn);
    else if (isOf(&style, "ShadedVolumeStyle") || isOf(&style, "ISOSurfaceVolumeStyle"))
        addShaded(style, voxels, drawn);
    else if (isOf(&style, "BlendedVolumeStyle"))
        addBlended(style, voxels, drawn, depth);
    else if (isOf(&style, "ProjectionVolumeStyle"))
        addProjection(style, drawn);
    else if (isOf(&style, "StippleVolumeStyle"))
        addStipple(style, drawn);
}

void VolumeStyles::addMap(const Node* function, bool opaqueAtZero, const VoxelsToDraw& voxels,
                          DrawnStyle& drawn)
{
    OpacityMap fields;
    fields.transferFunction = textures_.tableOf(function);
    fields.opaqueAtZero = opaqueAtZero;
    fields.voxelComponents = voxels.texture.components;
    drawn.chain.push_back(makeStyle(std::move(fields)));
}

void VolumeStyles::addBoundary(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn)
{
    if (const Node* const function = nodeOf(style, "transferFunction")) addMap(function, true, voxels, drawn);
    for (const char* const field : {"contribution", "surfaceNormals"})
        ignore(style, field);
    surfaceNormals(style, voxels); // tells of another size, as the proposal asks
    BoundaryEnhancement fields;
    fields.retainedOpacity = floatOf(style, "retainedOpacity");
    fields.boundaryOpacity = floatOf(style, "boundaryOpacity");
    fields.opacityFactor = floatOf(style, "opacityFactor");
    drawn.chain.push_back(makeStyle(fields));
    if (isSet(style, "gradientColor")) drawn.chain.push_back(gradientColor(vec4Of(style, "gradientColor")));
}

void VolumeStyles::addCartoon(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn)
{
    Cartoon fields;
    fields.parallelColor = vec4Of(style, "parallelColor");
    fields.orthogonalColor = vec4Of(style, "orthogonalColor");
    fields.colorSteps = integerOf(style, "colorSteps");
    fields.surfaceNormals = surfaceNormals(style, voxels);
    drawn.chain.push_back(makeStyle(std::move(fields)));
}

void VolumeStyles::addEdge(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn)
{
    ignore(style, "contribution");
    EdgeEnhancement fields;
    fields.edgeColor = vec4Of(style, "edgeColor");
    fields.gradientThreshold = floatOf(style, "gradientThreshold");
    fields.surfaceNormals = surfaceNormals(style, voxels);
    drawn.chain.push_back(makeStyle(std::move(fields)));
}

/// The proposal's equation is ISO's with nothing retained and a boundary opacity of 1.
void VolumeStyles::addSilhouette(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn)
{
    const bool isOld = style.edition() == Edition::proposal2005;
    SilhouetteEnhancement fields;
    fields.retainedOpacity = isOld ? 0.0f : floatOf(style, "silhouetteRetainedOpacity");
    fields.boundaryOpacity = isOld ? 1.0f : floatOf(style, "silhouetteBoundaryOpacity");
    fields.sharpness = floatOf(style, isOld ? "silhouetteFactor" : "silhouetteSharpness");
    fields.surfaceNormals = surfaceNormals(style, voxels);
    drawn.chain.push_back(makeStyle(std::move(fields)));
}

void VolumeStyles::addToneMapped(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn)
{
    ToneMapped fields;
    fields.coolColor = vec4Of(style, "coolColor");
    fields.warmColor = vec4Of(style, "warmColor");
    fields.surfaceNormals = surfaceNormals(style, voxels);
    drawn.chain.push_back(makeStyle(std::move(fields)));
}

void VolumeStyles::addShaded(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn)
{
    Shaded fields;
    fields.lighting = boolOf(style, "lighting");
    fields.shadows = boolOf(style, "shadows");
    if (const Node* const material = nodeOf(style, "material")) {
        fields.hasMaterial = true;
        readMaterial(*material, fields);
    }
    fields.surfaceNormals = surfaceNormals(style, voxels);
    if (isOf(&style, "ISOSurfaceVolumeStyle")) {
        drawn.isSurface = true;
        drawn.chain.push_back(fixedOpacity(1.0f));
    }
    drawn.chain.push_back(makeStyle(std::move(fields)));
}

void VolumeStyles::addBlended(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn, int depth)
{
    Blended fields;
    fields.voxels = textures_.of(nodeOf(style, "voxels"));
    if (!fields.voxels)
        return messages_.warn(style, "expected voxels in BlendedVolumeStyle, found none: left out");
    fields.dimensions = voxels.dimensions;
    const VoxelsToDraw otherVoxels{*fields.voxels, voxels.dimensions};
    DrawnStyle other;
    if (const Node* const otherStyle = nodeOf(style, "renderStyle"))
        add(*otherStyle, otherVoxels, other, depth + 1);
    else
        addMap(nullptr, false, otherVoxels, other);
    if (other.projection || other.stipple)
        messages_.warn(style, "a projection or stipples in BlendedVolumeStyle.renderStyle are not drawn");
    if (!other.isEnabled) other.chain = {fixedOpacity(0.0f)};
    fields.chain = std::move(other.chain);
    fields.weightFunction1 = weightFunction(stringOf(style, "weightFunction1"));
    fields.weightFunction2 = weightFunction(stringOf(style, "weightFunction2"));
    fields.weightConstant1 = floatOf(style, "weightConstant1");
    fields.weightConstant2 = floatOf(style, "weightConstant2");
    fields.weightTransferFunction1 = textures_.tableOf(nodeOf(style, "weightTransferFunction1"));
    fields.weightTransferFunction2 = textures_.tableOf(nodeOf(style, "weightTransferFunction2"));
    drawn.chain.push_back(makeStyle(std::move(fields)));
}

void VolumeStyles::addProjection(const Node& style, DrawnStyle& drawn)
{
    drawn.projection =
        RayProjection{projectionType(stringOf(style, "type")), floatOf(style, "intensityThreshold")};
}

void VolumeStyles::addStipple(const Node& style, DrawnStyle& drawn)
{
    StippleFactors fields;
    fields.distanceFactor = floatOf(style, "distanceFactor");
    fields.interiorFactor = floatOf(style, "interiorFactor");
    fields.lightingFactor = floatOf(style, "lightingFactor");
    fields.resolutionFactor = floatOf(style, "resolutionFactor");
    fields.gradientThreshold = floatOf(style, "gradientThreshold");
    fields.gradientRetainedOpacity = floatOf(style, "gradientRetainedOpacity");
    fields.gradientBoundaryOpacity = floatOf(style, "gradientBoundaryOpacity");
    fields.gradientOpacityFactor = floatOf(style, "gradientOpacityFactor");
    fields.silhouetteRetainedOpacity = floatOf(style, "silhouetteRetainedOpacity");
    fields.silhouetteBoundaryOpacity = floatOf(style, "silhouetteBoundaryOpacity");
    fields.silhouetteOpacityFactor = floatOf(style, "silhouetteOpacityFactor");
    drawn.stipple = std::move(fields);
}

std::shared_ptr<const VoxelTexture> VolumeStyles::normals(const Node& owner, const Node* node,
                                                          const VoxelTexture& voxels)
{
    auto texture = textures_.of(node);
    if (!texture) return nullptr;
    if (texture->components >= 3 && texture->size == voxels.size) return texture;
    messages_.warn(owner, owner.typeName() + ": expected normals of the voxels' size, " +
                              sizeText(voxels.size) + ", with 3 components, found " +
                              sizeText(texture->size) + " with " + std::to_string(texture->components) +
                              ": computed from the voxels instead");
    return nullptr;
}

std::shared_ptr<const VoxelTexture> VolumeStyles::surfaceNormals(const Node& style,
                                                                 const VoxelsToDraw& voxels)
{
    return normals(style, nodeOf(style, "surfaceNormals"), voxels.texture);
}

void VolumeStyles::ignore(const Node& style, const char* field)
{
    if (isSet(style, field))
        messages_.warn(style, style.typeName() + "." + field + " is in no equation and changes nothing");
}

} // namespace vo
