#pragma once

#include "cast/padded_voxels.h"
#include "draw/scene_context.h"
#include "style/voxel_texture.h"

#include <cstdint>
#include <memory>
#include <unordered_map>

namespace vo {

/// The textures of scenes in OpenGL, by their serial number. All are three-dimensional; components answer in
/// red, green, blue, alpha, in this order.
class StyleTextures
{
public:
    explicit StyleTextures(const SceneContext& context) : context_(context) {}
    ~StyleTextures();
    StyleTextures(const StyleTextures&) = delete;
    StyleTextures& operator=(const StyleTextures&) = delete;

    /// Binds it to a unit, and sends it first if need be. Throws std::runtime_error if the driver cannot hold
    /// it.
    void bind(int unit, const VoxelTexture& texture);
    /// What values the blocks of a texture of one component have; without blocks where that is not known.
    /// Found when it is asked for first.
    const VoxelBlocks& blocks(const VoxelTexture& texture);
    /// To be called once a picture: forgets those that many pictures had no use for.
    void endPicture();

private:
    struct Resident
    {
        GLuint name = 0;
        std::uint64_t lastPicture = 0;
        std::unique_ptr<const VoxelBlocks> blocks;
    };

    void send(const VoxelTexture& texture) const;

    const SceneContext& context_;
    std::unordered_map<std::uint64_t, Resident> resident_;
    std::uint64_t picture_ = 0;
};

} // namespace vo
