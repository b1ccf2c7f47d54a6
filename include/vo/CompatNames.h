#ifndef VO_COMPAT_NAMES_H
#define VO_COMPAT_NAMES_H

#include <vo/Enums.h>

/* Optional: the enumerators without their class, and the names with prefixes that are left over in the guide (pages
   42-44, 61-62, 134, 140, 143), as constants. No other header includes this one.

   Left out, to be written with their class: DEFAULT, NONE and BEST_PERFORMANCE, which several enumerations have; BYTE,
   SHORT, INT and FLOAT, which are types of Windows and in part of X (write _DATA_TYPE_FLOAT and the like); NO_ERROR, a
   macro of Windows. */

const voInterpolationType _2D = voInterpolationTypeScope::_2D;
const voInterpolationType _3D = voInterpolationTypeScope::_3D;

const voRenderingMode MONOCHROME = voRenderingModeScope::MONOCHROME;
const voRenderingMode COLOR = voRenderingModeScope::COLOR;

const voDataType UNSIGNED_BYTE = voDataTypeScope::UNSIGNED_BYTE;
const voDataType UNSIGNED_BYTE_3_3_2_EXT = voDataTypeScope::UNSIGNED_BYTE_3_3_2_EXT;
const voDataType UNSIGNED_SHORT = voDataTypeScope::UNSIGNED_SHORT;
const voDataType UNSIGNED_SHORT_4_4_4_4_EXT = voDataTypeScope::UNSIGNED_SHORT_4_4_4_4_EXT;
const voDataType UNSIGNED_SHORT_5_5_5_1_EXT = voDataTypeScope::UNSIGNED_SHORT_5_5_5_1_EXT;
const voDataType UNSIGNED_INT = voDataTypeScope::UNSIGNED_INT;
const voDataType UNSIGNED_INT_8_8_8_8_EXT = voDataTypeScope::UNSIGNED_INT_8_8_8_8_EXT;
const voDataType UNSIGNED_INT_10_10_10_2_EXT = voDataTypeScope::UNSIGNED_INT_10_10_10_2_EXT;
const voDataType INT_8_8_8_8_EXT = voDataTypeScope::INT_8_8_8_8_EXT;
const voDataType INT_10_10_10_2_EXT = voDataTypeScope::INT_10_10_10_2_EXT;

const voInternalFormatType INTENSITY8_EXT = voInternalFormatTypeScope::INTENSITY8_EXT;
const voInternalFormatType LUMINANCE8_EXT = voInternalFormatTypeScope::LUMINANCE8_EXT;
const voInternalFormatType LUMINANCE8_ALPHA8_EXT = voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT;
const voInternalFormatType RGBA8_EXT = voInternalFormatTypeScope::RGBA8_EXT;
const voInternalFormatType RGB8_EXT = voInternalFormatTypeScope::RGB8_EXT;
const voInternalFormatType RGBA4_EXT = voInternalFormatTypeScope::RGBA4_EXT;
const voInternalFormatType RGB4_EXT = voInternalFormatTypeScope::RGB4_EXT;
const voInternalFormatType RGB88_EXT = voInternalFormatTypeScope::RGB88_EXT;
const voInternalFormatType RGB84_EXT = voInternalFormatTypeScope::RGB84_EXT;
const voInternalFormatType RGB44_EXT = voInternalFormatTypeScope::RGB44_EXT;
const voInternalFormatType QUAD_LUMINANCE8_SGIS = voInternalFormatTypeScope::QUAD_LUMINANCE8_SGIS;
const voInternalFormatType DUAL_LUMINANCE_ALPHA8_SGIS = voInternalFormatTypeScope::DUAL_LUMINANCE_ALPHA8_SGIS;
const voInternalFormatType DUAL_INTENSITY8_SGIS = voInternalFormatTypeScope::DUAL_INTENSITY8_SGIS;

const voExternalFormatType INTENSITY = voExternalFormatTypeScope::INTENSITY;
const voExternalFormatType LUMINANCE_ALPHA = voExternalFormatTypeScope::LUMINANCE_ALPHA;
const voExternalFormatType LUMINANCE = voExternalFormatTypeScope::LUMINANCE;
const voExternalFormatType RGBA = voExternalFormatTypeScope::RGBA;
const voExternalFormatType ABGR_EXT = voExternalFormatTypeScope::ABGR_EXT;

const voPartialBrickType TRUNCATE = voPartialBrickTypeScope::TRUNCATE;
const voPartialBrickType AUGMENT = voPartialBrickTypeScope::AUGMENT;
const voPartialBrickType AUGMENT_TIGHT = voPartialBrickTypeScope::AUGMENT_TIGHT;

const voOptimizeVolumeType INTERLEAVE = voOptimizeVolumeTypeScope::INTERLEAVE;
const voOptimizeVolumeType TEXTURE_OBJECTS = voOptimizeVolumeTypeScope::TEXTURE_OBJECTS;
const voOptimizeVolumeType PRE_TRANSPOSE = voOptimizeVolumeTypeScope::PRE_TRANSPOSE;
const voOptimizeVolumeType BEST = voOptimizeVolumeTypeScope::BEST;

const voPlaneOrientation UNSPECIFIED = voPlaneOrientationScope::UNSPECIFIED;
const voPlaneOrientation XY = voPlaneOrientationScope::XY;
const voPlaneOrientation XZ = voPlaneOrientationScope::XZ;
const voPlaneOrientation YZ = voPlaneOrientationScope::YZ;

const voSamplingMode VIEWPORT_ALIGNED = voSamplingModeScope::VIEWPORT_ALIGNED;
const voSamplingMode AXIS_ALIGNED = voSamplingModeScope::AXIS_ALIGNED;
const voSamplingMode SPHERICAL = voSamplingModeScope::SPHERICAL;

const voSamplingSpace VIEW_VOLUME = voSamplingSpaceScope::VIEW_VOLUME;
const voSamplingSpace OBJECT = voSamplingSpaceScope::OBJECT;
const voSamplingSpace PRIMITIVE = voSamplingSpaceScope::PRIMITIVE;

const voInterleavedArrayType V3F = voInterleavedArrayTypeScope::V3F;
const voInterleavedArrayType T3F_V3F = voInterleavedArrayTypeScope::T3F_V3F;
const voInterleavedArrayType C3F_V3F = voInterleavedArrayTypeScope::C3F_V3F;
const voInterleavedArrayType C4F_V3F = voInterleavedArrayTypeScope::C4F_V3F;
const voInterleavedArrayType T3F_C3F_V3F = voInterleavedArrayTypeScope::T3F_C3F_V3F;
const voInterleavedArrayType T3F_C4F_V3F = voInterleavedArrayTypeScope::T3F_C4F_V3F;
const voInterleavedArrayType USER_V3F = voInterleavedArrayTypeScope::USER_V3F;

const voErrorType BAD_VALUE = voErrorTypeScope::BAD_VALUE;
const voErrorType BAD_ENUM = voErrorTypeScope::BAD_ENUM;
const voErrorType OUT_OF_MEMORY = voErrorTypeScope::OUT_OF_MEMORY;
const voErrorType UNSUPPORTED = voErrorTypeScope::UNSUPPORTED;

const voLookupTableType PRE_INTERPOLATION = voLookupTableTypeScope::PRE_INTERPOLATION;
const voLookupTableType POST_INTERPOLATION = voLookupTableTypeScope::POST_INTERPOLATION;

const voLookupTableShape LINEAR = voLookupTableShapeScope::LINEAR;

const voDecorationFlags BRICKS = voDecorationFlagsScope::BRICKS;
const voDecorationFlags TETRAS = voDecorationFlagsScope::TETRAS;
const voDecorationFlags ALL = voDecorationFlagsScope::ALL;

/* With prefixes. */
const voDataType _DATA_TYPE_DEFAULT = voDataTypeScope::DEFAULT;
const voDataType _DATA_TYPE_UNSIGNED_BYTE = voDataTypeScope::UNSIGNED_BYTE;
const voDataType _DATA_TYPE_BYTE = voDataTypeScope::BYTE;
const voDataType _DATA_TYPE_UNSIGNED_BYTE_3_3_2_EXT = voDataTypeScope::UNSIGNED_BYTE_3_3_2_EXT;
const voDataType _DATA_TYPE_UNSIGNED_SHORT = voDataTypeScope::UNSIGNED_SHORT;
const voDataType _DATA_TYPE_SHORT = voDataTypeScope::SHORT;
const voDataType _DATA_TYPE_UNSIGNED_SHORT_4_4_4_4_EXT = voDataTypeScope::UNSIGNED_SHORT_4_4_4_4_EXT;
const voDataType _DATA_TYPE_UNSIGNED_SHORT_5_5_5_1_EXT = voDataTypeScope::UNSIGNED_SHORT_5_5_5_1_EXT;
const voDataType _DATA_TYPE_UNSIGNED_INT = voDataTypeScope::UNSIGNED_INT;
const voDataType _DATA_TYPE_INT = voDataTypeScope::INT;
const voDataType _DATA_TYPE_UNSIGNED_INT_8_8_8_8_EXT = voDataTypeScope::UNSIGNED_INT_8_8_8_8_EXT;
const voDataType _DATA_TYPE_UNSIGNED_INT_10_10_10_2_EXT = voDataTypeScope::UNSIGNED_INT_10_10_10_2_EXT;
const voDataType _DATA_TYPE_FLOAT = voDataTypeScope::FLOAT;

const voInterleavedArrayType _V3F = voInterleavedArrayTypeScope::V3F;
const voInterleavedArrayType _T3F_V3F = voInterleavedArrayTypeScope::T3F_V3F;
const voInterleavedArrayType _C3F_V3F = voInterleavedArrayTypeScope::C3F_V3F;
const voInterleavedArrayType _C4F_V3F = voInterleavedArrayTypeScope::C4F_V3F;
const voInterleavedArrayType _T3F_C3F_V3F = voInterleavedArrayTypeScope::T3F_C3F_V3F;
const voInterleavedArrayType _T3F_C4F_V3F = voInterleavedArrayTypeScope::T3F_C4F_V3F;
const voInterleavedArrayType _USER_V3F = voInterleavedArrayTypeScope::USER_V3F;

const voSamplingSpace _SAMPLE_OVER_VIEW_VOLUME = voSamplingSpaceScope::VIEW_VOLUME;
const voSamplingSpace _SAMPLE_OVER_OBJECT = voSamplingSpaceScope::OBJECT;
const voSamplingSpace _SAMPLE_OVER_PRIMITIVE = voSamplingSpaceScope::PRIMITIVE;
const voSamplingMode _SAMPLING_VIEWPORT_ALIGNED = voSamplingModeScope::VIEWPORT_ALIGNED;
const voSamplingMode _SAMPLING_AXIS_ALIGNED = voSamplingModeScope::AXIS_ALIGNED;
const voSamplingMode _SAMPLING_SPHERICAL = voSamplingModeScope::SPHERICAL;
const voSamplingMode VO_SAMPLING_VIEWPORT_ALIGNED = voSamplingModeScope::VIEWPORT_ALIGNED;
const voSamplingMode VO_SAMPLING_AXIS_ALIGNED = voSamplingModeScope::AXIS_ALIGNED;
const voSamplingMode VO_SAMPLING_SPHERICAL = voSamplingModeScope::SPHERICAL;

#endif
