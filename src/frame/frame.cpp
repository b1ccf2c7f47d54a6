#include "frame/frame.h"

#include "core/log.h"
#include "draw/compositing_state.h"
#include "draw/draw_faces.h"
#include "draw/draw_state.h"
#include "draw/scoped_state.h"
#include "frame/cast_frame.h"
#include "frame/march_frame.h"
#include "polygonize/line_of_sight.h"
#include "sort/brick_order.h"

#include <chrono>
#include <algorithm>
#include <string>
#include <vector>
#include <utility>

namespace vo {

namespace {

const glm::vec4 kTetraColor(1.0f, 1.0f, 0.0f, 1.0f);
const glm::vec4 kBrickColor(0.0f, 0.0f, 1.0f, 1.0f);

/// Tells the phases of a frame apart, if somebody wants their times.
class PhaseClock
{
public:
    PhaseClock(const ContextRecord& context, FrameTimes* times) : context_(context), times_(times)
    {
        finish();
    }

    /// What passed since the phase before ended belongs to this one.
    void end(double FrameTimes::*phase)
    {
        if (!times_) return;
        const Clock::time_point now = Clock::now();
        times_->*phase += std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

    /// Waits for OpenGL.
    void finish() const
    {
        if (times_) waitForOpenGl(context_);
    }

private:
    using Clock = std::chrono::steady_clock;
    const ContextRecord& context_;
    FrameTimes* times_;
    Clock::time_point last_ = Clock::now();
};

glm::mat4 voxelToTexture(const FrameBrick& brick)
{
    const TexgenPlanes planes =
        texgenPlanes(brick.origin, brick.size, brick.image.twoDimensional, brick.thinAxis);
    glm::mat4 matrix(0.0f);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = planes.rows[row][column];
    matrix[3][3] = 1.0f;
    return matrix;
}

void drawOutlines(ContextRecord& context, const FrameRequest& request, DrawState state)
{
    std::vector<float> positions;
    if (request.outlineTetras) {
        appendTetraEdges(request.tetras, positions);
        state.color = kTetraColor;
        drawSegments(context, state, positions);
    }
    if (request.outlineBricks) {
        positions.clear();
        for (const FrameBrick& brick : request.bricks)
            appendBoxEdges(brick.origin, brick.size, positions);
        state.color = kBrickColor;
        drawSegments(context, state, positions);
    }
}

/// The state for one brick: its texture, and where its voxels lie in it.
void pointAtBrick(const ContextRecord& context, const FrameBrick& brick, const RecordLayout& layout,
                  const glm::mat4& callerTextureMatrix, DrawState& state)
{
    state.texturing = brick.image.twoDimensional ? Texturing::twoDimensional : Texturing::threeDimensional;
    const ResidentTexture& texture = context.textures.at(brick.image.id);
    state.oneChannel = texture.oneChannel;
    state.textureHasAlpha = texture.hasAlpha;
    state.texgen = layout.texCoord < 0;
    if (!state.texgen) {
        state.textureMatrix = callerTextureMatrix * voxelToTexture(brick);
        return;
    }
    const TexgenPlanes planes =
        texgenPlanes(brick.origin, brick.size, brick.image.twoDimensional, brick.thinAxis);
    for (std::size_t i = 0; i < 3; ++i)
        state.texgenPlanes[i] = planes.rows[i];
}

FrameResult toFrameResult(TextureResult result)
{
    switch (result) {
    case TextureResult::ok: return FrameResult::ok;
    case TextureResult::tooLarge: return FrameResult::textureTooLarge;
    case TextureResult::outOfMemory: return FrameResult::outOfMemory;
    case TextureResult::noVoxels: return FrameResult::noVoxels;
    }
    return FrameResult::ok;
}

/// Triangles in runs that lie in one brick each.
struct FrameTriangles
{
    std::span<const float> records;
    std::span<const std::uint32_t> indices;
    std::vector<PolygonCache::Run> runs; ///< from back to front
    bool bricksInterleave = false;       ///< runs have an order already
    int samples = 0;
    bool anew = true;
    std::uint64_t serial = 0; ///< of records and indices
    Camera camera;            ///< for which they were made
};

FrameTriangles frameTriangles(ContextRecord& context, const FrameRequest& request, const Camera& camera,
                              FrameCache& cache)
{
    FrameTriangles triangles;
    if (clearFragmentsLeaveNoTrace(context))
        if (const OccupiedSlices* slices = cache.leaping.slices(context, request, camera)) {
            triangles.records = slices->positions;
            triangles.indices = slices->indices;
            for (const OccupiedSlices::Run& run : slices->runs)
                triangles.runs.push_back({run.brick, run.first, run.count});
            triangles.samples = cache.leaping.samples();
            triangles.anew = !cache.leaping.kept();
            triangles.serial = cache.leaping.serial();
            triangles.camera = camera;
            return triangles;
        }
    PolygonCache& polygons = cache.polygons;
    triangles.anew =
        polygons.update({request.tetras, request.clipBoxes, camera, request.sampling}, request.threshold);
    triangles.records = polygons.records();
    triangles.indices = polygons.indices();
    triangles.runs.assign(polygons.runs().begin(), polygons.runs().end());
    triangles.bricksInterleave = polygons.bricksInterleave();
    triangles.samples = polygons.samples();
    triangles.serial = polygons.serial();
    triangles.camera = polygons.camera();
    return triangles;
}

/// Binds a brick's texture, sent if need be.
TextureResult loadBrick(ContextRecord& context, const FrameBrick& brick, PhaseClock& clock)
{
    clock.end(&FrameTimes::draw);
    const std::uint64_t downloads = context.downloads;
    const TextureResult bound = bindTexture(context, brick.image, false);
    if (downloads != context.downloads) clock.finish();
    clock.end(&FrameTimes::load);
    return bound;
}

FrameResult drawBricks(ContextRecord& context, const FrameRequest& request, const FrameTriangles& triangles,
                       DrawState state, PhaseClock& clock)
{
    const glm::mat4 callerTextureMatrix = state.textureMatrix;
    FaceStream stream(context, state, request.layout, triangles.records, triangles.indices, triangles.serial);
    for (const PolygonCache::Run& run : triangles.runs) {
        const FrameBrick& brick = request.bricks[static_cast<std::size_t>(run.brick)];
        const TextureResult bound = loadBrick(context, brick, clock);
        if (bound != TextureResult::ok) return toFrameResult(bound);
        pointAtBrick(context, brick, request.layout, callerTextureMatrix, state);
        stream.draw(state, run.first, run.count);
    }
    return FrameResult::ok;
}

FrameResult drawMarched(ContextRecord& context, const FrameRequest& request, const MarchedFrame& frame,
                        DrawState state, PhaseClock& clock)
{
    SampleMarch march(context, state, frame.state, frame.ramps, frame.cells);
    for (const MarchedFrame::Part& part : frame.parts) {
        const FrameBrick& brick = request.bricks[static_cast<std::size_t>(part.brick)];
        const TextureResult bound = loadBrick(context, brick, clock);
        if (bound != TextureResult::ok) return toFrameResult(bound);
        pointAtBrick(context, brick, request.layout, state.textureMatrix, state);
        march.draw(state, part.place, part.pixels);
    }
    return FrameResult::ok;
}

/// Polygon by polygon.
FrameResult drawSliced(ContextRecord& context, const FrameRequest& request, const Camera& camera,
                       const DrawState& state, FrameCache& cache, PhaseClock& clock)
{
    FrameTriangles triangles = frameTriangles(context, request, camera, cache);
    if (debugLevel() >= 2)
        debug(2, std::string("frame: ") + (triangles.anew ? "new" : "kept") + " polygons, " +
                     std::to_string(triangles.samples) + " samples, drawn as slices");
    clock.end(&FrameTimes::polygonize);
    if (!triangles.bricksInterleave) sortBackToFront(triangles.runs, request.clipBoxes, camera);
    clock.end(&FrameTimes::sort);
    DrawState samples = state;
    if (context.state.unitLength > 0.0)
        if (const auto gauge = sampleGauge(request.tetras, triangles.camera, request.sampling))
            setOpacityPerLength(context, *gauge, samples);
    return drawBricks(context, request, triangles, samples, clock);
}

FrameResult drawSlices(ContextRecord& context, const FrameRequest& request, const Camera& camera,
                       const DrawState& state, FrameCache& cache, PhaseClock& clock)
{
    const ScopedTextureBindings bindings(context.gl);
    const std::optional<MarchedFrame> marched = marchedFrame(context, request, state, camera, cache.leaping);
    if (!marched) return drawSliced(context, request, camera, state, cache, clock);
    debug(2, "frame: " + std::to_string(marched->ramps.count) + " samples, all of a pixel at once");
    clock.end(&FrameTimes::polygonize);
    DrawState samples = state;
    if (context.state.unitLength > 0.0)
        if (const auto gauge = sampleGauge(request.tetras, camera, request.sampling))
            setOpacityPerLength(context, *gauge, samples);
    return drawMarched(context, request, *marched, samples, clock);
}

/// The same with the whole box in place of boxes in it outside which nothing is seen: one body costs less
/// than many, and leaps as far.
FrameRequest withoutGaps(ContextRecord& context, const FrameRequest& request, SpaceLeaping& leaping)
{
    FrameRequest whole = request;
    if (!clearFragmentsLeaveNoTrace(context)) return whole;
    if (const std::optional<TetraView> box = leaping.boxAround(context, request)) {
        debug(2, "frame: nothing shows between the boxes of the set");
        whole.tetras = *box;
    }
    return whole;
}

void countFrame(ContextRecord& context, Engine engine)
{
    ++context.framesDrawn[static_cast<std::size_t>(engine)];
}

void tellWhySlices(ContextRecord& context, const std::string& reason)
{
    if (context.whySlices == reason) return;
    context.whySlices = reason;
    debug(1, "drawing slices: " + reason);
}

} // namespace

void sortBackToFront(std::span<PolygonCache::Run> runs, std::span<const Box> boxes, const Camera& camera)
{
    const std::vector<int> order = backToFront(boxes, camera);
    std::vector<int> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    std::ranges::sort(
        runs, {}, [&](const PolygonCache::Run& run) { return place[static_cast<std::size_t>(run.brick)]; });
}

FrameResult drawFrame(ContextRecord& context, const FrameRequest& request, FrameCache& cache)
{
    PhaseClock clock(context, request.times);
    const DrawState state = readDrawState(context);
    const std::optional<Camera> camera = findCamera(state.model, state.projection);
    if (!camera) return FrameResult::singularMatrices;
    if (!framebufferIsComplete(context)) return FrameResult::incompleteFramebuffer;
    if (request.outlineBricks || request.outlineTetras) drawOutlines(context, request, state);
    const FrameRequest whole = withoutGaps(context, request, cache.leaping);
    const std::string whySlices = drawCastFrame(context, whole, state, *camera, cache);
    if (whySlices.empty()) {
        countFrame(context, Engine::cast);
        clock.finish();
        clock.end(&FrameTimes::draw);
        return FrameResult::ok;
    }
    tellWhySlices(context, whySlices);
    clock.end(&FrameTimes::draw);

    const FrameResult result = drawSlices(context, whole, *camera, state, cache, clock);
    if (result == FrameResult::ok) countFrame(context, Engine::slices);
    clock.finish();
    clock.end(&FrameTimes::draw);
    return result;
}

void appendBoxEdges(const glm::vec3& origin, const glm::vec3& size, std::vector<float>& positions)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            glm::vec3 start = origin;
            if (corner & 1) start[(axis + 1) % 3] += size[(axis + 1) % 3];
            if (corner & 2) start[(axis + 2) % 3] += size[(axis + 2) % 3];
            glm::vec3 end = start;
            end[axis] += size[axis];
            for (const glm::vec3& p : {start, end})
                positions.insert(positions.end(), {p.x, p.y, p.z});
        }
}

void appendTetraEdges(const TetraView& tetras, std::vector<float>& positions)
{
    for (int tetra = 0; tetra < tetras.tetraCount(); ++tetra)
        for (int a = 0; a < 4; ++a)
            for (int b = a + 1; b < 4; ++b)
                for (const int corner : {a, b}) {
                    const glm::vec3 p(
                        tetras.position(tetras.indices[static_cast<std::size_t>(4 * tetra + corner)]));
                    positions.insert(positions.end(), {p.x, p.y, p.z});
                }
}

} // namespace vo
