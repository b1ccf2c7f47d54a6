#pragma once

#include <limits>

#include "x3d/scene.h"

namespace vo {

/// An event that leaves a field.
struct SceneEvent
{
    Node* from = nullptr;
    std::size_t slot = 0;
    FieldValue value;
};

/// The time sensor of a scene whose time begins at 0. With loop it has run since its startTime; without, what
/// began at 0 or before is over, as is what ended before the first time that is told.
class TimeSensor
{
public:
    explicit TimeSensor(Node& sensor) : node_(sensor) {}

    /// What it sends at a time, which does not go back; all of one time stamp. Where the time leaps over the
    /// whole of a run, or into a pause in which it stops, isDue afterwards: the end has a time stamp of its
    /// own. A pause that the time leaps over is not sent, and does not elapse.
    std::vector<SceneEvent> advance(double now);
    bool isDue() const { return isDue_; }
    bool isActive() const { return isActive_; }
    /// Back to the beginning of the scene's time.
    void rewind();
    /// Its startTime was set: it begins then, even if that is when it began before.
    void arm() { hasBegun_ = true, spentStart_ = std::numeric_limits<double>::quiet_NaN(); }
    /// Whether a field may not be set to this value while it runs.
    bool refuses(const FieldRow& row, const FieldValue& value) const;

private:
    struct Fields
    {
        bool enabled, loop;
        double cycleInterval, startTime, stopTime, pauseTime, resumeTime;
    };
    Fields fields() const;
    static double endOfCycle(const Fields& fields);
    bool begins(const Fields& fields, double now) const;
    bool ends(const Fields& fields, double now, double& elapsed) const;
    bool isStopped(const Fields& fields, double now) const;
    double elapsedAt(double now) const;
    double beginOfCycle(const Fields& fields, double number) const;
    void pause(const Fields& fields, double now, std::vector<SceneEvent>& events);
    void tell(const Fields& fields, double now, double elapsed, std::vector<SceneEvent>& events);
    void send(const char* field, FieldValue value, std::vector<SceneEvent>& events);

    Node& node_;
    bool isActive_ = false, isPaused_ = false, isDue_ = false, hasBegun_ = false;
    double start_ = 0, pausedAt_ = 0, pausedFor_ = 0, lastElapsed_ = 0;
    /// The latest pause that the time leapt over: what had elapsed before, and its length.
    double leaptAt_ = 0, leaptFor_ = 0;
    double lastSeen_ = 0;   ///< of the run, at most its stopTime
    double lastCycle_ = -1; // a whole number
    /// The startTime of a run that is over.
    double spentStart_ = std::numeric_limits<double>::quiet_NaN();
};

} // namespace vo
