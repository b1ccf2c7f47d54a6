#include "cast/ray_cast.h"

#include "cast/empty_blocks.h"
#include "cast/ray_frame.h"
#include "cast/voxel_grid.h"
#include "cast/walk_rays.h"
#include "core/parallel.h"
#include "geometry/convex_set.h"

#include <algorithm>
#include <cassert>
#include <list>
#include <new>
#include <optional>
#include <utility>

namespace vo {

namespace {

/// Of rearranged voxels, beyond those of the present frame.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

/// What a grid was made of.
struct GridKey
{
    struct Part
    {
        std::uint64_t id, version, tableSerial;
        glm::vec3 origin, size;
        glm::dvec3 lower, upper; ///< of the clip box
        int thinAxis;
        TexelFormat texel;
        VoxelFormat format;
        bool classified;
        friend bool operator==(const Part&, const Part&) = default;
    };
    std::vector<Part> parts;
    friend bool operator==(const GridKey&, const GridKey&) = default;
};

GridKey keyOf(const CastRequest& request)
{
    GridKey key;
    for (std::size_t i = 0; i < request.bricks.size(); ++i) {
        const CastBrick& brick = request.bricks[i];
        const Box& box = request.clipBoxes[i];
        key.parts.push_back({brick.id, brick.version, brick.tableSerial, brick.origin, brick.size, box.lower,
                             box.upper, brick.thinAxis, brick.texels.texel, brick.texels.format,
                             brick.texels.classified != nullptr});
    }
    return key;
}

Box boxAround(std::span<const Box> boxes)
{
    Box around = boxes.front();
    for (const Box& box : boxes)
        around = {glm::min(around.lower, box.lower), glm::max(around.upper, box.upper)};
    return around;
}

/// A grid, what the last table makes of it, or why there is none.
struct KeptGrid
{
    GridKey key;
    std::string refusal;
    std::unique_ptr<VoxelGrid> grid;

    bool shaded = false;
    CastShading shading; ///< the table by its serial
    Table table;
    CastBlending blending = CastBlending::over;
    ShadingPlan plan;
    EmptyBlocks blocks;
};

bool sameShading(const KeptGrid& kept, const CastRequest& request)
{
    const CastShading &a = kept.shading, &b = request.shading;
    return kept.shaded && kept.blending == request.blending && a.color == b.color && a.replace == b.replace &&
           (a.table == nullptr) == (b.table == nullptr) && (!b.table || kept.table == *b.table);
}

void shade(KeptGrid& kept, const CastRequest& request)
{
    if (sameShading(kept, request)) return;
    const BrickTexels& texels = request.bricks.front().texels;
    kept.plan = shadingPlan(request.shading, texels.texel, texels.classified != nullptr);
    kept.shading = request.shading;
    if (request.shading.table) kept.table = *request.shading.table;
    kept.blending = request.blending;
    findEmptyBlocks(*kept.grid, kept.plan, request.blending, kept.blocks);
    kept.shaded = true;
}

} // namespace

struct RayCaster::Private
{
    std::list<KeptGrid> grids; ///< the latest used first
    std::vector<float> records;
    std::vector<int> indices;
    std::optional<ConvexSet> convex;
    bool skipping = true;

    KeptGrid& gridOf(const CastRequest& request)
    {
        GridKey key = keyOf(request);
        const auto found =
            std::find_if(grids.begin(), grids.end(), [&](const KeptGrid& g) { return g.key == key; });
        if (found != grids.end()) {
            grids.splice(grids.begin(), grids, found);
            return grids.front();
        }
        KeptGrid kept;
        kept.key = std::move(key);
        try {
            kept.grid =
                std::make_unique<VoxelGrid>(request.bricks, request.clipBoxes, request.threads, kept.refusal);
        } catch (const std::bad_alloc&) {
            kept.refusal = "no memory for the voxels";
        }
        if (!kept.refusal.empty()) kept.grid.reset();
        grids.push_front(std::move(kept));
        std::size_t bytes = 0;
        for (auto i = grids.begin(); i != grids.end();) {
            bytes += i->grid ? i->grid->bytes() : 0;
            const bool tooMany =
                i != grids.begin() && (bytes > kMostBytes || std::distance(grids.begin(), i) > 64);
            i = tooMany ? grids.erase(i) : std::next(i);
        }
        return grids.front();
    }

    const std::optional<ConvexSet>& convexOf(const TetraView& tetras)
    {
        if (!std::ranges::equal(tetras.records, records) || !std::ranges::equal(tetras.indices, indices)) {
            records.assign(tetras.records.begin(), tetras.records.end());
            indices.assign(tetras.indices.begin(), tetras.indices.end());
            convex = convexSet(tetras);
        }
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
    return d->gridOf(request).refusal;
}

void RayCaster::cast(const CastRequest& request, CastPicture& picture)
{
    picture.x = picture.y = picture.width = picture.height = 0;
    if (request.tetras.tetraCount() == 0 || request.bricks.empty()) return;
    const std::optional<Camera> camera = findCamera(request.model, request.projection);
    const std::optional<ConvexSet>& convex = d->convexOf(request.tetras);
    KeptGrid& kept = d->gridOf(request);
    assert(camera && convex && kept.grid);
    shade(kept, request);

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
    job.grid = kept.grid->view();
    job.shift = kept.grid->shift();
    job.shading = &kept.plan;
    job.blending = request.blending;
    job.gauge = request.opacityGauge ? &*request.opacityGauge : nullptr;
    job.depth = request.depth.depths.empty() ? nullptr : &request.depth;
    job.viewportWidth = request.width;
    job.blockCount = kept.grid->blockCount();
    const bool extreme = request.blending == CastBlending::max || request.blending == CastBlending::min;
    job.extremeOfRaw = extreme && kept.plan.rises() && !job.gauge;
    if (d->skipping && !extreme) job.blockDistance = kept.blocks.distance.data();
    if (d->skipping && job.extremeOfRaw) job.blockRanges = kept.grid->blockRanges().data();
    job.picture = &picture;

    const int columns = (picture.width + kTile - 1) / kTile, rows = (picture.height + kTile - 1) / kTile;
    parallelFor(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), request.threads,
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
    std::erase_if(d->grids, [&](const KeptGrid& kept) {
        return std::ranges::any_of(kept.key.parts, [&](const auto& part) { return part.id == brickId; });
    });
}

std::size_t RayCaster::bytes() const
{
    std::size_t bytes = 0;
    for (const KeptGrid& kept : d->grids)
        if (kept.grid) bytes += kept.grid->bytes() + kept.blocks.distance.size();
    return bytes;
}

} // namespace vo
