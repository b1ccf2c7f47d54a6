#pragma once

#include <glad/gl.h>

#include <string>

namespace vo {

/// A program of two shaders, whole texts with their #version. Throws std::runtime_error with the driver's
/// words.
GLuint linkProgram(const GladGLContext& gl, const std::string& vertexText, const std::string& fragmentText);

} // namespace vo
