// G: containers of geometry (pages 46 to 49, 76, 77, 102 to 110).

#include <vo/Geometry.h>

#include "rows.h"

namespace DIALECT {

static void arrays()
{
    ROW(G1);
    float values[8 * 3] = {0};
    voVertexData own(4, 3), borrowed(8, 3, values);
    ROW(G2); // a stack instance
    ROW(G3);
    own.empty();
    ROW(G4);
    is<float* (voVertexData::*)(int)>(&voVertexData::operator[]);
    own[3][2] = 1;
    ROW(G5);
    is<int (voVertexData::*)() const>(&voVertexData::getCount);
    is<void (voVertexData::*)(int)>(&voVertexData::setCount);
    ROW(G6);
    is<int (voVertexData::*)() const>(&voVertexData::getCountMax);
    ROW(G7);
    is<int (voVertexData::*)() const>(&voVertexData::getValuesPerVertex);
    ROW(G8);
    is<float* (voVertexData::*)()>(&voVertexData::getDataPtr);
    ROW(G9);
    int entries[4] = {0, 1, 2, 3};
    voIndices ownIndices(4), borrowedIndices(4, entries);
    ROW(G10);
    is<void (voIndices::*)()>(&voIndices::empty);
    is<int& (voIndices::*)(int)>(&voIndices::operator[]);
    is<void (voIndices::*)(int)>(&voIndices::setCount);
    is<int (voIndices::*)() const>(&voIndices::getCount);
    ownIndices[3] = 7;
}

static void sets(voIndexedSet* set, voIndexedSetIterator* next)
{
    ROW(G11);
    ROW(G12);
    voVertexData* vertices = set->getVertexData();
    voIndices* indices = set->getIndices();
    is(vertices);
    is(indices);
    ROW(G13);
    is<void (voIndexedSet::*)()>(&voIndexedSet::empty);
    ROW(G14);
    is<float* (voIndexedSet::*)(int)>(&voIndexedSet::operator[]);
    ROW(G15);
    ROW(G16);
    is<float* (voIndexedSetIterator::*)()>(&voIndexedSetIterator::nextVertex);
    ROW(G17);
    next->nextPrimitive();
    ROW(G18);
    voBool finished = next->doneP();
    finished = next->done();
    is(finished);
}

static void faceSets()
{
    ROW(G19);
    voVertexData* vertexData = new voVertexData(1000, 3);
    voIndexedFaceSet* aFaceSet1 = new voIndexedFaceSet(1000, 3, 5000);
    voIndexedFaceSet* aFaceSet2 = new voIndexedFaceSet(vertexData, 5000);
    voIndexedFaceSet* noRoom = new voIndexedFaceSet(vertexData, 0);
    ROW(G20);
    aFaceSet1->empty();
    ROW(G21);
    ROW(G22);
    float vdata[] = {
        100, 100, 100, 200, 100, 200, 200, 100, 0,
    };
    aFaceSet1->appendPoly(vdata, 3);
    aFaceSet1->appendPoly(NULL, 3);
    ROW(G23);
    voIndexedFaceSetIterator iter(aFaceSet1);
    sets(aFaceSet1, &iter);
    ROW(G24);
    delete aFaceSet1;
    delete aFaceSet2;
    delete noRoom;
    delete vertexData;
}

static void tetraSets()
{
    ROW(G25);
    static float cubeVertices[8 * 3];
    static int cubeIndices[20];
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(cubeVertices, 8, 3, cubeIndices, 20);
    const static float constantVertices[8 * 3] = {0};
    const static int constantIndices[20] = {0};
    voIndexedTetraSet copied(constantVertices, 8, 3, constantIndices, 20);
    ROW(G26);
    voIndexedTetraSet room(8, 3, 20);
    (*room.getVertexData())[7][2] = 1;
    (*room.getIndices())[19] = 7;
    room.getVertexData()->setCount(8);
    room.getIndices()->setCount(20);
    ROW(G27);
    voVertexData data(8, 3, cubeVertices);
    voIndices indices(20, cubeIndices);
    voIndexedTetraSet parts(&data, &indices);
    ROW(G28);
    ROW(G29);
    voIndexedTetraSetIterator tetras(aTetraSet);
    is(tetras.nextVertex());
    delete aTetraSet;
}

void geometry()
{
    arrays();
    faceSets();
    tetraSets();
    ROW(G30);
    voIndexedFaceSet*** aPolygonSetArray = new voIndexedFaceSetPtrPtr[2];
    aPolygonSetArray[0] = new voIndexedFaceSetPtr[3];
    delete[] aPolygonSetArray[0];
    delete[] aPolygonSetArray;
    ROW(G31);
    is<int (*)(int)>(&boundFaceCount);
    ROW(G32);
    is<voBool (*)(voInterleavedArrayType)>(&hasTextureComponent);
    ROW(G33);
    is<int (*)(voInterleavedArrayType)>(&getValuesPerVertex);
    ROW(G34);
    ROW(G35);
    voIndexedFaceSet polygons(4, 3, 5);
    voFaceSet* alias = &polygons;
    is(alias);
}

} // namespace DIALECT
