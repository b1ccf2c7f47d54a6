#include "draw/link_program.h"

#include <stdexcept>

namespace vo {

namespace {

GLuint compile(const GladGLContext& gl, GLenum stage, const std::string& source)
{
    const GLuint shader = gl.CreateShader(stage);
    const char* part = source.c_str();
    gl.ShaderSource(shader, 1, &part, nullptr);
    gl.CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char text[1024] = "";
        gl.GetShaderInfoLog(shader, sizeof text, nullptr, text);
        gl.DeleteShader(shader);
        throw std::runtime_error(std::string("the driver does not compile a shader of the library: ") + text);
    }
    return shader;
}

} // namespace

GLuint linkProgram(const GladGLContext& gl, const std::string& vertexText, const std::string& fragmentText)
{
    const GLuint vertex = compile(gl, GL_VERTEX_SHADER, vertexText);
    GLuint fragment = 0;
    try {
        fragment = compile(gl, GL_FRAGMENT_SHADER, fragmentText);
    } catch (...) {
        gl.DeleteShader(vertex);
        throw;
    }
    const GLuint program = gl.CreateProgram();
    gl.AttachShader(program, vertex);
    gl.AttachShader(program, fragment);
    gl.LinkProgram(program);
    gl.DeleteShader(vertex);
    gl.DeleteShader(fragment);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    char text[1024] = "";
    gl.GetProgramInfoLog(program, sizeof text, nullptr, text);
    gl.DeleteProgram(program);
    throw std::runtime_error(std::string("the driver does not link a program of the library: ") + text);
}

} // namespace vo
