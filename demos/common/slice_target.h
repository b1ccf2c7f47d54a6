#pragma once

#include "gl.h"

#include <vo/Volumizer.h>

namespace vo {

/// A picture off the screen, in which a slice is put together before it goes into the frame. Its numbers are
/// of fixed point, 16 bits each: they stay between 0 and 1, whatever is added or subtracted. All functions
/// need the context that it was made in.
class SliceTarget
{
public:
    /// As large as the frame.
    SliceTarget(int width, int height);
    ~SliceTarget();
    SliceTarget(const SliceTarget&) = delete;
    SliceTarget& operator=(const SliceTarget&) = delete;

    int getWidth() const { return width_; }
    int getHeight() const { return height_; }

    /// Drawing goes here, onto transparent black, until end().
    void begin();
    void end();
    /// Draws the picture over the whole frame, at a depth from -1 (the near plane) to 1, with the blending
    /// and depth test that are set. Needs 3D textures, texture coordinates from positions and tables
    /// switched off. The colour becomes white.
    void draw(double depth);

private:
    void bind();

    int width_, height_;
    GLuint texture_ = 0, framebuffer_ = 0;
    GLint drawnBefore_ = 0, readBefore_ = 0;
    voIndexedFaceSet square_;
};

} // namespace vo
