#include "expect_error.h"
#include "face_scene.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <climits>
#include <type_traits>

namespace {

using namespace vo::test;
using Format = voInterleavedArrayTypeScope;

// Vertex records.

TEST(VertexDataTest, ownStorageBeginsEmpty)
{
    const voVertexData data(10, 6);
    EXPECT_EQ(data.getCount(), 0);
    EXPECT_EQ(data.getCountMax(), 10);
    EXPECT_EQ(data.getValuesPerVertex(), 6);
    EXPECT_NE(data.getDataPtr(), nullptr);
}

TEST(VertexDataTest, callersStorageIsUsedByReferenceAndFull)
{
    float values[12] = {};
    {
        voVertexData data(4, 3, values);
        EXPECT_EQ(data.getCount(), 4);
        EXPECT_EQ(data.getDataPtr(), values);
        data[2][1] = 5;
    }
    EXPECT_EQ(values[7], 5);
}

TEST(VertexDataTest, recordsLieOneAfterAnother)
{
    voVertexData data(5, 7);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(data[i], data.getDataPtr() + 7 * i);
}

TEST(VertexDataTest, recordsMayBeWrittenBeforeTheCountIsSet)
{
    voVertexData data(2, 3);
    data[1][2] = 4;
    data.setCount(2);
    EXPECT_EQ(data[1][2], 4);
    expectNoError();
}

TEST(VertexDataTest, subscriptOutsideIsBadValueAndNull)
{
    voVertexData data(2, 3);
    const voVertexData& constant = data;
    for (const int i : {-1, 2, INT_MAX, INT_MIN}) {
        EXPECT_EQ(data[i], nullptr);
        expectBadValue();
        EXPECT_EQ(constant[i], nullptr);
        expectBadValue();
    }
}

TEST(VertexDataTest, emptyKeepsStorageAndCapacity)
{
    voVertexData data(2, 3);
    data.setCount(2);
    const float* storage = data.getDataPtr();
    data.empty();
    EXPECT_EQ(data.getCount(), 0);
    EXPECT_EQ(data.getCountMax(), 2);
    EXPECT_EQ(data.getDataPtr(), storage);
}

TEST(VertexDataTest, countOutsideCapacityIsBadValue)
{
    voVertexData data(2, 3);
    data.setCount(1);
    for (const int count : {3, -1, INT_MAX}) {
        data.setCount(count);
        expectBadValue();
        EXPECT_EQ(data.getCount(), 1);
    }
}

TEST(VertexDataTest, badSizesMakeAnEmptyArray)
{
    for (const auto& [count, values] : {std::pair(-1, 3), std::pair(3, 0), std::pair(3, -2)}) {
        const voVertexData data(count, values);
        expectBadValue();
        EXPECT_EQ(data.getCountMax(), 0);
        EXPECT_GE(data.getValuesPerVertex(), 1);
    }
}

TEST(VertexDataTest, moreThanMemoryHasIsOutOfMemory)
{
    const voVertexData data(INT_MAX, INT_MAX);
    expectError(voErrorTypeScope::OUT_OF_MEMORY, "memory");
    EXPECT_EQ(data.getCountMax(), 0);
}

// Indices.

TEST(IndicesTest, entriesAreWritableBeforeTheCountIsSet)
{
    voIndices indices(3);
    EXPECT_EQ(indices.getCount(), 0);
    indices[2] = 7;
    indices.setCount(3);
    EXPECT_EQ(indices[2], 7);
    EXPECT_EQ(indices.getDataPtr()[2], 7);
    indices.empty();
    EXPECT_EQ(indices.getCount(), 0);
    EXPECT_EQ(indices.getCountMax(), 3);
}

TEST(IndicesTest, callersStorageIsUsedByReferenceAndFull)
{
    int values[3] = {1, 2, 3};
    voIndices indices(3, values);
    EXPECT_EQ(indices.getCount(), 3);
    indices[0] = 9;
    EXPECT_EQ(values[0], 9);
}

TEST(IndicesTest, subscriptOutsideIsBadValueAndHarmless)
{
    voIndices indices(3);
    indices[3] = 5;
    expectBadValue();
    indices[-1] = 5;
    expectBadValue();
    const voIndices& constant = indices;
    (void)constant[INT_MAX];
    expectBadValue();
    indices.setCount(4);
    expectBadValue();
    const voIndices negative(-4);
    expectBadValue();
    EXPECT_EQ(negative.getCountMax(), 0);
}

// Sets.

TEST(IndexedSetTest, isAbstractAndContainersCannotBeCopied)
{
    EXPECT_TRUE(std::is_abstract_v<voIndexedSet>);
    EXPECT_TRUE(std::is_abstract_v<voIndexedSetIterator>);
    EXPECT_FALSE(std::is_copy_constructible_v<voIndexedFaceSet>);
    EXPECT_FALSE(std::is_copy_constructible_v<voVertexData>);
    EXPECT_TRUE((std::is_same_v<voFaceSet, voIndexedFaceSet>));
    EXPECT_TRUE((std::is_same_v<decltype(new voIndexedFaceSetPtrPtr[2]), voIndexedFaceSet***>));
}

TEST(IndexedSetTest, subscriptFollowsTheIndexEntry)
{
    CubeArrays cube(4);
    voIndexedTetraSet set(&cube.vertices[0][0], 8, 3, cube.indices, 20);
    EXPECT_EQ(set[1], &cube.vertices[2][0]);
    EXPECT_EQ(set[19], &cube.vertices[7][0]);
    EXPECT_EQ(set[20], nullptr);
    expectBadValue("index entry 20");
    (*set.getIndices())[3] = 8;
    EXPECT_EQ(set[3], nullptr);
    expectBadValue("vertex 8");
}

// Face sets.

const float kTriangle[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const float kSquare[] = {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};

float* unchanging(const float* data)
{
    return const_cast<float*>(data); // appendPoly copies
}

TEST(FaceSetTest, appendPolyWritesACountAndTheVertexNumbers)
{
    voIndexedFaceSet faces(7, 3, 9);
    faces.appendPoly(unchanging(kTriangle), 3);
    faces.appendPoly(unchanging(kSquare), 4);
    const voIndices& indices = *faces.getIndices();
    const std::vector<int> entries(indices.getDataPtr(), indices.getDataPtr() + indices.getCount());
    EXPECT_EQ(entries, (std::vector<int>{3, 0, 1, 2, 4, 3, 4, 5, 6}));
    EXPECT_EQ(faces.getVertexData()->getCount(), 7);
    EXPECT_EQ((*faces.getVertexData())[6][1], 1);
    expectNoError();
}

TEST(FaceSetTest, appendPolyWithoutDataAddsIndicesOfTheNextRecords)
{
    voVertexData shared(10, 3);
    voIndexedFaceSet faces(&shared, 0);
    shared[0][0] = 5;
    faces.appendPoly(NULL, 3);
    EXPECT_EQ(shared.getCount(), 3);
    EXPECT_EQ(shared[0][0], 5);
    faces.appendPoly(shared[3], 4);
    EXPECT_EQ(shared.getCount(), 7);
    EXPECT_EQ(faces.getIndices()->getCount(), 9);
    EXPECT_EQ((*faces.getIndices())[5], 3);
    expectNoError();
}

TEST(FaceSetTest, appendPolyGrowsOwnStorage)
{
    voIndexedFaceSet faces(0, 3, 0);
    for (int i = 0; i < 1000; ++i)
        faces.appendPoly(unchanging(kSquare), 4);
    expectNoError();
    EXPECT_EQ(faces.getVertexData()->getCount(), 4000);
    EXPECT_EQ(polygonsOf(faces).size(), 1000u);
}

TEST(FaceSetTest, appendPolyTakesItsOwnRecordsWhileTheyMove)
{
    voIndexedFaceSet faces(3, 3, 0);
    faces.appendPoly(unchanging(kTriangle), 3);
    for (int i = 0; i < 10; ++i)
        faces.appendPoly((*faces.getVertexData())[0], 3);
    for (const auto& polygon : polygonsOf(faces))
        EXPECT_EQ(polygon[2][1], 1);
    expectNoError();
}

TEST(FaceSetTest, fullSharedStorageIsOutOfMemory)
{
    voVertexData shared(5, 3);
    voIndexedFaceSet faces(&shared, 0);
    faces.appendPoly(unchanging(kTriangle), 3);
    faces.appendPoly(unchanging(kSquare), 4);
    expectError(voErrorTypeScope::OUT_OF_MEMORY, "no room for 4 vertices, 3 of 5");
    EXPECT_EQ(shared.getCount(), 3);
    EXPECT_EQ(faces.getIndices()->getCount(), 4);
}

TEST(FaceSetTest, polygonsNeedThreeVertices)
{
    voIndexedFaceSet faces(10, 3, 10);
    for (const int count : {2, 0, -1, INT_MIN}) {
        faces.appendPoly(unchanging(kTriangle), count);
        expectBadValue();
    }
    EXPECT_EQ(faces.getIndices()->getCount(), 0);
}

TEST(FaceSetTest, emptyResetsOwnVerticesAndLeavesSharedOnes)
{
    voIndexedFaceSet own(3, 3, 4);
    own.appendPoly(unchanging(kTriangle), 3);
    own.empty();
    EXPECT_EQ(own.getVertexData()->getCount(), 0);
    EXPECT_EQ(own.getIndices()->getCount(), 0);

    voVertexData shared(6, 3);
    voIndexedFaceSet one(&shared, 0), other(&shared, 0);
    one.appendPoly(unchanging(kTriangle), 3);
    other.appendPoly(unchanging(kTriangle), 3);
    one.empty();
    EXPECT_EQ(one.getIndices()->getCount(), 0);
    EXPECT_EQ(shared.getCount(), 6);
    EXPECT_EQ(polygonsOf(other).size(), 1u);
}

TEST(FaceSetTest, deletingASetLeavesSharedVertices)
{
    voVertexData shared(6, 3);
    voIndexedSet* faces = new voIndexedFaceSet(&shared, 0);
    static_cast<voIndexedFaceSet*>(faces)->appendPoly(unchanging(kTriangle), 3);
    delete faces;
    EXPECT_EQ(shared[1][0], 1);
}

TEST(FaceSetTest, missingSharedVerticesAreBadValue)
{
    voIndexedFaceSet faces(static_cast<voVertexData*>(NULL), 3);
    expectBadValue("vertexData is NULL");
    EXPECT_NE(faces.getVertexData(), nullptr);
    const voIndexedFaceSet negative(-1, -1, -1);
    expectBadValue();
    EXPECT_NE(negative.getIndices(), nullptr);
}

TEST(FaceSetIteratorTest, visitsPolygonsInTheOrderOfAppending)
{
    voIndexedFaceSet faces(7, 3, 9);
    faces.appendPoly(unchanging(kTriangle), 3);
    faces.appendPoly(unchanging(kSquare), 4);
    const auto polygons = polygonsOf(faces);
    ASSERT_EQ(polygons.size(), 2u);
    EXPECT_EQ(polygons[0].size(), 3u);
    EXPECT_EQ(polygons[1].size(), 4u);
    EXPECT_EQ(polygons[1][2], (std::array<float, 3>{1, 1, 1}));
}

TEST(FaceSetIteratorTest, donePIsTrueOnceAllWasTraversedAndDoneIsTheSame)
{
    voIndexedFaceSet faces(3, 3, 4);
    voIndexedFaceSetIterator none(&faces);
    EXPECT_EQ(none.doneP(), VO_TRUE);
    EXPECT_EQ(none.nextVertex(), nullptr);
    faces.appendPoly(unchanging(kTriangle), 3);
    voIndexedFaceSetIterator next(&faces);
    EXPECT_EQ(next.doneP(), VO_FALSE);
    EXPECT_EQ(next.done(), VO_FALSE);
    next.nextPrimitive();
    EXPECT_EQ(next.doneP(), VO_TRUE);
    EXPECT_EQ(next.done(), VO_TRUE);
    next.nextPrimitive();
    EXPECT_EQ(next.doneP(), VO_TRUE);
}

TEST(FaceSetIteratorTest, nextPrimitiveRestartsTheVertices)
{
    voIndexedFaceSet faces(6, 3, 8);
    faces.appendPoly(unchanging(kTriangle), 3);
    faces.appendPoly(unchanging(kTriangle), 3);
    voIndexedFaceSetIterator next(&faces);
    next.nextVertex();
    next.nextPrimitive();
    EXPECT_EQ(next.nextVertex(), (*faces.getVertexData())[3]);
}

TEST(FaceSetIteratorTest, indicesThatAreNoGroupsEndIt)
{
    for (const int count : {-1, -5, 4, INT_MAX, INT_MIN}) {
        voIndexedFaceSet faces(6, 3, 8);
        faces.appendPoly(unchanging(kTriangle), 3);
        (*faces.getIndices())[0] = count;
        voIndexedFaceSetIterator next(&faces);
        EXPECT_EQ(next.doneP(), VO_TRUE);
        EXPECT_EQ(next.nextVertex(), nullptr);
        next.nextPrimitive();
    }
    voIndexedFaceSetIterator nothing(NULL);
    EXPECT_EQ(nothing.doneP(), VO_TRUE);
}

// Tetrahedra.

TEST(TetraSetTest, arraysAreUsedByReferenceAndFull)
{
    CubeArrays cube(4);
    voIndexedTetraSet set(&cube.vertices[0][0], 8, 3, cube.indices, 20);
    EXPECT_EQ(set.getVertexData()->getDataPtr(), &cube.vertices[0][0]);
    EXPECT_EQ(set.getIndices()->getDataPtr(), cube.indices);
    EXPECT_EQ(set.getVertexData()->getCount(), 8);
    EXPECT_EQ(set.getIndices()->getCount(), 20);
}

TEST(TetraSetTest, constantArraysAreCopied)
{
    const CubeArrays cube(4);
    voIndexedTetraSet set(&cube.vertices[0][0], 8, 3, cube.indices, 20);
    EXPECT_NE(set.getVertexData()->getDataPtr(), &cube.vertices[0][0]);
    EXPECT_EQ(set.getVertexData()->getCount(), 8);
    EXPECT_EQ(set[1][0], 4);
    expectNoError();
}

TEST(TetraSetTest, emptySetIsFilledThroughItsParts)
{
    voIndexedTetraSet set(4, 3, 4);
    EXPECT_EQ(set.getVertexData()->getCount(), 0);
    for (int i = 0; i < 4; ++i) {
        (*set.getVertexData())[i][2] = float(i);
        (*set.getIndices())[i] = 3 - i;
    }
    set.getVertexData()->setCount(4);
    set.getIndices()->setCount(4);
    EXPECT_EQ(set[0][2], 3);
    set.empty();
    EXPECT_EQ(set.getIndices()->getCount(), 0);
    expectNoError();
}

TEST(TetraSetTest, partsAreBorrowed)
{
    voVertexData vertices(4, 3);
    voIndices indices(4);
    {
        const voIndexedTetraSet set(&vertices, &indices);
        EXPECT_EQ(set.getVertexData(), &vertices);
        EXPECT_EQ(set.getIndices(), &indices);
    }
    vertices[3][0] = 1;
    const voIndexedTetraSet missing(&vertices, NULL);
    expectBadValue();
    EXPECT_NE(missing.getIndices(), nullptr);
}

TEST(TetraSetTest, indexCountMustBeAMultipleOfFour)
{
    CubeArrays cube(4);
    const voIndexedTetraSet set(&cube.vertices[0][0], 8, 3, cube.indices, 18);
    expectBadValue("multiple of 4");
    EXPECT_EQ(set.getIndices()->getCount(), 16);
    const CubeArrays constant(4);
    const voIndexedTetraSet copied(&constant.vertices[0][0], 8, 3, constant.indices, 18);
    expectBadValue("multiple of 4");
    EXPECT_EQ(copied.getIndices()->getCount(), 0);
}

TEST(TetraSetTest, badArraysAndCountsAreRefused)
{
    const CubeArrays cube(4);
    const voIndexedTetraSet none(static_cast<const float*>(NULL), 8, 3, cube.indices, 20);
    expectBadValue("NULL");
    const voIndexedTetraSet negative(&cube.vertices[0][0], -8, 3, cube.indices, -20);
    expectBadValue();
    const voIndexedTetraSet noValues(&cube.vertices[0][0], 8, 0, cube.indices, 20);
    expectBadValue();
    EXPECT_EQ(noValues.getVertexData()->getCount(), 0);
}

TEST(TetraSetIteratorTest, givesFourVerticesAPrimitive)
{
    CubeArrays cube(4);
    voIndexedTetraSet set(&cube.vertices[0][0], 8, 3, cube.indices, 20);
    int tetras = 0;
    for (voIndexedTetraSetIterator next(&set); !next.doneP(); next.nextPrimitive(), ++tetras) {
        EXPECT_EQ(next.nextVertex(), &cube.vertices[cube.indices[4 * tetras]][0]);
        int rest = 0;
        while (next.nextVertex())
            ++rest;
        EXPECT_EQ(rest, 3);
    }
    EXPECT_EQ(tetras, 5);
}

// Free functions.

TEST(GeometryFunctionsTest, boundFaceCountIsElevenATetrahedron)
{
    EXPECT_EQ(boundFaceCount(0), 0);
    EXPECT_EQ(boundFaceCount(5), 55);
    expectNoError();
    for (const int count : {-1, INT_MAX, INT_MIN}) {
        EXPECT_EQ(boundFaceCount(count), 0);
        expectBadValue();
    }
}

TEST(GeometryFunctionsTest, textureComponentIsInTheT3fLayouts)
{
    for (const int format : {Format::T3F_V3F, Format::T3F_C3F_V3F, Format::T3F_C4F_V3F})
        EXPECT_EQ(hasTextureComponent(static_cast<voInterleavedArrayType>(format)), VO_TRUE);
    for (const int format :
         {Format::DEFAULT, Format::V3F, Format::C3F_V3F, Format::C4F_V3F, Format::USER_V3F})
        EXPECT_EQ(hasTextureComponent(static_cast<voInterleavedArrayType>(format)), VO_FALSE);
    expectNoError();
    EXPECT_EQ(hasTextureComponent(static_cast<voInterleavedArrayType>(7)), VO_FALSE);
    expectBadEnum();
}

TEST(GeometryFunctionsTest, valuesPerVertexOfEachLayout)
{
    EXPECT_EQ(getValuesPerVertex(Format::DEFAULT), 3);
    EXPECT_EQ(getValuesPerVertex(Format::V3F), 3);
    EXPECT_EQ(getValuesPerVertex(Format::T3F_V3F), 6);
    EXPECT_EQ(getValuesPerVertex(Format::C3F_V3F), 6);
    EXPECT_EQ(getValuesPerVertex(Format::C4F_V3F), 7);
    EXPECT_EQ(getValuesPerVertex(Format::T3F_C3F_V3F), 9);
    EXPECT_EQ(getValuesPerVertex(Format::T3F_C4F_V3F), 10);
    expectNoError();
    EXPECT_EQ(getValuesPerVertex(Format::USER_V3F), 0);
    expectBadValue("USER_V3F");
    EXPECT_EQ(getValuesPerVertex(static_cast<voInterleavedArrayType>(-2)), 0);
    expectBadEnum();
}

} // namespace
