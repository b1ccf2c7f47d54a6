#pragma once

#include "gl.h"

namespace vo {

/// A framebuffer of 32-bit floats with depth, of any size, that is shown over the whole of another. All
/// functions need the context that it was made in.
class ScaledTarget
{
public:
    explicit ScaledTarget(const GladGLContext& context) : gl_(context) {}
    ~ScaledTarget();
    ScaledTarget(const ScaledTarget&) = delete;
    ScaledTarget& operator=(const ScaledTarget&) = delete;

    /// Drawing goes here, onto opaque black, until show().
    void begin(int width, int height);
    /// Spreads the picture over width x height pixels of framebuffer 0, which is bound then.
    void show(int width, int height) const;

private:
    const GladGLContext& gl_;
    int width_ = 0, height_ = 0;
    GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
};

} // namespace vo
