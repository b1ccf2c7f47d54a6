#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace {

TEST(Parallel, everyNumberComesOnce)
{
    for (const int threads : {0, 1, 2, 7}) {
        std::vector<std::atomic<int>> calls(1000);
        vo::parallelFor(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
        for (const std::atomic<int>& count : calls)
            EXPECT_EQ(count, 1) << threads << " threads";
    }
}

TEST(Parallel, exceptionComesOut)
{
    for (const int threads : {1, 2})
        EXPECT_THROW(vo::parallelFor(100, threads,
                                     [](std::size_t i) {
                                         if (i == 50) throw std::runtime_error("50");
                                     }),
                     std::runtime_error);
}

TEST(Parallel, environmentLowersTheNumberOfThreads)
{
    const int machine = vo::usualThreads();
    setenv("VO_THREADS", "1", 1);
    EXPECT_EQ(vo::usualThreads(), 1);
    for (const char* nonsense : {"0", "-1", "two", "1x", "", "100000"}) {
        setenv("VO_THREADS", nonsense, 1);
        EXPECT_EQ(vo::usualThreads(), machine) << nonsense;
    }
    unsetenv("VO_THREADS");
}

} // namespace
