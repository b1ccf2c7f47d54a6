// The sample program of the guide's chapter 4 (pages 67 to 92), written afresh after its text: what a program
// of 1998 looks like to the library. In place of the Motif window: a framebuffer without a window
// (chapter4_screen.h), and the view from the command line instead of the mouse.
//
//   chapter4_program FILE LATITUDE LONGITUDE PICTURE

#include <stdio.h>
#include <stdlib.h>

#include <vo/GeometryActions.h>
#include <vo/AppearanceActions.h>

#include <GL/gl.h>

#include "chapter4_screen.h"

// --- the volume (glwSimpleVolume) ---

extern int myGetVolumeSizesIfl(char* fileName, int& xSize, int& ySize, int& zSize,
                               voExternalFormatType& diskDataFormat, voDataType& dataType);
extern int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                          int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                          int zVolumeSize);

extern float modelScale[3];

int maxBrickCount = 0;
int maxSamplesNumber = 256;
float samplingRate = 1.0;
voInterleavedArrayType interleavedArrayFormat = voInterleavedArrayTypeScope::V3F;

voVertexData* allVertexData;
voIndexedFaceSet*** aPolygonSetArray;

void my_ExceptionHandler(void)
{
    fprintf(stderr, "OpenGL Volumizer error %d: %s\n", voError::getErrorNumber(), voError::getErrorString());
    exit(2); // beyond the guide: an error here must not pass for a picture
}

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
    if (voError::getErrorNumber() != voErrorTypeScope::NO_ERROR) {
        fprintf(stderr, "%s", voError::getErrorString());
        exit(1);
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
        int xBrickOrigin, yBrickOrigin, zBrickOrigin;
        void* vdata = brick->getDataPtr();
        brick->getBrickSizes(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize);
        myReadBrickIfl(dataFileName, vdata, xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize,
                       zBrickSize, xVolumeSize, yVolumeSize, zVolumeSize);
        voAppearanceActions::dataConvert(brick, vdata, diskDataFormat);
        voAppearanceActions::dataScaleRange(brick, loValue, hiValue);
    }
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        voAppearanceActions::volumeMakeTransposed(aVolume);

    voBrickSetCollectionIterator aCollectionIterator(aVolume);
    voBrickSet* aBrickSet;
    for (int j1 = 0; (aBrickSet = aCollectionIterator()); j1++)
        if (j1 == 0 || aBrickSet->getBrickCount() > maxBrickCount) maxBrickCount = aBrickSet->getBrickCount();

    maxSamplesNumber = xVolumeSize;
    if (maxSamplesNumber < yVolumeSize) maxSamplesNumber = yVolumeSize;
    if (maxSamplesNumber < zVolumeSize) maxSamplesNumber = zVolumeSize;
    maxSamplesNumber *= 2;
    return aVolume;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume)
{
    voError::setErrorHandler(my_ExceptionHandler);

    int xVolumeSize, yVolumeSize, zVolumeSize;
    aVolume->getCurrentBrickSet()->getVolumeSizes(xVolumeSize, yVolumeSize, zVolumeSize);

    // The guide writes the sizes into the braces as they are; C++11 wants the conversion said.
    const float xEnd = (float)xVolumeSize, yEnd = (float)yVolumeSize, zEnd = (float)zVolumeSize;
    static float vtxData[8][3] = {
        {0, 0, 0},    {xEnd, 0, 0},    {xEnd, yEnd, 0},    {0, yEnd, 0},
        {0, 0, zEnd}, {xEnd, 0, zEnd}, {xEnd, yEnd, zEnd}, {0, yEnd, zEnd},
    };
    static int cubeIndices[] = {
        0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7,
    };
    int tetraCount = sizeof(cubeIndices) / (VO_TETRA_VERTICES * sizeof(cubeIndices[0]));
    int valuesPerVtx = sizeof(vtxData[0]) / sizeof(float);
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet((float*)vtxData, 8, valuesPerVtx, cubeIndices, 20);

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

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    GLboolean wireframe = GL_TRUE;
    int brickNo;
    GLdouble modelMatrix[16], projMatrix[16];
    glGetDoublev(GL_MODELVIEW_MATRIX, modelMatrix);
    glGetDoublev(GL_PROJECTION_MATRIX, projMatrix);

    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        aVolume->setCurrentBrickSet(voGeometryActions::findClosestAxisIndex(
            modelMatrix, projMatrix, voSamplingModeScope::AXIS_ALIGNED));
    int BrickCount = aVolume->getCurrentBrickSet()->getBrickCount();

    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
    if (wireframe == GL_TRUE) {
        glColor4f(1.0, 1.0, 0.0, 1.0);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        voGeometryActions::draw(aTetraSet, interleavedArrayFormat);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        if (aVolume->getInterpolationType() == voInterpolationTypeScope::_3D) {
            glColor4f(0.0, 0.0, 1.0, 1.0);
            for (brickNo = 0; brickNo < BrickCount; brickNo++)
                voGeometryActions::draw(aVolume->getCurrentBrickSet()->getBrick(brickNo));
        }
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }

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

    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColor4f(1.0, 1.0, 1.0, 1.0);
    glDepthMask(GL_FALSE);

    for (brickNo = 0; brickNo < BrickCount; brickNo++) {
        int brickSortedNo = aSortAction[brickNo];
        voBrick* aBrick = aVolume->getCurrentBrickSet()->getBrick(brickSortedNo);
        if (!hasTextureComponent(interleavedArrayFormat)) voAppearanceActions::texgenSetEquation(aBrick);
        voAppearanceActions::textureBind(aBrick);
        for (int binNo = 0; binNo < samplesNumber; binNo++) {
            voGeometryActions::draw(aPolygonSetArray[brickSortedNo][binNo], interleavedArrayFormat);
        }
    }

    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
    voAppearanceActions::texgenDisable();
    glDepthMask(GL_TRUE);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    for (int j1 = 0; j1 < maxBrickCount; j1++) {
        for (int j2 = 0; j2 < maxSamplesNumber + 1; j2++)
            delete aPolygonSetArray[j1][j2];
        delete[] aPolygonSetArray[j1]; // the guide forgets the brackets
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

// --- the main program (glwSimpleMain) ---

voIndexedTetraSet* aTetraSet;
voBrickSetCollection* aVolume;

// For a volume of 80 x 80 x 40 voxels: what the guide's numbers are for its own.
float modelCentroid[3] = {40.0, 40.0, 20.0};
float modelSize[3] = {50.0, 50.0, 48.0};
float modelScale[3] = {1.0, 1.0, 1.0};

float latitude = 0, longitude = 0;

void Draw()
{
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.0, 0.0, 0.0, 1.0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glRotated(-latitude - 90, 1.0, 0.0, 0.0);
    glRotated(-longitude, 0.0, 0.0, 1.0);
    glScalef(modelScale[0], modelScale[1], modelScale[2]);
    glTranslatef(-modelCentroid[0], -modelCentroid[1], -modelCentroid[2]);
    my_DrawVolume(aTetraSet, aVolume);
}

void Expose(int width, int height)
{
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glViewport(0, 0, width, height);
    glOrtho(-modelSize[0] * 1.2, modelSize[0] * 1.2, -modelSize[1] * 1.2, modelSize[1] * 1.2,
            -modelSize[2] * 2.5, modelSize[2] * 2.5);
    glMatrixMode(GL_MODELVIEW);
    Draw();
}

int main(int argc, char** argv)
{
    fprintf(stderr, "%s\n", voVersion());
    if (argc != 5) {
        fprintf(stderr, "Usage: %s FILE LATITUDE LONGITUDE PICTURE\n", argv[0]);
        return 1;
    }
    latitude = (float)atof(argv[2]);
    longitude = (float)atof(argv[3]);

    aVolume = my_InitAppearance(argc, argv);
    aTetraSet = my_InitGeometry(aVolume);
    if (!openScreen(400, 400)) return 1;
    my_InitGfx(aTetraSet, aVolume);
    Expose(400, 400);
    my_Cleanup(aTetraSet, aVolume);
    return writeScreen(argv[4]) ? 0 : 1;
}
