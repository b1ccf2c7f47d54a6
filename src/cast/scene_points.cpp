#include "cast/scene_points.h"

#include "style/stipple_points.h"

namespace vo {

CastPoints::CastPoints(const StyledScene& scene, const SceneRays& rays, const TileGrid& grid, int threads)
    : scene_(scene), depths_(rays.depths()), grid_(grid)
{
    for (const StyledVolume& volume : scene.volumes)
        if (volume.stipple) add(volume, threads);
}

void CastPoints::add(const StyledVolume& volume, int threads)
{
    tiles_.resize(grid_.count());
    const glm::dmat4 eyeFromLocal = scene_.eyeFromWorld * volume.worldFromLocal;
    for (const StipplePoint& point : stipplePoints(scene_, volume, threads)) {
        const glm::dvec4 eye = eyeFromLocal * glm::dvec4(point.position, 1.0);
        const glm::dvec3 window = windowOf(scene_, eye);
        if (!(window.z > 0.0) || !(-eye.z >= depths_.begin && -eye.z <= depths_.end)) continue;
        const double left = window.x / window.z, low = window.y / window.z;
        if (!(left >= 0.0 && left < scene_.width && low >= 0.0 && low < scene_.height)) continue;
        const int x = static_cast<int>(left), y = static_cast<int>(low);
        const std::size_t tile = grid_.numberAt(x, y);
        tiles_[tile].push_back({static_cast<float>(-eye.z),
                                static_cast<std::uint32_t>(grid_.tile(tile).pixelAt(x, y)), point.color});
    }
}

void CastPoints::draw(const PictureTile& tile, std::vector<SurfaceFragment>& nearest) const
{
    nearest.clear();
    if (tiles_.empty()) return;
    const auto& points = tiles_[grid_.numberAt(tile.x, tile.y)];
    if (points.empty()) return;
    nearest.resize(tile.pixelCount());
    for (const PixelPoint& point : points) {
        SurfaceFragment& fragment = nearest[point.pixel];
        const auto depth = static_cast<double>(point.depth);
        if (depth < fragment.depth) fragment = {depth, glm::vec4(point.color, 1.0f)};
    }
}

} // namespace vo
