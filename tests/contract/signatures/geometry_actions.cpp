// P: operations on geometry, sorting, caches (pages 50 to 58, 78 to 81, 97, 98, 118 to 127, 149 to 156, 160).

#include <vo/GeometryActions.h>

#include "rows.h"

namespace DIALECT {

typedef voGeometryActions Actions;

static void polygonizing()
{
    ROW(P1);
    is<int (*)(voIndexedTetraSet*, voBrickSet*, voInterleavedArrayType, GLdouble[16], GLdouble[16],
               voSamplingMode, voSamplingSpace, float[3], int, int&, voIndexedFaceSet***)>(
        &Actions::polygonize);
    ROW(P2);
    is<int (*)(voIndexedTetraSet*, voBrickSet*, GLdouble[16], GLdouble[16], voSamplingMode, voSamplingSpace,
               int&, float[3], voIndexedFaceSet***)>(&Actions::polygonize);
    ROW(P3);
    ROW(P4);
    ROW(P5);
    ROW(P6);
    ROW(P7);
    ROW(P8);
    ROW(P9);
    ROW(P10);
    is<int (*)(float[4], voBrickSet*, voIndexedFaceSet***, voInterleavedArrayType)>(&Actions::polygonizeMPR);
    ROW(P11);
    is<int (*)(voVertexData*, voBrickSet*, voIndexedFaceSet***, voInterleavedArrayType)>(
        &Actions::polygonizeMPR);
    ROW(P12);
    is<int (*)(float[4][3], float[4], voVertexData*)>(&Actions::sample);
    is<int (*)(float[4][3], float[4], voVertexData*)>(&sample);
    ROW(P13);
    is<int (*)(voVertexData*, voInterleavedArrayType, float[3], float[3], voIndexedFaceSet*)>(&Actions::clip);
    is<int (*)(voVertexData*, float[3], float[3], voIndexedFaceSet*)>(&Actions::clip);
    is<int (*)(voVertexData*, float[3], float[3], voIndexedFaceSet*)>(&clip);
    ROW(P14);
    is<int (*)(voVertexData*, voInterleavedArrayType, float*, int, voIndexedFaceSet*)>(&Actions::clip);
}

static void drawing()
{
    ROW(P15);
    is<void (*)(voIndexedFaceSet*, voInterleavedArrayType)>(&Actions::draw);
    ROW(P16);
    is<void (*)(voIndexedFaceSet*, GLenum, voInterleavedArrayType)>(&Actions::draw);
    ROW(P17);
    is<void (*)(voIndexedTetraSet*, voInterleavedArrayType)>(&Actions::draw);
    is<void (*)(voIndexedTetraSet*, GLenum, voInterleavedArrayType)>(&Actions::draw);
    ROW(P18);
    is<void (*)(voBrick*)>(&Actions::draw);
    ROW(P19);
    is<void (*)(voBrickSet*)>(&Actions::draw);
    ROW(P20);
    ROW(P21);
    is<int (*)(voIndexedTetraSet*, voInterleavedArrayType, voBrickSetCollection*, voDrawActionCache*,
               voSamplingSpace, float[3], voDecorationFlags)>(&Actions::drawUtility);
}

static void viewing()
{
    ROW(P22);
    is<voBool (*)(int[2], int[4], voIndexedTetraSet*, voBrickSet*, voInterleavedArrayType, GLdouble[16],
                  GLdouble[16], float[3], voBool, voVertexData*, void*)>(&Actions::pick);
    ROW(P23);
    is<voBool (*)(int[2], int[4], voIndexedTetraSet*, voBrick*, voInterleavedArrayType, GLdouble[16],
                  GLdouble[16], float[3], voBool, voVertexData*, void*)>(&Actions::pick);
    ROW(P24);
    is<voPlaneOrientation (*)(GLdouble[16], GLdouble[16], int)>(&Actions::findClosestAxisIndex);
    is<voPlaneOrientation (*)(GLdouble[16], GLdouble[16], int)>(&findClosestAxisIndex);
    ROW(P25);
    is<void (*)(double[3], double[4], GLdouble[16], GLdouble[16])>(&Actions::findCameraPosition);
    ROW(P26);
    is<void (*)(double[3], GLdouble[16], GLdouble[16])>(&Actions::findViewDirection);
    ROW(P27);
    is<float (*)(voIndexedFaceSet*, GLdouble[16], GLdouble[16], GLint[4])>(&Actions::findProjectedArea);
}

// A program's own surfaces.
class OneTriangle : public voSamplingSurfaceSet
{
public:
    virtual int getSurfaceCount() const { return 1; }
    virtual void getSurface(int, float lowerLeft[3], float*, voIndexedFaceSet* facets)
    {
        float vdata[9] = {lowerLeft[0], lowerLeft[1], lowerLeft[2], 8, 0, 0, 0, 8, 0};
        facets->appendPoly(vdata, 3);
    }
};

static void sortingAndCaching()
{
    ROW(P28);
    GLdouble modelMatrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    GLdouble projMatrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    voBrickSetCollection volume(
        8, 8, 8, 8, 8, 8, voPartialBrickTypeScope::TRUNCATE, 1, voInternalFormatTypeScope::INTENSITY8_EXT,
        voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    voBrickSetCollection* aVolume = &volume;
    voSortAction aSortAction(aVolume->getCurrentBrickSet(), modelMatrix, projMatrix);
    int brickNo = 0;
    int brickSortedNo = aSortAction[brickNo];
    is(brickSortedNo);
    ROW(P29);
    OneTriangle ownSurfaces;
    voSamplingSurfaceSet* surfaces = &ownSurfaces;
    is(surfaces->getSurfaceCount());
    is<int (*)(voIndexedTetraSet*, voBrickSet*, voInterleavedArrayType, voSamplingSurfaceSet*, int, int&,
               voIndexedFaceSet***)>(&Actions::polygonize);
    ROW(P30);
    float planeEquation[4] = {0, 0, 1, 0};
    voSamplingPlaneSet planes(planeEquation, 1, 8);
    voSamplingPlaneSetIterator planeIter(&planes);
    for (float* plane; plane = planeIter();)
        is(plane);
    ROW(P31);
    ROW(P32);
    voIndexedTetraSet tetras(8, 3, 20);
    voDrawActionCache cache(&tetras, aVolume, 256, voSamplingModeScope::VIEWPORT_ALIGNED,
                            tetras.getVertexData()->getValuesPerVertex(), 250000);
    voCache* base = &cache;
    is(base);
    ROW(P33);
    cache.setThreshold(2);
    cache.setThreshold(2.5f);
    cache.setThreshold(2.5);
    ROW(P34);
}

void geometryActions()
{
    polygonizing();
    drawing();
    viewing();
    sortingAndCaching();
}

} // namespace DIALECT
