#include "expect_error.h"

#include <vo/utPerfMeter.h>

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>

namespace {

using namespace vo::test;

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

TEST(TimerTest, takesTimeMeasuredOtherwise)
{
    voutTimer timer;
    timer.add(1.5);
    timer.add(0.25);
    EXPECT_EQ(timer.getSeconds(), 1.75);
    timer.start();
    timer.add(1);
    timer.stop();
    EXPECT_GE(timer.getSeconds(), 2.75);
}

TEST(PerfMeterTest, hasATimerForEachPhase)
{
    voutPerfMeter meter;
    std::string names;
    for (int i = 0; i < voutPerfMeter::PHASE_COUNT; ++i) {
        const auto phase = static_cast<voutPerfMeter::Phase>(i);
        EXPECT_EQ(meter.getTimer(phase).getSeconds(), 0.0);
        meter.getTimer(phase).add(i + 1);
        names += std::string(voutPerfMeter::getName(phase)) + " ";
    }
    for (int i = 0; i < voutPerfMeter::PHASE_COUNT; ++i)
        EXPECT_EQ(meter.getTimer(static_cast<voutPerfMeter::Phase>(i)).getSeconds(), i + 1.0);
    EXPECT_EQ(names, "polygonize sort load draw ");
    expectNoError();
}

TEST(PerfMeterTest, printsPhasesAndFrames)
{
    voutPerfMeter meter;
    meter.getTimer(voutPerfMeter::POLYGONIZE).add(0.5);
    meter.getTimer(voutPerfMeter::DRAW).add(2);
    meter.countFrame();
    meter.countFrame();
    EXPECT_EQ(meter.getFrameCount(), 2);
    std::ostringstream printed;
    printed << meter;
    EXPECT_EQ(printed.str(), "polygonize 0.5 s, sort 0 s, load 0 s, draw 2 s, 2 frames");
    meter.reset();
    printed.str("");
    printed << meter;
    EXPECT_EQ(printed.str(), "polygonize 0 s, sort 0 s, load 0 s, draw 0 s, 0 frames");
}

TEST(PerfMeterTest, whatIsNoPhaseIsRefused)
{
    voutPerfMeter meter;
    const auto none = static_cast<voutPerfMeter::Phase>(7);
    EXPECT_EQ(&meter.getTimer(none), &meter.getTimer(voutPerfMeter::POLYGONIZE));
    expectBadValue("phase 7");
    EXPECT_STREQ(voutPerfMeter::getName(voutPerfMeter::PHASE_COUNT), "");
    expectBadValue("phase 4");
    const voutPerfMeter& constant = meter;
    EXPECT_EQ(&constant.getTimer(static_cast<voutPerfMeter::Phase>(-1)),
              &meter.getTimer(voutPerfMeter::POLYGONIZE));
    expectBadValue("phase -1");
}

} // namespace
