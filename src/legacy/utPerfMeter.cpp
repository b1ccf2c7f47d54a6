#include "legacy/perf_meter.h"

#include "legacy/report.h"

#include <chrono>
#include <ostream>

using vo::guarded;

namespace {

double secondsNow()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr double kStopped = -1.0;

thread_local voutPerfMeter* enabledMeter = nullptr;

/// POLYGONIZE, having reported, for what is no phase.
int checkedPhase(const char* action, int phase)
{
    const int failed = guarded(action, [&] {
        if (phase < 0 || phase >= voutPerfMeter::PHASE_COUNT)
            vo::badValue("phase " + std::to_string(phase) + " is outside 0 to " +
                         std::to_string(voutPerfMeter::PHASE_COUNT - 1));
    });
    return failed ? 0 : phase;
}

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

void voutTimer::add(double seconds)
{
    total += seconds;
}

double voutTimer::getSeconds() const
{
    return started == kStopped ? total : total + secondsNow() - started;
}

std::ostream& operator<<(std::ostream& stream, const voutTimer& timer)
{
    return stream << timer.getSeconds();
}

struct voutPerfMeter::Private
{
    voutTimer timers[PHASE_COUNT];
    int frames = 0;
};

voutPerfMeter::voutPerfMeter() : d(new Private) {}

voutPerfMeter::~voutPerfMeter()
{
    disable();
    delete d;
}

void voutPerfMeter::enable()
{
    enabledMeter = this;
}

void voutPerfMeter::disable()
{
    if (enabledMeter == this) enabledMeter = nullptr;
}

voutTimer& voutPerfMeter::getTimer(Phase phase)
{
    return d->timers[checkedPhase("voutPerfMeter::getTimer", phase)];
}

const voutTimer& voutPerfMeter::getTimer(Phase phase) const
{
    return d->timers[checkedPhase("voutPerfMeter::getTimer", phase)];
}

const char* voutPerfMeter::getName(Phase phase)
{
    switch (phase) {
    case POLYGONIZE: return "polygonize";
    case SORT: return "sort";
    case LOAD: return "load";
    case DRAW: return "draw";
    case PHASE_COUNT: break;
    }
    checkedPhase("voutPerfMeter::getName", phase);
    return "";
}

void voutPerfMeter::countFrame()
{
    ++d->frames;
}

int voutPerfMeter::getFrameCount() const
{
    return d->frames;
}

void voutPerfMeter::reset()
{
    for (voutTimer& timer : d->timers)
        timer.reset();
    d->frames = 0;
}

std::ostream& operator<<(std::ostream& stream, const voutPerfMeter& meter)
{
    for (int i = 0; i < voutPerfMeter::PHASE_COUNT; ++i) {
        const auto phase = static_cast<voutPerfMeter::Phase>(i);
        stream << voutPerfMeter::getName(phase) << ' ' << meter.getTimer(phase) << " s, ";
    }
    return stream << meter.getFrameCount() << " frames";
}

namespace vo {

voutPerfMeter* currentMeter()
{
    return enabledMeter;
}

} // namespace vo
