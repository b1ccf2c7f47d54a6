#pragma once

#include "style/styled_scene.h"

#include <cstdint>
#include <vector>

namespace vo {

/// Most texels of shadows along the longest side of a box; the other sides have as many as their length
/// needs.
constexpr int kShadowTexels = 128;

/// What of a volume stands between a place and a light, at the centres of texels that fill the box.
struct ShadowGrid
{
    /// A surface, and what comes through it.
    struct Surface
    {
        float value, through;
    };

    VoxelSize size;
    glm::vec3 edges{1.0f}; ///< of a texel, local
    std::vector<float>
        texels; ///< optical depth of a unit of local length; for surfaces the value, none where clipped
    bool hasSurfaces = false;      ///< light ends at them instead
    std::vector<Surface> surfaces; ///< rising
};

/// How far from a sample, local, its shadows begin, so that the texels of a surface do not darken itself.
float shadowOffset(const glm::vec3& dimensions);

/// The opacity that samples have after their chain, seen along their normal: of styles that look at the eye
/// too. Clipped parts are clear. A surface has the opacity of its chain for a voxel of its value. In up to
/// `threads` threads (0: the usual number). Throws std::bad_alloc. Needs isSound() and no tetrahedra.
ShadowGrid shadowGridOf(const StyledVolume& volume, int threads);

/// What of a light comes through to the centre of each texel, 65535 for all.
std::vector<std::uint16_t> lightThrough(const ShadowGrid& grid, const StyleLight& light, int threads);

} // namespace vo
