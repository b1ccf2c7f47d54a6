#pragma once

#include "draw/scene_context.h"

#include <array>
#include <vector>

namespace vo {

/// The caller's state that drawing a scene touches, given back at the end of the scope; until then it is what
/// OpenGL begins with. Framebuffer, scissor, stencil, colour mask and depth range stay the caller's.
class ScopedSceneState
{
public:
    explicit ScopedSceneState(const SceneContext& context);
    ~ScopedSceneState();
    ScopedSceneState(const ScopedSceneState&) = delete;
    ScopedSceneState& operator=(const ScopedSceneState&) = delete;

private:
    struct Unit
    {
        GLint texture3d = 0, texture2d = 0, texture2dArray = 0, sampler = 0;
    };
    struct Capability
    {
        GLenum name;
        GLboolean on;
    };

    void saveUnits();
    void saveBlending();
    void saveRasterizing();
    void restoreUnits() const;
    void restoreBlending() const;
    void restoreRasterizing() const;

    const SceneContext& context_;
    const GladGLContext& gl_;
    std::vector<Capability> capabilities_;
    std::vector<Unit> units_;
    GLint activeTexture_ = GL_TEXTURE0;
    GLint program_ = 0, vertexArray_ = 0, arrayBuffer_ = 0;
    std::array<GLint, 4> blendFactors_{}; ///< source and destination of colour, of alpha
    std::array<GLint, 2> blendEquations_{};
    GLint depthFunction_ = GL_LESS, frontFace_ = GL_CCW;
    GLboolean depthMask_ = GL_TRUE;
    std::array<GLint, 2> polygonModes_{GL_FILL, GL_FILL};
    std::array<GLint, 4> viewport_{};
    GLfloat pointSize_ = 1.0f;
};

} // namespace vo
