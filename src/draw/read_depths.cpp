#include "draw/read_depths.h"

#include "draw/depth_format.h"
#include "draw/scoped_state.h"

#include <cstddef>
#include <stdexcept>

namespace vo {

namespace {

GLint integer(const GladGLContext& gl, GLenum name)
{
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

/// The framebuffer that is bound for drawing with one sample a pixel, bound for reading: pixels with several
/// cannot be read.
class OneSampleDepths
{
public:
    OneSampleDepths(const GladGLContext& gl, const GLint viewport[4])
        : gl_(gl), drawn_(integer(gl, GL_DRAW_FRAMEBUFFER_BINDING)),
          bound_(integer(gl, GL_RENDERBUFFER_BINDING)), scissor_(gl.IsEnabled(GL_SCISSOR_TEST))
    {
        const GLenum format = depthFormatOf(depthBitsOf(gl), true);
        gl.GenFramebuffers(1, &framebuffer_);
        gl.GenRenderbuffers(1, &depths_);
        gl.BindRenderbuffer(GL_RENDERBUFFER, depths_);
        gl.RenderbufferStorage(GL_RENDERBUFFER, format, viewport[2], viewport[3]);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
        gl.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER,
                                   hasStencil(format) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                                   GL_RENDERBUFFER, depths_);
        gl.Disable(GL_SCISSOR_TEST);
        gl.BlitFramebuffer(viewport[0], viewport[1], viewport[0] + viewport[2], viewport[1] + viewport[3], 0,
                           0, viewport[2], viewport[3], GL_DEPTH_BUFFER_BIT, GL_NEAREST);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn_));
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
        if (scissor_) gl.Enable(GL_SCISSOR_TEST);
    }
    ~OneSampleDepths()
    {
        gl_.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound_));
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteRenderbuffers(1, &depths_);
    }
    OneSampleDepths(const OneSampleDepths&) = delete;
    OneSampleDepths& operator=(const OneSampleDepths&) = delete;

private:
    const GladGLContext& gl_;
    GLint drawn_, bound_;
    GLboolean scissor_;
    GLuint framebuffer_ = 0, depths_ = 0;
};

void readRectangle(const GladGLContext& gl, const GLint rectangle[4], std::vector<float>& depths)
{
    while (gl.GetError() != GL_NO_ERROR) {
    }
    gl.ReadPixels(rectangle[0], rectangle[1], rectangle[2], rectangle[3], GL_DEPTH_COMPONENT, GL_FLOAT,
                  depths.data());
    if (gl.GetError() != GL_NO_ERROR)
        throw std::runtime_error("the driver does not give the depths of the framebuffer");
}

} // namespace

bool hasDepthBuffer(const GladGLContext& gl)
{
    return depthBitsOf(gl).depth > 0;
}

void readDepths(const GladGLContext& gl, bool core, const GLint viewport[4], std::vector<float>& depths)
{
    // What lies outside the framebuffer is not read, and not drawn either.
    depths.assign(static_cast<std::size_t>(viewport[2]) * static_cast<std::size_t>(viewport[3]), 1.0f);
    const ScopedReadState scope(gl, core);
    const GLint drawn = integer(gl, GL_DRAW_FRAMEBUFFER_BINDING);
    const ScopedReadFramebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawn));
    if (drawn == 0 || integer(gl, GL_SAMPLE_BUFFERS) == 0) {
        readRectangle(gl, viewport, depths);
        return;
    }
    const GLint whole[4] = {0, 0, viewport[2], viewport[3]};
    const OneSampleDepths copy(gl, viewport);
    readRectangle(gl, whole, depths);
}

CastDepth depthsThere(const GladGLContext& gl, bool core, int width, int height, std::vector<float>& room)
{
    if (!hasDepthBuffer(gl)) return {};
    const GLint rectangle[4] = {0, 0, width, height};
    readDepths(gl, core, rectangle, room);
    GLdouble range[2];
    gl.GetDoublev(GL_DEPTH_RANGE, range);
    CastDepth there;
    there.depths = room;
    there.nearDepth = range[0];
    there.farDepth = range[1];
    return there;
}

} // namespace vo
