// The guide's chapter 3, pages 36 to 65.

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>
#include <vo/LookupTable.h>
#include <vo/CompatNames.h>

#include "chapters.h"

// Page 40, the form of page 43, and page 41.
extern int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                          int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                          int zVolumeSize);
extern int myReadBrickIfl(char* fileName, void* data, int minX, int minY, int minZ, int xBrickSize,
                          int yBrickSize, int zBrickSize);
extern int myReadBrickRaw(char** fileNames, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                          int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                          int zVolumeSize, int headerLength, int bytesPerVoxel);

namespace DIALECT {

static void allocateBricks(voBrickSetCollection* aVolume)
{
    voBrickSetCollectionIterator collectionIter(aVolume);
    // iterate over all brick sets in the brick set collection
    for (voBrickSet* brickSet; brickSet = collectionIter();) {
        // iterate over all bricks within the brick set
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; brick = brickSetIter();)
            voAppearanceActions::dataAlloc(brick);
    }
    aVolume->setCurrentBrickSet(voPlaneOrientationScope::XY);
}

static void readBricks(voBrickSetCollection* aVolume, char* dataFileName, int size,
                       voExternalFormatType diskDataFormat)
{
    int xVolumeSize = size, yVolumeSize = size, zVolumeSize = size;
    float loValue = -1.0, hiValue = -1.0;
    voBrickSetIterator brickSetIter(aVolume->getCurrentBrickSet());
    for (voBrick* brick; brick = brickSetIter();) {
        int xBrickOrigin, yBrickOrigin, zBrickOrigin;
        int xBrickSize, yBrickSize, zBrickSize;
        void* vdata = brick->getDataPtr();
        brick->getBrickSizes(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize);
        myReadBrickIfl(dataFileName, vdata, xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize,
                       zBrickSize, xVolumeSize, yVolumeSize, zVolumeSize);
        voAppearanceActions::dataConvert(brick, vdata, diskDataFormat);
        voAppearanceActions::dataScaleRange(brick, loValue, hiValue);
    }
}

voBrickSetCollection* readVolume(char* dataFileName, int size, int brickSize,
                                 voInterpolationType interpolationType, voExternalFormatType wanted)
{
    voRenderingMode renderingMode = voRenderingModeScope::MONOCHROME;
    voDataType dataType = voDataTypeScope::UNSIGNED_BYTE;
    voExternalFormatType diskDataFormat = voExternalFormatTypeScope::INTENSITY;
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    int xBrickSize = brickSize, yBrickSize = brickSize, zBrickSize = brickSize;
    voAppearanceActions::getBestParameters(interpolationType, renderingMode, dataType, diskDataFormat,
                                           internalFormat, externalFormat, xBrickSize, yBrickSize,
                                           zBrickSize);
    // what was suggested may be overwritten
    if (wanted != voExternalFormatTypeScope::DEFAULT) {
        externalFormat = wanted;
        internalFormat = voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT;
    }
    voBrickSetCollection* aVolume = new voBrickSetCollection(
        size, size, size, xBrickSize, yBrickSize, zBrickSize, voPartialBrickTypeScope::AUGMENT, 1,
        internalFormat, externalFormat, dataType, interpolationType);
    if (voError::getErrorNumber() != voErrorTypeScope::NO_ERROR)
        fprintf(stderr, "%s", voError::getErrorString());
    allocateBricks(aVolume);
    readBricks(aVolume, dataFileName, size, diskDataFormat);
    voAppearanceActions::volumeMakeTransposed(aVolume);
    voAppearanceActions::volumeOptimize(aVolume, voOptimizeVolumeTypeScope::BEST);
    return aVolume;
}

void convertThroughBuffer(char* fileName, voBrick* brick)
{
    int minX, minY, minZ, xBrickSize, yBrickSize, zBrickSize;
    brick->getBrickSizes(minX, minY, minZ, xBrickSize, yBrickSize, zBrickSize);
    // IO buffer
    unsigned char data[4096];
    // allocate storage for a brick
    (void)voAppearanceActions::dataAlloc(brick);
    // read the data into buffer
    myReadBrickIfl(fileName, data, minX, minY, minZ, xBrickSize, yBrickSize, zBrickSize);
    // replicate to the desired externalFormat
    voAppearanceActions::dataConvert(brick, data, UNSIGNED_BYTE);
}

void convertInPlace(char* fileName, voBrick* brick)
{
    int minX, minY, minZ, xBrickSize, yBrickSize, zBrickSize;
    brick->getBrickSizes(minX, minY, minZ, xBrickSize, yBrickSize, zBrickSize);
    // allocate storage for each brick; the cast is not the guide's
    unsigned char* data = (unsigned char*)voAppearanceActions::dataAlloc(brick);
    // read the data; OK to use brick data area as a temporary buffer
    myReadBrickIfl(fileName, data, minX, minY, minZ, xBrickSize, yBrickSize, zBrickSize);
    // replicate to the desired externalFormat
    voAppearanceActions::dataConvert(brick, data, _DATA_TYPE_UNSIGNED_BYTE);
}

void lendMemory(voBrick* brick, unsigned char* memory)
{
    brick->setDataPtr(memory);
}

int readRaw(char** fileNames, voBrick* brick, int size)
{
    int xBrickOrigin, yBrickOrigin, zBrickOrigin;
    int xBrickSize, yBrickSize, zBrickSize;
    brick->getBrickSizes(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize);
    return myReadBrickRaw(fileNames, voAppearanceActions::dataAlloc(brick), xBrickOrigin, yBrickOrigin,
                          zBrickOrigin, xBrickSize, yBrickSize, zBrickSize, size, size, size, 16, 1);
}

voIndexedTetraSet* makeCube(int size)
{
    float xSize = size, ySize = size, zSize = size;
    // copied by nobody: the arrays outlive the set
    static float cubeVertices[8 * 3];
    float corners[] = {
        0, 0, 0,     xSize, 0, 0,     xSize, ySize, 0,     0, ySize, 0,
        0, 0, zSize, xSize, 0, zSize, xSize, ySize, zSize, 0, ySize, zSize,
    };
    memcpy(cubeVertices, corners, sizeof corners);
    static int cubeIndices[] = {
        0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7,
    };
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(cubeVertices, 8, 3, cubeIndices, 20);
    return aTetraSet;
}

static voVertexData* allVertexData;
static voIndexedFaceSet*** aPolygonSetArray;
static int maxBrickCount;

static void allocateTransient(voBrickSetCollection* aVolume, int maxSamplesNumber)
{
    maxBrickCount = 0;
    voBrickSetCollectionIterator aCollectionIterator(aVolume);
    voBrickSet* aBrickSet;
    for (int j1 = 0; aBrickSet = aCollectionIterator(); j1++)
        if (j1 == 0 || aBrickSet->getBrickCount() > maxBrickCount) maxBrickCount = aBrickSet->getBrickCount();
    allVertexData = new voVertexData(100000, 3);
    aPolygonSetArray = new voIndexedFaceSetPtrPtr[maxBrickCount];
    for (int j1 = 0; j1 < maxBrickCount; j1++) {
        aPolygonSetArray[j1] = new voIndexedFaceSetPtr[maxSamplesNumber + 1];
        for (int j2 = 0; j2 < maxSamplesNumber + 1; j2++)
            aPolygonSetArray[j1][j2] = new voIndexedFaceSet(allVertexData, boundFaceCount(5));
    }
}

static void freeTransient(int maxSamplesNumber)
{
    // free storage for TRANSIENT geometry; the brackets of the second delete are not the guide's
    for (int j1 = 0; j1 < maxBrickCount; j1++) {
        for (int j2 = 0; j2 < maxSamplesNumber + 1; j2++)
            delete aPolygonSetArray[j1][j2];
        delete[] aPolygonSetArray[j1];
    }
    delete[] aPolygonSetArray;
    delete allVertexData;
}

static void drawPolygons(voBrickSetCollection* aVolume, voSortAction& aSortAction, int samplesNumber,
                         voInterleavedArrayType interleavedArrayFormat)
{
    int BrickCount = aVolume->getCurrentBrickSet()->getBrickCount();
    int brickNo;
    // Iterate over all bricks.
    for (brickNo = 0; brickNo < BrickCount; brickNo++) {
        int brickSortedNo = aSortAction[brickNo];
        voBrick* aBrick = aVolume->getCurrentBrickSet()->getBrick(brickSortedNo);
        // Update texgen equation for the current brick.
        if (!hasTextureComponent(interleavedArrayFormat)) voAppearanceActions::texgenSetEquation(aBrick);
        // load the texture from host to texture memory
        voAppearanceActions::textureBind(aBrick);
        // iterate over all sampling planes
        for (int binNo = 0; binNo < samplesNumber; binNo++) {
            voGeometryActions::draw(aPolygonSetArray[brickSortedNo][binNo], interleavedArrayFormat);
        }
    }
}

int drawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume,
               voInterleavedArrayType interleavedArrayFormat, int maxSamplesNumber, float samplingRate)
{
    allocateTransient(aVolume, maxSamplesNumber);
    GLdouble modelMatrix[16];
    GLdouble projMatrix[16];
    glGetDoublev(GL_MODELVIEW_MATRIX, modelMatrix);
    glGetDoublev(GL_PROJECTION_MATRIX, projMatrix);
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        aVolume->setCurrentBrickSet(voGeometryActions::findClosestAxisIndex(
            modelMatrix, projMatrix, voSamplingModeScope::AXIS_ALIGNED));
    int samplesNumber = maxSamplesNumber;
    float samplingPeriod[3] = {samplingRate, samplingRate, samplingRate};
    voSamplingMode samplingMode = aVolume->getInterpolationType() == voInterpolationTypeScope::_3D
                                      ? voSamplingModeScope::VIEWPORT_ALIGNED
                                      : voSamplingModeScope::AXIS_ALIGNED;
    voGeometryActions::polygonize(aTetraSet, aVolume->getCurrentBrickSet(), modelMatrix, projMatrix,
                                  samplingMode, voSamplingSpaceScope::OBJECT, samplesNumber, samplingPeriod,
                                  aPolygonSetArray);
    voSortAction aSortAction(aVolume->getCurrentBrickSet(), modelMatrix, projMatrix);
    voAppearanceActions::textureEnable(aVolume->getInterpolationType());
    if (!hasTextureComponent(interleavedArrayFormat)) voAppearanceActions::texgenEnable();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    drawPolygons(aVolume, aSortAction, samplesNumber, interleavedArrayFormat);
    if (!hasTextureComponent(interleavedArrayFormat)) voAppearanceActions::texgenDisable();
    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
    freeTransient(maxSamplesNumber);
    return samplesNumber;
}

voLookupTable* enableTable(float* lookupEntries)
{
    // FLOAT, as printed, is a type in the headers of Windows
    voTextureLookupPost* aLookupTable =
        new voTextureLookupPost(LUMINANCE8_ALPHA8_EXT, 256, LUMINANCE_ALPHA, _DATA_TYPE_FLOAT, lookupEntries);
    for (int j1 = 0; j1 < 256; j1++)
        lookupEntries[2 * j1] = lookupEntries[2 * j1 + 1] = 0.5 * (float)j1 / 256.0;
    aLookupTable->load();
    aLookupTable->enable();
    return aLookupTable;
}

void rampInstead(voLookupTable* aLookupTable)
{
    aLookupTable->set(voTextureLookup::LINEAR, 195, 50);
    aLookupTable->load();
}

voLookupTable* suggestedTable(voBrickSetCollection* aVolume, float* lookupEntries,
                              voLookupTableType preferred)
{
    voLookupTable* aLookupTable;
    voLookupTableType lookupType = preferred; // preferred type
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    voDataType dataType;
    int lookupLength = 256;
    voLookupTable::getBestParameters(aVolume, MONOCHROME, lookupLength, lookupType, internalFormat,
                                     externalFormat, dataType);
    if (lookupType == PRE_INTERPOLATION)
        aLookupTable = new voLookupTablePre(internalFormat, lookupLength, externalFormat, _DATA_TYPE_FLOAT,
                                            lookupEntries);
    else
        aLookupTable = new voLookupTablePost(internalFormat, lookupLength, externalFormat, _DATA_TYPE_FLOAT,
                                             lookupEntries);
    aLookupTable->load();
    aLookupTable->enable();
    return aLookupTable;
}

static char printed[200];

static void fail()
{
    voBrickSetCollection nothing(0, 8, 8, 8, 8, 8, voPartialBrickTypeScope::TRUNCATE, 1,
                                 voInternalFormatTypeScope::DEFAULT, voExternalFormatTypeScope::DEFAULT,
                                 voDataTypeScope::DEFAULT, voInterpolationTypeScope::DEFAULT);
}

const char* testForError()
{
    printed[0] = 0;
    fail();
    if (voError::getErrorNumber() != voError::NO_ERROR)
        sprintf(printed, "voError %.150s\n", voError::getErrorString());
    return printed;
}

static void myExceptionHandler(void)
{
    // inform the user AND reset the error flags and messages
    int number = voError::getErrorNumber();
    sprintf(printed, "OpenGL Volumizer error %d: %.150s\n", number, voError::getErrorString());
}

const char* handleError()
{
    printed[0] = 0;
    void (*previous)(void) = voError::setErrorHandler(myExceptionHandler);
    fail();
    voError::setErrorHandler(previous);
    return printed;
}

void cleanUp(voBrickSetCollection* aVolume, voIndexedTetraSet* aTetraSet)
{
    // free all voxel data storage
    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; brickSet = collectionIter();) {
        // iterate over all bricks within the brickCollection
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; brick = brickSetIter();)
            voAppearanceActions::dataFree(brick);
    }
    // delete the volumetric object itself
    delete aVolume;
    delete aTetraSet;
}

} // namespace DIALECT
