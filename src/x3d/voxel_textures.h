#pragma once

#include "x3d/scene.h"
#include "x3d/view_messages.h"
#include "x3d/voxel_files.h"

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace vo {

/// Whether a texture has no texels for a value that its file has and that was left out, as was told.
bool lacksRefusedValue(const Scene& scene, const Node& node);

/// The textures of texture nodes, of two and of three dimensions. Each is made once, for all places that its
/// node stands in, until a value of the node changes. In a texture of two dimensions T rises from the bottom
/// row of the picture.
class VoxelTextures
{
public:
    VoxelTextures(const Scene& scene, ViewMessages& messages, VoxelReading reading = VoxelReading::whole)
        : scene_(scene), messages_(messages), reading_(reading)
    {
    }

    /// Nothing where there is none (a message says why), or for NULL.
    std::shared_ptr<const VoxelTexture> of(const Node* node, TexelUse use = TexelUse::values);
    /// The same with all of its texels, however much of voxels is read.
    std::shared_ptr<const VoxelTexture> tableOf(const Node* node);

    /// The first components of each texel alone.
    std::shared_ptr<const VoxelTexture> firstComponents(const std::shared_ptr<const VoxelTexture>& texture,
                                                        int count);

private:
    std::shared_ptr<const VoxelTexture> of(const Node* node, TexelUse use, VoxelReading reading);
    using State = std::vector<std::pair<const Node*, std::uint64_t>>;
    struct Kept
    {
        State state;
        std::shared_ptr<const VoxelTexture> texture;
    };

    TextureResult make(const Node& node, TexelUse use, VoxelReading reading);
    TextureResult readUrls(const Node& node, TexelUse use, VoxelReading reading);
    TextureResult readFile(const Node& node, const std::string& path, TexelUse use, VoxelReading reading);
    TextureResult composed(const Node& node, TexelUse use, VoxelReading reading);
    void applyProperties(const Node& node, VoxelTexture& texture);

    const Scene& scene_;
    ViewMessages& messages_;
    VoxelReading reading_;
    std::map<std::tuple<const Node*, TexelUse, VoxelReading>, Kept> kept_;
    std::map<std::pair<std::shared_ptr<const VoxelTexture>, int>, std::shared_ptr<const VoxelTexture>> parts_;
};

} // namespace vo
