#include "draw/scene_resources.h"

#include <iterator>

namespace vo {

void filterNone(const GladGLContext& gl, GLenum target)
{
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

SceneArrays::SceneArrays(const SceneContext& context) : context_(context)
{
    context_.gl.GenVertexArrays(1, &array_);
    context_.gl.GenBuffers(1, &records_);
    context_.gl.GenBuffers(1, &indices_);
}

SceneArrays::~SceneArrays()
{
    if (!context_.isCurrent()) return;
    context_.gl.DeleteVertexArrays(1, &array_);
    context_.gl.DeleteBuffers(1, &records_);
    context_.gl.DeleteBuffers(1, &indices_);
}

void SceneArrays::send(const float* records, std::size_t floats)
{
    const GladGLContext& gl = context_.gl;
    gl.BindVertexArray(array_);
    for (GLuint location = 0; attributes_ >> location; ++location)
        if (attributes_ >> location & 1) gl.DisableVertexAttribArray(location);
    attributes_ = 0;
    gl.BindBuffer(GL_ARRAY_BUFFER, records_);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(floats * sizeof(float)), records, GL_STREAM_DRAW);
}

void SceneArrays::attribute(GLuint location, int count, int first, int stride)
{
    const GladGLContext& gl = context_.gl;
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, stride * static_cast<int>(sizeof(float)),
                           reinterpret_cast<const void*>(static_cast<std::size_t>(first) * sizeof(float)));
    attributes_ |= 1u << location;
}

void SceneArrays::sendPictureTriangle()
{
    constexpr float kCorners[] = {-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
    send(kCorners, std::size(kCorners));
    attribute(0, 2, 0, 2);
}

void SceneArrays::sendRectangle(const glm::dvec2& lower, const glm::dvec2& upper)
{
    const glm::vec2 corners[] = {glm::vec2(lower), {upper.x, lower.y}, {lower.x, upper.y}, glm::vec2(upper)};
    send(&corners[0].x, 2 * std::size(corners));
    attribute(0, 2, 0, 2);
}

void SceneArrays::sendIndices(const std::uint32_t* indices, std::size_t count)
{
    const GladGLContext& gl = context_.gl;
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(std::uint32_t)), indices,
                  GL_STREAM_DRAW);
}

} // namespace vo
