#include "draw/draw_scene.h"

#include "core/invertible.h"
#include "draw/draw_sky.h"
#include "draw/draw_stipples.h"
#include "draw/draw_surfaces.h"
#include "draw/draw_volumes.h"
#include "draw/opaque_depths.h"
#include "draw/scene_state.h"
#include "polygonize/slice_stack.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

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
    OpaqueDepths opaqueDepths{resources};
    std::vector<std::unique_ptr<DrawnVolume>> volumes;

    void draw(const StyledScene& scene);

private:
    std::size_t prepareVolumes(const StyledScene& scene);
    void drawLayers(const std::vector<Step>& steps);
    void checkErrors() const;
};

/// How many there are to draw.
std::size_t SceneDrawer::Private::prepareVolumes(const StyledScene& scene)
{
    std::size_t count = 0;
    bool depthsDrawn = false;
    for (const StyledVolume& volume : scene.volumes) {
        if (!isDrawn(volume)) continue;
        if (count == volumes.size()) volumes.push_back(std::make_unique<DrawnVolume>(resources));
        const bool ends = isProjected(volume) && (hasOpaqueSurfaces(scene) || !stipples.empty());
        if (ends && !std::exchange(depthsDrawn, true)) opaqueDepths.draw(scene, arrays, stipples);
        volumes[count++]->prepare(scene, volume, slicer, ends ? &opaqueDepths : nullptr);
    }
    return count;
}

void SceneDrawer::Private::drawLayers(const std::vector<Step>& steps)
{
    std::size_t used = volumes.size();
    for (std::size_t i = 0; i < steps.size();) {
        Step step = steps[i++];
        if (translucent.drawBehind(step.depth)) used = volumes.size();
        while (i < steps.size() && !translucent.anyBehind(steps[i].depth) && joined(step, steps[i]))
            ++i;
        if (step.volume != used) volumes[step.volume]->use();
        used = step.volume;
        volumes[used]->draw(step.first, step.count);
    }
    translucent.drawBehind(-std::numeric_limits<double>::infinity());
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
    stipples.prepare(scene);
    const std::vector<Step> steps = stepsOf(volumes, prepareVolumes(scene));
    std::vector<double> depths;
    std::ranges::transform(steps, std::back_inserter(depths), &Step::depth);
    translucent.prepare(scene, depths);

    gl.Viewport(0, 0, scene.width, scene.height);
    gl.Enable(GL_BLEND);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthMask(GL_FALSE);
    if (scene.background.opacity > 0.0f) drawSky(scene, resources, arrays);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.DepthMask(GL_TRUE);
    drawOpaqueSurfaces(scene, resources, arrays, SurfaceLook::color);
    stipples.draw(scene, SurfaceLook::color);
    gl.DepthMask(GL_FALSE);
    drawLayers(steps);
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
