#include <vo/utPerfMeter.h>

#include <chrono>
#include <ostream>

namespace {

double secondsNow()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr double kStopped = -1.0;

} // namespace

voutTimer::voutTimer() : total(0.0), started(kStopped) {}

void voutTimer::start()
{
    if (started == kStopped) started = secondsNow();
}

void voutTimer::stop()
{
    if (started == kStopped) return;
    total += secondsNow() - started;
    started = kStopped;
}

void voutTimer::reset()
{
    total = 0.0;
    started = kStopped;
}

double voutTimer::getSeconds() const
{
    return started == kStopped ? total : total + secondsNow() - started;
}

std::ostream& operator<<(std::ostream& stream, const voutTimer& timer)
{
    return stream << timer.getSeconds();
}
