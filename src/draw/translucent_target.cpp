#include "draw/translucent_target.h"

#include "draw/blend_texture.h"
#include "draw/depth_format.h"
#include "draw/scoped_state.h"

#include <array>
#include <stdexcept>
#include <string>

namespace vo {

namespace {

bool isMultisampled(const GladGLContext& gl)
{
    GLint buffers = 0;
    gl.GetIntegerv(GL_SAMPLE_BUFFERS, &buffers);
    return buffers > 0;
}

void forgetErrors(const GladGLContext& gl)
{
    while (gl.GetError() != GL_NO_ERROR) {
    }
}

void makeTexture(const GladGLContext& gl, GLenum format, int width, int height)
{
    GLenum channels = GL_DEPTH_COMPONENT, type = GL_FLOAT;
    if (format == GL_RGBA32F) channels = GL_RGBA;
    if (hasStencil(format)) {
        channels = GL_DEPTH_STENCIL;
        type = format == GL_DEPTH24_STENCIL8 ? GL_UNSIGNED_INT_24_8 : GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
    }
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, channels, type, nullptr);
    filterNone(gl, GL_TEXTURE_2D);
}

} // namespace

TranslucentTarget::~TranslucentTarget()
{
    if (resources_.context.isCurrent()) release();
}

void TranslucentTarget::release()
{
    const GladGLContext& gl = resources_.context.gl;
    for (GLuint* const framebuffer : {&withDepths_, &withoutDepths_}) {
        gl.DeleteFramebuffers(1, framebuffer);
        *framebuffer = 0;
    }
    for (GLuint* const texture : {&colors_, &depths_}) {
        gl.DeleteTextures(1, texture);
        *texture = 0;
    }
    width_ = height_ = 0;
}

void TranslucentTarget::makeTarget(int width, int height, GLenum depthFormat)
{
    const GladGLContext& gl = resources_.context.gl;
    release();
    gl.ActiveTexture(GL_TEXTURE0);
    const auto make = [&](GLenum format) {
        const ScopedUploadState upload(gl, resources_.context.core);
        GLuint texture = 0;
        gl.GenTextures(1, &texture);
        gl.BindTexture(GL_TEXTURE_2D, texture);
        makeTexture(gl, format, width, height);
        return texture;
    };
    colors_ = make(GL_RGBA32F);
    depths_ = make(depthFormat);
    for (GLuint* const framebuffer : {&withoutDepths_, &withDepths_}) {
        gl.GenFramebuffers(1, framebuffer);
        gl.BindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colors_, 0);
    }
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_, 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("the driver has no framebuffer of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " floats");
    width_ = width;
    height_ = height;
    depthFormat_ = depthFormat;
}

/// Of the caller's framebuffer.
bool TranslucentTarget::copyDepths() const
{
    const GladGLContext& gl = resources_.context.gl;
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(caller_->draw));
    const bool multisampled = isMultisampled(gl);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(caller_->draw));
    if (multisampled) {
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, withDepths_);
        gl.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    } else {
        const ScopedUploadState upload(gl, resources_.context.core);
        bindDepths(0);
        gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width_, height_);
    }
    return gl.GetError() == GL_NO_ERROR;
}

bool TranslucentTarget::begin(int width, int height)
{
    const GladGLContext& gl = resources_.context.gl;
    Caller& caller = caller_.emplace();
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &caller.draw);
    gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &caller.read);
    gl.GetBooleanv(GL_COLOR_WRITEMASK, caller.mask);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const DepthBits bits = depthBitsOf(gl);
    const GLenum format = depthFormatOf(bits, isMultisampled(gl));
    forgetErrors(gl);
    if (width != width_ || height != height_ || format != depthFormat_) makeTarget(width, height, format);
    const bool known = bits.depth != 0 && copyDepths();
    forgetErrors(gl);
    bindWithDepths();
    constexpr float kClear[4] = {}, kFarthest = 1.0f;
    gl.ClearBufferfv(GL_COLOR, 0, kClear);
    gl.DepthMask(GL_TRUE);
    if (!known) gl.ClearBufferfv(GL_DEPTH, 0, &kFarthest);
    gl.DepthMask(GL_FALSE);
    return known;
}

void TranslucentTarget::bindWithDepths() const
{
    resources_.context.gl.BindFramebuffer(GL_FRAMEBUFFER, withDepths_);
}

void TranslucentTarget::bindWithoutDepths() const
{
    resources_.context.gl.BindFramebuffer(GL_FRAMEBUFFER, withoutDepths_);
}

void TranslucentTarget::bindDepths(int unit) const
{
    resources_.context.gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    resources_.context.gl.BindTexture(GL_TEXTURE_2D, depths_);
}

void TranslucentTarget::end()
{
    if (!caller_) return;
    const GladGLContext& gl = resources_.context.gl;
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(caller_->draw));
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(caller_->read));
    gl.ColorMask(caller_->mask[0], caller_->mask[1], caller_->mask[2], caller_->mask[3]);
    caller_.reset();
}

void TranslucentTarget::show()
{
    const GladGLContext& gl = resources_.context.gl;
    end();
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, colors_);
    triangle_.bind();
    blendTexture(resources_.context, resources_.programs);
}

} // namespace vo
