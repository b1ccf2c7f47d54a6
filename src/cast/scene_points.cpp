#include "cast/scene_points.h"

#include "style/stipple_points.h"

#include <algorithm>

namespace vo {

CastPoints::CastPoints(const StyledScene& scene, const SceneRays& rays, int tileEdge, int threads)
    : scene_(scene), depths_(rays.depths()), tileEdge_(tileEdge),
      tilesAcross_((scene.width + tileEdge - 1) / tileEdge)
{
    for (const StyledVolume& volume : scene.volumes)
        if (volume.stipple) add(volume, threads);
}

void CastPoints::add(const StyledVolume& volume, int threads)
{
    const int tilesUp = (scene_.height + tileEdge_ - 1) / tileEdge_;
    tiles_.resize(static_cast<std::size_t>(tilesAcross_) * static_cast<std::size_t>(tilesUp));
    const glm::dmat4 eyeFromLocal = scene_.eyeFromWorld * volume.worldFromLocal;
    for (const StipplePoint& point : stipplePoints(scene_, volume, threads)) {
        const glm::dvec4 eye = eyeFromLocal * glm::dvec4(point.position, 1.0);
        const glm::dvec4 clip = scene_.clipFromEye * eye;
        if (!(clip.w > 0.0) || !(-eye.z >= depths_.begin && -eye.z <= depths_.end)) continue;
        const double left = (clip.x / clip.w + 1.0) * 0.5 * scene_.width;
        const double low = (clip.y / clip.w + 1.0) * 0.5 * scene_.height;
        if (!(left >= 0.0 && left < scene_.width && low >= 0.0 && low < scene_.height)) continue;
        const int x = static_cast<int>(left), y = static_cast<int>(low);
        const int tileX = x / tileEdge_, tileY = y / tileEdge_;
        const int width = std::min(tileEdge_, scene_.width - tileX * tileEdge_);
        const int pixel = (y - tileY * tileEdge_) * width + x - tileX * tileEdge_;
        tiles_[static_cast<std::size_t>(tileY) * static_cast<std::size_t>(tilesAcross_) +
               static_cast<std::size_t>(tileX)]
            .push_back({static_cast<float>(-eye.z), static_cast<std::uint32_t>(pixel), point.color});
    }
}

void CastPoints::draw(const PictureTile& tile, std::vector<SurfaceFragment>& nearest) const
{
    nearest.clear();
    if (tiles_.empty()) return;
    const auto& points =
        tiles_[static_cast<std::size_t>(tile.y / tileEdge_) * static_cast<std::size_t>(tilesAcross_) +
               static_cast<std::size_t>(tile.x / tileEdge_)];
    if (points.empty()) return;
    nearest.resize(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height));
    for (const PixelPoint& point : points) {
        SurfaceFragment& fragment = nearest[point.pixel];
        const auto depth = static_cast<double>(point.depth);
        if (depth < fragment.depth) fragment = {depth, glm::vec4(point.color, 1.0f)};
    }
}

} // namespace vo
