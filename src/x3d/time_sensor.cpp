#include "x3d/time_sensor.h"

#include <algorithm>
#include <cmath>

#include "x3d/node_values.h"

namespace vo {
TimeSensor::Fields TimeSensor::fields() const
{
    return {boolOf(node_, "enabled"),     boolOf(node_, "loop"),       doubleOf(node_, "cycleInterval"),
            doubleOf(node_, "startTime"), doubleOf(node_, "stopTime"), doubleOf(node_, "pauseTime"),
            doubleOf(node_, "resumeTime")};
}

void TimeSensor::send(const char* field, FieldValue value, std::vector<SceneEvent>& events)
{
    events.push_back({&node_, node_.field(field)->slot, std::move(value)});
}

void TimeSensor::rewind()
{
    isActive_ = isPaused_ = isDue_ = hasBegun_ = false;
    spentStart_ = std::numeric_limits<double>::quiet_NaN();
}

bool TimeSensor::refuses(const FieldRow& row, const FieldValue& value) const
{
    if (!isActive_) return false;
    if (row.name == "startTime" || row.name == "cycleInterval") return true;
    return row.name == "stopTime" && std::get<std::vector<double>>(value).front() <= start_;
}

bool TimeSensor::begins(const Fields& fields, double now) const
{
    if (!fields.enabled || now < fields.startTime) return false;
    if (fields.stopTime > fields.startTime && now >= fields.stopTime) return false;
    return fields.loop || fields.startTime != spentStart_;
}

/// Of the first one. What is paused in it ends later by that, or not at all.
double TimeSensor::endOfCycle(const Fields& fields)
{
    const double end = fields.startTime + fields.cycleInterval;
    if (!(fields.pauseTime > fields.startTime && fields.pauseTime < end)) return end;
    if (fields.resumeTime <= fields.pauseTime) return std::numeric_limits<double>::infinity();
    return end + (fields.resumeTime - fields.pauseTime);
}

bool TimeSensor::isStopped(const Fields& fields, double now) const
{
    return fields.stopTime > start_ && now >= fields.stopTime;
}

double TimeSensor::elapsedAt(double now) const
{
    return std::max(0.0, (isPaused_ ? pausedAt_ : now) - start_ - pausedFor_);
}

/// A run without loop ends with the cycle that it was in when it was last looked at.
bool TimeSensor::ends(const Fields& fields, double now, double& elapsed) const
{
    const bool isEnded = isStopped(fields, now) || !fields.enabled;
    if (fields.loop) return isEnded;
    const double cycles = std::floor(lastElapsed_ / fields.cycleInterval) + 1;
    const bool isOver = elapsed >= cycles * fields.cycleInterval;
    if (isOver) elapsed = cycles * fields.cycleInterval;
    return isOver || isEnded;
}

void TimeSensor::pause(const Fields& fields, double now, std::vector<SceneEvent>& events)
{
    const bool isReached = fields.pauseTime > start_ && now >= fields.pauseTime;
    const bool isWanted = isReached && (fields.resumeTime <= fields.pauseTime || now < fields.resumeTime);
    const bool isLeapt = isReached && !isWanted && !isPaused_ && fields.pauseTime > lastSeen_;
    if (isLeapt) {
        leaptAt_ = fields.pauseTime - start_ - pausedFor_;
        leaptFor_ = fields.resumeTime - fields.pauseTime;
        pausedFor_ += leaptFor_;
    }
    lastSeen_ = now;
    if (isWanted == isPaused_) return;
    if (isWanted)
        pausedAt_ = fields.pauseTime;
    else
        pausedFor_ += std::max(pausedAt_, std::min(now, fields.resumeTime)) - pausedAt_;
    isPaused_ = isWanted;
    send("isPaused", truthValue(isPaused_), events);
}

/// On the clock. A pause delays the cycles behind it alone, and of those that begin as it does the next.
double TimeSensor::beginOfCycle(const Fields& fields, double number) const
{
    const double elapsed = number * fields.cycleInterval;
    return start_ + elapsed + pausedFor_ - (elapsed < leaptAt_ ? leaptFor_ : 0.0);
}

void TimeSensor::tell(const Fields& fields, double now, double elapsed, std::vector<SceneEvent>& events)
{
    const double cycles = elapsed / fields.cycleInterval;
    // The end of a cycle is 1, not the 0 of the next.
    const double whole = elapsed > 0 ? std::ceil(cycles) - 1 : 0;
    if (whole > lastCycle_) {
        send("cycleTime", timeValue(beginOfCycle(fields, whole)), events);
        lastCycle_ = whole;
    }
    send("fraction_changed", std::vector<float>{static_cast<float>(cycles - whole)}, events);
    send("elapsedTime", timeValue(elapsed), events);
    send("time", timeValue(now), events);
}

std::vector<SceneEvent> TimeSensor::advance(double now)
{
    std::vector<SceneEvent> events;
    const Fields now_ = fields();
    if (!std::exchange(hasBegun_, true) && !now_.loop && (now_.startTime <= 0 || endOfCycle(now_) <= now))
        spentStart_ = now_.startTime;
    isDue_ = false;
    const bool wasActive = isActive_;
    if (!isActive_) {
        if (!begins(now_, now)) return events;
        isActive_ = true;
        isPaused_ = false;
        start_ = lastSeen_ = now_.startTime;
        pausedFor_ = lastElapsed_ = leaptAt_ = leaptFor_ = 0;
        lastCycle_ = -1;
        send("isActive", truthValue(true), events);
    }
    const bool wasPaused = isPaused_;
    const double seen = isStopped(now_, now) ? now_.stopTime : now;
    pause(now_, seen, events);
    double elapsed = elapsedAt(seen);
    const bool isOver = ends(now_, now, elapsed);
    if (!wasPaused || !isPaused_) tell(now_, now, elapsed, events);
    const bool isNewlyPaused = isPaused_ && !wasPaused;
    if (isOver && wasActive && !isNewlyPaused) {
        isActive_ = false;
        spentStart_ = now_.startTime;
        if (std::exchange(isPaused_, false)) send("isPaused", truthValue(false), events);
        send("isActive", truthValue(false), events);
        return events;
    }
    isDue_ = isOver;
    if (!isOver) lastElapsed_ = elapsed;
    return events;
}

} // namespace vo
