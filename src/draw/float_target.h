#pragma once

#include "draw/context_record.h"

namespace vo {

/// A framebuffer of 32-bit floats with 24 bits of depth and 8 of stencil, in one context. All functions need
/// that context current; the bindings they change are given back.
class FloatTarget
{
public:
    /// width x height pixels, both within the context's limits. Throws std::bad_alloc when the driver
    /// refuses.
    FloatTarget(ContextRecord& context, int width, int height);
    ~FloatTarget();
    FloatTarget(const FloatTarget&) = delete;
    FloatTarget& operator=(const FloatTarget&) = delete;

    /// Pixels that a side may have at most.
    static int largestSize(const ContextRecord& context);

    void begin();
    void end();
    void show(int x, int y) const;
    void readPixels(float* rgba) const;
    int width() const { return width_; }
    int height() const { return height_; }

private:
    ContextRecord& context_;
    int width_;
    int height_;
    GLuint framebuffer_ = 0;
    GLuint color_ = 0;
    GLuint depthStencil_ = 0;
    bool active_ = false;
    GLint savedDraw_ = 0;
    GLint savedRead_ = 0;
    GLint savedViewport_[4] = {};
};

} // namespace vo
