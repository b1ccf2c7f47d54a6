// The guide's chapter 8, pages 149 to 156.

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

#include "chapters.h"

namespace DIALECT {

static void drawPlane(float planeEquation[4], voIndexedTetraSet* aTetraSet, voBrick* aBrick)
{
    float brickLowerLeft[3], brickUpperRight[3];
    aBrick->getClipBrickSizes(brickLowerLeft, brickUpperRight);
    voIndexedFaceSet polygons(40, 3, 50);
    voIndexedTetraSetIterator iter(aTetraSet);
    for (; !iter.doneP(); iter.nextPrimitive()) {
        float tetraVerts[4][3];
        for (int i = 0; i < 4; i++)
            memcpy(tetraVerts[i], iter.nextVertex(), 3 * sizeof(float));
        voVertexData polygonVerts(4, 3);
        sample(tetraVerts, planeEquation, &polygonVerts);
        if (polygonVerts.getCount() > 0) clip(&polygonVerts, brickLowerLeft, brickUpperRight, &polygons);
    }
    voGeometryActions::draw(&polygons, voInterleavedArrayTypeScope::V3F);
}

void customDraw(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    GLdouble modelMatrix[16], projMatrix[16];
    glGetDoublev(GL_MODELVIEW_MATRIX, modelMatrix);
    glGetDoublev(GL_PROJECTION_MATRIX, projMatrix);
    float samplingPeriod[3] = {1, 1, 1};
    voSamplingPlaneSet aPlaneSet(aTetraSet, aVolume->currentBrickSet, modelMatrix, projMatrix,
                                 voSamplingModeScope::VIEWPORT_ALIGNED, voSamplingSpaceScope::OBJECT,
                                 samplingPeriod, 256);
    voAppearanceActions::textureEnable(aVolume->interpolationType);
    voAppearanceActions::texgenEnable();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    voGeometryActions::voSortAction aSortAction(aVolume->getCurrentBrickSet(), modelMatrix, projMatrix);
    int BrickCount = aVolume->currentBrickSet->getBrickCount();
    for (int brickNo = 0; brickNo < BrickCount; brickNo++) {
        int brickSortedNo = aSortAction[brickNo];
        voBrick* aBrick = aVolume->currentBrickSet->getBrick(brickSortedNo);
        voAppearanceActions::textureLoad(aBrick);
        voAppearanceActions::texgenSetEquation(aBrick);
        voSamplingPlaneSetIterator iter(&aPlaneSet);
        for (float* planeEquation; planeEquation = iter();)
            drawPlane(planeEquation, aTetraSet, aBrick);
    }
    voAppearanceActions::texgenDisable();
    voAppearanceActions::textureDisable(aVolume->interpolationType);
}

int visitInOrder(voBrickSetCollection* aVolume, GLdouble modelMatrix[16], GLdouble projMatrix[16])
{
    int BrickCount = aVolume->currentBrickSet->getBrickCount();
    int brickNo, sum = 0;
    voSortAction aSortAction(aVolume->getCurrentBrickSet(), modelMatrix, projMatrix);
    for (brickNo = 0; brickNo < BrickCount; brickNo++) {
        int brickSortedNo = aSortAction[brickNo];
        voBrick* aBrick = aVolume->currentBrickSet->getBrick(brickSortedNo);
        int x, y, z, xSize, ySize, zSize;
        aBrick->getBrickSizes(x, y, z, xSize, ySize, zSize);
        sum += (brickNo + 1) * z;
    }
    return sum;
}

void sliceAndClip(float planeEquation[4], float tetraVerts[4][3], voBrick* aBrick, voIndexedFaceSet* aFaceSet)
{
    float brickLowerLeft[3] = {0.5, 0.5, 0.5};
    float brickUpperRight[3] = {254.5, 254.5, 254.5};
    int valuesPerVertex = 3;
    voVertexData polygonVerts(4,
                              valuesPerVertex); // intermediate polygon verts; the guide has two names for it
    sample(tetraVerts, planeEquation, &polygonVerts);
    aBrick->getClipBrickSizes(brickLowerLeft, brickUpperRight);
    clip(&polygonVerts, brickLowerLeft, brickUpperRight, aFaceSet);
}

void clipToTenPlanes(voVertexData* polygonVerts, float* planes, voIndexedFaceSet* aFaceSet)
{
    voAppearanceActions::clip(polygonVerts, voInterleavedArrayTypeScope::V3F, planes, 10, aFaceSet);
}

void selectClosest(voBrickSetCollection* aVolume, GLdouble modelMatrix[16], GLdouble projMatrix[16])
{
    if (aVolume->interpolationType == voInterpolationTypeScope::_2D)
        aVolume->setCurrentBrickSet(
            findClosestAxisIndex(modelMatrix, projMatrix, voSamplingModeScope::AXIS_ALIGNED));
}

void drawWithMode(voIndexedFaceSet* aFaceSet, GLenum mode)
{
    voGeometryActions::draw(aFaceSet, mode, // GL_LINE or GL_FILL
                            voInterleavedArrayTypeScope::V3F);
}

float projectedArea(voIndexedFaceSet* aFaceSet, GLdouble modelMatrix[16], GLdouble projMatrix[16],
                    GLint viewport[4])
{
    return voGeometryActions::findProjectedArea(aFaceSet, modelMatrix, projMatrix, viewport);
}

} // namespace DIALECT
