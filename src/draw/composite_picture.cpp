#include "draw/composite_picture.h"

#include "draw/programs.h"
#include "draw/scoped_state.h"

#include <cstddef>

namespace vo {

namespace {

constexpr const char* kVertexShader = R"(#version 330 core
uniform vec4 rectangle; // left, bottom, right, top in normalised device coordinates
void main()
{
    gl_Position = vec4(rectangle[(gl_VertexID & 1) * 2], rectangle[(gl_VertexID & 2) + 1], 0.0, 1.0);
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
uniform sampler2D picture;
uniform sampler2D alphas;
uniform ivec2 corner;
uniform int alphaFrom; // 0: the picture; 1: alphas; 2: what the picture hides; 3: nothing is added
layout(location = 0, index = 0) out vec4 front;
layout(location = 0, index = 1) out vec4 behind;
void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - corner;
    vec4 seen = texelFetch(picture, pixel, 0);
    front = seen;
    behind = vec4(1.0);
    if (alphaFrom == 0) return;
    behind = vec4(seen.aaa, alphaFrom == 3 ? 1.0 : seen.a);
    front.a = alphaFrom == 1 ? texelFetch(alphas, pixel, 0).r : alphaFrom == 2 ? 1.0 - seen.a : 0.0;
}
)";

const PictureProgram& pictureProgram(ContextRecord& context)
{
    PictureProgram& program = context.pictureProgram;
    if (program.name != 0) return program;
    const GladGLContext& gl = context.gl;
    program.name = linkProgram(gl, kVertexShader, kFragmentShader);
    program.rectangle = gl.GetUniformLocation(program.name, "rectangle");
    program.picture = gl.GetUniformLocation(program.name, "picture");
    program.alphas = gl.GetUniformLocation(program.name, "alphas");
    program.corner = gl.GetUniformLocation(program.name, "corner");
    program.alphaFrom = gl.GetUniformLocation(program.name, "alphaFrom");
    return program;
}

/// Sends pixels into a texture of the context's own, which is as large as the last picture was.
void sendPixels(const GladGLContext& gl, PictureTexture& texture, GLint internalFormat, GLenum format,
                const CastPicture& picture, const float* pixels)
{
    if (texture.name == 0) gl.GenTextures(1, &texture.name);
    gl.BindTexture(GL_TEXTURE_2D, texture.name);
    if (texture.width == picture.width && texture.height == picture.height) {
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, picture.width, picture.height, format, GL_FLOAT, pixels);
        return;
    }
    gl.TexImage2D(GL_TEXTURE_2D, 0, internalFormat, picture.width, picture.height, 0, format, GL_FLOAT,
                  pixels);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    texture.width = picture.width;
    texture.height = picture.height;
}

/// The caller's state that stands in the way of a picture which has been tested and clipped already, and the
/// texture of the unit that is active at the scope's begin.
class ScopedPictureState
{
public:
    explicit ScopedPictureState(const GladGLContext& gl)
        : gl_(gl), clipping_(gl), depthTest_(gl.IsEnabled(GL_DEPTH_TEST))
    {
        gl.GetIntegerv(GL_ACTIVE_TEXTURE, &unit_);
        gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture_);
        if (depthTest_) gl.Disable(GL_DEPTH_TEST);
    }
    ~ScopedPictureState()
    {
        gl_.ActiveTexture(static_cast<GLenum>(unit_));
        gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture_));
        if (depthTest_) gl_.Enable(GL_DEPTH_TEST);
    }
    ScopedPictureState(const ScopedPictureState&) = delete;
    ScopedPictureState& operator=(const ScopedPictureState&) = delete;

private:
    const GladGLContext& gl_;
    ScopedUnclipped clipping_;
    GLboolean depthTest_;
    GLint unit_ = 0;
    GLint texture_ = 0;
};

void setUniforms(const GladGLContext& gl, const PictureProgram& program, const DrawState& draw,
                 const CompositingState& state, const CastPicture& picture)
{
    const auto inDevice = [](int pixel, int size) {
        return static_cast<float>(2.0 * pixel / static_cast<double>(size) - 1.0);
    };
    gl.Uniform4f(program.rectangle, inDevice(picture.x, state.viewport[2]),
                 inDevice(picture.y, state.viewport[3]),
                 inDevice(picture.x + picture.width, state.viewport[2]),
                 inDevice(picture.y + picture.height, state.viewport[3]));
    gl.Uniform2i(program.corner, state.viewport[0] + picture.x, state.viewport[1] + picture.y);
    gl.Uniform1i(program.picture, draw.voxelUnit);
    gl.Uniform1i(program.alphas, draw.tableUnit);
    gl.Uniform1i(program.alphaFrom, alphaSource(state.blending));
}

} // namespace

void compositePicture(ContextRecord& context, const DrawState& draw, const CompositingState& state,
                      const CastPicture& picture)
{
    if (picture.width <= 0 || picture.height <= 0) return;
    const GladGLContext& gl = context.gl;
    const ScopedTextureBindings bindings(gl);
    const ScopedDrawState drawScope(gl, draw.voxelUnit, draw.tableUnit);
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(draw.tableUnit));
    const ScopedPictureState scope(gl);
    {
        const ScopedUploadState uploadScope(gl, context.core);
        if (alphaSource(state.blending) == 1)
            sendPixels(gl, context.pictureAlpha, GL_R32F, GL_RED, picture, picture.alpha.data());
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(draw.voxelUnit));
        sendPixels(gl, context.pictureColor, GL_RGBA32F, GL_RGBA, picture, picture.rgbt.data());
    }
    const PictureProgram& program = pictureProgram(context);
    gl.UseProgram(program.name);
    setUniforms(gl, program, draw, state, picture);
    if (context.pictureVertexArray == 0) gl.GenVertexArrays(1, &context.pictureVertexArray);
    gl.BindVertexArray(context.pictureVertexArray);
    const ScopedJoinedBlending blending(gl, state.blending);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

} // namespace vo
