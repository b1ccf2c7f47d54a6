#pragma once

#include "draw/scene_context.h"
#include "draw/scene_programs.h"
#include "draw/style_textures.h"

#include <glm/vec2.hpp>

namespace vo {

/// What stays in the context from picture to picture.
struct SceneResources
{
    SceneContext context;
    ScenePrograms programs{context};
    StyleTextures textures{context};
};

/// Of the texture that is bound: it has one level, and no filter reaches from texel to texel.
void filterNone(const GladGLContext& gl, GLenum target);

/// A vertex array with its buffers, deleted with it.
class SceneArrays
{
public:
    explicit SceneArrays(const SceneContext& context);
    ~SceneArrays();
    SceneArrays(const SceneArrays&) = delete;
    SceneArrays& operator=(const SceneArrays&) = delete;

    void bind() const { context_.gl.BindVertexArray(array_); }
    /// Binds it, and sends records of floats; the attributes of earlier ones are switched off.
    void send(const float* records, std::size_t floats);
    /// The floats from `first` on in records of `stride` become an attribute.
    void attribute(GLuint location, int count, int first, int stride);
    /// A triangle that covers the picture, two floats a corner: attribute 0.
    void sendPictureTriangle();
    /// Corners of a part of the picture, in device coordinates, for a strip of two triangles: attribute 0.
    void sendRectangle(const glm::dvec2& lower, const glm::dvec2& upper);
    void sendIndices(const std::uint32_t* indices, std::size_t count);

private:
    const SceneContext& context_;
    GLuint array_ = 0, records_ = 0, indices_ = 0;
    GLuint attributes_ = 0; ///< a bit each
};

} // namespace vo
