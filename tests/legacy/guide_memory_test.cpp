// The set-up and clean-up of the guide (pages 70 to 82), again and again: the sanitizers see what is left
// over.

#include "expect_error.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <thread>

int guideProgram20(int size, int brickSize, voInterpolationType interpolationType);

namespace {

using namespace vo::test;

TEST(GuideMemoryTest, setUpAndCleanUpLeaveNothing)
{
    const int first = guideProgram20(12, 6, voInterpolationTypeScope::_3D);
    EXPECT_GT(first, 12);
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(guideProgram20(12, 6, voInterpolationTypeScope::_3D), first);
        EXPECT_GT(guideProgram20(9, 4, voInterpolationTypeScope::_2D), 9);
    }
    expectNoError();
}

TEST(GuideMemoryTest, constructorsThatFailLeaveNothing)
{
    for (int i = 0; i < 10; ++i) {
        const voBrickSetCollection volume(
            -1, 0, 0, 0, 0, 0, voPartialBrickTypeScope::TRUNCATE, 0, voInternalFormatTypeScope::DEFAULT,
            voExternalFormatTypeScope::DEFAULT, voDataTypeScope::DEFAULT, voInterpolationTypeScope::_2D);
        const voIndexedTetraSet tetras(static_cast<voVertexData*>(NULL), NULL);
        const voIndexedFaceSet faces(static_cast<voVertexData*>(NULL), -1);
        const voLookupTablePost table(0, -1, 0, 0);
        const voDrawActionCache cache(NULL, NULL, 0, voSamplingModeScope::SPHERICAL, 0, 0);
    }
    voError::getErrorNumber();
    voError::getErrorString();
}

TEST(GuideMemoryTest, objectsMayBeDeletedInAnyOrder)
{
    for (int i = 0; i < 3; ++i) {
        auto* vertices = new voVertexData(100, 3);
        auto* faces = new voIndexedFaceSet(vertices, 0);
        auto* tetras = new voIndexedTetraSet(4, 3, 4);
        auto* volume = new voBrickSetCollection(
            8, 8, 8, 4, 4, 4, voPartialBrickTypeScope::AUGMENT, 1, voInternalFormatTypeScope::DEFAULT,
            voExternalFormatTypeScope::DEFAULT, voDataTypeScope::DEFAULT, voInterpolationTypeScope::_3D);
        voAppearanceActions::dataAlloc(volume->getCurrentBrickSet());
        auto* cache = new voDrawActionCache(tetras, volume, 16, voSamplingModeScope::DEFAULT, 3, 100);
        double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        auto* order = new voSortAction(volume->getCurrentBrickSet(), matrix, matrix);
        delete vertices;
        delete volume;
        delete tetras;
        cache->invalidate();
        cache->setThreshold(1);
        EXPECT_GE((*order)[0], 0);
        delete cache;
        delete order;
        delete faces;
    }
    expectNoError();
}

TEST(GuideMemoryTest, threadsWorkOnVolumesOfTheirOwn)
{
    int polygons[2] = {0, 0};
    const auto work = [](int* count) {
        for (int i = 0; i < 5; ++i) {
            double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -4, -4, -4, 1};
            double projection[16] = {0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, -0.1, 0, 0, 0, 0, 1};
            const float corners[] = {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8};
            const int indices[] = {0, 1, 2, 3};
            voIndexedTetraSet tetras(corners, 4, 3, indices, 4);
            voBrickSetCollection volume(
                8, 8, 8, 4, 4, 4, voPartialBrickTypeScope::AUGMENT, 1, voInternalFormatTypeScope::DEFAULT,
                voExternalFormatTypeScope::DEFAULT, voDataTypeScope::DEFAULT, voInterpolationTypeScope::_3D);
            voBrickSet* set = volume.getCurrentBrickSet();
            voIndexedFaceSet faces(0, 3, 0);
            voIndexedFaceSet* row[] = {&faces};
            std::vector<voIndexedFaceSet**> rows(static_cast<std::size_t>(set->getBrickCount()), row);
            int samples = 1;
            voGeometryActions::polygonize(&tetras, set, matrix, projection, voSamplingModeScope::DEFAULT,
                                          voSamplingSpaceScope::DEFAULT, samples, NULL, rows.data());
            voIndexedFaceSetIterator next(&faces);
            for (*count = 0; !next.doneP(); next.nextPrimitive())
                ++*count;
            EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::NO_ERROR);
        }
    };
    std::thread one(work, &polygons[0]), two(work, &polygons[1]);
    one.join();
    two.join();
    EXPECT_GT(polygons[0], 0);
    EXPECT_EQ(polygons[0], polygons[1]);
}

} // namespace
