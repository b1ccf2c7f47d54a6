#pragma once

#include "cast/picture_tile.h"
#include "cast/scene_rays.h"
#include "style/styled_scene.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace vo {

/// A surface in one pixel: its colour, multiplied by opacity.
struct SurfaceFragment
{
    double depth = std::numeric_limits<double>::infinity();
    glm::vec4 color{0.0f};
};

/// The surfaces in the pixels of one tile, row by row.
class SurfaceTile
{
public:
    /// The nearest opaque one; at infinity where there is none.
    const SurfaceFragment& opaque(std::size_t pixel) const
    {
        return opaque_.empty() ? none_ : opaque_[pixel];
    }
    /// Translucent ones in front of it, the nearest first.
    std::span<const SurfaceFragment> translucent(std::size_t pixel) const
    {
        if (first_.empty()) return {};
        return std::span(translucent_).subspan(first_[pixel], first_[pixel + 1] - first_[pixel]);
    }

private:
    friend class CastSurfaces;
    SurfaceFragment none_;
    std::vector<SurfaceFragment> opaque_, translucent_;
    std::vector<std::size_t> first_; ///< of each pixel in translucent_, and the end
};

/// The surfaces of a scene, for one picture of it.
class CastSurfaces
{
public:
    /// Sorts triangles into tiles. The scene and its rays outlive this.
    CastSurfaces(const StyledScene& scene, const SceneRays& rays, const TileGrid& grid);
    ~CastSurfaces();

    /// Triangles in a tile of the picture, lit as X3D says.
    void draw(const PictureTile& tile, SurfaceTile& result) const;

private:
    struct Vertex;
    struct Prepared;
    struct Triangle;
    struct Hit;
    struct Covered;

    void prepare(const StyledSurface& surface);
    void sortIntoTiles(std::uint32_t surface, std::size_t first);
    void cover(const Triangle& triangle, const PictureTile& tile, Covered& covered) const;
    bool isSeen(const Prepared& prepared, const Hit& hit, const DepthRay& ray) const;
    std::vector<glm::vec4> colorsOf(const PictureTile& tile, std::span<const Hit> hits) const;
    void shade(const PictureTile& tile, std::span<const Hit> hits, std::span<const std::size_t> which,
               std::span<glm::vec4> colors) const;

    const StyledScene& scene_;
    const SceneRays& rays_;
    TileGrid grid_;
    std::vector<Prepared> surfaces_;
    std::vector<std::vector<Triangle>> tiles_; ///< empty without surfaces
};

} // namespace vo
