#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <set>

#include "x3d/time_sensor.h"

namespace vo {

/// The events of a scene: sensors send them, routes carry them, and fields take them, so that who draws the
/// scene sees what they set. Output fields keep what they sent last.
class SceneEvents
{
public:
    /// The scene is borrowed. Nodes and routes may be added to it.
    explicit SceneEvents(Scene& scene) : scene_(scene) {}

    /// Lets it be `seconds` on the scene's clock, which begins at 0, and sends what time sensors send then.
    /// Where time goes back, sensors begin anew.
    void setTime(double seconds);
    double time() const { return time_; }
    /// Whether a time sensor runs.
    bool isRunning() const;

    /// Sends events out of fields at the present time, with one time stamp: a field sends one event for each,
    /// so that routes in a circle come to an end.
    void send(std::vector<SceneEvent> events);
    /// Lets an event arrive at a field, as from a route. What the field may not hold does not arrive, which
    /// is a message, once for each field.
    void receive(Node& to, const FieldRow& row, const FieldValue& value);

    /// The viewpoint that set_bind chose last; nothing while none has.
    const Node* boundViewpoint() const { return boundViewpoint_; }
    /// Grows whenever an event sets a field.
    std::uint64_t changes() const { return changes_; }

private:
    using Outlet = std::pair<const Node*, std::size_t>;
    using Waiting = std::deque<SceneEvent>;

    void refresh();
    void cascade(Waiting waiting);
    void runSensors();
    void arrive(Node& node, const FieldRow& row, const FieldValue& value, Waiting& waiting);
    bool mayHold(const Node& node, const FieldRow& row, const FieldValue& value);
    void takeInput(Node& node, const FieldRow& row, const FieldValue& value, Waiting& waiting);
    void bind(Node& node, bool isBound, Waiting& waiting);
    TimeSensor* sensorOf(const Node& node);

    Scene& scene_;
    double time_ = 0;
    std::size_t knownNodes_ = 0, knownRoutes_ = 0;
    std::map<const Node*, TimeSensor> sensors_;
    std::vector<TimeSensor*> sensorOrder_; // of the scene
    std::set<TimeSensor*> unsettled_;      // had events since they were looked at
    std::multimap<Outlet, const Route> routes_;
    std::set<Outlet> refused_; // fields that something did not arrive at, as was told
    Node* boundViewpoint_ = nullptr;
    std::uint64_t changes_ = 0;
};

} // namespace vo
