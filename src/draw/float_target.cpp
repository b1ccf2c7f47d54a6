#include "draw/float_target.h"

#include "draw/scoped_state.h"

#include <new>

namespace vo {

FloatTarget::FloatTarget(ContextRecord& context, int width, int height)
    : context_(context), width_(width), height_(height)
{
    const GladGLContext& gl = context_.gl;
    GLint renderbuffer = 0, draw = 0, read = 0;
    gl.GetIntegerv(GL_RENDERBUFFER_BINDING, &renderbuffer);
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
    gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    gl.GenRenderbuffers(1, &color_);
    gl.BindRenderbuffer(GL_RENDERBUFFER, color_);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
    gl.GenRenderbuffers(1, &depthStencil_);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depthStencil_);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
    gl.GenFramebuffers(1, &framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depthStencil_);
    const bool complete = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    gl.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbuffer));
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw));
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
    if (complete) return;
    gl.DeleteFramebuffers(1, &framebuffer_);
    gl.DeleteRenderbuffers(1, &color_);
    gl.DeleteRenderbuffers(1, &depthStencil_);
    throw std::bad_alloc();
}

FloatTarget::~FloatTarget()
{
    if (currentContext() != &context_) return;
    end();
    context_.gl.DeleteFramebuffers(1, &framebuffer_);
    context_.gl.DeleteRenderbuffers(1, &color_);
    context_.gl.DeleteRenderbuffers(1, &depthStencil_);
}

int FloatTarget::largestSize(const ContextRecord& context)
{
    GLint size = 0;
    context.gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &size);
    return size;
}

void FloatTarget::begin()
{
    if (active_) return;
    const GladGLContext& gl = context_.gl;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &savedDraw_);
    gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &savedRead_);
    gl.GetIntegerv(GL_VIEWPORT, savedViewport_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.Viewport(0, 0, width_, height_);
    active_ = true;
}

void FloatTarget::end()
{
    if (!active_) return;
    const GladGLContext& gl = context_.gl;
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(savedDraw_));
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(savedRead_));
    gl.Viewport(savedViewport_[0], savedViewport_[1], savedViewport_[2], savedViewport_[3]);
    active_ = false;
}

void FloatTarget::show(int x, int y) const
{
    const GladGLContext& gl = context_.gl;
    GLint read = 0;
    gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    const GLboolean scissor = gl.IsEnabled(GL_SCISSOR_TEST);
    gl.Disable(GL_SCISSOR_TEST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl.BlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
    if (scissor) gl.Enable(GL_SCISSOR_TEST);
}

void FloatTarget::readPixels(float* rgba) const
{
    const GladGLContext& gl = context_.gl;
    const ScopedReadState scope(gl, context_.core);
    GLint read = 0;
    gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, rgba);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
}

} // namespace vo
