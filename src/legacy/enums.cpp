#include "legacy/enums.h"

#include "legacy/report.h"

#include <string>

namespace vo {

namespace {

std::string described(const char* enumeration, int value)
{
    return std::string(enumeration) + " has no value " + std::to_string(value);
}

} // namespace

voInterpolationType resolveInterpolation(int type)
{
    if (type == -1) return voInterpolationTypeScope::_3D;
    switch (static_cast<voInterpolationType>(type)) {
    case voInterpolationTypeScope::_2D: return voInterpolationTypeScope::_2D;
    case voInterpolationTypeScope::DEFAULT:
    case voInterpolationTypeScope::_3D: return voInterpolationTypeScope::_3D;
    }
    badEnum(described("voInterpolationType", type));
}

voDataType resolveDataType(int type)
{
    if (type == -1 || type == voDataTypeScope::DEFAULT) return voDataTypeScope::UNSIGNED_BYTE;
    if (type < 0 || type > voDataTypeScope::FLOAT) badEnum(described("voDataType", type));
    return static_cast<voDataType>(type);
}

voExternalFormatType resolveExternalFormat(int format)
{
    if (format == -1 || format == voExternalFormatTypeScope::DEFAULT)
        return voExternalFormatTypeScope::LUMINANCE;
    if (format < 0 || format > voExternalFormatTypeScope::ABGR_EXT)
        badEnum(described("voExternalFormatType", format));
    return static_cast<voExternalFormatType>(format);
}

voInternalFormatType resolveInternalFormat(int format, voExternalFormatType external)
{
    if (format < -1 || format > voInternalFormatTypeScope::DUAL_INTENSITY8_SGIS)
        badEnum(described("voInternalFormatType", format));
    if (format != -1 && format != voInternalFormatTypeScope::DEFAULT)
        return static_cast<voInternalFormatType>(format);
    switch (channels(external)) {
    case Channels::intensity:
    case Channels::luminance: return voInternalFormatTypeScope::INTENSITY8_EXT;
    case Channels::luminanceAlpha: return voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT;
    case Channels::rgba:
    case Channels::abgr: return voInternalFormatTypeScope::RGBA8_EXT;
    }
    badEnum(described("voExternalFormatType", external));
}

VoxelType voxelType(voDataType type)
{
    switch (type) {
    case voDataTypeScope::DEFAULT:
    case voDataTypeScope::UNSIGNED_BYTE: return VoxelType::uint8;
    case voDataTypeScope::BYTE: return VoxelType::int8;
    case voDataTypeScope::UNSIGNED_BYTE_3_3_2_EXT: return VoxelType::uint8_332;
    case voDataTypeScope::UNSIGNED_SHORT: return VoxelType::uint16;
    case voDataTypeScope::SHORT: return VoxelType::int16;
    case voDataTypeScope::UNSIGNED_SHORT_4_4_4_4_EXT: return VoxelType::uint16_4444;
    case voDataTypeScope::UNSIGNED_SHORT_5_5_5_1_EXT: return VoxelType::uint16_5551;
    case voDataTypeScope::UNSIGNED_INT: return VoxelType::uint32;
    case voDataTypeScope::INT: return VoxelType::int32;
    case voDataTypeScope::UNSIGNED_INT_8_8_8_8_EXT: return VoxelType::uint32_8888;
    case voDataTypeScope::UNSIGNED_INT_10_10_10_2_EXT: return VoxelType::uint32_1010102;
    case voDataTypeScope::FLOAT: return VoxelType::float32;
    }
    badEnum(described("voDataType", type));
}

Channels channels(voExternalFormatType format)
{
    switch (format) {
    case voExternalFormatTypeScope::INTENSITY: return Channels::intensity;
    case voExternalFormatTypeScope::LUMINANCE_ALPHA: return Channels::luminanceAlpha;
    case voExternalFormatTypeScope::DEFAULT:
    case voExternalFormatTypeScope::LUMINANCE: return Channels::luminance;
    case voExternalFormatTypeScope::RGBA: return Channels::rgba;
    case voExternalFormatTypeScope::ABGR_EXT: return Channels::abgr;
    }
    badEnum(described("voExternalFormatType", format));
}

TexelFormat texelFormat(voInternalFormatType format)
{
    switch (format) {
    case voInternalFormatTypeScope::DEFAULT:
    case voInternalFormatTypeScope::INTENSITY8_EXT: return TexelFormat::intensity;
    case voInternalFormatTypeScope::LUMINANCE8_EXT: return TexelFormat::luminance;
    case voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT: return TexelFormat::luminanceAlpha;
    case voInternalFormatTypeScope::RGBA8_EXT:
    case voInternalFormatTypeScope::RGBA4_EXT: return TexelFormat::rgba;
    case voInternalFormatTypeScope::RGB8_EXT:
    case voInternalFormatTypeScope::RGB4_EXT: return TexelFormat::rgb;
    case voInternalFormatTypeScope::QUAD_LUMINANCE8_SGIS:
    case voInternalFormatTypeScope::DUAL_LUMINANCE_ALPHA8_SGIS:
    case voInternalFormatTypeScope::DUAL_INTENSITY8_SGIS:
        unsupported("the packed SGIS texture formats are not part of today's OpenGL");
    }
    badEnum(described("voInternalFormatType", format));
}

PartialBricks partialBricks(int type)
{
    if (type == -1) return PartialBricks::truncate;
    switch (static_cast<voPartialBrickType>(type)) {
    case voPartialBrickTypeScope::DEFAULT:
    case voPartialBrickTypeScope::TRUNCATE: return PartialBricks::truncate;
    case voPartialBrickTypeScope::AUGMENT: return PartialBricks::augment;
    case voPartialBrickTypeScope::AUGMENT_TIGHT: return PartialBricks::augmentTight;
    }
    badEnum(described("voPartialBrickType", type));
}

SamplingMode samplingMode(int mode)
{
    if (mode == -1) return SamplingMode::viewportAligned;
    switch (static_cast<voSamplingMode>(mode)) {
    case voSamplingModeScope::DEFAULT:
    case voSamplingModeScope::VIEWPORT_ALIGNED: return SamplingMode::viewportAligned;
    case voSamplingModeScope::AXIS_ALIGNED: return SamplingMode::axisAligned;
    case voSamplingModeScope::SPHERICAL: return SamplingMode::spherical;
    }
    badEnum(described("voSamplingMode", mode));
}

SamplingSpace samplingSpace(int space)
{
    if (space == -1) return SamplingSpace::object;
    switch (static_cast<voSamplingSpace>(space)) {
    case voSamplingSpaceScope::VIEW_VOLUME: return SamplingSpace::viewVolume;
    case voSamplingSpaceScope::DEFAULT:
    case voSamplingSpaceScope::OBJECT: return SamplingSpace::object;
    case voSamplingSpaceScope::PRIMITIVE: return SamplingSpace::primitive;
    }
    badEnum(described("voSamplingSpace", space));
}

EngineChoice engineChoiceOf(int engine)
{
    switch (static_cast<voEngine>(engine)) {
    case voEngineScope::AUTOMATIC: return EngineChoice::automatic;
    case voEngineScope::SLICES: return EngineChoice::slices;
    case voEngineScope::CAST: return EngineChoice::cast;
    }
    badEnum(described("voEngine", engine));
}

RecordLayout recordLayout(int format, int values)
{
    switch (static_cast<voInterleavedArrayType>(format)) {
    case voInterleavedArrayTypeScope::DEFAULT:
    case voInterleavedArrayTypeScope::V3F: return {3, -1, -1, 0};
    case voInterleavedArrayTypeScope::T3F_V3F: return {6, 0, -1, 0};
    case voInterleavedArrayTypeScope::C3F_V3F: return {6, -1, 0, 3};
    case voInterleavedArrayTypeScope::C4F_V3F: return {7, -1, 0, 4};
    case voInterleavedArrayTypeScope::T3F_C3F_V3F: return {9, 0, 3, 3};
    case voInterleavedArrayTypeScope::T3F_C4F_V3F: return {10, 0, 3, 4};
    case voInterleavedArrayTypeScope::USER_V3F: return {values, -1, -1, 0};
    }
    badEnum(described("voInterleavedArrayType", format));
}

} // namespace vo
