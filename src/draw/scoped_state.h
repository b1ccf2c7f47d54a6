#pragma once

#include "draw/context_record.h"

#include <array>

namespace vo {

/// The caller's state that uploads touch, given back at the end of the scope: pixel store, pixel-unpack
/// buffer, and, in compatibility contexts, pixel transfer, which would change voxels on their way.
class ScopedUploadState
{
public:
    explicit ScopedUploadState(const GladGLContext& gl, bool core);
    ~ScopedUploadState();
    ScopedUploadState(const ScopedUploadState&) = delete;
    ScopedUploadState& operator=(const ScopedUploadState&) = delete;

private:
    const GladGLContext& gl_;
    bool core_;
    GLint store_[8];
    GLint buffer_ = 0;
};

/// The same for reading pixels back.
class ScopedReadState
{
public:
    explicit ScopedReadState(const GladGLContext& gl, bool core);
    ~ScopedReadState();
    ScopedReadState(const ScopedReadState&) = delete;
    ScopedReadState& operator=(const ScopedReadState&) = delete;

private:
    const GladGLContext& gl_;
    bool core_;
    GLint store_[8];
    GLint buffer_ = 0;
};

/// The caller's framebuffer for reading, bound again at the end of the scope.
class ScopedReadFramebuffer
{
public:
    explicit ScopedReadFramebuffer(const GladGLContext& gl) : gl_(gl)
    {
        gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound_);
    }
    ~ScopedReadFramebuffer() { gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound_)); }
    ScopedReadFramebuffer(const ScopedReadFramebuffer&) = delete;
    ScopedReadFramebuffer& operator=(const ScopedReadFramebuffer&) = delete;

private:
    const GladGLContext& gl_;
    GLint bound_ = 0;
};

/// The caller's state that draws touch: program, vertex array, array buffer, active texture unit, the texture
/// of the unit that carries the table, and the samplers of both units.
class ScopedDrawState
{
public:
    /// `voxelUnit` and `tableUnit` are numbers from 0.
    ScopedDrawState(const GladGLContext& gl, int voxelUnit, int tableUnit);
    ~ScopedDrawState();
    ScopedDrawState(const ScopedDrawState&) = delete;
    ScopedDrawState& operator=(const ScopedDrawState&) = delete;

private:
    const GladGLContext& gl_;
    int voxelUnit_;
    int tableUnit_;
    GLint program_ = 0;
    GLint vertexArray_ = 0;
    GLint arrayBuffer_ = 0;
    GLint activeTexture_ = 0;
    GLint tableTexture_ = 0;
    GLint voxelSampler_ = 0;
    GLint tableSampler_ = 0;
};

/// The textures that the active unit has bound, given back at the end of the scope.
class ScopedTextureBindings
{
public:
    explicit ScopedTextureBindings(const GladGLContext& gl);
    ~ScopedTextureBindings();
    ScopedTextureBindings(const ScopedTextureBindings&) = delete;
    ScopedTextureBindings& operator=(const ScopedTextureBindings&) = delete;

private:
    const GladGLContext& gl_;
    GLint bound3d_ = 0;
    GLint bound2d_ = 0;
};

/// Without the caller's clip planes, while the scope lasts.
class ScopedUnclipped
{
public:
    explicit ScopedUnclipped(const GladGLContext& gl);
    ~ScopedUnclipped();
    ScopedUnclipped(const ScopedUnclipped&) = delete;
    ScopedUnclipped& operator=(const ScopedUnclipped&) = delete;

private:
    const GladGLContext& gl_;
    std::array<GLboolean, 8> clipped_{};
};

/// Another polygon mode for front and back, while the scope lasts.
class ScopedPolygonMode
{
public:
    ScopedPolygonMode(const ContextRecord& context, GLenum mode);
    ~ScopedPolygonMode();
    ScopedPolygonMode(const ScopedPolygonMode&) = delete;
    ScopedPolygonMode& operator=(const ScopedPolygonMode&) = delete;

private:
    const ContextRecord& context_;
    GLint saved_[2];
};

} // namespace vo
