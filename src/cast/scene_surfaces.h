#pragma once

#include "cast/picture_tile.h"
#include "cast/scene_rays.h"
#include "style/shared_planes.h"
#include "style/styled_scene.h"

#include <glm/vec4.hpp>

#include <array>
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

/// The surfaces in the pixels of a tile or a part of one, row by row.
class SurfaceTile
{
public:
    /// The nearest opaque one; at infinity where there is none.
    const SurfaceFragment& opaque(std::size_t pixel) const
    {
        return opaque_.empty() ? none_ : opaque_[pixel];
    }
    /// Translucent ones in front of it, the nearest first, as far as anything shows through.
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

    /// The rows of a tile, from `row` of the picture on, that are to be drawn at once: all that are left,
    /// unless very many triangles would take much memory.
    PictureTile partFrom(const PictureTile& tile, int row) const;
    /// Triangles in such a part, lit as X3D says.
    void draw(const PictureTile& part, SurfaceTile& result) const;

private:
    struct Vertex;
    struct Prepared;
    struct Triangle;
    struct TileTriangles;
    struct Crossing;
    class Covered;
    class PixelRays;

    void prepare(std::size_t number);
    void sortIntoTiles(std::uint32_t surface, std::size_t first);
    std::array<glm::dvec3, 3> windowsOf(const Triangle& triangle) const;
    std::vector<std::uint32_t> translucentNearestFirst(const PictureTile& part) const;
    void cover(const PictureTile& part, std::uint32_t number, PixelRays& rays, Covered& covered) const;
    bool isSeen(const Triangle& triangle, const DepthRay& ray, double depth) const;
    glm::dvec3 outwardOf(const Triangle& triangle) const;
    float opacityOf(const Triangle& triangle, const glm::dvec3& weights) const;
    std::vector<glm::vec4> colorsOf(const PictureTile& part, std::span<const Crossing> crossings,
                                    PixelRays& rays) const;
    void shade(std::span<const Triangle> triangles, std::span<const Crossing> crossings,
               std::span<const std::size_t> which, PixelRays& rays, std::span<glm::vec4> colors) const;

    const StyledScene& scene_;
    const SceneRays& rays_;
    SharedPlanes planes_;
    TileGrid grid_;
    std::vector<Prepared> surfaces_;
    std::vector<TileTriangles> tiles_; ///< empty without surfaces
};

} // namespace vo
