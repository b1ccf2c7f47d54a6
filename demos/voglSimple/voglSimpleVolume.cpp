// The volume of voglSimple: how it looks, its shape, and how both become a picture (guide, chapter 4).

// Before any header of <vo/...>.
#include "gl.h"

#include "brick_io.h"

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

#include <stdio.h>
#include <stdlib.h>

extern float modelScale[3];
extern bool wireframe;

int maxBrickCount = 0;      // bricks in the largest copy of the volume
int maxSamplesNumber = 256; // most sampling planes
float samplingRate = 1.0;   // planes are as far apart as voxels
voInterleavedArrayType interleavedArrayFormat = voInterleavedArrayTypeScope::V3F;

voVertexData* allVertexData;          // vertices of all polygons of a frame
voIndexedFaceSet*** aPolygonSetArray; // polygons: [brick][sample]

voBrickSetCollection* my_InitAppearance(int argc, char** argv)
{
    int xVolumeSize, yVolumeSize, zVolumeSize;
    int xBrickSize, yBrickSize, zBrickSize;
    voExternalFormatType diskDataFormat;
    voExternalFormatType externalFormat;
    voInternalFormatType internalFormat;
    voDataType dataType;
    voInterpolationType interpolationType = voInterpolationTypeScope::DEFAULT;
    voRenderingMode renderingMode = voRenderingModeScope::MONOCHROME;
    float loValue = -1.0, hiValue = -1.0;

    if (argc < 2) {
        fprintf(stderr, "Usage: %s inFileName\n", argv[0]);
        exit(1);
    }
    char* dataFileName = argv[1];
    if (myGetVolumeSizesIfl(dataFileName, xVolumeSize, yVolumeSize, zVolumeSize, diskDataFormat, dataType))
        exit(1);

    xBrickSize = xVolumeSize;
    yBrickSize = yVolumeSize;
    zBrickSize = zVolumeSize;
    voAppearanceActions::getBestParameters(interpolationType, renderingMode, dataType, diskDataFormat,
                                           internalFormat, externalFormat, xBrickSize, yBrickSize,
                                           zBrickSize);

    voBrickSetCollection* aVolume = new voBrickSetCollection(
        xVolumeSize, yVolumeSize, zVolumeSize, xBrickSize, yBrickSize, zBrickSize,
        voPartialBrickTypeScope::TRUNCATE, 1, internalFormat, externalFormat, dataType, interpolationType);

    // room for the voxels of all bricks
    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; (brickSet = collectionIter());) {
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; (brick = brickSetIter());)
            if (!voAppearanceActions::dataAlloc(brick)) exit(1);
        if (brickSet->getBrickCount() > maxBrickCount) maxBrickCount = brickSet->getBrickCount();
    }

    // read one copy of the volume, brick by brick
    aVolume->setCurrentBrickSet(voPlaneOrientationScope::XY);
    voBrickSetIterator brickSetIter(aVolume->getCurrentBrickSet());
    for (voBrick* brick; (brick = brickSetIter());) {
        int xBrickOrigin, yBrickOrigin, zBrickOrigin;
        void* vdata = brick->getDataPtr();
        brick->getBrickSizes(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize);
        if (myReadBrickIfl(dataFileName, vdata, xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize,
                           yBrickSize, zBrickSize, xVolumeSize, yVolumeSize, zVolumeSize))
            exit(1);
        voAppearanceActions::dataConvert(brick, vdata, diskDataFormat);
        voAppearanceActions::dataScaleRange(brick, loValue, hiValue);
    }
    // make the other copies from it
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        voAppearanceActions::volumeMakeTransposed(aVolume);

    maxSamplesNumber = xVolumeSize;
    if (maxSamplesNumber < yVolumeSize) maxSamplesNumber = yVolumeSize;
    if (maxSamplesNumber < zVolumeSize) maxSamplesNumber = zVolumeSize;
    maxSamplesNumber *= 2;
    return aVolume;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume)
{
    int xVolumeSize, yVolumeSize, zVolumeSize;
    aVolume->getCurrentBrickSet()->getVolumeSizes(xVolumeSize, yVolumeSize, zVolumeSize);
    const float x = float(xVolumeSize), y = float(yVolumeSize), z = float(zVolumeSize);
    const float vtxData[8][3] = {
        {0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z},
    };
    // five tetrahedra are a cube: one in the middle, four at its corners
    static const int cubeIndices[] = {
        0, 2, 5, 7, //
        3, 2, 0, 7, //
        1, 2, 5, 0, //
        2, 7, 6, 5, //
        5, 4, 0, 7, //
    };
    const int tetraCount = sizeof(cubeIndices) / (VO_TETRA_VERTICES * sizeof(cubeIndices[0]));
    const int valuesPerVtx = sizeof(vtxData[0]) / sizeof(float);
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(vtxData[0], 8, valuesPerVtx, cubeIndices, 20);

    // room for the polygons that the tetrahedra are cut into
    allVertexData = new voVertexData(100000, valuesPerVtx);
    aPolygonSetArray = new voIndexedFaceSetPtrPtr[maxBrickCount];
    for (int j1 = 0; j1 < maxBrickCount; j1++) {
        aPolygonSetArray[j1] = new voIndexedFaceSetPtr[maxSamplesNumber + 1];
        for (int j2 = 0; j2 < maxSamplesNumber + 1; j2++)
            aPolygonSetArray[j1][j2] = new voIndexedFaceSet(allVertexData, boundFaceCount(tetraCount));
    }
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection* aVolume)
{
    voAppearanceActions::volumeOptimize(aVolume, voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
}

// tetrahedra in yellow, bricks in blue
static void drawOutlines(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
    gl->Color4f(1.0, 1.0, 0.0, 1.0);
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    voGeometryActions::draw(aTetraSet, interleavedArrayFormat);
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_3D) {
        gl->Color4f(0.0, 0.0, 1.0, 1.0);
        for (int brickNo = 0; brickNo < aVolume->getCurrentBrickSet()->getBrickCount(); brickNo++)
            voGeometryActions::draw(aVolume->getCurrentBrickSet()->getBrick(brickNo));
    }
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    GLdouble modelMatrix[16], projMatrix[16];
    gl->GetDoublev(GL_MODELVIEW_MATRIX, modelMatrix);
    gl->GetDoublev(GL_PROJECTION_MATRIX, projMatrix);

    // of three stacks of 2D textures, the one that faces the eye
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        aVolume->setCurrentBrickSet(voGeometryActions::findClosestAxisIndex(
            modelMatrix, projMatrix, voSamplingModeScope::AXIS_ALIGNED));
    const int BrickCount = aVolume->getCurrentBrickSet()->getBrickCount();

    if (wireframe) drawOutlines(aTetraSet, aVolume);

    // cut the tetrahedra into polygons, and those at the bricks
    int samplesNumber;
    float samplingPeriod[3] = {samplingRate / modelScale[0], samplingRate / modelScale[1],
                               samplingRate / modelScale[2]};
    voGeometryActions::polygonize(
        aTetraSet, aVolume->getCurrentBrickSet(), interleavedArrayFormat, modelMatrix, projMatrix,
        aVolume->getInterpolationType() == voInterpolationTypeScope::_3D
            ? voSamplingModeScope::VIEWPORT_ALIGNED
            : voSamplingModeScope::AXIS_ALIGNED,
        voSamplingSpaceScope::OBJECT, samplingPeriod, maxSamplesNumber, samplesNumber, aPolygonSetArray);
    if (hasTextureComponent(interleavedArrayFormat))
        voAppearanceActions::xfmVox2TexCoords(aVolume->getCurrentBrickSet(), samplesNumber, aPolygonSetArray,
                                              interleavedArrayFormat);

    voSortAction aSortAction(aVolume->getCurrentBrickSet(), modelMatrix, projMatrix);

    voAppearanceActions::textureEnable(aVolume->getInterpolationType());
    if (!hasTextureComponent(interleavedArrayFormat)) voAppearanceActions::texgenEnable();
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl->Color4f(1.0, 1.0, 1.0, 1.0);
    gl->DepthMask(GL_FALSE);

    // bricks from back to front, and the polygons of each likewise
    for (int brickNo = 0; brickNo < BrickCount; brickNo++) {
        const int brickSortedNo = aSortAction[brickNo];
        voBrick* aBrick = aVolume->getCurrentBrickSet()->getBrick(brickSortedNo);
        if (!hasTextureComponent(interleavedArrayFormat)) voAppearanceActions::texgenSetEquation(aBrick);
        voAppearanceActions::textureBind(aBrick);
        for (int binNo = 0; binNo < samplesNumber; binNo++)
            voGeometryActions::draw(aPolygonSetArray[brickSortedNo][binNo], interleavedArrayFormat);
    }

    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
    voAppearanceActions::texgenDisable();
    gl->DepthMask(GL_TRUE);
}

// the name under which the guide's main program calls it
void my_Draw(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    my_DrawVolume(aTetraSet, aVolume);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    for (int j1 = 0; j1 < maxBrickCount; j1++) {
        for (int j2 = 0; j2 < maxSamplesNumber + 1; j2++)
            delete aPolygonSetArray[j1][j2];
        delete[] aPolygonSetArray[j1];
    }
    delete[] aPolygonSetArray;
    delete allVertexData;

    voAppearanceActions::volumeUnoptimize(aVolume);
    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; (brickSet = collectionIter());) {
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; (brick = brickSetIter());)
            voAppearanceActions::dataFree(brick);
    }
    delete aVolume;
    delete aTetraSet;
}
