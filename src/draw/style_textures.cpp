#include "draw/style_textures.h"

#include "draw/scoped_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace vo {

namespace {

constexpr std::uint64_t kPicturesKept = 16;

/// How texels lie in OpenGL.
struct Storage
{
    GLint internalFormat;
    GLenum format, type;
};

Storage storageOf(const VoxelTexture& texture, bool wide)
{
    constexpr std::array kFormats{GL_RED, GL_RG, GL_RGB, GL_RGBA};
    constexpr std::array<std::array<GLint, 4>, 3> kInternal{{{GL_R8, GL_RG8, GL_RGB8, GL_RGBA8},
                                                             {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16},
                                                             {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F}}};
    constexpr std::array kTypes{GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT};
    const auto channels = static_cast<std::size_t>(texture.components) - 1;
    const auto kind = static_cast<std::size_t>(texture.kind);
    return {kInternal[wide ? 1 : kind][channels], static_cast<GLenum>(kFormats[channels]),
            static_cast<GLenum>(kTypes[wide ? 1 : kind])};
}

/// Bytes as shorts that stand for the same numbers, slice by slice, so that the memory needed stays small.
void sendWidened(const GladGLContext& gl, const VoxelTexture& texture, const Storage& storage)
{
    const VoxelSize& size = texture.size;
    const std::size_t slice = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                              static_cast<std::size_t>(texture.components);
    std::vector<std::uint16_t> texels(slice);
    for (int z = 0; z < size.z; ++z) {
        const std::byte* from = texture.texels.data() + static_cast<std::size_t>(z) * slice;
        std::transform(from, from + slice, texels.begin(), [](std::byte value) {
            return static_cast<std::uint16_t>(257u * std::to_integer<unsigned>(value));
        });
        gl.TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, z, size.x, size.y, 1, storage.format, storage.type,
                         texels.data());
    }
}

/// Throws std::runtime_error for texels that do not fill the size.
void checkWhole(const VoxelTexture& texture)
{
    if (isUsable(texture)) return;
    throw std::runtime_error("a texture of " + sizeText(texture.size) + " texels with " +
                             std::to_string(texture.components) + " components has " +
                             std::to_string(texture.texels.size()) + " bytes, which is too few");
}

/// Floats without what is no number, for which 0 stands; empty where there is none of it.
std::vector<float> withoutNonNumbers(const VoxelTexture& texture)
{
    if (texture.kind != TexelKind::float32) return {};
    std::vector<float> values(texture.texels.size() / sizeof(float));
    std::memcpy(values.data(), texture.texels.data(), values.size() * sizeof(float));
    const auto isNoNumber = [](float value) { return !std::isfinite(value); };
    if (std::ranges::none_of(values, isNoNumber)) return {};
    std::ranges::replace_if(values, isNoNumber, 0.0f);
    return values;
}

void setFilter(const GladGLContext& gl, const VoxelTexture& texture)
{
    const GLint filter = texture.nearest ? GL_NEAREST : GL_LINEAR;
    gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    constexpr std::array<GLenum, 3> kWraps{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    for (std::size_t axis = 0; axis < 3; ++axis)
        gl.TexParameteri(GL_TEXTURE_3D, kWraps[axis], texture.repeats[axis] ? GL_REPEAT : GL_CLAMP_TO_EDGE);
}

} // namespace

StyleTextures::~StyleTextures()
{
    if (!context_.isCurrent()) return;
    for (const auto& [serial, resident] : resident_)
        context_.gl.DeleteTextures(1, &resident.name);
}

void StyleTextures::send(const VoxelTexture& texture) const
{
    const GladGLContext& gl = context_.gl;
    const VoxelSize& size = texture.size;
    checkWhole(texture);
    if (std::max({size.x, size.y, size.z}) > context_.most3dTexels)
        throw std::runtime_error("a texture of " + sizeText(size) + " texels: this driver takes " +
                                 std::to_string(context_.most3dTexels) + " on an axis");
    const ScopedUploadState scope(gl, context_.core);
    const bool wide = texture.kind == TexelKind::uint8 && context_.filters8BitTexturesCoarsely;
    const Storage storage = storageOf(texture, wide);
    while (gl.GetError() != GL_NO_ERROR) {
    }
    const std::vector<float> numbers = withoutNonNumbers(texture);
    const void* texels = wide ? nullptr : texture.texels.data();
    if (!numbers.empty()) texels = numbers.data();
    gl.TexImage3D(GL_TEXTURE_3D, 0, storage.internalFormat, size.x, size.y, size.z, 0, storage.format,
                  storage.type, texels);
    setFilter(gl, texture);
    const bool allocated = gl.GetError() == GL_NO_ERROR;
    if (allocated && wide) sendWidened(gl, texture, storage);
    if (!allocated || gl.GetError() != GL_NO_ERROR)
        throw std::runtime_error("the driver has no memory for a texture of " + sizeText(size) + " texels");
}

void StyleTextures::bind(int unit, const VoxelTexture& texture)
{
    const GladGLContext& gl = context_.gl;
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    Resident& resident = resident_[texture.serial];
    resident.lastPicture = picture_;
    if (resident.name != 0) {
        gl.BindTexture(GL_TEXTURE_3D, resident.name);
        return;
    }
    gl.GenTextures(1, &resident.name);
    gl.BindTexture(GL_TEXTURE_3D, resident.name);
    try {
        send(texture);
    } catch (...) {
        gl.DeleteTextures(1, &resident.name);
        resident_.erase(texture.serial);
        throw;
    }
}

const VoxelBlocks& StyleTextures::blocks(const VoxelTexture& texture)
{
    Resident& resident = resident_[texture.serial];
    resident.lastPicture = picture_;
    if (resident.blocks) return *resident.blocks;
    auto blocks = std::make_unique<VoxelBlocks>();
    try {
        if (isUsable(texture)) *blocks = PaddedVoxels(texture, 0).blocks();
    } catch (const std::bad_alloc&) {
        // Nothing is leapt over then.
    }
    resident.blocks = std::move(blocks);
    return *resident.blocks;
}

void StyleTextures::endPicture()
{
    std::erase_if(resident_, [this](const auto& entry) {
        if (entry.second.lastPicture + kPicturesKept > picture_) return false;
        context_.gl.DeleteTextures(1, &entry.second.name);
        return true;
    });
    ++picture_;
}

} // namespace vo
