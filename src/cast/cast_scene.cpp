#include "cast/cast_scene.h"

#include "cast/scene_points.h"
#include "cast/scene_surfaces.h"
#include "cast/sight_limits.h"
#include "cast/sky.h"
#include "cast/styled_rays.h"
#include "core/parallel.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <new>
#include <span>

namespace vo {

namespace {

constexpr int kTileEdge = 32;
/// Rays end where less than this shows through.
constexpr float kLeastThrough = 1.0f / 2048.0f;

/// One pixel on its way: colour so far, multiplied by opacity, and how much shows through.
struct Pixel
{
    glm::vec3 color{0.0f};
    float through = 1.0f;
    double depth = std::numeric_limits<double>::infinity();

    void add(const glm::vec4& fragment, double at)
    {
        color += glm::vec3(fragment) * through;
        const float before = through;
        through *= 1.0f - fragment.a;
        if (before > 0.5f && through <= 0.5f) depth = at;
    }
    bool done() const { return through < kLeastThrough; }
};

/// A volume's walk through the ray at hand.
struct Stream
{
    const CastVolume* volume;
    StyledRay ray;
    FragmentRun run;
    TetraTile tetras;
};

/// All that the tiles of a picture share.
struct TileRequest
{
    const StyledScene& scene;
    const SceneRays& rays;
    const SightLimits& limits;
    const CastSurfaces& surfaces;
    const CastPoints& points;
    const std::vector<CastVolume>& volumes;
};

/// Colours of the pixels of one tile.
class TileCaster
{
public:
    explicit TileCaster(const TileRequest& request)
        : rays_(request.rays), sky_(request.scene.background, request.rays.worldFromEye()),
          limits_(request.limits), surfaces_(request.surfaces), points_(request.points)
    {
        const std::vector<CastVolume>& volumes = request.volumes;
        streams_.reserve(volumes.size());
        for (const CastVolume& volume : volumes)
            streams_.push_back({&volume, StyledRay(volume), {}, {}});
    }

    void cast(const PictureTile& tile, ScenePicture& picture)
    {
        points_.draw(tile, nearestPoints_);
        for (Stream& stream : streams_)
            if (stream.volume->tetras) stream.volume->tetras->spansOf(tile, rays_, stream.tetras);
        for (int y = tile.y; y < tile.y + tile.height; y += part_.height) {
            part_ = surfaces_.partFrom(tile, y);
            surfaces_.draw(part_, surfaceTile_);
            castPart(tile, picture);
        }
    }

private:
    void castPart(const PictureTile& tile, ScenePicture& picture)
    {
        for (int y = part_.y; y < part_.y + part_.height; ++y)
            for (int x = part_.x; x < part_.x + part_.width; ++x)
                write(castPixel(x, y, tile.pixelAt(x, y)), x, y, picture);
    }

    /// `index` is the pixel's number in the tile.
    Pixel castPixel(int x, int y, std::size_t index)
    {
        const std::size_t inPart = part_.pixelAt(x, y);
        const DepthRay ray = rays_.ray(x + 0.5, y + 0.5);
        const double limit = limits_.at(x, y);
        SurfaceFragment opaque = opaqueAt(index, inPart);
        if (limit <= opaque.depth) opaque = {limit, glm::vec4(0.0f)};
        fragments_ = surfaceTile_.translucent(inPart);
        while (!fragments_.empty() && fragments_.back().depth >= opaque.depth)
            fragments_ = fragments_.first(fragments_.size() - 1);
        active_.clear();
        for (Stream& stream : streams_) {
            std::span<const TetraSpan> spans;
            if (stream.volume->tetras) spans = stream.tetras.of(index);
            // Surfaces of values in one place with what is opaque are in front of it.
            const double end = behind(opaque.depth, stream.volume->styled->surfaces ? kRounding : 0.0);
            if (stream.ray.begin(ray, rays_.depths(), end, spans) && stream.ray.next(stream.run))
                active_.push_back(&stream);
        }
        Pixel pixel;
        while (!pixel.done() && addNearest(pixel)) {
        }
        if (opaque.color.a > 0.0f) pixel.add(opaque.color, opaque.depth);
        if (limit == std::numeric_limits<double>::infinity()) addSky(ray, pixel);
        return pixel;
    }

    void addSky(const DepthRay& ray, Pixel& pixel) const
    {
        const glm::vec4 behind = sky_.at(ray.direction);
        pixel.color += glm::vec3(behind) * pixel.through;
        pixel.through *= 1.0f - behind.a;
    }

    const SurfaceFragment& opaqueAt(std::size_t pixel, std::size_t inPart) const
    {
        const SurfaceFragment& surface = surfaceTile_.opaque(inPart);
        if (nearestPoints_.empty() || nearestPoints_[pixel].depth >= surface.depth) return surface;
        return nearestPoints_[pixel];
    }

    /// Adds what is in front of all else that is left; false if nothing is.
    bool addNearest(Pixel& pixel)
    {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        const double surface = fragments_.empty() ? kFar : fragments_.front().depth;
        const auto nearest = nearestStream();
        if (nearest == active_.end() || isBefore(surface, depthOf(**nearest), roundingOf(**nearest))) {
            if (fragments_.empty()) return false;
            pixel.add(fragments_.front().color, surface);
            fragments_ = fragments_.subspan(1);
            return true;
        }
        Stream& stream = **nearest;
        addUntil(stream, behind(std::min(surface, limitOf(nearest)), -roundingOf(stream)), pixel);
        if (stream.run.atEnd() && !pixel.done() && !stream.ray.next(stream.run)) active_.erase(nearest);
        return true;
    }

    static double depthOf(const Stream& stream)
    {
        return stream.run.depth[static_cast<std::size_t>(stream.run.next)];
    }

    /// Of depths at which faces and surfaces of values are found in different ways, a part of them.
    static constexpr double kRounding = 2e-6;

    /// Samples are on planes.
    static double roundingOf(const Stream& stream)
    {
        const StyledVolume& volume = *stream.volume->styled;
        return volume.projection || volume.surfaces ? kRounding : 0.0;
    }

    /// A depth that is farther by a part of it.
    static double behind(double depth, double part)
    {
        return std::isfinite(depth) ? depth + part * std::abs(depth) : depth;
    }

    static bool isBefore(double depth, double other, double rounding)
    {
        return depth < behind(other, -rounding);
    }

    /// The stream whose next fragment is nearest: at equal depths the one that the scene has first.
    std::vector<Stream*>::iterator nearestStream()
    {
        return std::min_element(active_.begin(), active_.end(), [](const Stream* a, const Stream* b) {
            return isBefore(depthOf(*a), depthOf(*b), std::min(roundingOf(*a), roundingOf(*b)));
        });
    }

    /// The depth of the nearest fragment of the other streams.
    double limitOf(std::vector<Stream*>::iterator nearest)
    {
        double limit = std::numeric_limits<double>::infinity();
        for (auto other = active_.begin(); other != active_.end(); ++other)
            if (other != nearest) limit = std::min(limit, depthOf(**other));
        return limit;
    }

    static void addUntil(Stream& stream, double limit, Pixel& pixel)
    {
        FragmentRun& run = stream.run;
        do {
            const auto i = static_cast<std::size_t>(run.next++);
            pixel.add(run.color[i], run.depth[i]);
        } while (!run.atEnd() && !pixel.done() && depthOf(stream) < limit);
    }

    static void write(const Pixel& pixel, int x, int y, ScenePicture& picture)
    {
        const std::size_t index = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                  static_cast<std::size_t>(x);
        float* const rgba = picture.rgba.data() + 4 * index;
        for (int c = 0; c < 3; ++c)
            rgba[c] = pixel.color[c];
        rgba[3] = 1.0f - pixel.through;
        picture.depth[index] = static_cast<float>(pixel.depth);
    }

    const SceneRays& rays_;
    Sky sky_;
    const SightLimits& limits_;
    const CastSurfaces& surfaces_;
    const CastPoints& points_;
    PictureTile part_; ///< rows of the tile
    SurfaceTile surfaceTile_;
    std::vector<SurfaceFragment> nearestPoints_;
    std::span<const SurfaceFragment> fragments_; ///< of the pixel, what is left
    std::vector<Stream> streams_;
    std::vector<Stream*> active_;
};

void clear(const StyledScene& scene, ScenePicture& picture)
{
    picture.width = std::max(scene.width, 0);
    picture.height = std::max(scene.height, 0);
    const auto pixels =
        static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height);
    if (pixels > picture.rgba.max_size() / 4) throw std::bad_alloc();
    picture.rgba.assign(4 * static_cast<std::size_t>(pixels), 0.0f);
    picture.depth.assign(static_cast<std::size_t>(pixels), std::numeric_limits<float>::infinity());
}

} // namespace

struct SceneCaster::Private
{
    std::map<std::uint64_t, std::shared_ptr<const PaddedVoxels>> voxels; ///< by serial
    std::vector<std::shared_ptr<const SegmentBlocks>> segments;

    std::vector<CastVolume> volumesOf(const StyledScene& scene, const SceneRays& rays, const TileGrid& grid,
                                      int threads)
    {
        std::map<std::uint64_t, std::shared_ptr<const PaddedVoxels>> used;
        std::vector<std::shared_ptr<const SegmentBlocks>> usedSegments;
        std::vector<CastVolume> volumes;
        for (const StyledVolume& styled : scene.volumes) {
            if (!isCast(styled)) continue;
            volumes.emplace_back(styled, rays);
            if (styled.tetras)
                volumes.back().tetras.emplace(scene, *styled.tetras, volumes.back().localFromEye, grid);
            const std::uint64_t serial = styled.voxels->serial;
            auto& kept = used[serial];
            if (!kept && voxels.contains(serial)) kept = voxels[serial];
            if (!kept) kept = std::make_shared<PaddedVoxels>(*styled.voxels, threads);
            volumes.back().voxels = kept;
            if (styled.segments) usedSegments.push_back(segmentsOf(*kept, styled, threads));
            volumes.back().findClear(styled.segments ? usedSegments.back()->chainsIn()
                                                     : std::span<const std::uint64_t>());
        }
        voxels = std::move(used);
        segments = std::move(usedSegments);
        return volumes;
    }

    std::shared_ptr<const SegmentBlocks> segmentsOf(const PaddedVoxels& padded, const StyledVolume& styled,
                                                    int threads) const
    {
        const auto chains = static_cast<int>(styled.chains.size());
        for (const auto& kept : segments)
            if (kept->isOf(padded.blocks(), padded.size(), *styled.segments, chains)) return kept;
        return std::make_shared<SegmentBlocks>(padded.blocks(), padded.size(), *styled.segments, chains,
                                               threads);
    }
};

SceneCaster::SceneCaster() : d(std::make_unique<Private>()) {}
SceneCaster::~SceneCaster() = default;

void SceneCaster::cast(const StyledScene& scene, int threads, ScenePicture& picture, const CastDepth& there)
{
    assert(there.depths.empty() || there.depths.size() == static_cast<std::size_t>(scene.width) *
                                                              static_cast<std::size_t>(scene.height));
    clear(scene, picture);
    const std::optional<SceneRays> rays = SceneRays::of(scene);
    if (!rays) return;
    const TileGrid grid(scene.width, scene.height, kTileEdge);
    const std::vector<CastVolume> volumes = d->volumesOf(scene, *rays, grid, threads);
    const CastSurfaces surfaces(scene, *rays, grid);
    const CastPoints points(scene, *rays, grid, threads);
    const SightLimits limits(there, *rays, scene.width);
    parallelInOrder(grid.count(), threads, [&](std::size_t i) {
        TileCaster({scene, *rays, limits, surfaces, points, volumes}).cast(grid.tile(i), picture);
    });
}

void castScene(const StyledScene& scene, int threads, ScenePicture& picture)
{
    SceneCaster().cast(scene, threads, picture);
}

} // namespace vo
