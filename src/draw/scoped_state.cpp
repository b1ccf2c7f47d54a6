#include "draw/scoped_state.h"

namespace vo {

namespace {

constexpr int kStoreCount = 8;
constexpr GLenum kUnpackNames[kStoreCount] = {
    GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST,   GL_UNPACK_ROW_LENGTH,  GL_UNPACK_IMAGE_HEIGHT,
    GL_UNPACK_SKIP_ROWS,  GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_ALIGNMENT};
constexpr GLenum kPackNames[kStoreCount] = {GL_PACK_SWAP_BYTES,   GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH,
                                            GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                                            GL_PACK_SKIP_IMAGES,  GL_PACK_ALIGNMENT};
constexpr GLint kPlainStore[kStoreCount] = {0, 0, 0, 0, 0, 0, 0, 1};

void replaceStore(const GladGLContext& gl, const GLenum* names, GLint* saved)
{
    for (int i = 0; i < kStoreCount; ++i) {
        gl.GetIntegerv(names[i], &saved[i]);
        gl.PixelStorei(names[i], kPlainStore[i]);
    }
}

void restoreStore(const GladGLContext& gl, const GLenum* names, const GLint* saved)
{
    for (int i = 0; i < kStoreCount; ++i)
        gl.PixelStorei(names[i], saved[i]);
}

/// Saves pixel transfer on the attribute stack of a compatibility context and makes it change nothing.
void replaceTransfer(const GladGLContext& gl)
{
    gl.PushAttrib(GL_PIXEL_MODE_BIT);
    for (const GLenum scale : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE})
        gl.PixelTransferf(scale, 1.0f);
    for (const GLenum bias : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS})
        gl.PixelTransferf(bias, 0.0f);
    gl.PixelTransferf(GL_DEPTH_SCALE, 1.0f);
    gl.PixelTransferf(GL_DEPTH_BIAS, 0.0f);
    gl.PixelTransferi(GL_MAP_COLOR, GL_FALSE);
}

} // namespace

ScopedUploadState::ScopedUploadState(const GladGLContext& gl, bool core) : gl_(gl), core_(core)
{
    replaceStore(gl_, kUnpackNames, store_);
    gl_.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &buffer_);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    if (!core_) replaceTransfer(gl_);
}

ScopedUploadState::~ScopedUploadState()
{
    if (!core_) gl_.PopAttrib();
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(buffer_));
    restoreStore(gl_, kUnpackNames, store_);
}

ScopedReadState::ScopedReadState(const GladGLContext& gl, bool core) : gl_(gl), core_(core)
{
    replaceStore(gl_, kPackNames, store_);
    gl_.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer_);
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    if (!core_) replaceTransfer(gl_);
}

ScopedReadState::~ScopedReadState()
{
    if (!core_) gl_.PopAttrib();
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(buffer_));
    restoreStore(gl_, kPackNames, store_);
}

ScopedDrawState::ScopedDrawState(const GladGLContext& gl, int voxelUnit, int tableUnit)
    : gl_(gl), voxelUnit_(voxelUnit), tableUnit_(tableUnit)
{
    gl_.GetIntegerv(GL_CURRENT_PROGRAM, &program_);
    gl_.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
    gl_.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &arrayBuffer_);
    gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &activeTexture_);
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(voxelUnit_));
    gl_.GetIntegerv(GL_SAMPLER_BINDING, &voxelSampler_);
    gl_.BindSampler(static_cast<GLuint>(voxelUnit_), 0);
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(tableUnit_));
    gl_.GetIntegerv(GL_TEXTURE_BINDING_1D, &tableTexture_);
    gl_.GetIntegerv(GL_SAMPLER_BINDING, &tableSampler_);
    gl_.BindSampler(static_cast<GLuint>(tableUnit_), 0);
}

ScopedDrawState::~ScopedDrawState()
{
    gl_.BindSampler(static_cast<GLuint>(tableUnit_), static_cast<GLuint>(tableSampler_));
    gl_.BindSampler(static_cast<GLuint>(voxelUnit_), static_cast<GLuint>(voxelSampler_));
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(tableUnit_));
    gl_.BindTexture(GL_TEXTURE_1D, static_cast<GLuint>(tableTexture_));
    gl_.ActiveTexture(static_cast<GLenum>(activeTexture_));
    gl_.BindVertexArray(static_cast<GLuint>(vertexArray_));
    gl_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(arrayBuffer_));
    gl_.UseProgram(static_cast<GLuint>(program_));
}

ScopedTextureBindings::ScopedTextureBindings(const GladGLContext& gl) : gl_(gl)
{
    gl_.GetIntegerv(GL_TEXTURE_BINDING_3D, &bound3d_);
    gl_.GetIntegerv(GL_TEXTURE_BINDING_2D, &bound2d_);
}

ScopedTextureBindings::~ScopedTextureBindings()
{
    gl_.BindTexture(GL_TEXTURE_3D, static_cast<GLuint>(bound3d_));
    gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound2d_));
}

ScopedUnclipped::ScopedUnclipped(const GladGLContext& gl) : gl_(gl)
{
    for (GLenum i = 0; i < clipped_.size(); ++i) {
        clipped_[i] = gl_.IsEnabled(GL_CLIP_DISTANCE0 + i);
        if (clipped_[i]) gl_.Disable(GL_CLIP_DISTANCE0 + i);
    }
}

ScopedUnclipped::~ScopedUnclipped()
{
    for (GLenum i = 0; i < clipped_.size(); ++i)
        if (clipped_[i]) gl_.Enable(GL_CLIP_DISTANCE0 + i);
}

ScopedPolygonMode::ScopedPolygonMode(const ContextRecord& context, GLenum mode)
    : context_(context), saved_{GL_FILL, GL_FILL}
{
    context_.gl.GetIntegerv(GL_POLYGON_MODE, saved_);
    context_.gl.PolygonMode(GL_FRONT_AND_BACK, mode);
}

ScopedPolygonMode::~ScopedPolygonMode()
{
    const auto front = static_cast<GLenum>(saved_[0]), back = static_cast<GLenum>(saved_[1]);
    if (context_.core || front == back) {
        context_.gl.PolygonMode(GL_FRONT_AND_BACK, front);
        return;
    }
    context_.gl.PolygonMode(GL_FRONT, front);
    context_.gl.PolygonMode(GL_BACK, back);
}

} // namespace vo
