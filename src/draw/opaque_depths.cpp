#include "draw/opaque_depths.h"

#include "draw/draw_surfaces.h"
#include "draw/scoped_state.h"

#include <stdexcept>
#include <string>

namespace vo {

namespace {

constexpr float kNothing = 1e30f;

/// What of the caller's state clearing and drawing into another framebuffer heeds, and what they change.
class ScopedTarget
{
public:
    explicit ScopedTarget(const GladGLContext& gl) : gl_(gl)
    {
        gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
        gl_.GetIntegerv(GL_RENDERBUFFER_BINDING, &renderbuffer_);
        gl_.GetBooleanv(GL_COLOR_WRITEMASK, mask_);
        scissor_ = gl_.IsEnabled(GL_SCISSOR_TEST);
        stencil_ = gl_.IsEnabled(GL_STENCIL_TEST);
        gl_.Disable(GL_SCISSOR_TEST);
        gl_.Disable(GL_STENCIL_TEST);
        gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    ~ScopedTarget()
    {
        if (scissor_) gl_.Enable(GL_SCISSOR_TEST);
        if (stencil_) gl_.Enable(GL_STENCIL_TEST);
        gl_.ColorMask(mask_[0], mask_[1], mask_[2], mask_[3]);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbuffer_));
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }
    ScopedTarget(const ScopedTarget&) = delete;
    ScopedTarget& operator=(const ScopedTarget&) = delete;

private:
    const GladGLContext& gl_;
    GLint draw_ = 0, read_ = 0, renderbuffer_ = 0;
    GLboolean mask_[4]{}, scissor_ = GL_FALSE, stencil_ = GL_FALSE;
};

} // namespace

OpaqueDepths::~OpaqueDepths()
{
    if (resources_.context.isCurrent()) release();
}

void OpaqueDepths::release()
{
    const GladGLContext& gl = resources_.context.gl;
    gl.DeleteFramebuffers(1, &framebuffer_);
    gl.DeleteTextures(1, &texture_);
    gl.DeleteRenderbuffers(1, &depthBuffer_);
    framebuffer_ = texture_ = depthBuffer_ = 0;
    width_ = height_ = 0;
}

void OpaqueDepths::bind(int unit) const
{
    resources_.context.gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    resources_.context.gl.BindTexture(GL_TEXTURE_2D, texture_);
}

void OpaqueDepths::makeTarget(int width, int height)
{
    const GladGLContext& gl = resources_.context.gl;
    release();
    gl.GenFramebuffers(1, &framebuffer_);
    gl.GenTextures(1, &texture_);
    gl.GenRenderbuffers(1, &depthBuffer_);
    bind(0);
    const ScopedUploadState upload(gl, resources_.context.core);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depthBuffer_);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depthBuffer_);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("the driver has no framebuffer of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " floats");
    width_ = width;
    height_ = height;
}

void OpaqueDepths::draw(const StyledScene& scene, SceneArrays& arrays, DrawnStipples& stipples)
{
    const GladGLContext& gl = resources_.context.gl;
    const ScopedTarget scope(gl);
    if (width_ != scene.width || height_ != scene.height) makeTarget(scene.width, scene.height);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.Viewport(0, 0, scene.width, scene.height);
    gl.DepthMask(GL_TRUE);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_BLEND);
    constexpr float kFarthest[4] = {kNothing, kNothing, kNothing, kNothing}, kDepth = 1.0f;
    gl.ClearBufferfv(GL_COLOR, 0, kFarthest);
    gl.ClearBufferfv(GL_DEPTH, 0, &kDepth);
    drawOpaqueSurfaces(scene, resources_, arrays, SurfaceLook::depth);
    stipples.draw(scene, SurfaceLook::depth);
}

} // namespace vo
