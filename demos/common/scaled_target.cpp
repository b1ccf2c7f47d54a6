#include "scaled_target.h"

namespace vo {

ScaledTarget::~ScaledTarget()
{
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteRenderbuffers(1, &color_);
    gl_.DeleteRenderbuffers(1, &depth_);
}

void ScaledTarget::begin(int width, int height)
{
    if (framebuffer_ == 0) {
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.GenRenderbuffers(1, &color_);
        gl_.GenRenderbuffers(1, &depth_);
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (width != width_ || height != height_) {
        gl_.BindRenderbuffer(GL_RENDERBUFFER, color_);
        gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
        gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
        width_ = width;
        height_ = height;
    }
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void ScaledTarget::show(int width, int height) const
{
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                        width == width_ && height == height_ ? GL_NEAREST : GL_LINEAR);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

} // namespace vo
