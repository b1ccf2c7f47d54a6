#pragma once

#include "style/styled_scene.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace vo {

/// Most texels of shadows along the longest side of their box; the other sides have as many as their length
/// needs.
constexpr int kShadowTexels = 128;

/// Light ends where less than this comes through.
constexpr float kLeastThrough = 1e-3f;
/// The optical depth of that. No texel is darker: beside a clear one it would be thicker than it is.
inline const float kMostDepth = -std::log(kLeastThrough);

/// What of a volume stands between a position and a light, at the centres of texels that fill a box: that of
/// the volume, or the smallest round its tetrahedra.
struct ShadowGrid
{
    /// A surface, and what comes through it.
    struct Surface
    {
        float value, through;
    };

    LocalBox box;
    VoxelSize size;
    glm::vec3 edges{1.0f};         ///< of a texel, local
    glm::vec3 voxelEdges{1.0f};    ///< local
    std::vector<float> texels;     ///< optical depth of a unit of local length; for surfaces the value, none
                                   ///< where clipped or outside
    bool hasSurfaces = false;      ///< light ends at them instead
    std::vector<Surface> surfaces; ///< rising
};

/// Nothing for tetrahedra that enclose nothing.
std::optional<LocalBox> shadowBoxOf(const StyledVolume& volume);

/// How far from a sample, local, its shadows begin on the way to a light, so that a surface does not darken
/// itself: as far as its opacity may take to rise and the first samples may lie within it, a matter of voxels
/// along that way, and the reach of texels.
float shadowOffset(const ShadowGrid& grid, const glm::vec3& wayToLight);

/// Without texels: where it lies, and the edges of texels and voxels.
ShadowGrid emptyShadowGrid(const StyledVolume& volume, const LocalBox& box);

/// The opacity that samples have after their chain, seen along their normal: of styles that look at the eye
/// too. Clipped parts are clear. A surface has the opacity of its chain for a voxel of its value. In up to
/// `threads` threads (0: the usual number). Without texels where there is no shadowBoxOf(). Throws
/// std::bad_alloc. Needs isSound().
ShadowGrid shadowGridOf(const StyledVolume& volume, int threads);

/// What of a light comes through to the centre of each texel, 65535 for all.
std::vector<std::uint16_t> lightThrough(const ShadowGrid& grid, const StyleLight& light, int threads);

} // namespace vo
