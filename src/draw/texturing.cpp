#include "draw/texturing.h"

namespace vo {

void enableTexturing(ContextRecord& context, bool twoDimensional, bool enabled)
{
    const GLenum target = twoDimensional ? GL_TEXTURE_2D : GL_TEXTURE_3D;
    if (!context.core)
        enabled ? context.gl.Enable(target) : context.gl.Disable(target);
    else if (enabled)
        context.state.enabledTarget = target;
    else if (context.state.enabledTarget == target)
        context.state.enabledTarget = 0;
}

void enableTexgen(ContextRecord& context, bool enabled)
{
    if (context.core) {
        context.state.texgen = enabled;
        return;
    }
    const GladGLContext& gl = context.gl;
    for (const GLenum coordinate : {GL_S, GL_T, GL_R})
        gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    for (const GLenum generation : {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R})
        enabled ? gl.Enable(generation) : gl.Disable(generation);
}

void setTexgenPlanes(ContextRecord& context, const TexgenPlanes& planes)
{
    constexpr GLenum coordinates[] = {GL_S, GL_T, GL_R};
    for (std::size_t i = 0; i < 3; ++i)
        if (context.core)
            context.state.texgenPlanes[i] = planes.rows[i];
        else
            context.gl.TexGenfv(coordinates[i], GL_OBJECT_PLANE, &planes.rows[i][0]);
}

} // namespace vo
