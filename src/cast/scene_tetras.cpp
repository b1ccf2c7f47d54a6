#include "cast/scene_tetras.h"

#include "style/tetra_corners.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace vo {

namespace {

bool isBefore(const glm::dvec3& a, const glm::dvec3& b)
{
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

/// The plane through three corners, the same to the last bit for all tetrahedra that have them.
glm::dvec4 planeOf(std::array<glm::dvec3, 3> corners)
{
    std::sort(corners.begin(), corners.end(), isBefore);
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    return {normal, -glm::dot(normal, corners[0])};
}

} // namespace

CastTetras::CastTetras(const StyledScene& scene, const StyledTetras& tetras, const glm::dmat4& localFromEye,
                       const TileGrid& grid)
    : grid_(grid)
{
    const glm::dmat4 eyeFromLocal = glm::inverse(localFromEye);
    for (std::size_t tetra = 0; 4 * tetra + 4 <= tetras.indices.size(); ++tetra)
        add(scene, tetras, tetra, eyeFromLocal);
    tiles_.resize(grid_.count());
    for (std::uint32_t i = 0; i < cells_.size(); ++i)
        grid_.forTilesOf(pixelsOf(cells_[i].windows, grid_.picture()),
                         [&](std::size_t tile) { tiles_[tile].push_back(i); });
}

void CastTetras::add(const StyledScene& scene, const StyledTetras& tetras, std::size_t tetra,
                     const glm::dmat4& eyeFromLocal)
{
    const std::optional<TetraCorners> corners = cornersOf(tetras, tetra);
    const std::optional<glm::dmat4> place = corners ? corners->placeFromLocal() : std::nullopt;
    if (!place) return;
    Cell cell;
    cell.placeFromLocal = *place;
    std::array<glm::dvec3, 4> c;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec4 eye = eyeFromLocal * glm::dvec4(corners->positions[i], 1.0);
        c[i] = glm::dvec3(eye);
        cell.windows[i] = windowOf(scene, eye);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        cell.faces[i] = planeOf({c[(i + 1) % 4], c[(i + 2) % 4], c[(i + 3) % 4]});
        if (glm::dot(cell.faces[i], glm::dvec4(c[i], 1.0)) < 0.0) cell.faces[i] = -cell.faces[i];
    }
    cells_.push_back(cell);
}

RayPart CastTetras::rangeOf(const Cell& cell, const DepthRay& ray)
{
    constexpr double kFar = std::numeric_limits<double>::infinity();
    RayPart range{-kFar, kFar};
    for (const glm::dvec4& face : cell.faces)
        range.cut(glm::dot(glm::dvec3(face), ray.origin) + face.w, glm::dot(glm::dvec3(face), ray.direction));
    return range;
}

void CastTetras::spansOf(const PictureTile& tile, const SceneRays& rays, TetraTile& result) const
{
    std::vector<PixelSpan> found;
    for (const std::uint32_t tetra : tiles_[grid_.numberAt(tile.x, tile.y)]) {
        const PictureTile pixels = pixelsOf(cells_[tetra].windows, tile);
        for (int y = pixels.y; y < pixels.y + pixels.height; ++y)
            for (int x = pixels.x; x < pixels.x + pixels.width; ++x) {
                const DepthRay edges = transformed(rays.shift(), rays.ray(x + 0.5, y + 0.5));
                const RayPart range = rangeOf(cells_[tetra], edges);
                const auto pixel = static_cast<std::uint32_t>(tile.pixelAt(x, y));
                if (!range.empty()) found.push_back({pixel, {range, tetra}});
            }
    }
    std::stable_sort(found.begin(), found.end(), [](const PixelSpan& a, const PixelSpan& b) {
        return a.pixel != b.pixel ? a.pixel < b.pixel : a.span.depths.begin < b.span.depths.begin;
    });
    result.spans.clear();
    result.first.assign(tile.pixelCount() + 1, 0);
    for (const PixelSpan& span : found) {
        result.spans.push_back(span.span);
        ++result.first[span.pixel + 1];
    }
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
}

} // namespace vo
