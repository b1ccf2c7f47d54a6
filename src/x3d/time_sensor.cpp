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

double TimeSensor::elapsedAt(double now) const
{
    return std::max(0.0, (isPaused_ ? pausedAt_ : now) - start_ - pausedFor_);
}

/// A run without loop ends with the cycle that it was in when it was last looked at.
bool TimeSensor::ends(const Fields& fields, double now, double& elapsed) const
{
    const bool isStopped = fields.stopTime > start_ && now >= fields.stopTime;
    if (isStopped) elapsed = std::min(elapsed, fields.stopTime - start_ - pausedFor_);
    if (fields.loop) return isStopped || !fields.enabled;
    const double cycles = std::floor(lastElapsed_ / fields.cycleInterval) + 1;
    const bool isOver = elapsed >= cycles * fields.cycleInterval;
    if (isOver) elapsed = cycles * fields.cycleInterval;
    return isOver || isStopped || !fields.enabled;
}

void TimeSensor::pause(const Fields& fields, double now, std::vector<SceneEvent>& events)
{
    const bool isWanted = fields.pauseTime > start_ && now >= fields.pauseTime &&
                          (fields.resumeTime <= fields.pauseTime || now < fields.resumeTime);
    if (isWanted == isPaused_) return;
    if (isWanted)
        pausedAt_ = fields.pauseTime;
    else
        pausedFor_ += std::max(pausedAt_, std::min(now, fields.resumeTime)) - pausedAt_;
    isPaused_ = isWanted;
    send("isPaused", truthValue(isPaused_), events);
}

void TimeSensor::tell(const Fields& fields, double now, double elapsed, std::vector<SceneEvent>& events)
{
    const double cycles = elapsed / fields.cycleInterval;
    // The end of a cycle is 1, not the 0 of the next.
    const double whole = elapsed > 0 ? std::ceil(cycles) - 1 : 0;
    if (whole > lastCycle_) {
        send("cycleTime", timeValue(start_ + pausedFor_ + whole * fields.cycleInterval), events);
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
    if (!std::exchange(hasBegun_, true) && !now_.loop &&
        (now_.startTime <= 0 || now_.startTime + now_.cycleInterval <= now))
        spentStart_ = now_.startTime;
    isDue_ = false;
    const bool wasActive = isActive_;
    if (!isActive_) {
        if (!begins(now_, now)) return events;
        isActive_ = true;
        isPaused_ = false;
        start_ = now_.startTime;
        pausedFor_ = lastElapsed_ = 0;
        lastCycle_ = -1;
        send("isActive", truthValue(true), events);
    }
    const bool wasPaused = isPaused_;
    pause(now_, now, events);
    double elapsed = elapsedAt(now);
    const bool isOver = ends(now_, now, elapsed);
    if (!wasPaused || !isPaused_) tell(now_, now, elapsed, events);
    if (isOver && wasActive) {
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
