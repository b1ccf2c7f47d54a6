#pragma once

#include "cast/picture_tile.h"
#include "cast/scene_rays.h"
#include "style/styled_scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// The part of a ray in one tetrahedron.
struct TetraSpan
{
    DepthRange depths;
    std::uint32_t tetra = 0;
};

/// What the rays of a tile meet, pixel by pixel.
struct TetraTile
{
    std::vector<TetraSpan> spans;   ///< of a pixel from the nearest on
    std::vector<std::size_t> first; ///< of each pixel in spans, and the end

    std::span<const TetraSpan> of(std::size_t pixel) const
    {
        return std::span(spans).subspan(first[pixel], first[pixel + 1] - first[pixel]);
    }
};

/// The tetrahedra of a volume. Those that are flat or name corners that are not there are left out. Where two
/// share a face, a ray leaves the one at the very depth at which it enters the other.
class CastTetras
{
public:
    CastTetras(const StyledTetras& tetras, const glm::dmat4& localFromEye);

    /// Sorts them into tiles of the scene's picture; before spansOf.
    void sortIntoTiles(const StyledScene& scene, int tileEdge);
    void spansOf(const PictureTile& tile, const SceneRays& rays, TetraTile& result) const;

    /// Texture coordinates from local positions.
    const glm::dmat4& placeFromLocal(std::uint32_t tetra) const { return cells_[tetra].placeFromLocal; }

private:
    struct Cell
    {
        glm::dvec4 faces[4]; ///< eye space, not negative inside
        glm::dvec3 corners[4];
        glm::dmat4 placeFromLocal;
    };
    struct Bounds
    {
        int left, right, bottom, top;
    };
    struct PixelSpan
    {
        std::uint32_t pixel;
        TetraSpan span;
    };

    void add(const StyledTetras& tetras, std::size_t first, const glm::dmat4& eyeFromLocal);
    Bounds boundsOf(const Cell& cell) const;
    static DepthRange rangeOf(const Cell& cell, const DepthRay& ray);

    std::vector<Cell> cells_;
    glm::dmat4 clipFromEye_{1.0};
    int width_ = 0, height_ = 0, tileEdge_ = 1, tilesAcross_ = 0;
    std::vector<std::vector<std::uint32_t>> tiles_; ///< row by row
};

} // namespace vo
