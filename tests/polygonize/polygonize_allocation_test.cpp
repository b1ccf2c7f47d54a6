#include "frame/polygon_cache.h"
#include "polygonize/polygonize.h"

#include "scenes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size)
{
    ++allocations;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}

} // namespace

// Every allocation of the library goes through these.
void* operator new(std::size_t size)
{
    return counted(size);
}
void* operator new[](std::size_t size)
{
    return counted(size);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
    ++allocations;
    const auto step = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
    std::free(memory);
}
void operator delete[](void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace {

struct CountingSink : vo::FaceSink
{
    long faces = 0;
    bool append(int, int, std::span<const float>) override
    {
        ++faces;
        return true;
    }
};

long allocationsOfOneTurn(const scenes::TetraSet& set, std::span<const vo::Box> boxes,
                          vo::PolygonizeWorkspace& workspace)
{
    CountingSink sink;
    long inside = 0;
    for (int view = 0; view < 36; ++view) {
        const vo::Camera camera = scenes::camera(64, gl_matrices::rotate(10.0 * view, {1, 2, 0.5}), view % 2);
        for (const vo::SamplingSpace space : {vo::SamplingSpace::object, vo::SamplingSpace::primitive}) {
            vo::SamplingRequest request = scenes::everyVoxel();
            request.space = space;
            const long before = allocations;
            vo::polygonize(set.view(), boxes, camera, request, workspace, sink);
            inside += allocations - before;
        }
    }
    EXPECT_GT(sink.faces, 0);
    return inside;
}

} // namespace

TEST(PolygonizeAllocation, secondTurnAllocatesNothing)
{
    const scenes::TetraSet set = scenes::jitteredLattice(3, -4, 68, 0.1, 2).withValues(7);
    const std::vector<vo::Box> boxes = scenes::bricks(3, 64);
    vo::PolygonizeWorkspace workspace;
    EXPECT_GT(allocationsOfOneTurn(set, boxes, workspace), 0) << "the first turn fills the workspace";
    EXPECT_EQ(allocationsOfOneTurn(set, boxes, workspace), 0);
}

TEST(PolygonizeAllocation, secondTurnOfFramesAllocatesNothing)
{
    const std::vector<vo::Box> boxes = scenes::bricks(3, 64);
    for (const scenes::TetraSet& set :
         {scenes::cube(64), scenes::cube(64).withValues(7), scenes::jitteredLattice(3, -4, 68, 0.1, 2)}) {
        vo::PolygonCache cache;
        long turns[2]{};
        for (long& inside : turns)
            for (int view = 0; view < 36; ++view) {
                const glm::dmat4 turn = gl_matrices::rotate(10.0 * view, {1, 2, 0.5});
                const vo::Camera camera = scenes::camera(64, turn, view % 2);
                const long before = allocations;
                EXPECT_TRUE(cache.update({set.view(), boxes, camera, scenes::everyVoxel()}, 0.0));
                inside += allocations - before;
            }
        EXPECT_GT(turns[0], 0);
        EXPECT_EQ(turns[1], 0);
    }
}
