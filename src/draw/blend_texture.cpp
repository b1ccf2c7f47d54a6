#include "draw/blend_texture.h"

namespace vo {

namespace {

/// One triangle over all of the viewport.
constexpr const char* kVertexShader = R"(#version 330 core
void main()
{
    gl_Position = vec4((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1, 0.0, 1.0);
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
uniform sampler2D picture;
out vec4 color;
void main()
{
    color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}
)";

} // namespace

void blendTexture(const SceneContext& context, ScenePrograms& programs)
{
    const GladGLContext& gl = context.gl;
    SceneProgram& program = programs.find(kVertexShader, kFragmentShader);
    program.use();
    program.set("picture", 0);
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace vo
