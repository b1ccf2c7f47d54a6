// The steady state of polygonize through the face, with containers as legacy programs make them: one shared
// array of vertices, face sets that begin without room for indices.

#include "expect_error.h"
#include "face_scene.h"

#include "support/malloc_counter.h"

#include <gtest/gtest.h>

namespace {

using namespace vo::test;

struct FaceAllocationTest : testing::Test
{
    /// Once round; returns the number of allocations.
    std::uint64_t turn(voSamplingMode mode)
    {
        const MallocCounter counter;
        for (int view = 0; view < 36; ++view) {
            Matrix model = rotation(10 * view, 0.3, 1, 0.2) * translation(-16, -16, -16);
            float period[3] = {1, 1, 1};
            int samples;
            EXPECT_EQ(voGeometryActions::polygonize(&tetras, volume->getCurrentBrickSet(),
                                                    voInterleavedArrayTypeScope::V3F, model, projection, mode,
                                                    voSamplingSpaceScope::OBJECT, period, faces.samples(),
                                                    samples, faces),
                      0);
        }
        return counter.ofThisThread();
    }

    std::unique_ptr<voBrickSetCollection> volume = byteVolume(32, 17);
    CubeArrays cube{32};
    voIndexedTetraSet tetras{&cube.vertices[0][0], 8, 3, cube.indices, 20};
    Matrix projection = ortho(32, -64, 64);
    FaceSets faces{volume->getCurrentBrickSet()->getBrickCount(), 64};
};

TEST_F(FaceAllocationTest, secondTurnAllocatesNothing)
{
    EXPECT_GT(turn(voSamplingModeScope::VIEWPORT_ALIGNED), 0u); // the counter counts
    EXPECT_EQ(turn(voSamplingModeScope::VIEWPORT_ALIGNED), 0u);
    turn(voSamplingModeScope::AXIS_ALIGNED);
    EXPECT_EQ(turn(voSamplingModeScope::AXIS_ALIGNED), 0u);
    expectNoError();
}

} // namespace
