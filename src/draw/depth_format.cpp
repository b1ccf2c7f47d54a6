#include "draw/depth_format.h"

namespace vo {

DepthBits depthBitsOf(const GladGLContext& gl)
{
    GLint framebuffer = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    const auto asked = [&](GLenum attachment, GLenum what) {
        GLint answer = 0;
        gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &answer);
        return answer;
    };
    const GLenum depth = framebuffer == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
    const GLenum stencil = framebuffer == 0 ? GL_STENCIL : GL_DEPTH_ATTACHMENT;
    constexpr GLenum kType = GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE;
    DepthBits bits;
    if (asked(depth, kType) == GL_NONE) return bits;
    bits.depth = asked(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    bits.isFloat = asked(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
    if (asked(stencil, kType) != GL_NONE)
        bits.stencil = asked(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    return bits;
}

GLenum depthFormatOf(const DepthBits& bits, bool withStencil)
{
    const bool both = withStencil && bits.stencil > 0;
    if (bits.isFloat) return both ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
    if (both) return GL_DEPTH24_STENCIL8;
    return bits.depth == 16   ? GL_DEPTH_COMPONENT16
           : bits.depth == 32 ? GL_DEPTH_COMPONENT32
                              : GL_DEPTH_COMPONENT24;
}

bool hasStencil(GLenum depthFormat)
{
    return depthFormat == GL_DEPTH32F_STENCIL8 || depthFormat == GL_DEPTH24_STENCIL8;
}

} // namespace vo
