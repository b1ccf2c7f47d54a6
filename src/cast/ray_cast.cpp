#include "cast/ray_cast.h"

#include "cast/empty_blocks.h"
#include "cast/grid_store.h"
#include "cast/ray_frame.h"
#include "cast/walk_rays.h"
#include "core/parallel.h"
#include "geometry/convex_set.h"
#include "geometry/kept_tetras.h"

#include <algorithm>
#include <cassert>
#include <list>
#include <optional>

namespace vo {

namespace {

Box boxAround(std::span<const Box> boxes)
{
    Box around = boxes.front();
    for (const Box& box : boxes)
        around = {glm::min(around.lower, box.lower), glm::max(around.upper, box.upper)};
    return around;
}

/// What the last table makes of a grid.
struct ShadedGrid
{
    std::uint64_t serial = 0; ///< of the grid
    CastShading shading;      ///< `table` for its table
    Table table;
    CastBlending blending = CastBlending::over;
    ShadingPlan plan;
    EmptyBlocks blocks;
};

bool sameShading(const ShadedGrid& shaded, const CastRequest& request)
{
    const CastShading &a = shaded.shading, &b = request.shading;
    return shaded.blending == request.blending && a.color == b.color && a.replace == b.replace &&
           (a.table == nullptr) == (b.table == nullptr) && (!b.table || shaded.table == *b.table);
}

void shade(const VoxelGrid& grid, const CastRequest& request, ShadedGrid& shaded)
{
    const BrickTexels& texels = request.bricks.front().texels;
    shaded.plan = shadingPlan(request.shading, texels.texel, texels.classified != nullptr);
    shaded.shading = request.shading;
    if (request.shading.table) shaded.table = *request.shading.table;
    shaded.blending = request.blending;
    findEmptyBlocks(grid, shaded.plan, request.blending, request.threads, shaded.blocks);
}

/// Units of opacity from one sample to the next, where rays are parallel.
std::optional<double> unitsOfAllRays(const CastRequest& request, const RayFrame& frame)
{
    if (!request.opacityGauge || !frame.isParallel()) return std::nullopt;
    const glm::dvec3 direction(frame.direction[0].at, frame.direction[1].at, frame.direction[2].at);
    return glm::length(direction) / glm::length(*request.opacityGauge * direction);
}

} // namespace

struct RayCaster::Private
{
    GridStore store;
    std::list<ShadedGrid> shaded; ///< of grids in the store; the latest used first
    KeptTetras convexTetras;
    std::optional<ConvexSet> convex; ///< that they fill
    bool skipping = true;

    const StoredGrid& gridOf(const CastRequest& request)
    {
        return store.gridOf(request, 0, request.bricks.size());
    }

    const ShadedGrid& shadedGrid(const StoredGrid& stored, const CastRequest& request)
    {
        const auto found = std::ranges::find(shaded, stored.serial, &ShadedGrid::serial);
        const bool known = found != shaded.end();
        if (known)
            shaded.splice(shaded.begin(), shaded, found);
        else
            shaded.emplace_front().serial = stored.serial;
        if (!known || !sameShading(shaded.front(), request)) shade(*stored.grid, request, shaded.front());
        return shaded.front();
    }

    void dropShadingOfLostGrids()
    {
        std::erase_if(shaded, [&](const ShadedGrid& entry) { return !store.holds(entry.serial); });
    }

    const std::optional<ConvexSet>& convexOf(const TetraView& tetras)
    {
        if (convexTetras.renew(tetras)) convex = convexSet(tetras);
        return convex;
    }
};

RayCaster::RayCaster() : d(std::make_unique<Private>()) {}
RayCaster::~RayCaster() = default;

std::string RayCaster::refusal(const CastRequest& request)
{
    assert(request.bricks.size() == request.clipBoxes.size());
    if (request.tetras.tetraCount() == 0 || request.bricks.empty()) return {};
    if (request.layout.texCoord >= 0 || request.tetras.voxelColumn >= 0)
        return "vertices with voxel coordinates";
    if (request.layout.color >= 0) return "vertices with colours";
    if (request.sampling.space == SamplingSpace::primitive && request.tetras.tetraCount() > 1)
        return "planes of their own for each tetrahedron";
    if (request.shading.table && request.shading.table->size() < 1) return "an empty table";
    if (!findCamera(request.model, request.projection)) return "singular matrices";
    if (!d->convexOf(request.tetras)) return "tetrahedra that fill no convex polyhedron";
    d->store.startFrame();
    d->dropShadingOfLostGrids();
    return d->gridOf(request).refusal;
}

void RayCaster::cast(const CastRequest& request, CastPicture& picture)
{
    picture.x = picture.y = picture.width = picture.height = 0;
    if (request.tetras.tetraCount() == 0 || request.bricks.empty()) return;
    const std::optional<Camera> camera = findCamera(request.model, request.projection);
    const std::optional<ConvexSet>& convex = d->convexOf(request.tetras);
    const StoredGrid& stored = d->gridOf(request);
    assert(camera && convex && stored.grid);
    const VoxelGrid& grid = *stored.grid;
    const ShadedGrid& shaded = d->shadedGrid(stored, request);

    RayFrame frame = rayFrame(request, *camera);
    boundByBox(request, boxAround(request.clipBoxes), frame);
    boundByConvexSet(*convex, frame);
    const PixelRectangle pixels = frame.pixels;
    if (pixels.empty() || frame.count == 0) return;
    picture.x = pixels.left;
    picture.y = pixels.bottom;
    picture.width = pixels.width();
    picture.height = pixels.height();
    const std::size_t count =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.rgbt.resize(4 * count);
    picture.alpha.resize(hidesBehind(request.blending) ? count : 0);

    RayJob job;
    job.frame = &frame;
    job.grid = grid.view();
    job.shift = grid.shift();
    job.shading = &shaded.plan;
    job.blending = request.blending;
    job.gauge = request.opacityGauge ? &*request.opacityGauge : nullptr;
    const std::optional<double> units = unitsOfAllRays(request, frame);
    const std::optional<ShadingPlan> folded = units ? withUnits(shaded.plan, *units) : std::nullopt;
    job.depth = request.depth.depths.empty() ? nullptr : &request.depth;
    job.viewportWidth = request.width;
    job.blockCount = grid.blockCount();
    const bool extreme = request.blending == CastBlending::max || request.blending == CastBlending::min;
    job.extremeOfRaw = extreme && shaded.plan.rises() && !job.gauge;
    if (folded) {
        job.shading = &*folded;
        job.gauge = nullptr;
    }
    if (d->skipping && !extreme) job.blockDistance = shaded.blocks.distance.data();
    if (d->skipping && job.extremeOfRaw) job.blockRanges = grid.blockRanges().data();
    job.picture = &picture;

    const int columns = (picture.width + kTile - 1) / kTile, rows = (picture.height + kTile - 1) / kTile;
    parallelInOrder(
        static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), request.threads,
        [&](std::size_t i) {
            const int x = pixels.left + static_cast<int>(i) % columns * kTile;
            const int y = pixels.bottom + static_cast<int>(i) / columns * kTile;
            walkRays(job, {x, y, std::min(x + kTile, pixels.right), std::min(y + kTile, pixels.top)});
        });
}

void RayCaster::setSkipping(bool on)
{
    d->skipping = on;
}

void RayCaster::forget(std::uint64_t brickId)
{
    d->store.forget(brickId);
    d->dropShadingOfLostGrids();
}

std::size_t RayCaster::bytes() const
{
    std::size_t bytes = d->store.bytes();
    for (const ShadedGrid& shaded : d->shaded)
        bytes += shaded.blocks.distance.size();
    return bytes;
}

} // namespace vo
