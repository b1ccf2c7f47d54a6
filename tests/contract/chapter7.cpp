// The guide's chapter 7, pages 129 to 148.

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>
#include <vo/CompatNames.h>

#include "chapters.h"

extern int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                          int xBrickSize, int yBrickSize, int zBrickSize);

namespace DIALECT {

void initializeVoxels(char* fileName, voBrickSet* aBrickSet, float loValue, float hiValue)
{
    voBrickSetIterator aBrickSetIter(aBrickSet);
    for (voBrick* brick; brick = aBrickSetIter();) {
        int xBrickOrigin, yBrickOrigin, zBrickOrigin;
        int xBrickSize, yBrickSize, zBrickSize;
        brick->getBrickSizes(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize);
        unsigned char* vdata = (unsigned char*)voTexture3DActions::dataAlloc(brick);
        myReadBrickIfl(fileName, vdata, xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize,
                       zBrickSize);
        // convert to the desired externalFormat
        Texture3DActions::dataConvert(brick, vdata, INTENSITY);
        // expand the values to span the whole dymanic range
        voAppearanceActions::dataScaleRange(brick, loValue, hiValue);
    }
}

void drawGenerated(voBrickSetCollection* aVolume, voIndexedFaceSet*** aPolygonSetArray, int samplesNumber,
                   voInterleavedArrayType interleavedArrayFormat)
{
    voBrickSet* aBrickSet = aVolume->getCurrentBrickSet();
    int BrickCount = aBrickSet->getBrickCount();
    int brickNo;
    voAppearanceActions::textureEnable(aVolume->getInterpolationType());
    if (interleavedArrayFormat == _V3F)
        voAppearanceActions::texgenEnable();
    else
        voAppearanceActions::xfmVox2TexCoords(aBrickSet, samplesNumber, aPolygonSetArray,
                                              interleavedArrayFormat);
    // iterate over all bricks
    for (brickNo = 0; brickNo < BrickCount; brickNo++) {
        int brickSortedNo = brickNo;
        voBrick* aBrick = aBrickSet->getBrick(brickSortedNo);
        voAppearanceActions::textureBind(aBrick);
        // update texgen equation for the current brick
        if (interleavedArrayFormat == _V3F) voAppearanceActions::texgenSetEquation(aBrick);
        // iterate over all sampling planes
        for (int binNo = 0; binNo < samplesNumber; binNo++)
            voGeometryActions::draw(aPolygonSetArray[brickSortedNo][binNo], GL_FILL, interleavedArrayFormat);
    }
    if (interleavedArrayFormat == _V3F) voAppearanceActions::texgenDisable();
    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
}

void drawThroughTextureMatrix(voBrick* aBrick, voIndexedFaceSet* aFaceSet)
{
    float matrix[16];
    voAppearanceActions::textureMakeMatrix(aBrick, matrix);
    voAppearanceActions::textureEnable(_3D);
    voAppearanceActions::textureBind(aBrick);
    glMatrixMode(GL_TEXTURE);
    glPushMatrix();
    glMultMatrixf(matrix);
    voGeometryActions::draw(aFaceSet, GL_FILL, _T3F_V3F);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    voAppearanceActions::textureDisable(_3D);
}

int interleave(voTexture3D* aBrick1, voTexture3D* aBrick2, int* before, int* after)
{
    *before = voTexture3DActions::cliqueTest(aBrick1, aBrick2);
    int failed = voAppearanceActions::textureInterleave(aBrick1, aBrick2);
    *after = voTexture3DActions::cliqueTest(aBrick1, aBrick2);
    return failed;
}

void brickSizes(voBrick* aBrick, int* sixInts, float* position, float* size)
{
    aBrick->setBrickSizes(1, 2, 3, 4, 5, 6);
    aBrick->getBrickSizes(sixInts[0], sixInts[1], sixInts[2], sixInts[3], sixInts[4], sixInts[5]);
    aBrick->getBrickSizes(position, size);
}

void suggestBrickSizes(int xVolumeSize, int yVolumeSize, int zVolumeSize, int* sizes)
{
    voInterpolationType interpolationType = voInterpolationTypeScope::DEFAULT;
    voRenderingMode renderingMode = voRenderingModeScope::MONOCHROME;
    voDataType dataType = voDataTypeScope::UNSIGNED_BYTE;
    voExternalFormatType diskDataFormat = voExternalFormatTypeScope::INTENSITY;
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    int xBrickSize, yBrickSize, zBrickSize;
    xBrickSize = xVolumeSize;
    yBrickSize = yVolumeSize;
    zBrickSize = zVolumeSize;
    voAppearanceActions::getBestParameters(interpolationType, renderingMode, dataType, // In
                                           diskDataFormat,                             // In
                                           internalFormat, externalFormat,             // Out
                                           xBrickSize, yBrickSize, zBrickSize);        // In/Out
    sizes[0] = xBrickSize;
    sizes[1] = yBrickSize;
    sizes[2] = zBrickSize;
}

void drawOutline(voBrick* brick)
{
    voGeometryActions::draw(brick);
}

void selectStack(voBrickSetCollection* aBrickSetCollection, GLdouble modelMatrix[16], GLdouble projMatrix[16])
{
    aBrickSetCollection->setCurrentBrickSet(findClosestAxisIndex(modelMatrix, projMatrix, AXIS_ALIGNED));
}

void loadAndBind(voTexture3D* aTexture3D)
{
    voAppearanceActions::textureLoad(aTexture3D);
    voAppearanceActions::textureBind(aTexture3D);
}

} // namespace DIALECT
