#include "frame/cast_frame.h"

#include "cast/fill_polygons.h"
#include "core/environment.h"
#include "core/log.h"
#include "draw/composite_picture.h"
#include "draw/compositing_state.h"
#include "draw/read_depths.h"
#include "lookup/brick_texels.h"
#include "polygonize/line_of_sight.h"

#include <string_view>
#include <vector>

namespace vo {

namespace {

std::vector<CastBrick> castBricks(const ContextRecord& context, std::span<const FrameBrick> bricks)
{
    const TableSlot* classified = activeTable(context, TableKind::preInterpolation);
    std::vector<CastBrick> result;
    result.reserve(bricks.size());
    for (const FrameBrick& brick : bricks) {
        const TextureImage& image = brick.image;
        CastBrick b;
        b.id = image.id;
        b.version = image.version;
        b.tableSerial = classified ? classified->serial : 0;
        b.texels = {image.size, image.format, image.texel, image.voxels,
                    classified ? &classified->table : nullptr};
        b.origin = brick.origin;
        b.size = brick.size;
        b.thinAxis = image.twoDimensional ? brick.thinAxis : -1;
        result.push_back(b);
    }
    return result;
}

CastShading castShading(const ContextRecord& context, const DrawState& draw)
{
    const TableSlot* slot = activeTable(context, TableKind::postInterpolation);
    CastShading shading;
    shading.table = slot ? &slot->table : nullptr;
    shading.tableSerial = slot ? slot->serial : 0;
    shading.color = draw.color;
    shading.replace = draw.replace;
    shading.flat = draw.flat;
    return shading;
}

CastRequest castRequest(const ContextRecord& context, const FrameRequest& request, const DrawState& draw,
                        const CompositingState& state, std::span<const CastBrick> bricks)
{
    CastRequest cast = viewRequest(request, draw, state);
    cast.layout = request.layout;
    cast.clipBoxes = request.clipBoxes;
    cast.bricks = bricks;
    cast.shading = castShading(context, draw);
    cast.blending = state.blending.color;
    return cast;
}

void setOpacityGauge(const ContextRecord& context, const Camera& camera, CastRequest& cast)
{
    if (!(context.state.unitLength > 0.0)) return;
    if (const auto gauge = sampleGauge(cast.tetras, camera, cast.sampling))
        cast.opacityGauge = *gauge * context.state.unitLength;
}

void readDepths(ContextRecord& context, const CompositingState& state, CastRequest& cast)
{
    if (!state.depthTest) return;
    vo::readDepths(context.gl, context.core, state.viewport, context.depths);
    cast.depth = {context.depths, state.depthOrEqual, state.depthRange[0], state.depthRange[1]};
}

void fill(ContextRecord& context, const FrameRequest& request, const Camera& camera, const CastRequest& cast,
          PolygonCache& cache)
{
    cache.update({request.tetras, request.clipBoxes, camera, request.sampling}, request.threshold);
    std::vector<PolygonCache::Run> order(cache.runs().begin(), cache.runs().end());
    if (!cache.bricksInterleave()) sortBackToFront(order, request.clipBoxes, camera);
    std::vector<PolygonRun> runs;
    for (const PolygonCache::Run& run : order)
        runs.push_back({run.brick, run.first, run.count});
    context.polygonFiller.fill(cast, {cache.records(), cache.indices(), runs}, context.picture);
}

EngineChoice wantedByEnvironment()
{
    const std::string_view word = environmentText("VO_ENGINE");
    if (word == "slices") return EngineChoice::slices;
    if (word == "cast") return EngineChoice::cast;
    if (!word.empty()) tellUnusable("VO_ENGINE", "slices or cast");
    return EngineChoice::automatic;
}

} // namespace

CastRequest viewRequest(const FrameRequest& request, const DrawState& draw, const CompositingState& state)
{
    CastRequest rays;
    rays.model = draw.model;
    rays.projection = draw.projection;
    rays.width = state.viewport[2];
    rays.height = state.viewport[3];
    rays.tetras = request.tetras;
    rays.sampling = request.sampling;
    rays.clipPlanes = state.clipPlanes;
    return rays;
}

bool isUnbounded(const ContextRecord& context, const FrameRequest& request, const DrawState& draw)
{
    for (int channel = 0; channel < 4; ++channel)
        if (!(draw.color[channel] >= 0.0f && draw.color[channel] <= 1.0f)) return true;
    if (request.layout.color >= 0) return true;
    if (activeTable(context, TableKind::preInterpolation) ||
        activeTable(context, TableKind::postInterpolation))
        return false;
    for (const FrameBrick& brick : request.bricks)
        if (!clampsTexels(brick.image.format.type)) return true;
    return false;
}

EngineChoice engineChoice(const ContextRecord& context)
{
    const EngineChoice wanted = wantedByEnvironment();
    return context.state.engine == EngineChoice::automatic ? wanted : context.state.engine;
}

std::string drawCastFrame(ContextRecord& context, const FrameRequest& request, const DrawState& draw,
                          const Camera& camera, FrameCache& cache)
{
    switch (engineChoice(context)) {
    case EngineChoice::slices: return "slices were asked for";
    case EngineChoice::cast: break;
    case EngineChoice::automatic:
        if (!context.quirks.drawsOnProcessor) return "OpenGL has hardware of its own";
    }
    CompositingState state;
    const bool unbounded = isUnbounded(context, request, draw);
    std::string obstacle = readCompositingState(context, draw, unbounded, state);
    if (!obstacle.empty()) return obstacle;
    const std::vector<CastBrick> bricks = castBricks(context, request.bricks);
    CastRequest cast = castRequest(context, request, draw, state, bricks);
    setOpacityGauge(context, camera, cast);
    const std::string noRays = unbounded && hidesBehind(cast.blending) ? "opacities may lie outside 0 to 1"
                                                                       : context.rayCaster.refusal(cast);
    if (!noRays.empty()) obstacle = fillRefusal(cast);
    if (!obstacle.empty()) return noRays + "; " + obstacle;

    readDepths(context, state, cast);
    if (noRays.empty())
        context.rayCaster.cast(cast, context.picture);
    else
        fill(context, request, camera, cast, cache.polygons);
    compositePicture(context, draw, state, context.picture);
    if (debugLevel() >= 2)
        debug(2, "frame: computed by the CPU engine, " +
                     (noRays.empty() ? std::string("by rays") : "polygon by polygon: " + noRays));
    return "";
}

} // namespace vo
