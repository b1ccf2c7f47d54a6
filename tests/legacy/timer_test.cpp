#include <vo/utPerfMeter.h>

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>

namespace {

/// Lasts until the clock has moved on.
void pass()
{
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::microseconds(10)) {
    }
}

TEST(TimerTest, beginsAtZero)
{
    EXPECT_EQ(voutTimer().getSeconds(), 0.0);
}

TEST(TimerTest, stretchesAddUp)
{
    voutTimer timer;
    timer.start();
    pass();
    timer.stop();
    const double first = timer.getSeconds();
    EXPECT_GT(first, 0.0);
    pass();
    EXPECT_EQ(timer.getSeconds(), first);
    timer.start();
    pass();
    EXPECT_GT(timer.getSeconds(), first);
    timer.stop();
    EXPECT_GT(timer.getSeconds(), first);
}

TEST(TimerTest, startWhileRunningAndStopWhileStoppedDoNothing)
{
    voutTimer timer;
    timer.stop();
    EXPECT_EQ(timer.getSeconds(), 0.0);
    timer.start();
    pass();
    const double running = timer.getSeconds();
    timer.start();
    EXPECT_GE(timer.getSeconds(), running);
    timer.stop();
    const double stopped = timer.getSeconds();
    timer.stop();
    EXPECT_EQ(timer.getSeconds(), stopped);
}

TEST(TimerTest, resetGoesBackToZero)
{
    voutTimer timer;
    timer.start();
    pass();
    timer.reset();
    EXPECT_EQ(timer.getSeconds(), 0.0);
}

TEST(TimerTest, printsSeconds)
{
    voutTimer timer;
    timer.start();
    pass();
    timer.stop();
    std::ostringstream printed, expected;
    printed << timer;
    expected << timer.getSeconds();
    EXPECT_EQ(printed.str(), expected.str());
}

} // namespace
