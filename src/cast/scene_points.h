#pragma once

#include "cast/picture_tile.h"
#include "cast/scene_rays.h"
#include "cast/scene_surfaces.h"
#include "style/styled_scene.h"

#include <cstdint>
#include <vector>

namespace vo {

/// The points of stippled volumes in one picture: opaque, a pixel each.
class CastPoints
{
public:
    /// In up to `threads` threads; the scene outlives this.
    CastPoints(const StyledScene& scene, const SceneRays& rays, const TileGrid& grid, int threads);

    /// Of each pixel of a tile the nearest point, at infinity where there is none; nothing if no pixel has
    /// one.
    void draw(const PictureTile& tile, std::vector<SurfaceFragment>& nearest) const;

private:
    struct PixelPoint
    {
        float depth;
        std::uint32_t pixel; ///< of the tile
        glm::vec3 color;
    };

    void add(const StyledVolume& volume, int threads);

    const StyledScene& scene_;
    RayPart depths_;
    TileGrid grid_;
    std::vector<std::vector<PixelPoint>> tiles_; ///< empty without points
};

} // namespace vo
