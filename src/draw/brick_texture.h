#pragma once

#include "appearance/voxel_format.h"
#include "core/volume_size.h"
#include "draw/context_record.h"

#include <cstddef>
#include <span>

namespace vo {

/// What a texture is made from. `id` stands for the texture as long as it lives, `version` for its present
/// voxels.
struct TextureImage
{
    std::uint64_t id = 0;
    std::uint64_t version = 0;
    bool twoDimensional = false; ///< one of the sizes is 1: GL_TEXTURE_2D over the other two axes
    VoxelSize size;
    VoxelFormat format;
    TexelFormat texel = TexelFormat::intensity;
    std::span<const std::byte> voxels; ///< in `format`, x fastest; may be empty while the texture is resident
};

/// What a texture answers when sampled; a table before interpolation makes red, green, blue and alpha of
/// anything.
struct TextureAnswer
{
    bool oneChannel; ///< one number, in red
    bool hasAlpha;   ///< in the sense of GL_REPLACE
};
TextureAnswer textureAnswer(TexelFormat texel, bool classified);

enum class TextureResult { ok, tooLarge, outOfMemory, noVoxels };

/// Binds the texture of `image` to the active unit. It is downloaded first when it is not resident, is stale
/// (its version, or the pre-interpolation table, changed), or `always`. The caller's pixel state is given
/// back.
TextureResult bindTexture(ContextRecord& context, const TextureImage& image, bool always);

/// Texture coordinates of a brick as rows (a, b, c, d): coordinate = dot(row, (x, y, z, 1)). A
/// two-dimensional texture uses the first two rows, for the two axes that are thicker than 1 in their order.
struct TexgenPlanes
{
    glm::vec4 rows[3];
};
TexgenPlanes texgenPlanes(const glm::vec3& origin, const glm::vec3& size, bool twoDimensional, int thinAxis);

} // namespace vo
