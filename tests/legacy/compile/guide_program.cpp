// A program as chapter 4 of the guide lays it out (pages 69 to 82), without files, windows and drawing.
// C++98; GUIDE_PROGRAM is the name of the one function that is seen from outside.

#include <vo/GeometryActions.h>
#include <vo/AppearanceActions.h>

namespace {

const int maxSamplesNumber = 64;
const float samplingRate = 1;
const voInterleavedArrayType interleavedArrayFormat = voInterleavedArrayTypeScope::T3F_V3F;

voVertexData* allVertexData;
voIndexedFaceSet*** aPolygonSetArray;
int maxBrickCount;

void my_ExceptionHandler(void)
{
    fprintf(stderr, "OpenGL Volumizer error %d: %s\n", voError::getErrorNumber(), voError::getErrorString());
}

// Stands for a loader: voxels of one byte, those outside the volume zero.
void fillBrick(void* data, int xO, int yO, int zO, int xB, int yB, int zB, int size)
{
    unsigned char* voxel = (unsigned char*)data;
    for (int z = zO; z < zO + zB; z++)
        for (int y = yO; y < yO + yB; y++)
            for (int x = xO; x < xO + xB; x++)
                *voxel++ = x < size && y < size && z < size ? (unsigned char)(x + y + z) : 0;
}

voBrickSetCollection* my_InitAppearance(int size, int brickSize, voInterpolationType interpolationType)
{
    voExternalFormatType diskDataFormat = voExternalFormatTypeScope::INTENSITY, externalFormat;
    voInternalFormatType internalFormat;
    voDataType dataType = voDataTypeScope::UNSIGNED_BYTE;
    float loValue = -1.0, hiValue = -1.0;
    int xBrickSize = brickSize, yBrickSize = brickSize, zBrickSize = brickSize;

    voAppearanceActions::getBestParameters(interpolationType, voRenderingModeScope::MONOCHROME, dataType,
                                           diskDataFormat, internalFormat, externalFormat, xBrickSize,
                                           yBrickSize, zBrickSize);
    voBrickSetCollection* aVolume = new voBrickSetCollection(
        size, size, size, xBrickSize, yBrickSize, zBrickSize, voPartialBrickTypeScope::AUGMENT_TIGHT, 1,
        internalFormat, externalFormat, dataType, interpolationType);
    if (voError::getErrorNumber() != voErrorTypeScope::NO_ERROR) {
        fprintf(stderr, "%s", voError::getErrorString());
        return aVolume;
    }

    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; (brickSet = collectionIter());) {
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; (brick = brickSetIter());)
            voAppearanceActions::dataAlloc(brick);
    }
    aVolume->setCurrentBrickSet(voPlaneOrientationScope::XY);
    voBrickSetIterator brickSetIter(aVolume->getCurrentBrickSet());
    for (voBrick* brick; (brick = brickSetIter());) {
        int xO, yO, zO, xB, yB, zB;
        void* vdata = brick->getDataPtr();
        brick->getBrickSizes(xO, yO, zO, xB, yB, zB);
        fillBrick(vdata, xO, yO, zO, xB, yB, zB, size);
        voAppearanceActions::dataConvert(brick, vdata, diskDataFormat);
        voAppearanceActions::dataScaleRange(brick, loValue, hiValue);
    }
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        voAppearanceActions::volumeMakeTransposed(aVolume);
    return aVolume;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume)
{
    voError::setErrorHandler(my_ExceptionHandler);
    int xV, yV, zV;
    aVolume->getCurrentBrickSet()->getVolumeSizes(xV, yV, zV);
    static float vtxData[8][6];
    for (int i = 0; i < 8; i++) {
        vtxData[i][0] = vtxData[i][3] = i % 4 == 1 || i % 4 == 2 ? xV : 0;
        vtxData[i][1] = vtxData[i][4] = i % 4 >= 2 ? yV : 0;
        vtxData[i][2] = vtxData[i][5] = i >= 4 ? zV : 0;
    }
    static int cubeIndices[] = {
        0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7,
    };
    int tetraCount = sizeof(cubeIndices) / (VO_TETRA_VERTICES * sizeof(cubeIndices[0]));
    int valuesPerVtx = sizeof(vtxData[0]) / sizeof(float);
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet((float*)vtxData, 8, valuesPerVtx, cubeIndices, 20);

    maxBrickCount = 0;
    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; (brickSet = collectionIter());)
        if (maxBrickCount < brickSet->getBrickCount()) maxBrickCount = brickSet->getBrickCount();
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

// All of the guide's my_DrawVolume that needs no context. Returns the number of polygons.
int my_Polygonize(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    GLdouble modelMatrix[16] = {0.8, 0.6, 0, 0, -0.6, 0.8, 0, 0, 0, 0, 1, 0, -4, -4, -4, 1};
    GLdouble projMatrix[16] = {0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, -0.1, 0, 0, 0, 0, 1};
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        aVolume->setCurrentBrickSet(voGeometryActions::findClosestAxisIndex(
            modelMatrix, projMatrix, voSamplingModeScope::AXIS_ALIGNED));
    int BrickCount = aVolume->getCurrentBrickSet()->getBrickCount();
    int samplesNumber;
    float samplingPeriod[3] = {samplingRate, samplingRate, samplingRate};
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
    int polygons = 0;
    for (int brickNo = 0; brickNo < BrickCount; brickNo++) {
        int brickSortedNo = aSortAction[brickNo];
        for (int binNo = 0; binNo < samplesNumber; binNo++) {
            voIndexedFaceSetIterator iter(aPolygonSetArray[brickSortedNo][binNo]);
            for (; !iter.doneP(); iter.nextPrimitive())
                polygons++;
        }
    }
    return polygons;
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
    voError::setErrorHandler(NULL);
}

} // namespace

/// Sets a volume of size^3 up, cuts it once and cleans up. Returns the number of polygons.
int GUIDE_PROGRAM(int size, int brickSize, voInterpolationType interpolationType)
{
    voBrickSetCollection* aVolume = my_InitAppearance(size, brickSize, interpolationType);
    voIndexedTetraSet* aTetraSet = my_InitGeometry(aVolume);
    my_InitGfx(aTetraSet, aVolume);
    const int polygons = my_Polygonize(aTetraSet, aVolume);
    my_Cleanup(aTetraSet, aVolume);
    return polygons;
}
