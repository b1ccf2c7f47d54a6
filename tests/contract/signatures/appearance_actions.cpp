// F: operations on appearance (pages 36 to 44, 57, 58, 131 to 145).

#include <vo/AppearanceActions.h>

#include "rows.h"

namespace DIALECT {

typedef voAppearanceActions Actions;

static void parameters()
{
    ROW(F1);
    is<int (*)(voInterpolationType&, voRenderingMode, voDataType, voExternalFormatType, voInternalFormatType&,
               voExternalFormatType&, int&, int&, int&)>(&Actions::getBestParameters);
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    int xBrickSize = 8, yBrickSize = 8, zBrickSize = 8;
    voAppearanceActions::getBestParameters(voInterpolationTypeScope::_3D, voRenderingModeScope::MONOCHROME,
                                           voDataTypeScope::UNSIGNED_BYTE,
                                           voExternalFormatTypeScope::INTENSITY, internalFormat,
                                           externalFormat, xBrickSize, yBrickSize, zBrickSize);
}

static void data()
{
    ROW(F2);
    is<void* (*)(voTexture3D*)>(&Actions::dataAlloc);
    is<void* (*)(voBrickSet*)>(&Actions::dataAlloc);
    ROW(F3);
    is<void (*)(voTexture3D*)>(&Actions::dataFree);
    is<void (*)(voBrickSet*)>(&Actions::dataFree);
    ROW(F4);
    is<int (*)(voTexture3D*, float&, float&)>(&Actions::dataScaleRange);
    voBrick brick(voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE,
                  voDataTypeScope::UNSIGNED_BYTE);
    voAppearanceActions::dataScaleRange(&brick, -1, -1);
    voAppearanceActions::dataScaleRange(&brick, -1.0, -1.0);
    ROW(F5);
    is<int (*)(voTexture3D*, void*, voExternalFormatType)>(&Actions::dataConvert);
    is<int (*)(voTexture3D*, void*, voDataType)>(&Actions::dataConvert);
}

static void volume()
{
    ROW(F6);
    is<int (*)(voBrickSetCollection*)>(&Actions::volumeMakeTransposed);
    ROW(F7);
    is<int (*)(voBrickSetCollection*, int)>(&Actions::volumeOptimize);
    ROW(F8);
    is<int (*)(voBrickSetCollection*)>(&Actions::volumeUnoptimize);
}

static void textures()
{
    ROW(F9);
    is<int (*)(voTexture3D*, voTexture3D*)>(&Actions::textureInterleave);
    ROW(F10);
    is<voBool (*)(voTexture3D*, voTexture3D*)>(&Actions::cliqueTest);
    ROW(F11);
    is<void (*)(voInterpolationType)>(&Actions::textureEnable);
    is<void (*)(voInterpolationType)>(&Actions::textureDisable);
    ROW(F12);
    is<void (*)()>(&Actions::texgenEnable);
    is<void (*)()>(&Actions::texgenDisable);
    ROW(F13);
    is<void (*)(voBrick*)>(&Actions::texgenSetEquation);
    ROW(F14);
    is<int (*)(voTexture3D*)>(&Actions::textureBind);
    ROW(F15);
    is<int (*)(voTexture3D*)>(&Actions::textureLoad);
    ROW(F16);
    is<void (*)(voBrick*, float*)>(&Actions::textureMakeMatrix);
    ROW(F17);
    is<void (*)(voBrick*, voIndexedFaceSet*, voInterleavedArrayType, voPlaneOrientation)>(
        &Actions::xfmVox2TexCoords);
    ROW(F18);
    is<void (*)(voBrickSet*, int, voIndexedFaceSet***, voInterleavedArrayType)>(&Actions::xfmVox2TexCoords);
}

void appearanceActions()
{
    parameters();
    data();
    volume();
    textures();
    ROW(F19);
    is<int (*)(voVertexData*, voInterleavedArrayType, float[3], float[3], voIndexedFaceSet*)>(&Actions::clip);
    is<int (*)(voVertexData*, voInterleavedArrayType, float*, int, voIndexedFaceSet*)>(&Actions::clip);
    is<int (*)(float[4][3], float[4], voVertexData*)>(&Actions::sample);
    ROW(F20);
}

} // namespace DIALECT
