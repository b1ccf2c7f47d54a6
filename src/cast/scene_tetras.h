#pragma once

#include "cast/picture_tile.h"
#include "cast/scene_rays.h"
#include "style/styled_scene.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// The part of a ray in one tetrahedron.
struct TetraSpan
{
    RayPart depths;
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
    /// Sorts them into tiles of the scene's picture.
    CastTetras(const StyledScene& scene, const StyledTetras& tetras, const glm::dmat4& localFromEye,
               const TileGrid& grid);

    void spansOf(const PictureTile& tile, const SceneRays& rays, TetraTile& result) const;

    /// Texture coordinates from local positions.
    const glm::dmat4& placeFromLocal(std::uint32_t tetra) const { return cells_[tetra].placeFromLocal; }

private:
    struct Cell
    {
        glm::dvec4 faces[4];               ///< eye space, not negative inside
        std::array<glm::dvec3, 4> windows; ///< of its corners
        glm::dmat4 placeFromLocal;
    };
    struct PixelSpan
    {
        std::uint32_t pixel;
        TetraSpan span;
    };

    void add(const StyledScene& scene, const StyledTetras& tetras, std::size_t tetra,
             const glm::dmat4& eyeFromLocal);
    static RayPart rangeOf(const Cell& cell, const DepthRay& ray);

    std::vector<Cell> cells_;
    TileGrid grid_;
    std::vector<std::vector<std::uint32_t>> tiles_;
};

} // namespace vo
