#pragma once

#include "cast/cast_depth.h"

#include <glad/gl.h>

#include <vector>

namespace vo {

/// Whether the framebuffer that is bound for drawing has depths.
bool hasDepthBuffer(const GladGLContext& gl);

/// The window depths of a viewport in it, rows from the bottom; 1 outside of the framebuffer. Of pixels with
/// several samples one of them counts. Throws std::runtime_error where the driver does not give them.
void readDepths(const GladGLContext& gl, bool core, const GLint viewport[4], std::vector<float>& depths);

/// Those of width x height pixels from the lower left corner, with the depth range, for GL_LESS; empty
/// without a depth buffer. They lie in `room`.
CastDepth depthsThere(const GladGLContext& gl, bool core, int width, int height, std::vector<float>& room);

} // namespace vo
