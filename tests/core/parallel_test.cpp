#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr auto kForms = {vo::parallelFor, vo::parallelInOrder};

TEST(Parallel, everyNumberComesOnce)
{
    for (const auto form : kForms)
        for (const int threads : {0, 1, 2, 7})
            for (const std::size_t count : {0, 1, 3, 1000}) {
                std::vector<std::atomic<int>> calls(count);
                form(count, threads, [&](std::size_t i) { ++calls[i]; });
                for (const std::atomic<int>& called : calls)
                    EXPECT_EQ(called, 1) << threads << " threads, " << count << " numbers";
            }
}

TEST(Parallel, exceptionComesOut)
{
    for (const auto form : kForms)
        for (const int threads : {1, 2})
            EXPECT_THROW(form(100, threads,
                              [](std::size_t i) {
                                  if (i == 50) throw std::runtime_error("50");
                              }),
                         std::runtime_error);
}

TEST(Parallel, numbersBeginInOrder)
{
    for (const int threads : {1, 2, 7}) {
        std::atomic<int> begun{0};
        std::atomic<int> farthest{0};
        vo::parallelInOrder(2000, threads, [&](std::size_t i) {
            const int ahead = static_cast<int>(i) - begun++;
            for (int most = farthest; ahead > most && !farthest.compare_exchange_weak(most, ahead);) {
            }
            std::this_thread::yield();
        });
        EXPECT_EQ(begun, 2000);
        EXPECT_LT(farthest, threads) << "each other thread may have taken one and not begun it";
    }
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

/// In a process of its own, so that nothing has been told before.
TEST(ParallelDeathTest, unusableNumberOfThreadsIsToldOnce)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const std::string word : {"0", "-1", "abc", "2x", "1.5", "99999999999"})
        EXPECT_EXIT(
            {
                setenv("VO_THREADS", word.c_str(), 1);
                vo::parallelFor(10, 0, [](std::size_t) {});
                std::exit(vo::usualThreads() >= 1 ? 0 : 1);
            },
            testing::ExitedWithCode(0),
            testing::Eq("VO_THREADS: expected a whole number from 1 on, found \"" + word +
                        "\", which has no effect\n"));
    for (const char* word : {"", "1", "100000"})
        EXPECT_EXIT(
            {
                setenv("VO_THREADS", word, 1);
                std::exit(vo::usualThreads() >= 1 ? 0 : 1);
            },
            testing::ExitedWithCode(0), testing::Eq(""));
}

} // namespace
