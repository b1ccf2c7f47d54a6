// The guide's chapter 8, pages 149 to 156.

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

#include "chapters.h"

namespace DIALECT {

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
