#include "draw/draw_scene.h"

#include "core/invertible.h"
#include "draw/draw_sky.h"
#include "draw/draw_stipples.h"
#include "draw/draw_surfaces.h"
#include "draw/draw_volumes.h"
#include "draw/scene_state.h"
#include "draw/seen_bounds.h"
#include "draw/translucent_target.h"
#include "polygonize/slice_stack.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace vo {

namespace {

/// Gives the caller's framebuffer back, whatever happens.
class ScopedEnd
{
public:
    explicit ScopedEnd(TranslucentTarget& target) : target_(target) {}
    ~ScopedEnd() { target_.end(); }
    ScopedEnd(const ScopedEnd&) = delete;
    ScopedEnd& operator=(const ScopedEnd&) = delete;

private:
    TranslucentTarget& target_;
};

} // namespace

struct SceneDrawer::Private
{
    SceneResources resources;
    StackSlicer slicer;
    SceneArrays arrays{resources.context};
    TranslucentSurfaces translucent{resources};
    DrawnStipples stipples{resources};
    TranslucentTarget target{resources};
    ProjectionMerger merger{resources};
    std::vector<std::unique_ptr<DrawnVolume>> volumes;
    std::optional<SharedPlanes> planes; ///< of the scene at hand
    RayHits hits{resources};
    std::vector<std::size_t> walked, ofHits; ///< volumes between hits, the nearest first, and those of them
    std::vector<SliceLayer> mergedLayer;     ///< of all merged projections, or none

    void draw(const StyledScene& scene);

private:
    std::size_t prepareVolumes(const StyledScene& scene);
    void drawOpaque(const StyledScene& scene);
    void drawTranslucent(const StyledScene& scene, std::size_t count);
    LayerLists layerLists(std::size_t count);
    void drawApart(const StyledScene& scene, std::size_t count);
    void useStep(const SceneStep& step, std::size_t merged);
    void findHits(bool hasSurfaces);
    float sourceBetween(std::size_t volume) const;
    void drawFromHitToHit(const StyledScene& scene);
    void drawSteps(const std::vector<SceneStep>& steps, std::size_t merged);
    void checkErrors() const;
};

/// How many there are to draw.
std::size_t SceneDrawer::Private::prepareVolumes(const StyledScene& scene)
{
    std::vector<const StyledVolume*> drawn;
    for (const StyledVolume& volume : scene.volumes)
        if (isDrawn(volume)) drawn.push_back(&volume);
    const std::vector<VolumePlace> places = volumePlaces(scene, drawn);
    while (volumes.size() < drawn.size())
        volumes.push_back(std::make_unique<DrawnVolume>(resources));
    for (std::size_t i = 0; i < drawn.size(); ++i)
        volumes[i]->prepare(scene, *drawn[i], slicer, places[i]);
    walked = walkedNearestFirst(scene, drawn, places);
    ofHits.clear();
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (places[i] == VolumePlace::ofHits) ofHits.push_back(i);
    return drawn.size();
}

void SceneDrawer::Private::drawOpaque(const StyledScene& scene)
{
    const GladGLContext& gl = resources.context.gl;
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.DepthMask(GL_TRUE);
    drawOpaqueSurfaces(scene, *planes, resources, arrays);
    stipples.draw(scene);
    gl.DepthMask(GL_FALSE);
}

/// Of each volume, and at last of the projections that are merged.
LayerLists SceneDrawer::Private::layerLists(std::size_t count)
{
    LayerLists lists(count + 1);
    mergedLayer.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const std::vector<SliceLayer>& layers = volumes[i]->layers();
        if (!volumes[i]->isMerged()) {
            lists[i] = layers;
            continue;
        }
        const SliceLayer& whole = layers.front();
        if (mergedLayer.empty()) mergedLayer.push_back(whole);
        SliceLayer& all = mergedLayer.front();
        const double farthest = std::max(all.depth + all.reach, whole.depth + whole.reach);
        all.depth = std::min(all.depth, whole.depth);
        all.reach = farthest - all.depth;
    }
    lists[count] = mergedLayer;
    return lists;
}

void SceneDrawer::Private::drawApart(const StyledScene& scene, std::size_t count)
{
    const auto merged = static_cast<std::size_t>(
        std::count_if(volumes.begin(), volumes.begin() + static_cast<std::ptrdiff_t>(count),
                      [](const auto& volume) { return volume->isMerged(); }));
    merger.prepare(scene.width, scene.height, merged);
    std::size_t layer = 0;
    for (std::size_t i = 0; i < count; ++i) {
        volumes[i]->drawApart(target);
        if (volumes[i]->isMerged()) volumes[i]->keep(target, merger, layer++);
    }
}

void SceneDrawer::Private::useStep(const SceneStep& step, std::size_t merged)
{
    if (step.drawn != merged) return volumes[step.drawn]->use(target);
    target.bindWithoutDepths();
    merger.use();
}

void SceneDrawer::Private::drawSteps(const std::vector<SceneStep>& steps, std::size_t merged)
{
    const std::size_t none = merged + 1;
    std::size_t used = none;
    const auto drawSurfacesBehind = [&](double depth) {
        if (!translucent.anyBehind(depth)) return;
        target.bindWithDepths();
        resources.context.gl.Enable(GL_DEPTH_TEST);
        translucent.drawBehind(depth);
        used = none;
    };
    for (std::size_t i = 0; i < steps.size();) {
        SceneStep step = steps[i++];
        drawSurfacesBehind(step.depth());
        while (i < steps.size() && !translucent.anyBehind(steps[i].depth()) && step.join(steps[i]))
            ++i;
        if (step.drawn != used) useStep(step, merged);
        used = step.drawn;
        if (used == merged)
            merger.draw(step.nearest, step.farthest);
        else
            volumes[used]->draw(step);
    }
    drawSurfacesBehind(-std::numeric_limits<double>::infinity());
}

/// The next ones of all sources: volumes, and at last the translucent surfaces.
void SceneDrawer::Private::findHits(bool hasSurfaces)
{
    const GladGLContext& gl = resources.context.gl;
    for (std::size_t source = 0; source < ofHits.size(); ++source) {
        hits.bind(source);
        volumes[ofHits[source]]->findHits(hits, source, target);
    }
    if (!hasSurfaces) return;
    hits.bindForgetful(ofHits.size());
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS); // of one depth the first
    translucent.findHits(hits, target, ofHits.size());
}

/// The place of a volume among the sources, which are in the order of the scene.
float SceneDrawer::Private::sourceBetween(std::size_t volume) const
{
    const auto before = std::ranges::lower_bound(ofHits, volume) - ofHits.begin();
    return static_cast<float>(before) - 0.5f;
}

void SceneDrawer::Private::drawFromHitToHit(const StyledScene& scene)
{
    const GladGLContext& gl = resources.context.gl;
    const bool hasSurfaces = translucent.prepareHits(scene, *planes);
    if (!target.begin(scene.width, scene.height)) drawOpaque(scene);
    hits.begin(scene.width, scene.height, ofHits.size() + 1);
    constexpr float kClear[4] = {};
    target.bindWithoutDepths();
    gl.ClearBufferfv(GL_COLOR, 0, kClear);
    gl.BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    // A driver that rounds a depth in another way with each pass would find the same hits for ever.
    constexpr int kMostPasses = 1 << 14;
    bool isOn = true;
    for (int pass = 0; isOn && pass < kMostPasses; ++pass) {
        findHits(hasSurfaces);
        hits.chooseNext(target);
        gl.Enable(GL_BLEND);
        for (const std::size_t i : walked)
            volumes[i]->drawBetween(hits, sourceBetween(i), target);
        isOn = hits.advance(target);
    }
    gl.DepthMask(GL_FALSE);
    target.show();
}

void SceneDrawer::Private::drawTranslucent(const StyledScene& scene, std::size_t count)
{
    const bool areFacesAlone = count == 0 && facesHaveHits(scene);
    if (!walked.empty() || !ofHits.empty() || areFacesAlone) return drawFromHitToHit(scene);
    const LayerLists lists = layerLists(count);
    std::vector<double> borders = stepBorders(lists);
    translucent.prepare(scene, *planes, borders);
    const std::vector<SceneStep> steps = sceneSteps(lists, borders);
    constexpr double kNearest = -std::numeric_limits<double>::infinity();
    if (steps.empty() && !translucent.anyBehind(kNearest)) return;
    if (!target.begin(scene.width, scene.height)) drawOpaque(scene);
    drawApart(scene, count);
    constexpr float kClear[4] = {};
    target.bindWithDepths();
    resources.context.gl.ClearBufferfv(GL_COLOR, 0, kClear);
    drawSteps(steps, count);
    target.show();
}

void SceneDrawer::Private::checkErrors() const
{
    const GLenum error = resources.context.gl.GetError();
    if (error == GL_OUT_OF_MEMORY)
        throw std::runtime_error("drawing a scene: the driver says GL_OUT_OF_MEMORY");
    if (error != GL_NO_ERROR)
        throw std::runtime_error("drawing a scene: the driver says error " + std::to_string(error));
}

void SceneDrawer::Private::draw(const StyledScene& scene)
{
    const GladGLContext& gl = resources.context.gl;
    const ScopedSceneState state(resources.context);
    while (gl.GetError() != GL_NO_ERROR) {
    }
    const ScopedEnd end(target);
    stipples.prepare(scene);
    planes.emplace(scene);
    const std::size_t count = prepareVolumes(scene);

    gl.Viewport(0, 0, scene.width, scene.height);
    gl.Enable(GL_BLEND);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    if (scene.background.opacity > 0.0f) drawSky(scene, resources, arrays);
    drawOpaque(scene);
    drawTranslucent(scene, count);
    resources.textures.endPicture();
    checkErrors();
}

SceneDrawer::SceneDrawer() = default;
SceneDrawer::~SceneDrawer() = default;

void SceneDrawer::draw(const StyledScene& scene)
{
    if (scene.width < 1 || scene.height < 1) return;
    if (!isInvertible(scene.eyeFromWorld) || !isInvertible(scene.clipFromEye)) return;
    if (!d) d = std::make_unique<Private>();
    if (!d->resources.context.isCurrent())
        throw std::runtime_error("scenes are drawn in the context of the first, which is not current");
    d->draw(scene);
}

} // namespace vo
