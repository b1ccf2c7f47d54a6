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
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

namespace vo {

namespace {

/// A layer of a volume of the picture.
struct Step
{
    double depth;
    std::size_t volume, first, count;
};

/// All layers, the farthest first; at one depth the volume that comes first in the scene is in front.
std::vector<Step> stepsOf(const std::vector<std::unique_ptr<DrawnVolume>>& volumes, std::size_t count)
{
    std::vector<Step> steps;
    for (std::size_t i = count; i-- > 0;)
        for (const SliceLayer& layer : volumes[i]->layers())
            steps.push_back({layer.depth, i, layer.first, layer.count});
    std::ranges::stable_sort(steps, std::greater<>(), &Step::depth);
    return steps;
}

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

/// One draw for two steps that follow each other in a volume.
bool joined(Step& step, const Step& next)
{
    if (next.volume != step.volume || next.first != step.first + step.count) return false;
    step.count += next.count;
    return true;
}

} // namespace

struct SceneDrawer::Private
{
    SceneResources resources;
    StackSlicer slicer;
    SceneArrays arrays{resources.context};
    TranslucentSurfaces translucent{resources};
    DrawnStipples stipples{resources};
    TranslucentTarget target{resources};
    std::vector<std::unique_ptr<DrawnVolume>> volumes;

    void draw(const StyledScene& scene);

private:
    std::size_t prepareVolumes(const StyledScene& scene);
    void drawOpaque(const StyledScene& scene);
    void drawTranslucent(const StyledScene& scene, std::size_t count);
    void drawLayers(const std::vector<Step>& steps);
    void checkErrors() const;
};

/// How many there are to draw.
std::size_t SceneDrawer::Private::prepareVolumes(const StyledScene& scene)
{
    std::vector<const StyledVolume*> drawn;
    for (const StyledVolume& volume : scene.volumes)
        if (isDrawn(volume)) drawn.push_back(&volume);
    const std::vector<bool> alone = standingAlone(scene, drawn);
    while (volumes.size() < drawn.size())
        volumes.push_back(std::make_unique<DrawnVolume>(resources));
    for (std::size_t i = 0; i < drawn.size(); ++i)
        volumes[i]->prepare(scene, *drawn[i], slicer, alone[i]);
    return drawn.size();
}

void SceneDrawer::Private::drawOpaque(const StyledScene& scene)
{
    const GladGLContext& gl = resources.context.gl;
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.DepthMask(GL_TRUE);
    drawOpaqueSurfaces(scene, resources, arrays);
    stipples.draw(scene);
    gl.DepthMask(GL_FALSE);
}

void SceneDrawer::Private::drawLayers(const std::vector<Step>& steps)
{
    std::size_t used = volumes.size();
    const auto drawSurfacesBehind = [&](double depth) {
        if (!translucent.anyBehind(depth)) return;
        target.bindWithDepths();
        resources.context.gl.Enable(GL_DEPTH_TEST);
        translucent.drawBehind(depth);
        used = volumes.size();
    };
    for (std::size_t i = 0; i < steps.size();) {
        Step step = steps[i++];
        drawSurfacesBehind(step.depth);
        while (i < steps.size() && !translucent.anyBehind(steps[i].depth) && joined(step, steps[i]))
            ++i;
        if (step.volume != used) volumes[step.volume]->use(target);
        used = step.volume;
        volumes[used]->draw(step.first, step.count);
    }
    drawSurfacesBehind(-std::numeric_limits<double>::infinity());
}

void SceneDrawer::Private::drawTranslucent(const StyledScene& scene, std::size_t count)
{
    const std::vector<Step> steps = stepsOf(volumes, count);
    std::vector<double> depths;
    std::ranges::transform(steps, std::back_inserter(depths), &Step::depth);
    translucent.prepare(scene, depths);
    constexpr double kNearest = -std::numeric_limits<double>::infinity();
    if (steps.empty() && !translucent.anyBehind(kNearest)) return;
    if (!target.begin(scene.width, scene.height)) drawOpaque(scene);
    constexpr float kClear[4] = {};
    target.bindWithDepths();
    resources.context.gl.ClearBufferfv(GL_COLOR, 0, kClear);
    for (std::size_t i = 0; i < count; ++i)
        volumes[i]->drawApart(target);
    drawLayers(steps);
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
