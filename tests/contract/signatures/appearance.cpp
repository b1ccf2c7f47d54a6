// A: textures, bricks, sets of bricks (pages 27 to 29, 36 to 41, 129 to 147).

#include <vo/Appearance.h>

#include "rows.h"

namespace DIALECT {

static void textures()
{
    ROW(A1);
    voTexture3D texture(voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE,
                        voDataTypeScope::UNSIGNED_BYTE);
    ROW(A2);
    static unsigned char mine[8];
    texture.setDataPtr(mine);
    void* vdata = texture.getDataPtr();
    is(vdata);
    ROW(A3);
    is<voInternalFormatType (voTexture3D::*)() const>(&voTexture3D::getInternalFormat);
    is<voExternalFormatType (voTexture3D::*)() const>(&voTexture3D::getExternalFormat);
    is<voDataType (voTexture3D::*)() const>(&voTexture3D::getDataType);
}

static void bricks(voBrick* brick)
{
    ROW(A4);
    voTexture3D* base = brick;
    is(base);
    ROW(A5);
    is<void (voBrick::*)(float, float, float, float, float, float)>(&voBrick::setBrickSizes);
    ROW(A6);
    int xBrickOrigin, yBrickOrigin, zBrickOrigin;
    int xBrickSize, yBrickSize, zBrickSize;
    brick->getBrickSizes(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize);
    ROW(A7);
    float position[3], size[3];
    brick->getBrickSizes(position, size);
    ROW(A8);
    float brickLowerLeft[3], brickUpperRight[3];
    brick->getClipBrickSizes(brickLowerLeft, brickUpperRight);
    ROW(A9);
    brick->setBrickSizes(0, 0, 0, 7, 5, 3);
}

static void brickSet(voBrickSet* aBrickSet)
{
    ROW(A10);
    ROW(A11);
    int BrickCount = aBrickSet->getBrickCount();
    voBrick* aBrick = aBrickSet->getBrick(BrickCount - 1);
    bricks(aBrick);
    ROW(A12);
    int xVolumeSize, yVolumeSize, zVolumeSize;
    aBrickSet->getVolumeSizes(xVolumeSize, yVolumeSize, zVolumeSize);
    ROW(A13);
    aBrickSet->getBrickSizes(xVolumeSize, yVolumeSize, zVolumeSize);
    voPlaneOrientation orientation = aBrickSet->getOrientation();
    is(orientation);
    ROW(A14);
    voBrickSetIterator brickSetIter(aBrickSet);
    for (voBrick* brick; brick = brickSetIter();)
        is(brick);
}

void appearance()
{
    textures();
    ROW(A15);
    voBrickSetCollection* aVolume = new voBrickSetCollection(
        20, 20, 20, 8, 8, 8, voPartialBrickTypeScope::TRUNCATE, 1, voInternalFormatTypeScope::INTENSITY8_EXT,
        voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_2D);
    ROW(A16);
    aVolume->setCurrentBrickSet(voPlaneOrientationScope::XY);
    ROW(A17);
    brickSet(aVolume->getCurrentBrickSet());
    is(aVolume->currentBrickSet->getBrick(0));
    ROW(A18);
    voInterpolationType interpolationType = aVolume->getInterpolationType();
    interpolationType = aVolume->interpolationType;
    is(interpolationType);
    ROW(A19);
    aVolume->setDirtyFlag(VO_TRUE);
    ROW(A20);
    ROW(A21);
    ROW(A22);
    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* each; each = collectionIter();)
        is(each);
    ROW(A23);
    is(aVolume->getMaxBrickCount());
    ROW(A24);
    delete aVolume;
    ROW(A25);
}

} // namespace DIALECT
