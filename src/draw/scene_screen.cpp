#include "draw/scene_screen.h"

#include "core/environment.h"
#include "draw/blend_texture.h"
#include "draw/draw_scene.h"
#include "draw/read_depths.h"
#include "draw/scene_programs.h"
#include "draw/scene_state.h"
#include "draw/scoped_state.h"

#include <cstring>
#include <stdexcept>
#include <vector>

namespace vo {

struct SceneScreen::Private
{
    SceneContext context;
    ScenePrograms programs{context};
    SceneDrawer drawer;
    GLuint texture = 0, vertexArray = 0;
    std::vector<float> depths;

    ~Private()
    {
        context.gl.DeleteTextures(1, &texture);
        context.gl.DeleteVertexArrays(1, &vertexArray);
    }

    void send(const ScenePicture& picture)
    {
        const GladGLContext& gl = context.gl;
        const ScopedUploadState upload(gl, context.core);
        if (texture == 0) gl.GenTextures(1, &texture);
        gl.BindTexture(GL_TEXTURE_2D, texture);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, picture.width, picture.height, 0, GL_RGBA, GL_FLOAT,
                      picture.rgba.data());
    }
};

SceneScreen::SceneScreen() = default;
SceneScreen::~SceneScreen() = default;

SceneScreen::Private& SceneScreen::opened()
{
    if (!d) d = std::make_unique<Private>();
    if (!d->context.isCurrent())
        throw std::runtime_error("scenes are drawn in the context of the first, which is not current");
    return *d;
}

void SceneScreen::draw(const StyledScene& scene)
{
    opened().drawer.draw(scene);
}

CastDepth SceneScreen::readDepths(int width, int height)
{
    Private& own = opened();
    return depthsThere(own.context.gl, own.context.core, width, height, own.depths);
}

void SceneScreen::show(const ScenePicture& picture)
{
    Private& own = opened();
    const GladGLContext& gl = own.context.gl;
    const ScopedSceneState state(own.context);
    gl.ActiveTexture(GL_TEXTURE0);
    const ScopedTextureBindings bindings(gl);
    own.send(picture);
    if (own.vertexArray == 0) gl.GenVertexArrays(1, &own.vertexArray);
    gl.BindVertexArray(own.vertexArray);
    gl.Viewport(0, 0, picture.width, picture.height);
    blendTexture(own.context, own.programs);
}

bool SceneScreen::prefersCasting()
{
    const GladGLContext& gl = opened().context.gl;
    const std::string_view word = environmentText("VO_ENGINE");
    if (word == "cast" || word == "slices") return word == "cast";
    if (!word.empty()) tellUnusable("VO_ENGINE", "slices or cast");
    const char* const renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    for (const char* const name : {"llvmpipe", "softpipe", "SWR", "swrast"})
        if (renderer && std::strstr(renderer, name)) return true;
    return false;
}

} // namespace vo
