#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/report.h"

#include "appearance/convert_voxels.h"

#include <algorithm>
#include <atomic>
#include <cmath>

using vo::badValue;
using vo::guarded;
using vo::unsupported;

namespace {

/// Smallest OpenGL constant in question; enumerators of ours are all smaller, so the two cannot be confused.
constexpr GLenum kFirstOpenGlConstant = 0x1400;
/// The width of a texture that today's OpenGL can be relied on to hold.
constexpr int kMostEntries = 16384;

void checkWidth(int width)
{
    if (width < 2 || width > kMostEntries)
        badValue("a table of " + std::to_string(width) + " entries, 2 to " + std::to_string(kMostEntries) +
                 " are possible");
}

vo::Channels channelsOf(GLenum format)
{
    if (format < kFirstOpenGlConstant) {
        const vo::Channels channels = vo::channels(vo::resolveExternalFormat(static_cast<int>(format)));
        if (vo::channelCount(channels) == 1)
            unsupported("a table needs entries of luminance and alpha, or of four channels");
        return channels;
    }
    switch (format) {
    case GL_LUMINANCE_ALPHA: return vo::Channels::luminanceAlpha;
    case GL_RGBA: return vo::Channels::rgba;
    default: unsupported("a table needs entries of GL_LUMINANCE_ALPHA or GL_RGBA");
    }
}

vo::VoxelType typeOf(GLenum type)
{
    if (type < kFirstOpenGlConstant) return vo::voxelType(vo::resolveDataType(static_cast<int>(type)));
    switch (type) {
    case GL_UNSIGNED_BYTE: return vo::VoxelType::uint8;
    case GL_BYTE: return vo::VoxelType::int8;
    case GL_UNSIGNED_SHORT: return vo::VoxelType::uint16;
    case GL_SHORT: return vo::VoxelType::int16;
    case GL_UNSIGNED_INT: return vo::VoxelType::uint32;
    case GL_INT: return vo::VoxelType::int32;
    case GL_FLOAT: return vo::VoxelType::float32;
    default: unsupported("a table needs entries of bytes, shorts, ints or floats");
    }
}

bool isLuminanceAlpha(GLenum internalFormat)
{
    switch (internalFormat) {
    case voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT:
    case GL_LUMINANCE8_ALPHA8:
    case GL_LUMINANCE_ALPHA: return true;
    case voInternalFormatTypeScope::RGBA8_EXT:
    case GL_RGBA8:
    case GL_RGBA: return false;
    default: unsupported("a table is kept as LUMINANCE8_ALPHA8_EXT or RGBA8_EXT");
    }
}

std::uint64_t nextSerial()
{
    static std::atomic<std::uint64_t> next{1};
    return next++;
}

vo::Table readEntries(const void* data, int width, GLenum externalFormat, GLenum dataType,
                      bool luminanceAlpha)
{
    const vo::VoxelFormat format{channelsOf(externalFormat), typeOf(dataType)};
    if (!data) badValue("the table has no entries");
    if (!vo::isValid(format)) unsupported("packed entries need four channels");
    const auto count = static_cast<std::size_t>(width);
    vo::Table table;
    table.rgba.resize(4 * count);
    vo::decodeVoxels({static_cast<const std::byte*>(data), count * vo::voxelBytes(format)}, format, count,
                     table.rgba.data());
    for (float& value : table.rgba)
        value = std::clamp(value, 0.0f, 1.0f);
    for (std::size_t i = 0; luminanceAlpha && i < count; ++i)
        table.rgba[4 * i + 1] = table.rgba[4 * i + 2] = table.rgba[4 * i];
    return table;
}

vo::TableKind kindOf(voLookupTableType type)
{
    return type == voLookupTableTypeScope::PRE_INTERPOLATION ? vo::TableKind::preInterpolation
                                                             : vo::TableKind::postInterpolation;
}

} // namespace

voLookupTable::voLookupTable(GLenum internalFormat, int width, GLenum externalFormat, GLenum dataType,
                             void* data)
    : d(new Private)
{
    d->internalFormat = internalFormat;
    d->externalFormat = externalFormat;
    d->dataType = dataType;
    d->data = data;
    d->slot = std::make_shared<vo::TableSlot>();
    guarded("voLookupTable", [&] {
        checkWidth(width);
        d->width = width;
    });
}

voLookupTable::~voLookupTable()
{
    vo::retireTable(d->slot);
    delete d;
}

void voLookupTable::load()
{
    guarded("voLookupTable::load", [&] {
        checkWidth(d->width);
        const bool luminanceAlpha = isLuminanceAlpha(d->internalFormat);
        d->slot->table = d->ramp
                             ? vo::linearRamp(d->width, d->rampCenter, d->rampWidth)
                             : readEntries(d->data, d->width, d->externalFormat, d->dataType, luminanceAlpha);
        d->slot->serial = nextSerial();
        d->visible = vo::VisibleValues(d->slot->table);
    });
}

voBool voLookupTable::isVisible(float low, float high) const
{
    bool visible = true;
    guarded("voLookupTable::isVisible", [&] {
        if (!d->visible) badValue("the table was not loaded");
        visible = d->visible->any(low, high);
    });
    return visible ? VO_TRUE : VO_FALSE;
}

void voLookupTable::enable()
{
    guarded("voLookupTable::enable", [&] { vo::activateTable(kindOf(getType()), d->slot); });
}

void voLookupTable::disable()
{
    guarded("voLookupTable::disable", [&] { vo::activateTable(kindOf(getType()), nullptr); });
}

void voLookupTable::set(voLookupTableShape shape, float center, float width)
{
    guarded("voLookupTable::set", [&] {
        if (shape != LINEAR) vo::badEnum("voLookupTableShape has no value " + std::to_string(shape));
        if (!std::isfinite(center) || !std::isfinite(width)) badValue("center or width is not a number");
        d->ramp = true;
        d->rampCenter = center;
        d->rampWidth = width;
    });
}

int voLookupTable::getBestParameters(voBrickSetCollection*, voRenderingMode renderingMode, int lookupLength,
                                     voLookupTableType& lookupType, voInternalFormatType& internalFormat,
                                     voExternalFormatType& externalFormat, voDataType& dataType)
{
    return guarded("voLookupTable::getBestParameters", [&] {
        const int mode = renderingMode, type = lookupType;
        if (mode < -1 || mode > voRenderingModeScope::COLOR)
            vo::badEnum("voRenderingMode has no value " + std::to_string(mode));
        if (type < -1 || type > voLookupTableTypeScope::POST_INTERPOLATION)
            vo::badEnum("voLookupTableType has no value " + std::to_string(type));
        checkWidth(lookupLength);
        const bool color = mode == voRenderingModeScope::COLOR;
        if (type != voLookupTableTypeScope::PRE_INTERPOLATION)
            lookupType = voLookupTableTypeScope::POST_INTERPOLATION;
        internalFormat =
            color ? voInternalFormatTypeScope::RGBA8_EXT : voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT;
        externalFormat = color ? voExternalFormatTypeScope::RGBA : voExternalFormatTypeScope::LUMINANCE_ALPHA;
        dataType = voDataTypeScope::FLOAT;
    });
}

voLookupTablePre::voLookupTablePre(GLenum internalFormat, int width, GLenum externalFormat, GLenum dataType,
                                   void* data)
    : voLookupTable(internalFormat, width, externalFormat, dataType, data)
{
}

voLookupTablePre::~voLookupTablePre() = default;

voLookupTableType voLookupTablePre::getType() const
{
    return voLookupTableTypeScope::PRE_INTERPOLATION;
}

voLookupTablePost::voLookupTablePost(GLenum internalFormat, int width, GLenum externalFormat, GLenum dataType,
                                     void* data)
    : voLookupTable(internalFormat, width, externalFormat, dataType, data)
{
}

voLookupTablePost::~voLookupTablePost() = default;

voLookupTableType voLookupTablePost::getType() const
{
    return voLookupTableTypeScope::POST_INTERPOLATION;
}
