#include "support/malloc_counter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

namespace {

using vo::test::MallocCounter;

/// Keeps the compiler from leaving an allocation out.
void* volatile sink;

TEST(MallocCounter, countsNothingWhereNothingIsAllocated)
{
    std::vector<int> numbers;
    numbers.reserve(100);
    const MallocCounter counter;
    for (int i = 0; i < 100; ++i)
        numbers.push_back(i);
    EXPECT_EQ(counter.ofThisThread(), 0u);
}

TEST(MallocCounter, countsNewMallocCallocAndRealloc)
{
    const MallocCounter counter;
    sink = std::malloc(10);
    std::free(sink);
    EXPECT_EQ(counter.ofThisThread(), 1u);
    sink = std::calloc(10, 10);
    EXPECT_EQ(counter.ofThisThread(), 2u);
    sink = std::realloc(sink, 100000);
    std::free(sink);
    EXPECT_EQ(counter.ofThisThread(), 3u);
    sink = new int[100];
    delete[] static_cast<int*>(sink);
    EXPECT_EQ(counter.ofThisThread(), 4u);
    sink = std::aligned_alloc(64, 128);
    std::free(sink);
    EXPECT_EQ(counter.ofThisThread(), 5u);
}

TEST(MallocCounter, threadsCountApart)
{
    const MallocCounter counter;
    std::uint64_t ofOther = 0;
    std::thread other([&] {
        const MallocCounter inside;
        for (int i = 0; i < 1000; ++i) {
            sink = std::malloc(10);
            std::free(sink);
        }
        ofOther = inside.ofThisThread();
    });
    other.join();
    EXPECT_EQ(ofOther, 1000u);
    EXPECT_LT(counter.ofThisThread(), 100u);
    EXPECT_GE(counter.ofProcess(), 1000u);
}

} // namespace
