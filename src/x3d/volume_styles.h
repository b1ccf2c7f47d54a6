#pragma once

#include "style/styled_scene.h"
#include "x3d/view_messages.h"
#include "x3d/voxel_textures.h"

#include <memory>
#include <optional>

namespace vo {

/// What a style node asks for.
struct DrawnStyle
{
    StyleChain chain;
    std::optional<RayProjection> projection;
    std::optional<StippleFactors> stipple;
    bool isSurface = false; ///< ISOSurfaceVolumeStyle: the chain is that of a surface
    bool isEnabled = true;  ///< else what it is for is not drawn
};

/// What a style is to draw.
struct VoxelsToDraw
{
    const VoxelTexture& texture;
    glm::vec3 dimensions; ///< of the volume
};

/// Makes chains of style nodes.
class VolumeStyles
{
public:
    VolumeStyles(VoxelTextures& textures, ViewMessages& messages) : textures_(textures), messages_(messages)
    {
    }

    /// Of a style; NULL: an OpacityMapVolumeStyle with the defaults of `edition`.
    DrawnStyle of(const Node* style, Edition edition, const VoxelsToDraw& voxels);

    /// Normals of a texture: three components, and the size of the voxels; else nothing, with a message.
    std::shared_ptr<const VoxelTexture> normals(const Node& owner, const Node* node,
                                                const VoxelTexture& voxels);

private:
    void add(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn, int depth);
    void addMap(const Node* function, bool opaqueAtZero, const VoxelsToDraw& voxels, DrawnStyle& drawn);
    void addBoundary(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn);
    void addCartoon(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn);
    void addEdge(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn);
    void addSilhouette(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn);
    void addToneMapped(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn);
    void addShaded(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn);
    void addBlended(const Node& style, const VoxelsToDraw& voxels, DrawnStyle& drawn, int depth);
    void addProjection(const Node& style, DrawnStyle& drawn);
    void addStipple(const Node& style, DrawnStyle& drawn);
    std::shared_ptr<const VoxelTexture> surfaceNormals(const Node& style, const VoxelsToDraw& voxels);
    void ignore(const Node& style, const char* field);

    VoxelTextures& textures_;
    ViewMessages& messages_;
};

} // namespace vo
