// A program as they were written in 2000, over the installed headers: docs/porting.md has the line that compiles it.
// Reads a volume, cuts it into slices and prints what it found; no window.
//
//   program_of_2000 FILE

#include <iostream.h>
#include <iomanip.h>
#include <vo/Volumizer.h>
#include <vo/CompatNames.h>
#include <ifl/iflFile.h>

static char *programName = "program_of_2000";
const int maxSamplesNumber = 256;

int brickNo;

void my_ExceptionHandler(void)
{
    cerr << programName << ": error " << voError::getErrorNumber() << ": " << voError::getErrorString() << endl;
    exit(1);
}

// The guide's loaders, pages 40 and 146.
int myGetVolumeSizesIfl(char *fileName, int &xSize, int &ySize, int &zSize, voExternalFormatType &diskDataFormat,
                        voDataType &dataType)
{
    iflStatus status;
    iflFile *file;
    if (!(file = iflFile::open(fileName, O_RDONLY, &status))) return 1;
    iflSize size;
    file->getDimensions(size);
    xSize = size.x, ySize = size.y, zSize = size.z;
    file->close();
    diskDataFormat = size.c == 4 ? RGBA : INTENSITY;
    dataType = file->getDataType() == iflUChar ? UNSIGNED_BYTE : UNSIGNED_SHORT;
    return 0;
}

int myReadBrickIfl(char *fileName, void *data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin, int xBrickSize,
                   int yBrickSize, int zBrickSize, int, int, int)
{
    iflStatus status;
    iflFile *file = iflFile::open(fileName, O_RDONLY, &status);
    if (status != iflOKAY) return 1;
    iflConfig config(file->getDataType(), iflInterleaved);
    status = file->getTile(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize, data, &config);
    file->close();
    return status != iflOKAY;
}

voBrickSetCollection *my_InitAppearance(char *dataFileName)
{
    int xVolumeSize, yVolumeSize, zVolumeSize;
    int xBrickSize, yBrickSize, zBrickSize;
    voExternalFormatType diskDataFormat, externalFormat;
    voInternalFormatType internalFormat;
    voDataType dataType;
    voInterpolationType interpolationType = 2; // as it came out of a file of settings
    if (myGetVolumeSizesIfl(dataFileName, xVolumeSize, yVolumeSize, zVolumeSize, diskDataFormat, dataType)) {
        cerr << programName << ": cannot read " << dataFileName << endl;
        exit(1);
    }
    xBrickSize = xVolumeSize / 2.0 + 1;
    yBrickSize = yVolumeSize;
    zBrickSize = zVolumeSize;
    voAppearanceActions::getBestParameters(interpolationType, MONOCHROME, dataType, diskDataFormat, internalFormat,
                                           externalFormat, xBrickSize, yBrickSize, zBrickSize);
    voBrickSetCollection *aVolume =
        new voBrickSetCollection(xVolumeSize, yVolumeSize, zVolumeSize, xBrickSize, yBrickSize, zBrickSize, AUGMENT, 1,
                                 internalFormat, externalFormat, dataType, interpolationType);
    long sum = 0;
    voBrickSetIterator brickSetIter(aVolume->getCurrentBrickSet());
    for (voBrick *brick; brick = brickSetIter();) {
        int x, y, z, xSize, ySize, zSize;
        unsigned char *vdata = voAppearanceActions::dataAlloc(brick);
        brick->getBrickSizes(x, y, z, xSize, ySize, zSize);
        if (myReadBrickIfl(dataFileName, vdata, x, y, z, xSize, ySize, zSize, xVolumeSize, yVolumeSize, zVolumeSize))
            exit(1);
        voAppearanceActions::dataConvert(brick, vdata, diskDataFormat);
        for (int i = 0; i < xSize * ySize * zSize; i++)
            sum += vdata[i];
    }
    cout << "voxels " << xVolumeSize << " x " << yVolumeSize << " x " << zVolumeSize << ", sum in bricks " << sum << endl;
    return aVolume;
}

voIndexedTetraSet *my_InitGeometry(voBrickSetCollection *aVolume)
{
    int x, y, z;
    aVolume->getCurrentBrickSet()->getVolumeSizes(x, y, z);
    static float vtxData[8][3];
    for (int i = 0; i < 8; i++) {
        vtxData[i][0] = i % 4 == 1 || i % 4 == 2 ? x : 0;
        vtxData[i][1] = i % 4 >= 2 ? y : 0;
        vtxData[i][2] = i >= 4 ? z : 0;
    }
    static int cubeIndices[] = {
        0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7,
    };
    return new voIndexedTetraSet((float *)vtxData, 8, 3, cubeIndices, 20);
}

int my_Polygonize(voIndexedTetraSet *aTetraSet, voBrickSetCollection *aVolume)
{
    GLdouble modelMatrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    GLdouble projMatrix[16] = {.01, 0, 0, 0, 0, .01, 0, 0, 0, 0, -.01, 0, 0, 0, 0, 1};
    int BrickCount = aVolume->getCurrentBrickSet()->getBrickCount(), samplesNumber;
    voVertexData *allVertexData = new voVertexData(100000, 3);
    voIndexedFaceSet ***aPolygonSetArray = new voIndexedFaceSetPtrPtr[BrickCount];
    for (brickNo = 0; brickNo < BrickCount; brickNo++) {
        aPolygonSetArray[brickNo] = new voIndexedFaceSetPtr[maxSamplesNumber];
        for (int j = 0; j < maxSamplesNumber; j++)
            aPolygonSetArray[brickNo][j] = new voIndexedFaceSet(allVertexData, 0);
    }
    float samplingPeriod[3] = {1, 1, 1};
    voGeometryActions::polygonize(aTetraSet, aVolume->getCurrentBrickSet(), _V3F, modelMatrix, projMatrix,
                                  VIEWPORT_ALIGNED, OBJECT, samplingPeriod, maxSamplesNumber, samplesNumber,
                                  aPolygonSetArray);
    voSortAction aSortAction(aVolume->getCurrentBrickSet(), modelMatrix, projMatrix);
    cout << setw(3) << samplesNumber << " slices, " << allVertexData->getCount() << " vertices, last brick "
         << aSortAction[BrickCount - 1] << endl;
    for (brickNo = 0; brickNo < BrickCount; brickNo++) {
        for (int j = 0; j < maxSamplesNumber; j++)
            delete aPolygonSetArray[brickNo][j];
        delete[] aPolygonSetArray[brickNo];
    }
    delete[] aPolygonSetArray;
    delete allVertexData;
    return samplesNumber;
}

main(int argc, char **argv)
{
    if (argc < 2) {
        cerr << "Usage: " << programName << " inFileName" << endl;
        return 1;
    }
    voError::setErrorHandler(my_ExceptionHandler);
    voBrickSetCollection *aVolume = my_InitAppearance(argv[1]);
    voIndexedTetraSet *aTetraSet = my_InitGeometry(aVolume);
    my_Polygonize(aTetraSet, aVolume);
    delete aTetraSet;
    delete aVolume;
    return 0;
}
