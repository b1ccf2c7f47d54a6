#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/report.h"

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

#include "appearance/cell_ranges.h"
#include "appearance/convert_voxels.h"
#include "appearance/transposed_stacks.h"
#include "draw/scoped_state.h"
#include "draw/texturing.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <memory>
#include <utility>

using vo::badValue;
using vo::guarded;
using vo::required;

namespace {

constexpr int kLimitWithoutContext = 2048;
/// Channels of the richest disk format, which the storage of a brick has room for.
constexpr voExternalFormatType kWidestFormat = voExternalFormatTypeScope::RGBA;

vo::VoxelFormat formatOf(const voTexture3D& texture)
{
    return {vo::channels(texture.getExternalFormat()), vo::voxelType(texture.getDataType())};
}

std::size_t voxelCount(const voTexture3D& texture)
{
    int x = 1, y = 1, z = 1;
    texture.getSizes(x, y, z);
    return vo::VoxelSize{x, y, z}.count();
}

std::span<std::byte> requiredVoxels(const voTexture3D& texture)
{
    const voInside::Texture& d = voInside::of(texture);
    const std::span<std::byte> voxels = d.source->voxels(d.slot);
    if (voxels.empty()) badValue("the texture has no voxels; dataAlloc or setDataPtr gives it some");
    return voxels;
}

/// The storage, which must have room for all voxels in the texture's own format.
std::span<std::byte> voxelsToWrite(const voTexture3D& texture)
{
    const std::span<std::byte> voxels = requiredVoxels(texture);
    if (voxels.size() < texture.getDataSize())
        badValue("the texture has " + std::to_string(voxels.size()) + " bytes of voxels, " +
                 std::to_string(texture.getDataSize()) + " are needed");
    return voxels;
}

void touch(voTexture3D& texture)
{
    ++voInside::of(texture).version;
}

void allocate(voTexture3D& texture)
{
    voInside::Texture& d = voInside::of(texture);
    const vo::VoxelFormat widest{vo::channels(kWidestFormat), vo::voxelType(d.dataType)};
    const std::size_t perVoxel = std::max(vo::voxelBytes(widest), vo::voxelBytes(formatOf(texture)));
    const std::size_t voxels = voxelCount(texture);
    if (voxels > PTRDIFF_MAX / perVoxel || !d.source->allocate(d.slot, voxels * perVoxel))
        throw std::bad_alloc();
    touch(texture);
}

void release(voTexture3D& texture)
{
    voInside::Texture& d = voInside::of(texture);
    d.source->release(d.slot);
}

int textureLimit()
{
    const vo::ContextRecord* context = vo::currentContext();
    return context && context->usable() ? context->max3dSize : kLimitWithoutContext;
}

/// The ranges of what decides the opacity of a brick's samples.
vo::CellRanges opacityRanges(const voBrick& brick, const vo::CellGrid& grid)
{
    const voInside::Texture& d = voInside::of(brick);
    const vo::TexelFormat texel = vo::texelFormat(d.internalFormat);
    vo::VoxelOrigin origin;
    vo::VoxelSize size;
    brick.getBrickSizes(origin.x, origin.y, origin.z, size.x, size.y, size.z);
    for (int axis = 0; axis < 3; ++axis)
        if (d.origin[axis] != static_cast<float>(origin[axis]) || origin[axis] < 0 ||
            d.extent[axis] != static_cast<float>(d.size[axis]))
            badValue("a brick is not where whole voxels of the volume lie");
    const bool oneChannel = texel == vo::TexelFormat::intensity || texel == vo::TexelFormat::luminance;
    vo::CellRanges ranges =
        vo::cellRanges(voxelsToWrite(brick), formatOf(brick), size, origin,
                       oneChannel ? vo::VoxelComponent::red : vo::VoxelComponent::alpha, grid);
    if (texel == vo::TexelFormat::rgb) std::ranges::fill(ranges.ranges, vo::ValueRange{1.0f, 1.0f});
    return ranges;
}

/// The lowest and the highest value of each of `count` blocks over all bricks.
void uniteRanges(std::span<const vo::CellRanges> bricks, const vo::VoxelSize& count, float* ranges)
{
    const vo::ValueRange none;
    for (std::uint64_t block = 0; block < count.count(); ++block) {
        ranges[2 * block] = none.low;
        ranges[2 * block + 1] = none.high;
    }
    for (const vo::CellRanges& brick : bricks) {
        std::size_t number = 0;
        for (int z = brick.first.z; z < brick.first.z + brick.count.z; ++z)
            for (int y = brick.first.y; y < brick.first.y + brick.count.y; ++y)
                for (int x = brick.first.x; x < brick.first.x + brick.count.x; ++x, ++number) {
                    if (x >= count.x || y >= count.y || z >= count.z) continue;
                    const std::size_t block =
                        (static_cast<std::size_t>(z) * static_cast<std::size_t>(count.y) +
                         static_cast<std::size_t>(y)) *
                            static_cast<std::size_t>(count.x) +
                        static_cast<std::size_t>(x);
                    ranges[2 * block] = std::min(ranges[2 * block], brick.ranges[number].low);
                    ranges[2 * block + 1] = std::max(ranges[2 * block + 1], brick.ranges[number].high);
                }
    }
}

struct BestFormats
{
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
};

BestFormats bestFormats(voExternalFormatType disk, bool color)
{
    using External = voExternalFormatTypeScope;
    using Internal = voInternalFormatTypeScope;
    switch (vo::channels(disk)) {
    case vo::Channels::intensity:
    case vo::Channels::luminance: return {Internal::INTENSITY8_EXT, External::LUMINANCE};
    case vo::Channels::luminanceAlpha: return {Internal::LUMINANCE8_ALPHA8_EXT, External::LUMINANCE_ALPHA};
    case vo::Channels::rgba:
    case vo::Channels::abgr: break;
    }
    if (color) return {Internal::RGBA8_EXT, disk};
    return {Internal::LUMINANCE8_ALPHA8_EXT, External::LUMINANCE_ALPHA};
}

void bind(voTexture3D& texture, bool always)
{
    vo::ContextRecord& context = vo::requireContext();
    switch (vo::bindTexture(context, vo::textureImage(texture), always)) {
    case vo::TextureResult::ok: return;
    case vo::TextureResult::tooLarge: {
        int x, y, z;
        texture.getSizes(x, y, z);
        badValue("a texture of " + std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z) +
                 " is larger than OpenGL takes here (" + std::to_string(context.max3dSize) + ")");
    }
    case vo::TextureResult::outOfMemory: throw std::bad_alloc();
    case vo::TextureResult::noVoxels:
        badValue("the texture has no voxels; dataAlloc or setDataPtr gives it some");
    }
}

/// Binds every brick of the current set once and gives the caller's bindings back.
void makeResident(voBrickSetCollection& volume)
{
    const vo::ScopedTextureBindings bindings(vo::requireContext().gl);
    voBrickSetIterator bricks(volume.getCurrentBrickSet());
    for (voBrick* brick; (brick = bricks());)
        if (brick->getDataPtr()) bind(*brick, false);
}

std::vector<vo::BrickVoxels> bricksOf(voBrickSet& set)
{
    const std::size_t bytes = vo::voxelBytes(formatOf(*set.getBrick(0)));
    std::vector<vo::BrickVoxels> bricks;
    for (int i = 0; i < set.getBrickCount(); ++i) {
        voBrick& brick = *set.getBrick(i);
        vo::BrickVoxels b;
        brick.getBrickSizes(b.extent.origin.x, b.extent.origin.y, b.extent.origin.z, b.extent.size.x,
                            b.extent.size.y, b.extent.size.z);
        const voInside::Texture& d = voInside::of(brick);
        const std::span<std::byte> voxels = d.source->voxels(d.slot);
        const std::size_t needed = b.extent.size.count() * bytes;
        if (voxels.size() >= needed) b.voxels = voxels.first(needed);
        bricks.push_back(b);
    }
    return bricks;
}

/// Four channels fill a texel of OpenGL alone; two voxels of fewer share one.
bool fitsInterleaved(const voTexture3D& texture)
{
    return vo::channelCount(vo::channels(texture.getExternalFormat())) <= 2;
}

struct TextureShape
{
    int x = 1, y = 1, z = 1;
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    voDataType dataType;
    friend auto operator<=>(const TextureShape&, const TextureShape&) = default;
};

TextureShape shapeOf(const voTexture3D& texture)
{
    TextureShape shape{
        1, 1, 1, texture.getInternalFormat(), texture.getExternalFormat(), texture.getDataType()};
    texture.getSizes(shape.x, shape.y, shape.z);
    return shape;
}

/// True when its partner is still there.
bool isInterleaved(const voTexture3D& texture)
{
    return voInside::of(texture).clique.use_count() > 1;
}

void interleave(voTexture3D& first, voTexture3D& second)
{
    voInside::of(first).clique = voInside::of(second).clique = std::make_shared<char>();
}

/// Each brick of a set with the next one of its shape that is free; the odd one stays alone.
void interleaveBricks(voBrickSet& set)
{
    std::map<TextureShape, voBrick*> waiting;
    voBrickSetIterator bricks(&set);
    for (voBrick* brick; (brick = bricks());) {
        if (!fitsInterleaved(*brick) || isInterleaved(*brick)) continue;
        voBrick*& partner = waiting[shapeOf(*brick)];
        if (partner)
            interleave(*std::exchange(partner, nullptr), *brick);
        else
            partner = brick;
    }
}

bool isTwoDimensional(voInterpolationType type)
{
    return vo::resolveInterpolation(type) == voInterpolationTypeScope::_2D;
}

vo::TexgenPlanes planesOf(const voBrick& brick)
{
    const voInside::Texture& d = voInside::of(brick);
    return vo::texgenPlanes({d.origin[0], d.origin[1], d.origin[2]}, {d.extent[0], d.extent[1], d.extent[2]},
                            d.inStack, vo::thinAxis(d.orientation));
}

vo::RecordLayout layoutWithTexCoord(const voIndexedFaceSet& faceSet, voInterleavedArrayType format)
{
    const int values = faceSet.getVertexData()->getValuesPerVertex();
    const vo::RecordLayout layout = vo::recordLayout(format, values);
    if (layout.texCoord < 0) badValue("the vertex format has no voxel coordinates (T3F)");
    if (layout.values != values)
        badValue("the vertex format has " + std::to_string(layout.values) +
                 " values a record, the face set " + std::to_string(values));
    return layout;
}

/// The indices are groups of a count and that many vertices, all there.
void checkPolygons(const voIndexedFaceSet& faceSet)
{
    const int vertices = faceSet.getVertexData()->getCount();
    const std::span<const int> entries(faceSet.getIndices()->getDataPtr(),
                                       static_cast<std::size_t>(faceSet.getIndices()->getCount()));
    for (std::size_t i = 0; i < entries.size(); i += static_cast<std::size_t>(entries[i]) + 1) {
        if (entries[i] < 0 || static_cast<std::size_t>(entries[i]) >= entries.size() - i)
            badValue("the indices are no groups of a count and that many vertices");
        for (const int vertex : entries.subspan(i + 1, static_cast<std::size_t>(entries[i])))
            if (vertex < 0 || vertex >= vertices)
                badValue("vertex " + std::to_string(vertex) + " is outside 0 to " +
                         std::to_string(vertices - 1));
    }
}

/// Voxel to texture coordinates of each vertex that the face set uses; `done` marks vertices of shared data.
void transformTexCoords(const voBrick& brick, voIndexedFaceSet& faceSet, const vo::RecordLayout& layout,
                        std::vector<bool>& done)
{
    checkPolygons(faceSet);
    const vo::TexgenPlanes planes = planesOf(brick);
    voVertexData& vertices = *faceSet.getVertexData();
    const voIndices& indices = *faceSet.getIndices();
    done.resize(static_cast<std::size_t>(vertices.getCount()), false);
    const int* entries = indices.getDataPtr();
    for (int i = 0; i < indices.getCount(); i += entries[i] + 1)
        for (int corner = 1; corner <= entries[i]; ++corner) {
            const auto vertex = static_cast<std::size_t>(entries[i + corner]);
            if (done[vertex]) continue;
            done[vertex] = true;
            float* t =
                vertices.getDataPtr() + vertex * static_cast<std::size_t>(layout.values) + layout.texCoord;
            const glm::vec4 voxel(t[0], t[1], t[2], 1.0f);
            for (int row = 0; row < 3; ++row)
                t[row] = glm::dot(planes.rows[row], voxel);
        }
}

} // namespace

int voAppearanceActions::getBestParameters(const voInterpolationType& interpolationType,
                                           voRenderingMode renderingMode, voDataType dataType,
                                           voExternalFormatType diskDataFormat,
                                           voInternalFormatType& internalFormat,
                                           voExternalFormatType& externalFormat, int& xBrickSize,
                                           int& yBrickSize, int& zBrickSize)
{
    voInterpolationType resolved = interpolationType;
    return getBestParameters(resolved, renderingMode, dataType, diskDataFormat, internalFormat,
                             externalFormat, xBrickSize, yBrickSize, zBrickSize);
}

int voAppearanceActions::getBestParameters(voInterpolationType& interpolationType,
                                           voRenderingMode renderingMode, voDataType dataType,
                                           voExternalFormatType diskDataFormat,
                                           voInternalFormatType& internalFormat,
                                           voExternalFormatType& externalFormat, int& xBrickSize,
                                           int& yBrickSize, int& zBrickSize)
{
    return guarded("voAppearanceActions::getBestParameters", [&] {
        const voInterpolationType resolved = vo::resolveInterpolation(interpolationType);
        vo::resolveDataType(dataType);
        const int mode = renderingMode;
        if (mode < -1 || mode > voRenderingModeScope::COLOR)
            vo::badEnum("voRenderingMode has no value " + std::to_string(mode));
        const BestFormats best =
            bestFormats(vo::resolveExternalFormat(diskDataFormat), mode == voRenderingModeScope::COLOR);
        for (const int size : {xBrickSize, yBrickSize, zBrickSize})
            if (size < 1) badValue("a brick size of " + std::to_string(size) + ", 1 or more is needed");
        const int limit = textureLimit();
        interpolationType = resolved;
        internalFormat = best.internalFormat;
        externalFormat = best.externalFormat;
        for (int* size : {&xBrickSize, &yBrickSize, &zBrickSize})
            *size = std::min(*size, limit);
    });
}

void* voAppearanceActions::dataAlloc(voTexture3D* texture)
{
    void* data = nullptr;
    guarded("voAppearanceActions::dataAlloc", [&] {
        allocate(required(texture, "texture"));
        data = texture->getDataPtr();
    });
    return data;
}

void* voAppearanceActions::dataAlloc(voBrickSet* brickSet)
{
    void* data = nullptr;
    guarded("voAppearanceActions::dataAlloc", [&] {
        voBrickSetIterator bricks(&required(brickSet, "brickSet"));
        for (voBrick* brick; (brick = bricks());)
            allocate(*brick);
        data = brickSet->getBrick(0)->getDataPtr();
    });
    return data;
}

void voAppearanceActions::dataFree(voTexture3D* texture)
{
    guarded("voAppearanceActions::dataFree", [&] { release(required(texture, "texture")); });
}

void voAppearanceActions::dataFree(voBrickSet* brickSet)
{
    guarded("voAppearanceActions::dataFree", [&] {
        voBrickSetIterator bricks(&required(brickSet, "brickSet"));
        for (voBrick* brick; (brick = bricks());)
            release(*brick);
    });
}

int voAppearanceActions::dataScaleRange(voTexture3D* texture, float& loValue, float& hiValue)
{
    return dataScaleRange(texture, static_cast<double>(loValue), static_cast<double>(hiValue));
}

int voAppearanceActions::dataScaleRange(voTexture3D* texture, double loValue, double hiValue)
{
    return guarded("voAppearanceActions::dataScaleRange", [&] {
        voTexture3D& t = required(texture, "texture");
        if (!(hiValue > loValue)) return;
        if (!std::isfinite(hiValue - loValue)) badValue("a range without end cannot be scaled");
        const vo::VoxelFormat format = formatOf(t);
        if (vo::isPacked(format.type)) vo::unsupported("packed voxels have no range to scale");
        const std::span<std::byte> voxels = requiredVoxels(t);
        vo::stretchRange(voxels.first(std::min(voxels.size(), t.getDataSize())), format, loValue, hiValue);
        touch(t);
    });
}

int voAppearanceActions::dataConvert(voTexture3D* texture, void* data, voExternalFormatType diskFormat)
{
    return guarded("voAppearanceActions::dataConvert", [&] {
        voTexture3D& t = required(texture, "texture");
        const vo::VoxelFormat target = formatOf(t);
        const vo::VoxelFormat source{vo::channels(vo::resolveExternalFormat(diskFormat)), target.type};
        if (!data) badValue("data is NULL");
        if (!vo::isValid(source))
            vo::unsupported("a packed data type needs RGBA or ABGR_EXT voxels, 3_3_2 needs RGBA");
        const std::span<std::byte> storage = voxelsToWrite(t);
        const bool ownInPlace = data == storage.data() && voInside::of(t).source->owns(voInside::of(t).slot);
        if (ownInPlace && storage.size() < voxelCount(t) * vo::voxelBytes(source))
            badValue("the texture's storage is too small for voxels of that format");
        vo::convertVoxels(static_cast<const std::byte*>(data), source, storage.data(), target, voxelCount(t));
        touch(t);
    });
}

int voAppearanceActions::dataConvert(voTexture3D* texture, void* data, voDataType diskType)
{
    return guarded("voAppearanceActions::dataConvert", [&] {
        voTexture3D& t = required(texture, "texture");
        const vo::VoxelFormat target = formatOf(t);
        const vo::VoxelFormat source{target.channels, vo::voxelType(vo::resolveDataType(diskType))};
        if (!data) badValue("data is NULL");
        if (!vo::isValid(source))
            vo::unsupported("a packed data type needs RGBA or ABGR_EXT voxels, 3_3_2 needs RGBA");
        const std::span<std::byte> storage = voxelsToWrite(t);
        const bool ownInPlace = data == storage.data() && voInside::of(t).source->owns(voInside::of(t).slot);
        if (ownInPlace && storage.size() < voxelCount(t) * vo::voxelBytes(source))
            badValue("the texture's storage is too small for voxels of that type");
        vo::convertVoxels(static_cast<const std::byte*>(data), source, storage.data(), target, voxelCount(t));
        touch(t);
    });
}

int voAppearanceActions::volumeMakeTransposed(voBrickSetCollection* volume)
{
    return guarded("voAppearanceActions::volumeMakeTransposed", [&] {
        voBrickSetCollection& v = required(volume, "volume");
        if (v.getInterpolationType() != voInterpolationTypeScope::_2D) return;
        const vo::VoxelSize size = voInside::of(*v.getBrickSet(0)).volume;
        const std::vector<vo::BrickVoxels> sources = bricksOf(*v.getBrickSet(0));
        const std::size_t bytes = vo::voxelBytes(formatOf(*v.getBrickSet(0)->getBrick(0)));
        for (int stack = 1; stack < v.getBrickSetCount(); ++stack) {
            voBrickSet& set = *v.getBrickSet(stack);
            voBrickSetIterator bricks(&set);
            for (voBrick* brick; (brick = bricks()); touch(*brick))
                if (!brick->getDataPtr()) allocate(*brick);
            const std::vector<vo::BrickVoxels> targets = bricksOf(set);
            vo::fillFromBricks(sources, targets, bytes, size);
        }
    });
}

int voAppearanceActions::volumeFindRanges(voBrickSetCollection* volume, int blockSize, float* ranges)
{
    return guarded("voAppearanceActions::volumeFindRanges", [&] {
        const voBrickSet& set = *required(volume, "volume").getCurrentBrickSet();
        required(ranges, "ranges");
        if (blockSize < 1) badValue("blocks of " + std::to_string(blockSize) + " voxels a side");
        vo::VoxelSize size;
        set.getVolumeSizes(size.x, size.y, size.z);
        const vo::CellGrid grid{std::min(blockSize, std::max({size.x, size.y, size.z})), true};
        std::vector<vo::CellRanges> found;
        for (int brick = 0; brick < set.getBrickCount(); ++brick)
            found.push_back(opacityRanges(*set.getBrick(brick), grid));
        const auto blocks = [&](int voxels) { return (voxels - 1) / grid.side + 1; };
        uniteRanges(found, {blocks(size.x), blocks(size.y), blocks(size.z)}, ranges);
    });
}

int voAppearanceActions::volumeOptimize(voBrickSetCollection* volume, int flags)
{
    return guarded("voAppearanceActions::volumeOptimize", [&] {
        voBrickSetCollection& v = required(volume, "volume");
        using Flags = voOptimizeVolumeTypeScope;
        constexpr int kAll = int{Flags::BEST_PERFORMANCE} | int{Flags::PRE_TRANSPOSE};
        if (flags & ~kAll) vo::badEnum("voOptimizeVolumeType has no flags " + std::to_string(flags));
        if (flags & Flags::INTERLEAVE) {
            voBrickSetCollectionIterator sets(&v);
            for (voBrickSet* set; (set = sets());)
                interleaveBricks(*set);
        }
        const bool textures = flags & Flags::TEXTURE_OBJECTS;
        if (textures && vo::currentContext()) makeResident(v);
    });
}

int voAppearanceActions::volumeUnoptimize(voBrickSetCollection* volume)
{
    return guarded("voAppearanceActions::volumeUnoptimize", [&] {
        voBrickSetCollectionIterator sets(&required(volume, "volume"));
        for (voBrickSet* set; (set = sets());) {
            voBrickSetIterator bricks(set);
            for (voBrick* brick; (brick = bricks());) {
                vo::forgetTexture(voInside::of(*brick).id);
                voInside::of(*brick).clique.reset();
            }
        }
    });
}

int voAppearanceActions::textureInterleave(voTexture3D* texture1, voTexture3D* texture2)
{
    return guarded("voAppearanceActions::textureInterleave", [&] {
        voTexture3D &first = required(texture1, "texture1"), &second = required(texture2, "texture2");
        if (&first == &second) badValue("texture1 and texture2 are one texture");
        if (shapeOf(first) != shapeOf(second)) badValue("the textures differ in sizes, formats or data type");
        if (!fitsInterleaved(first)) badValue("voxels of four channels leave no room for another");
        if (cliqueTest(texture1, texture2)) return;
        if (isInterleaved(first) || isInterleaved(second))
            badValue("a texture is interleaved with another already");
        interleave(first, second);
    });
}

voBool voAppearanceActions::cliqueTest(voTexture3D* texture1, voTexture3D* texture2)
{
    voBool together = VO_FALSE;
    guarded("voAppearanceActions::cliqueTest", [&] {
        const voTexture3D &first = required(texture1, "texture1"), &second = required(texture2, "texture2");
        const std::shared_ptr<char>& clique = voInside::of(first).clique;
        if (&first != &second && clique && clique == voInside::of(second).clique) together = VO_TRUE;
    });
    return together;
}

void voAppearanceActions::textureEnable(voInterpolationType interpolationType)
{
    guarded("voAppearanceActions::textureEnable",
            [&] { vo::enableTexturing(vo::requireContext(), isTwoDimensional(interpolationType), true); });
}

void voAppearanceActions::textureDisable(voInterpolationType interpolationType)
{
    guarded("voAppearanceActions::textureDisable",
            [&] { vo::enableTexturing(vo::requireContext(), isTwoDimensional(interpolationType), false); });
}

void voAppearanceActions::texgenEnable()
{
    guarded("voAppearanceActions::texgenEnable", [] { vo::enableTexgen(vo::requireContext(), true); });
}

void voAppearanceActions::texgenDisable()
{
    guarded("voAppearanceActions::texgenDisable", [] { vo::enableTexgen(vo::requireContext(), false); });
}

void voAppearanceActions::texgenSetEquation(voBrick* brick)
{
    guarded("voAppearanceActions::texgenSetEquation",
            [&] { vo::setTexgenPlanes(vo::requireContext(), planesOf(required(brick, "brick"))); });
}

int voAppearanceActions::textureBind(voTexture3D* texture)
{
    return guarded("voAppearanceActions::textureBind", [&] { bind(required(texture, "texture"), false); });
}

int voAppearanceActions::textureLoad(voTexture3D* texture)
{
    return guarded("voAppearanceActions::textureLoad", [&] {
        ++voInside::of(required(texture, "texture"))
              .version; // other contexts and the CPU engine have older voxels
        bind(*texture, true);
    });
}

void voAppearanceActions::textureMakeMatrix(voBrick* brick, float* matrix)
{
    guarded("voAppearanceActions::textureMakeMatrix", [&] {
        const vo::TexgenPlanes planes = planesOf(required(brick, "brick"));
        if (!matrix) badValue("matrix is NULL");
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix[4 * column + row] = row < 3 ? planes.rows[row][column] : column < 3 ? 0.0f : 1.0f;
    });
}

void voAppearanceActions::xfmVox2TexCoords(voBrick* brick, voIndexedFaceSet* faceSet,
                                           voInterleavedArrayType format, voPlaneOrientation)
{
    guarded("voAppearanceActions::xfmVox2TexCoords", [&] {
        std::vector<bool> done;
        const vo::RecordLayout layout = layoutWithTexCoord(required(faceSet, "faceSet"), format);
        transformTexCoords(required(brick, "brick"), *faceSet, layout, done);
    });
}

void voAppearanceActions::xfmVox2TexCoords(voBrickSet* brickSet, int samplesNumber,
                                           voIndexedFaceSet*** polygonSet, voInterleavedArrayType format)
{
    guarded("voAppearanceActions::xfmVox2TexCoords", [&] {
        voBrickSet& set = required(brickSet, "brickSet");
        if (!polygonSet) badValue("polygonSet is NULL");
        std::vector<bool> done;
        const voVertexData* marked = nullptr;
        for (int b = 0; b < set.getBrickCount(); ++b)
            for (int s = 0; s < samplesNumber; ++s) {
                voIndexedFaceSet* const* row = &required(polygonSet[b], "a row of polygonSet");
                voIndexedFaceSet& faces = required(row[s], "a face set of polygonSet");
                const vo::RecordLayout layout = layoutWithTexCoord(faces, format);
                // Face sets share vertex data or own theirs; no vertex belongs to two bricks.
                if (marked != faces.getVertexData()) done.clear();
                marked = faces.getVertexData();
                transformTexCoords(*set.getBrick(b), faces, layout, done);
            }
    });
}

int voAppearanceActions::clip(voVertexData* polygon, voInterleavedArrayType format, float lowerLeft[3],
                              float upperRight[3], voIndexedFaceSet* faceSet)
{
    return voGeometryActions::clip(polygon, format, lowerLeft, upperRight, faceSet);
}

int voAppearanceActions::clip(voVertexData* polygon, float lowerLeft[3], float upperRight[3],
                              voIndexedFaceSet* faceSet)
{
    return voGeometryActions::clip(polygon, lowerLeft, upperRight, faceSet);
}

int voAppearanceActions::clip(voVertexData* polygon, voInterleavedArrayType format, float* planes,
                              int planeCount, voIndexedFaceSet* faceSet)
{
    return voGeometryActions::clip(polygon, format, planes, planeCount, faceSet);
}

int voAppearanceActions::sample(float tetraVerts[4][3], float planeEquation[4], voVertexData* polygonVerts)
{
    return voGeometryActions::sample(tetraVerts, planeEquation, polygonVerts);
}
