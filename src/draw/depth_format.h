#pragma once

#include <glad/gl.h>

namespace vo {

/// Of the depths in the framebuffer that is bound for drawing.
struct DepthBits
{
    GLint depth = 0, stencil = 0; ///< none: 0
    bool isFloat = false;
};

DepthBits depthBitsOf(const GladGLContext& gl);

/// The format of equal depths: what is drawn beside them lies at the same ones. Depths of several samples a
/// pixel become those of one only where all bits are alike, those of the stencil too.
GLenum depthFormatOf(const DepthBits& bits, bool withStencil);

/// Whether depthFormatOf() said one with a stencil.
bool hasStencil(GLenum depthFormat);

} // namespace vo
