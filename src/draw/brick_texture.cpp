#include "draw/brick_texture.h"

#include "appearance/convert_voxels.h"
#include "draw/scoped_state.h"
#include "lookup/table.h"

#include <algorithm>
#include <vector>

namespace vo {

namespace {

/// How a texture lies in OpenGL, and how its texels are sent.
struct Storage
{
    GLint internalFormat = 0;
    GLenum format = 0; ///< of the texels sent
    GLenum type = 0;
    Channels channels = Channels::luminance; ///< of the texels sent
    GLint swizzle[4] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
};

enum class Precision { bits8, bits16, float32 };

Precision precisionFor(VoxelType type, const DriverQuirks& quirks)
{
    switch (type) {
    case VoxelType::uint8:
    case VoxelType::int8:
    case VoxelType::uint8_332:
    case VoxelType::uint16_4444:
    case VoxelType::uint16_5551:
    case VoxelType::uint32_8888:
        return quirks.filters8BitTexturesCoarsely ? Precision::bits16 : Precision::bits8;
    case VoxelType::uint16:
    case VoxelType::int16:
    case VoxelType::uint32_1010102: return Precision::bits16;
    case VoxelType::uint32:
    case VoxelType::int32:
    case VoxelType::float32: return Precision::float32;
    }
    return Precision::float32;
}

GLint pick(Precision precision, GLint bits8, GLint bits16, GLint float32)
{
    return precision == Precision::bits8 ? bits8 : precision == Precision::bits16 ? bits16 : float32;
}

/// In a compatibility context the legacy formats, which fixed-function texturing of the caller understands;
/// in a core context one and two channels with a swizzle that answers the same.
Storage storageFor(TexelFormat texel, Precision precision, bool core)
{
    Storage s;
    s.type = precision == Precision::float32 ? GL_FLOAT : GL_UNSIGNED_SHORT;
    const auto swizzle = [&s](GLint r, GLint g, GLint b, GLint a) {
        s.swizzle[0] = r, s.swizzle[1] = g, s.swizzle[2] = b, s.swizzle[3] = a;
    };
    switch (texel) {
    case TexelFormat::intensity:
        s.format = GL_RED;
        s.internalFormat = core ? pick(precision, GL_R8, GL_R16, GL_R32F)
                                : pick(precision, GL_INTENSITY8, GL_INTENSITY16, GL_INTENSITY32F_ARB);
        if (core) swizzle(GL_RED, GL_RED, GL_RED, GL_RED);
        break;
    case TexelFormat::luminance:
        s.format = GL_RED;
        s.internalFormat = core ? pick(precision, GL_R8, GL_R16, GL_R32F)
                                : pick(precision, GL_LUMINANCE8, GL_LUMINANCE16, GL_LUMINANCE32F_ARB);
        if (core) swizzle(GL_RED, GL_RED, GL_RED, GL_ONE);
        break;
    case TexelFormat::luminanceAlpha:
        s.channels = Channels::luminanceAlpha;
        s.format = core ? GL_RG : GL_LUMINANCE_ALPHA;
        s.internalFormat =
            core ? pick(precision, GL_RG8, GL_RG16, GL_RG32F)
                 : pick(precision, GL_LUMINANCE8_ALPHA8, GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA32F_ARB);
        if (core) swizzle(GL_RED, GL_RED, GL_RED, GL_GREEN);
        break;
    case TexelFormat::rgba:
        s.channels = Channels::rgba;
        s.format = GL_RGBA;
        s.internalFormat = pick(precision, GL_RGBA8, GL_RGBA16, GL_RGBA32F);
        break;
    case TexelFormat::rgb:
        s.channels = Channels::rgba;
        s.format = GL_RGBA;
        s.internalFormat = pick(precision, GL_RGB8, GL_RGB16, GL_RGB32F);
        break;
    }
    return s;
}

/// The type with which OpenGL reads the voxels as they lie, 0 when they have to be converted here.
GLenum typeAsItLies(VoxelFormat format, Channels wanted)
{
    const bool oneChannel = channelCount(format.channels) == 1 && channelCount(wanted) == 1;
    if (!oneChannel && format.channels != wanted) return 0;
    switch (format.type) {
    case VoxelType::uint8: return GL_UNSIGNED_BYTE;
    case VoxelType::uint16: return GL_UNSIGNED_SHORT;
    case VoxelType::float32: return GL_FLOAT;
    case VoxelType::int8:
    case VoxelType::uint8_332:
    case VoxelType::int16:
    case VoxelType::uint16_4444:
    case VoxelType::uint16_5551:
    case VoxelType::uint32:
    case VoxelType::int32:
    case VoxelType::uint32_8888:
    case VoxelType::uint32_1010102: break;
    }
    return 0;
}

/// The texture as OpenGL sees it: a two-dimensional one drops its axis of one voxel.
struct TexelGrid
{
    GLenum target = GL_TEXTURE_3D;
    GLsizei width = 1, height = 1, depth = 1;
};

TexelGrid texelGrid(const TextureImage& image)
{
    const VoxelSize& s = image.size;
    if (!image.twoDimensional) return {GL_TEXTURE_3D, s.x, s.y, s.z};
    if (s.z == 1) return {GL_TEXTURE_2D, s.x, s.y, 1};
    if (s.y == 1) return {GL_TEXTURE_2D, s.x, s.z, 1};
    return {GL_TEXTURE_2D, s.y, s.z, 1};
}

void sendRows(const GladGLContext& gl, const TexelGrid& grid, int row, int rows, int slice, int slices,
              const Storage& storage, GLenum type, const void* texels)
{
    if (grid.target == GL_TEXTURE_2D)
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, row, grid.width, rows, storage.format, type, texels);
    else
        gl.TexSubImage3D(GL_TEXTURE_3D, 0, 0, row, slice, grid.width, rows, slices, storage.format, type,
                         texels);
}

/// Texels that OpenGL cannot read from the voxels directly: decoded, classified if a table is given, and sent
/// row by row, so that the memory needed stays small.
void sendConverted(const GladGLContext& gl, const TextureImage& image, const TexelGrid& grid,
                   const Storage& storage, const Table* table)
{
    const auto width = static_cast<std::size_t>(grid.width);
    const std::size_t bytes = voxelBytes(image.format);
    const VoxelFormat target{storage.channels,
                             storage.type == GL_FLOAT ? VoxelType::float32 : VoxelType::uint16};
    const int rowsAtOnce =
        static_cast<int>(std::clamp<std::size_t>(65536 / width, 1, static_cast<std::size_t>(grid.height)));
    std::vector<float> rgba(4 * width * static_cast<std::size_t>(rowsAtOnce));
    std::vector<std::byte> texels(voxelBytes(target) * width * static_cast<std::size_t>(rowsAtOnce));
    std::size_t voxel = 0;
    for (int slice = 0; slice < grid.depth; ++slice)
        for (int row = 0; row < grid.height; row += rowsAtOnce) {
            const int rows = std::min(rowsAtOnce, grid.height - row);
            const std::size_t count = width * static_cast<std::size_t>(rows);
            decodeVoxels(image.voxels.subspan(voxel * bytes, count * bytes), image.format, count,
                         rgba.data());
            if (table) applyTable(*table, rgba.data(), count);
            // OpenGL takes the first component for intensity and luminance, not a weighted sum.
            if (storage.channels != Channels::rgba)
                for (std::size_t i = 0; i < count; ++i)
                    rgba[4 * i + 1] = rgba[4 * i + 2] = rgba[4 * i];
            encodeVoxels(rgba.data(), count, target, texels);
            sendRows(gl, grid, row, rows, slice, 1, storage, storage.type, texels.data());
            voxel += count;
        }
}

TextureResult download(ContextRecord& context, const TextureImage& image, const TexelGrid& grid,
                       ResidentTexture& texture, const Table* table)
{
    const GladGLContext& gl = context.gl;
    const ScopedUploadState scope(gl, context.core);
    const Storage storage =
        table ? storageFor(TexelFormat::rgba, Precision::bits16, context.core)
              : storageFor(image.texel, precisionFor(image.format.type, context.quirks), context.core);
    while (gl.GetError() != GL_NO_ERROR) {
    }
    if (grid.target == GL_TEXTURE_2D)
        gl.TexImage2D(GL_TEXTURE_2D, 0, storage.internalFormat, grid.width, grid.height, 0, storage.format,
                      storage.type, nullptr);
    else
        gl.TexImage3D(GL_TEXTURE_3D, 0, storage.internalFormat, grid.width, grid.height, grid.depth, 0,
                      storage.format, storage.type, nullptr);
    if (gl.GetError() != GL_NO_ERROR) return TextureResult::outOfMemory;
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(grid.target, name, GL_LINEAR);
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.TexParameteri(grid.target, name, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(grid.target, GL_TEXTURE_MAX_LEVEL, 0);
    if (context.core) gl.TexParameteriv(grid.target, GL_TEXTURE_SWIZZLE_RGBA, storage.swizzle);
    if (const GLenum type = table ? 0 : typeAsItLies(image.format, storage.channels))
        sendRows(gl, grid, 0, grid.height, 0, grid.depth, storage, type, image.voxels.data());
    else
        sendConverted(gl, image, grid, storage, table);
    const TextureAnswer answer = textureAnswer(image.texel, table != nullptr);
    texture.oneChannel = answer.oneChannel;
    texture.hasAlpha = answer.hasAlpha;
    ++context.downloads;
    return gl.GetError() == GL_NO_ERROR ? TextureResult::ok : TextureResult::outOfMemory;
}

} // namespace

TextureAnswer textureAnswer(TexelFormat texel, bool classified)
{
    switch (texel) {
    case TexelFormat::intensity: return {!classified, true};
    case TexelFormat::luminance: return {!classified, classified};
    case TexelFormat::luminanceAlpha:
    case TexelFormat::rgba: return {false, true};
    case TexelFormat::rgb: return {false, classified};
    }
    return {false, true};
}

TextureResult bindTexture(ContextRecord& context, const TextureImage& image, bool always)
{
    const GladGLContext& gl = context.gl;
    const TexelGrid grid = texelGrid(image);
    const int limit = grid.target == GL_TEXTURE_2D ? context.max2dSize : context.max3dSize;
    if (std::max({grid.width, grid.height, grid.depth}) > limit) return TextureResult::tooLarge;

    const TableSlot* pre = activeTable(context, TableKind::preInterpolation);
    const std::uint64_t tableSerial = pre ? pre->serial : 0;
    const auto resident = context.textures.find(image.id);
    const bool fresh = resident != context.textures.end() && resident->second.version == image.version &&
                       resident->second.tableSerial == tableSerial && !always;
    if (!fresh && image.voxels.empty()) return TextureResult::noVoxels;
    ResidentTexture& texture = context.textures[image.id];
    if (texture.name == 0) {
        gl.GenTextures(1, &texture.name);
        context.textureIds[texture.name] = image.id;
    }
    texture.target = grid.target;
    gl.BindTexture(grid.target, texture.name);
    if (fresh) return TextureResult::ok;

    const TextureResult result = download(context, image, grid, texture, pre ? &pre->table : nullptr);
    if (result != TextureResult::ok) {
        context.textureIds.erase(texture.name);
        gl.DeleteTextures(1, &texture.name);
        context.textures.erase(image.id);
        return result;
    }
    texture.version = image.version;
    texture.tableSerial = tableSerial;
    return TextureResult::ok;
}

TexgenPlanes texgenPlanes(const glm::vec3& origin, const glm::vec3& size, bool twoDimensional, int thinAxis)
{
    TexgenPlanes planes{};
    int row = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (twoDimensional && axis == thinAxis) continue;
        planes.rows[row][axis] = 1.0f / size[axis];
        planes.rows[row][3] = -origin[axis] / size[axis];
        ++row;
    }
    return planes;
}

} // namespace vo
