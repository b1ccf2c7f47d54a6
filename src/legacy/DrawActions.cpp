#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/perf_meter.h"
#include "legacy/report.h"

#include "draw/draw_faces.h"
#include "draw/draw_state.h"
#include "draw/scoped_state.h"
#include "frame/frame.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

using vo::badValue;
using vo::guarded;
using vo::required;

namespace {

/// The formats that draw knows, checked against the records at hand.
vo::RecordLayout drawLayout(int format, int values)
{
    if (format == voInterleavedArrayTypeScope::USER_V3F)
        vo::unsupported("USER_V3F records are drawn by the application");
    const vo::RecordLayout layout = vo::recordLayout(format, values);
    if (layout.values != values)
        badValue("the vertex format has " + std::to_string(layout.values) + " values a record, the set has " +
                 std::to_string(values));
    return layout;
}

void checkMode(GLenum mode)
{
    if (mode != GL_FILL && mode != GL_LINE && mode != GL_POINT)
        vo::badEnum("the mode is none of GL_FILL, GL_LINE, GL_POINT");
}

/// The vertices that the polygons use, renumbered from 0, so that small sets of large shared data are sent
/// alone.
void gather(const voIndexedFaceSet& faceSet, int values, vo::FaceBatch& batch)
{
    const voVertexData& vertices = *faceSet.getVertexData();
    const voIndices& indices = *faceSet.getIndices();
    batch.clear();
    const std::span<const int> entries(indices.getDataPtr(), static_cast<std::size_t>(indices.getCount()));
    for (std::size_t i = 0; i < entries.size();) {
        const int count = entries[i];
        if (count < 0 || entries.size() - i - 1 < static_cast<std::size_t>(count))
            badValue("the indices are no groups of a count and that many vertices");
        batch.polygons.push_back(count);
        for (const int vertex : entries.subspan(i + 1, static_cast<std::size_t>(count))) {
            if (vertex < 0 || vertex >= vertices.getCount())
                badValue("vertex " + std::to_string(vertex) + " is outside 0 to " +
                         std::to_string(vertices.getCount() - 1));
            batch.polygons.push_back(static_cast<int>(batch.records.size()) / values);
            const float* record =
                vertices.getDataPtr() + static_cast<std::size_t>(vertex) * static_cast<std::size_t>(values);
            batch.records.insert(batch.records.end(), record, record + values);
        }
        i += static_cast<std::size_t>(count) + 1;
    }
}

void drawFaceSet(voIndexedFaceSet& faceSet, const GLenum* mode, int format)
{
    thread_local vo::FaceBatch batch;
    const vo::RecordLayout layout = drawLayout(format, faceSet.getVertexData()->getValuesPerVertex());
    if (faceSet.getIndices()->getCount() == 0) return;
    vo::ContextRecord& context = vo::requireContext();
    gather(faceSet, layout.values, batch);
    vo::DrawState state = vo::readDrawState(context);
    if (context.state.sampleGauge) vo::setOpacityPerLength(context, *context.state.sampleGauge, state);
    vo::drawFaces(context, state, layout, batch.records, batch.polygons, mode ? *mode : state.polygonMode);
}

void drawTetraSet(voIndexedTetraSet& tetraSet, const GLenum* mode, int format)
{
    const vo::RecordLayout layout = drawLayout(format, tetraSet.getVertexData()->getValuesPerVertex());
    const vo::TetraView view = vo::tetraView(tetraSet);
    vo::ContextRecord& context = vo::requireContext();
    std::vector<int> polygons;
    constexpr int kFaces[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    for (std::size_t tetra = 0; tetra + 3 < view.indices.size(); tetra += 4)
        for (const auto& face : kFaces) {
            polygons.push_back(3);
            for (const int corner : face)
                polygons.push_back(view.indices[tetra + static_cast<std::size_t>(corner)]);
        }
    const vo::DrawState state = vo::readDrawState(context);
    vo::drawFaces(context, state, layout, view.records, polygons, mode ? *mode : state.polygonMode);
}

void drawOutlines(std::span<voBrick* const> bricks)
{
    vo::ContextRecord& context = vo::requireContext();
    std::vector<float> positions;
    for (const voBrick* brick : bricks) {
        float origin[3], size[3];
        brick->getBrickSizes(origin, size);
        vo::appendBoxEdges(glm::make_vec3(origin), glm::make_vec3(size), positions);
    }
    vo::drawSegments(context, vo::readDrawState(context), positions);
}

std::vector<vo::FrameBrick> frameBricks(const voBrickSet& set)
{
    std::vector<vo::FrameBrick> bricks;
    for (int i = 0; i < set.getBrickCount(); ++i) {
        const voBrick& brick = *set.getBrick(i);
        vo::FrameBrick b;
        b.image = vo::textureImage(brick);
        brick.getBrickSizes(&b.origin[0], &b.size[0]);
        b.thinAxis = vo::thinAxis(set.getOrientation());
        bricks.push_back(b);
    }
    return bricks;
}

/// As many samples as the finest period can ask for along the diagonal of the tetrahedra, without a cache to
/// say.
int defaultMaxSamples(const voBrickSet& set)
{
    int x, y, z;
    set.getVolumeSizes(x, y, z);
    return static_cast<int>(std::min<long long>(2LL * std::max({x, y, z}), vo::kMostFrameSamples));
}

void addTimes(const vo::FrameTimes& times, voutPerfMeter& meter)
{
    meter.getTimer(voutPerfMeter::POLYGONIZE).add(times.polygonize);
    meter.getTimer(voutPerfMeter::SORT).add(times.sort);
    meter.getTimer(voutPerfMeter::LOAD).add(times.load);
    meter.getTimer(voutPerfMeter::DRAW).add(times.draw);
    meter.countFrame();
}

void throwOnFailure(vo::FrameResult result)
{
    switch (result) {
    case vo::FrameResult::ok: return;
    case vo::FrameResult::singularMatrices: badValue("the matrices are singular");
    case vo::FrameResult::incompleteFramebuffer: badValue("the framebuffer bound for drawing is incomplete");
    case vo::FrameResult::textureTooLarge: badValue("a brick is larger than a texture of OpenGL can be here");
    case vo::FrameResult::outOfMemory: throw std::bad_alloc();
    case vo::FrameResult::noVoxels: badValue("a brick has no voxels; dataAlloc or setDataPtr gives it some");
    }
}

} // namespace

void voGeometryActions::draw(voIndexedFaceSet* faceSet, voInterleavedArrayType format)
{
    guarded("voGeometryActions::draw", [&] { drawFaceSet(required(faceSet, "faceSet"), nullptr, format); });
}

void voGeometryActions::draw(voIndexedFaceSet* faceSet, GLenum mode, voInterleavedArrayType format)
{
    guarded("voGeometryActions::draw", [&] {
        checkMode(mode);
        voIndexedFaceSet& faces = required(faceSet, "faceSet");
        const vo::ScopedPolygonMode scope(vo::requireContext(), mode);
        drawFaceSet(faces, &mode, format);
    });
}

void voGeometryActions::draw(voIndexedTetraSet* tetraSet, voInterleavedArrayType format)
{
    guarded("voGeometryActions::draw",
            [&] { drawTetraSet(required(tetraSet, "tetraSet"), nullptr, format); });
}

void voGeometryActions::draw(voIndexedTetraSet* tetraSet, GLenum mode, voInterleavedArrayType format)
{
    guarded("voGeometryActions::draw", [&] {
        checkMode(mode);
        voIndexedTetraSet& tetras = required(tetraSet, "tetraSet");
        const vo::ScopedPolygonMode scope(vo::requireContext(), mode);
        drawTetraSet(tetras, &mode, format);
    });
}

void voGeometryActions::draw(voBrick* brick)
{
    guarded("voGeometryActions::draw", [&] {
        voBrick* const bricks[] = {&required(brick, "brick")};
        drawOutlines(bricks);
    });
}

void voGeometryActions::draw(voBrickSet* brickSet)
{
    guarded("voGeometryActions::draw", [&] {
        std::vector<voBrick*> bricks;
        voBrickSetIterator next(&required(brickSet, "brickSet"));
        for (voBrick* brick; (brick = next());)
            bricks.push_back(brick);
        drawOutlines(bricks);
    });
}

int voGeometryActions::drawUtility(voIndexedTetraSet* tetraSet, voInterleavedArrayType format,
                                   voBrickSetCollection* aVolume, voDrawActionCache* cache,
                                   voSamplingSpace samplingSpace, float samplingPeriod[3],
                                   voDecorationFlags decorations)
{
    return guarded("voGeometryActions::drawUtility", [&] {
        voIndexedTetraSet& tetras = required(tetraSet, "tetraSet");
        voBrickSetCollection& volume = required(aVolume, "volume");
        if (static_cast<int>(decorations) & ~voDecorationFlagsScope::ALL)
            vo::badEnum("voDecorationFlags has no value " + std::to_string(decorations));
        vo::ContextRecord& context = vo::requireContext();
        thread_local vo::FrameCache ownFrames;
        voInside::DrawCache* kept = cache ? &voInside::of(*cache) : nullptr;

        const bool stacks = volume.getInterpolationType() == voInterpolationTypeScope::_2D;
        if (stacks) {
            const vo::DrawState state = vo::readDrawState(context);
            const std::optional<vo::Camera> camera = vo::findCamera(state.model, state.projection);
            if (!camera) badValue("the matrices are singular");
            volume.setCurrentBrickSet(vo::stackAcross(vo::closestAxis(*camera)));
        }
        const voBrickSet& set = *volume.getCurrentBrickSet();
        const voSamplingMode mode = stacks ? voSamplingModeScope::AXIS_ALIGNED
                                    : kept ? kept->samplingMode
                                           : voSamplingModeScope::VIEWPORT_ALIGNED;
        thread_local std::vector<vo::Box> boxes;
        vo::clipBoxes(set, boxes);
        const std::vector<vo::FrameBrick> bricks = frameBricks(set);
        vo::FrameRequest request;
        request.tetras = vo::tetraView(tetras);
        request.layout = drawLayout(format, request.tetras.valuesPerVertex);
        request.tetras.voxelColumn = request.layout.texCoord;
        request.clipBoxes = boxes;
        request.bricks = bricks;
        request.sampling =
            vo::samplingRequest(mode, samplingSpace, samplingPeriod,
                                kept ? kept->maxSamples : defaultMaxSamples(set), set.getOrientation());
        if (context.state.unitLength > 0.0 && request.sampling.space == vo::SamplingSpace::primitive)
            vo::unsupported("opacity per length needs samples of one distance, which PRIMITIVE has not");
        request.threshold = kept ? kept->threshold : 0.0;
        request.outlineBricks = decorations & voDecorationFlagsScope::BRICKS;
        request.outlineTetras = decorations & voDecorationFlagsScope::TETRAS;
        vo::FrameTimes times;
        voutPerfMeter* meter = vo::currentMeter();
        request.times = meter ? &times : nullptr;
        throwOnFailure(vo::drawFrame(context, request, kept ? kept->frames : ownFrames));
        if (meter) addTimes(times, *meter);
    });
}
