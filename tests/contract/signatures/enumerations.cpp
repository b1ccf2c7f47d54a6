// E: every enumerator by its scope.

#include <vo/Enums.h>

#include "rows.h"

namespace DIALECT {

void enumerations()
{
    ROW(E1);
    voInterpolationType interpolation[] = {voInterpolationTypeScope::DEFAULT, voInterpolationTypeScope::_2D,
                                           voInterpolationTypeScope::_3D};
    isOldEnumeration(interpolation[0]);
    ROW(E2);
    voRenderingMode rendering[] = {voRenderingModeScope::DEFAULT, voRenderingModeScope::MONOCHROME,
                                   voRenderingModeScope::COLOR};
    isOldEnumeration(rendering[0]);
    ROW(E3);
    voDataType data[] = {voDataTypeScope::DEFAULT,
                         voDataTypeScope::UNSIGNED_BYTE,
                         voDataTypeScope::BYTE,
                         voDataTypeScope::UNSIGNED_BYTE_3_3_2_EXT,
                         voDataTypeScope::UNSIGNED_SHORT,
                         voDataTypeScope::SHORT,
                         voDataTypeScope::UNSIGNED_SHORT_4_4_4_4_EXT,
                         voDataTypeScope::UNSIGNED_SHORT_5_5_5_1_EXT,
                         voDataTypeScope::UNSIGNED_INT,
                         voDataTypeScope::INT,
                         voDataTypeScope::UNSIGNED_INT_8_8_8_8_EXT,
                         voDataTypeScope::UNSIGNED_INT_10_10_10_2_EXT,
                         voDataTypeScope::FLOAT};
    isOldEnumeration(data[0]);
    ROW(E4);
    voInternalFormatType internalFormat[] = {voInternalFormatTypeScope::DEFAULT,
                                             voInternalFormatTypeScope::INTENSITY8_EXT,
                                             voInternalFormatTypeScope::LUMINANCE8_EXT,
                                             voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT,
                                             voInternalFormatTypeScope::RGBA8_EXT,
                                             voInternalFormatTypeScope::RGB8_EXT,
                                             voInternalFormatTypeScope::RGBA4_EXT,
                                             voInternalFormatTypeScope::QUAD_LUMINANCE8_SGIS,
                                             voInternalFormatTypeScope::DUAL_LUMINANCE_ALPHA8_SGIS,
                                             voInternalFormatTypeScope::RGB4_EXT,
                                             voInternalFormatTypeScope::DUAL_INTENSITY8_SGIS};
    isOldEnumeration(internalFormat[0]);
    ROW(E5);
    voExternalFormatType externalFormat[] = {voExternalFormatTypeScope::DEFAULT,
                                             voExternalFormatTypeScope::INTENSITY,
                                             voExternalFormatTypeScope::LUMINANCE_ALPHA,
                                             voExternalFormatTypeScope::LUMINANCE,
                                             voExternalFormatTypeScope::RGBA,
                                             voExternalFormatTypeScope::ABGR_EXT};
    isOldEnumeration(externalFormat[0]);
    ROW(E6);
    voPartialBrickType partial[] = {voPartialBrickTypeScope::DEFAULT, voPartialBrickTypeScope::TRUNCATE,
                                    voPartialBrickTypeScope::AUGMENT, voPartialBrickTypeScope::AUGMENT_TIGHT};
    isOldEnumeration(partial[0]);
    ROW(E7);
    voOptimizeVolumeType optimize = (voOptimizeVolumeType)(int)(voOptimizeVolumeTypeScope::INTERLEAVE |
                                                                voOptimizeVolumeTypeScope::TEXTURE_OBJECTS |
                                                                voOptimizeVolumeTypeScope::PRE_TRANSPOSE);
    optimize = voOptimizeVolumeTypeScope::BEST;
    optimize = voOptimizeVolumeTypeScope::BEST_PERFORMANCE;
    isOldEnumeration(optimize);
    ROW(E8);
    voPlaneOrientation orientation[] = {voPlaneOrientationScope::UNSPECIFIED, voPlaneOrientationScope::XY,
                                        voPlaneOrientationScope::XZ, voPlaneOrientationScope::YZ};
    isOldEnumeration(orientation[0]);
    ROW(E9);
    voSamplingMode mode[] = {voSamplingModeScope::DEFAULT, voSamplingModeScope::VIEWPORT_ALIGNED,
                             voSamplingModeScope::AXIS_ALIGNED, voSamplingModeScope::SPHERICAL,
                             voSamplingModeScope::BEST_PERFORMANCE};
    isOldEnumeration(mode[0]);
    ROW(E10);
    voSamplingSpace space[] = {voSamplingSpaceScope::DEFAULT, voSamplingSpaceScope::VIEW_VOLUME,
                               voSamplingSpaceScope::OBJECT, voSamplingSpaceScope::PRIMITIVE};
    isOldEnumeration(space[0]);
    ROW(E11);
    voInterleavedArrayType format[] = {
        voInterleavedArrayTypeScope::DEFAULT,     voInterleavedArrayTypeScope::V3F,
        voInterleavedArrayTypeScope::T3F_V3F,     voInterleavedArrayTypeScope::C3F_V3F,
        voInterleavedArrayTypeScope::C4F_V3F,     voInterleavedArrayTypeScope::T3F_C3F_V3F,
        voInterleavedArrayTypeScope::T3F_C4F_V3F, voInterleavedArrayTypeScope::USER_V3F};
    isOldEnumeration(format[0]);
    ROW(E12);
    voErrorType error[] = {voErrorTypeScope::NO_ERROR, voErrorTypeScope::BAD_VALUE,
                           voErrorTypeScope::BAD_ENUM, voErrorTypeScope::OUT_OF_MEMORY,
                           voErrorTypeScope::UNSUPPORTED};
    isOldEnumeration(error[0]);
    ROW(E13);
    voLookupTableType table[] = {voLookupTableTypeScope::PRE_INTERPOLATION,
                                 voLookupTableTypeScope::POST_INTERPOLATION, voLookupTableTypeScope::DEFAULT};
    isOldEnumeration(table[0]);
    ROW(E14);
    voLookupTableShape shape = voLookupTableShapeScope::LINEAR;
    isOldEnumeration(shape);
    ROW(E15);
    voDecorationFlags decorations[] = {voDecorationFlagsScope::NONE, voDecorationFlagsScope::BRICKS,
                                       voDecorationFlagsScope::TETRAS, voDecorationFlagsScope::ALL};
    isOldEnumeration(decorations[0]);
}

} // namespace DIALECT
