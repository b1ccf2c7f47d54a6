#include "cast/scene_tetras.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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

CastTetras::CastTetras(const StyledTetras& tetras, const glm::dmat4& localFromEye)
{
    const glm::dmat4 eyeFromLocal = glm::inverse(localFromEye);
    for (std::size_t first = 0; first + 4 <= tetras.indices.size(); first += 4)
        add(tetras, first, eyeFromLocal);
}

void CastTetras::add(const StyledTetras& tetras, std::size_t first, const glm::dmat4& eyeFromLocal)
{
    Cell cell;
    std::array<glm::dvec3, 4> local, place;
    for (std::size_t i = 0; i < 4; ++i) {
        const int corner = tetras.indices[first + i];
        if (corner < 0) return;
        const auto c = static_cast<std::size_t>(corner);
        if (c >= tetras.positions.size() || c >= tetras.places.size()) return;
        local[i] = tetras.positions[c];
        place[i] = tetras.places[c];
        cell.corners[i] = glm::dvec3(eyeFromLocal * glm::dvec4(local[i], 1.0));
    }
    const glm::dmat3 edges(local[1] - local[0], local[2] - local[0], local[3] - local[0]);
    const glm::dmat3 linear =
        glm::dmat3(place[1] - place[0], place[2] - place[0], place[3] - place[0]) * glm::inverse(edges);
    cell.placeFromLocal = glm::dmat4(linear);
    cell.placeFromLocal[3] = glm::dvec4(place[0] - linear * local[0], 1.0);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(cell.placeFromLocal[column][row])) return;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& c = cell.corners;
        cell.faces[i] = planeOf({c[(i + 1) % 4], c[(i + 2) % 4], c[(i + 3) % 4]});
        if (glm::dot(cell.faces[i], glm::dvec4(c[i], 1.0)) < 0.0) cell.faces[i] = -cell.faces[i];
    }
    cells_.push_back(cell);
}

void CastTetras::sortIntoTiles(const StyledScene& scene, int tileEdge)
{
    clipFromEye_ = scene.clipFromEye;
    width_ = scene.width;
    height_ = scene.height;
    tileEdge_ = tileEdge;
    tilesAcross_ = (width_ + tileEdge - 1) / tileEdge;
    tiles_.assign(static_cast<std::size_t>(tilesAcross_) *
                      static_cast<std::size_t>((height_ + tileEdge - 1) / tileEdge),
                  {});
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
        const Bounds bounds = boundsOf(cells_[i]);
        if (bounds.left > bounds.right || bounds.bottom > bounds.top) continue;
        for (int y = bounds.bottom / tileEdge; y <= bounds.top / tileEdge; ++y)
            for (int x = bounds.left / tileEdge; x <= bounds.right / tileEdge; ++x)
                tiles_[static_cast<std::size_t>(y) * static_cast<std::size_t>(tilesAcross_) +
                       static_cast<std::size_t>(x)]
                    .push_back(i);
    }
}

/// The pixels that a tetrahedron may cover: all where it reaches behind the eye.
CastTetras::Bounds CastTetras::boundsOf(const Cell& cell) const
{
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& corner : cell.corners) {
        const glm::dvec4 clip = clipFromEye_ * glm::dvec4(corner, 1.0);
        if (!(clip.w > 1e-9)) return {0, width_ - 1, 0, height_ - 1};
        const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w + 1.0) * 0.5 * glm::dvec2(width_, height_);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    const auto inside = [](double pixel, int size) {
        return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(size)));
    };
    return {std::max(inside(std::floor(low.x - 0.5), width_), 0),
            std::min(inside(std::ceil(high.x - 0.5), width_), width_ - 1),
            std::max(inside(std::floor(low.y - 0.5), height_), 0),
            std::min(inside(std::ceil(high.y - 0.5), height_), height_ - 1)};
}

DepthRange CastTetras::rangeOf(const Cell& cell, const DepthRay& ray)
{
    constexpr double kFar = std::numeric_limits<double>::infinity();
    DepthRange range{-kFar, kFar};
    for (const glm::dvec4& face : cell.faces)
        range.cut(glm::dot(glm::dvec3(face), ray.origin) + face.w, glm::dot(glm::dvec3(face), ray.direction));
    return range;
}

void CastTetras::spansOf(const PictureTile& tile, const SceneRays& rays, TetraTile& result) const
{
    std::vector<PixelSpan> found;
    const std::size_t index =
        static_cast<std::size_t>(tile.y / tileEdge_) * static_cast<std::size_t>(tilesAcross_) +
        static_cast<std::size_t>(tile.x / tileEdge_);
    for (const std::uint32_t tetra : tiles_[index]) {
        const Bounds bounds = boundsOf(cells_[tetra]);
        for (int y = std::max(bounds.bottom, tile.y); y <= std::min(bounds.top, tile.y + tile.height - 1);
             ++y)
            for (int x = std::max(bounds.left, tile.x); x <= std::min(bounds.right, tile.x + tile.width - 1);
                 ++x) {
                const DepthRange range = rangeOf(cells_[tetra], rays.ray(x + 0.5, y + 0.5));
                const auto pixel = static_cast<std::uint32_t>((y - tile.y) * tile.width + x - tile.x);
                if (!range.empty()) found.push_back({pixel, {range, tetra}});
            }
    }
    std::stable_sort(found.begin(), found.end(), [](const PixelSpan& a, const PixelSpan& b) {
        return a.pixel != b.pixel ? a.pixel < b.pixel : a.span.depths.begin < b.span.depths.begin;
    });
    result.spans.clear();
    result.first.assign(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height) + 1, 0);
    for (const PixelSpan& span : found) {
        result.spans.push_back(span.span);
        ++result.first[span.pixel + 1];
    }
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
}

} // namespace vo
