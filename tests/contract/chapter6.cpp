// The guide's chapter 6, pages 102 to 127.

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

#include "chapters.h"

namespace DIALECT {

void useFaceSets(char* printed, int* vertexCounts)
{
    // new is not the guide's, nor are the loops' start and the last value of vdata
    voIndexedFaceSet* aFaceSet1 = new voIndexedFaceSet(1000, 3, 5000);
    voVertexData* vertexData = new voVertexData(1000, 3);
    voIndexedFaceSet* aFaceSet2 = new voIndexedFaceSet(vertexData, 5000);
    voIndexedFaceSetPtr aFaceSetArray[10];
    int i1;
    for (i1 = 0; i1 < 10; i1++)
        aFaceSetArray[i1] = new voIndexedFaceSet(vertexData, 5000);

    float vdata[] = {
        100, 100, 100, 200, 100, 200, 200, 100, 300,
    };
    aFaceSet1->appendPoly(vdata, 3);
    for (i1 = 0; i1 < 10; i1++)
        aFaceSetArray[i1]->appendPoly(vdata, 3);
    vertexCounts[0] = vertexData->getCount();

    int valuesPerVertex = 3;
    float* ptr;
    // doneP in place of done, since it stops when it is true
    for (voIndexedFaceSetIterator iter(aFaceSet1); !iter.doneP(); iter.nextPrimitive()) {
        while ((ptr = iter.nextVertex()) != NULL)
            printed += sprintf(printed, "(%f %f %f) ", ptr[valuesPerVertex - 3], ptr[valuesPerVertex - 2],
                               ptr[valuesPerVertex - 1]);
        printed += sprintf(printed, "\n");
    }

    for (i1 = 0; i1 < 10; i1++)
        aFaceSetArray[i1]->empty();
    vertexCounts[1] = vertexData->getCount();
    vertexData->empty();
    vertexCounts[2] = vertexData->getCount();

    for (i1 = 0; i1 < 10; i1++)
        delete aFaceSetArray[i1];
    delete aFaceSet2;
    delete vertexData;
    delete aFaceSet1;
}

voIndexedTetraSet* makeColouredCube()
{
    const static float VSizeX = 128;
    const static float VSizeY = 128;
    const static float VSizeZ = 128;
    static float vtxData[8 * 6] = {
        1,      0,      0, 0,      0, 0, 0,      1,      0,      VSizeX, 0, 0, 0, 0,      1,      VSizeX,
        VSizeY, 0,      0, 1,      1, 0, VSizeY, 0,      1,      0,      1, 0, 0, VSizeZ, 1,      1,
        0,      VSizeX, 0, VSizeZ, 1, 1, 1,      VSizeX, VSizeY, VSizeZ, 0, 1, 1, 0,      VSizeY, VSizeZ,
    };
    static int cubeIndeces[20] = {
        0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7,
    };
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(vtxData, 8, 6, cubeIndeces, 20);
    return aTetraSet;
}

// The area of polygons across z, and empties them.
static float areaOf(voIndexedFaceSet* faces)
{
    float area = 0;
    voIndexedFaceSetIterator iter(faces);
    for (; !iter.doneP(); iter.nextPrimitive()) {
        float *first = NULL, *before = NULL, *ptr;
        while ((ptr = iter.nextVertex()) != NULL) {
            if (!first) first = ptr;
            if (before)
                area += 0.5f * ((before[0] - first[0]) * (ptr[1] - first[1]) -
                                (ptr[0] - first[0]) * (before[1] - first[1]));
            before = ptr;
        }
    }
    faces->empty();
    return fabs(area);
}

static float sumOfAreas(voIndexedFaceSet*** polygonSet, int bricks)
{
    float sum = 0;
    for (int brickNo = 0; brickNo < bricks; brickNo++)
        sum += areaOf(polygonSet[brickNo][0]);
    return sum;
}

void crossSections(voBrickSet* aBrickSet, float height, float* planeArea, float* polygonArea)
{
    int bricks = aBrickSet->getBrickCount();
    int xV, yV, zV;
    aBrickSet->getVolumeSizes(xV, yV, zV);
    voIndexedFaceSet*** polygonSet = new voIndexedFaceSetPtrPtr[bricks];
    for (int j1 = 0; j1 < bricks; j1++) {
        polygonSet[j1] = new voIndexedFaceSetPtr[1];
        polygonSet[j1][0] = new voIndexedFaceSet(100, 3, 100);
    }
    voInterleavedArrayType interleavedArrayFormat = voInterleavedArrayTypeScope::V3F;
    float planeEquation[4] = {0, 0, 1, -height};
    voGeometryActions::polygonizeMPR(planeEquation, aBrickSet, polygonSet, interleavedArrayFormat);
    *planeArea = sumOfAreas(polygonSet, bricks);

    voVertexData vData(4, 3);
    float corners[4][3] = {{1, 1, height},
                           {(float)xV - 1, 1, height},
                           {(float)xV - 1, (float)yV - 1, height},
                           {1, (float)yV - 1, height}};
    for (int i = 0; i < 4; i++)
        memcpy(vData[i], corners[i], sizeof corners[i]);
    vData.setCount(4);
    voGeometryActions::polygonizeMPR(&vData, aBrickSet, polygonSet, interleavedArrayFormat);
    *polygonArea = sumOfAreas(polygonSet, bricks);

    for (int j1 = 0; j1 < bricks; j1++) {
        delete polygonSet[j1][0];
        delete[] polygonSet[j1];
    }
    delete[] polygonSet;
}

int pickVoxels(int x, int y, int windowSize, voIndexedTetraSet* tetraSet, voBrickSet* aBrickSet,
               voBrick* aBrick, unsigned char* voxels, float* positions)
{
    int pixelPosition[2] = {x, y};
    int viewport[4] = {0, 0, windowSize, windowSize};
    GLdouble modelMatrix[16];
    GLdouble projMatrix[16];
    glGetDoublev(GL_MODELVIEW_MATRIX, modelMatrix);
    glGetDoublev(GL_PROJECTION_MATRIX, projMatrix);
    float samplingPeriod[3] = {1, 1, 1};
    voVertexData coordinates(256, 3);
    voBool flag = VO_FALSE;
    voBool hit;
    if (aBrick == NULL)
        hit = voGeometryActions::pick(pixelPosition, viewport, tetraSet, aBrickSet,
                                      voInterleavedArrayTypeScope::V3F, modelMatrix, projMatrix,
                                      samplingPeriod, flag, &coordinates, voxels);
    else
        hit = voGeometryActions::pick(pixelPosition, viewport, tetraSet, aBrick,
                                      voInterleavedArrayTypeScope::V3F, modelMatrix, projMatrix,
                                      samplingPeriod, flag, &coordinates, voxels);
    if (hit != VO_TRUE) return 0;
    memcpy(positions, coordinates.getDataPtr(), coordinates.getCount() * 3 * sizeof(float));
    return coordinates.getCount();
}

void findCamera(GLdouble modelMatrix[16], GLdouble projMatrix[16], double eyePos[3], double viewDir[4],
                double onlyViewDir[3])
{
    voGeometryActions::findCameraPosition(eyePos, viewDir, modelMatrix, projMatrix);
    voGeometryActions::findViewDirection(onlyViewDir, modelMatrix, projMatrix);
}

} // namespace DIALECT
