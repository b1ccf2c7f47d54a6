#include "x3d/scene_events.h"

#include <algorithm>
#include <cmath>

#include "x3d/interpolate.h"
#include "x3d/node_values.h"
#include "x3d/printable_word.h"

namespace vo {
namespace {

/// Whether a node would stand below itself.
bool makesCircle(const Node& node, const FieldValue& value)
{
    const auto* const below = std::get_if<std::vector<Node*>>(&value);
    return below && std::ranges::any_of(*below, [&](const Node* each) { return isAtOrBelow(node, *each); });
}

/// The children of a grouping node after addChildren or removeChildren.
std::vector<Node*> changedChildren(const Node& node, const FieldRow& children, bool isAdded,
                                   const std::vector<Node*>& change)
{
    auto nodes = std::get<std::vector<Node*>>(node.value(children));
    std::erase_if(nodes, [&](const Node* each) { return std::ranges::find(change, each) != change.end(); });
    if (isAdded) nodes.insert(nodes.end(), change.begin(), change.end());
    return nodes;
}

} // namespace

void SceneEvents::refresh()
{
    for (; knownNodes_ < scene_.nodeCount(); ++knownNodes_) {
        Node& node = *scene_.nodes()[knownNodes_];
        if (isOf(&node, "TimeSensor"))
            sensorOrder_.push_back(&sensors_.try_emplace(&node, node).first->second);
    }
    for (; knownRoutes_ < scene_.routes.size(); ++knownRoutes_) {
        const Route& route = scene_.routes[knownRoutes_];
        routes_.emplace(Outlet{route.from, route.fromSlot}, route);
    }
}

TimeSensor* SceneEvents::sensorOf(const Node& node)
{
    const auto found = sensors_.find(&node);
    return found == sensors_.end() ? nullptr : &found->second;
}

bool SceneEvents::isRunning() const
{
    return std::ranges::any_of(sensors_, [](const auto& each) { return each.second.isActive(); });
}

void SceneEvents::setTime(double seconds)
{
    refresh();
    if (seconds < time_)
        for (auto& [node, sensor] : sensors_)
            sensor.rewind();
    time_ = seconds;
    unsettled_ = {sensorOrder_.begin(), sensorOrder_.end()};
    runSensors();
}

/// Sensors that others start, or stop, with their events are looked at again, each once more at most.
void SceneEvents::runSensors()
{
    for (int round = 0; round < 2 && !unsettled_.empty(); ++round) {
        const auto sensors = std::exchange(unsettled_, {});
        std::vector<TimeSensor*> due;
        Waiting events, ends;
        for (TimeSensor* const sensor : sensorOrder_) {
            if (!sensors.contains(sensor)) continue;
            std::ranges::move(sensor->advance(time_), std::back_inserter(events));
            if (sensor->isDue()) due.push_back(sensor);
        }
        cascade(std::move(events));
        for (TimeSensor* const sensor : due)
            std::ranges::move(sensor->advance(time_), std::back_inserter(ends));
        cascade(std::move(ends));
    }
    unsettled_.clear();
}

void SceneEvents::send(std::vector<SceneEvent> events)
{
    refresh();
    cascade({std::make_move_iterator(events.begin()), std::make_move_iterator(events.end())});
    runSensors();
}

void SceneEvents::receive(Node& to, const FieldRow& row, const FieldValue& value)
{
    refresh();
    Waiting waiting;
    arrive(to, row, value, waiting);
    cascade(std::move(waiting));
    runSensors();
}

void SceneEvents::cascade(Waiting waiting)
{
    std::set<Outlet> sent;
    while (!waiting.empty()) {
        const SceneEvent event = std::move(waiting.front());
        waiting.pop_front();
        if (!sent.insert({event.from, event.slot}).second) continue;
        if (event.from->field(event.slot).access == Access::outputOnly)
            event.from->put(event.slot, event.value);
        const auto [begin, end] = routes_.equal_range({event.from, event.slot});
        for (auto each = begin; each != end; ++each)
            arrive(*each->second.to, each->second.to->field(each->second.toSlot), event.value, waiting);
    }
}

bool SceneEvents::mayHold(const Node& node, const FieldRow& row, const FieldValue& value)
{
    auto against = objection(row, value);
    if (!against && makesCircle(node, value)) against = "expected nodes that it does not stand below";
    if (!against) return true;
    if (refused_.insert({&node, row.slot}).second)
        scene_.tell(Severity::warning, node,
                    node.typeName() + "." + row.name +
                        (node.name.empty() ? "" : " of " + quotedWord(node.name)) +
                        ": an event does not arrive: " + *against);
    return false;
}

void SceneEvents::arrive(Node& node, const FieldRow& row, const FieldValue& value, Waiting& waiting)
{
    if (!mayHold(node, row, value)) return;
    if (row.access != Access::inputOutput) {
        takeInput(node, row, value, waiting);
        return;
    }
    if (TimeSensor* const sensor = sensorOf(node)) {
        if (sensor->refuses(row, value)) return;
        if (row.name == "startTime") sensor->arm();
        unsettled_.insert(sensor);
    }
    node.put(row.slot, value);
    ++changes_;
    waiting.push_back({&node, row.slot, value});
}

void SceneEvents::takeInput(Node& node, const FieldRow& row, const FieldValue& value, Waiting& waiting)
{
    if (row.name == "set_fraction") {
        auto made = interpolated(node, std::get<std::vector<float>>(value).front());
        if (made) waiting.push_back({&node, node.field("value_changed")->slot, std::move(*made)});
    } else if (row.name == "set_bind") {
        bind(node, std::get<std::vector<std::int32_t>>(value).front() != 0, waiting);
    } else if (row.name == "addChildren" || row.name == "removeChildren") {
        const FieldRow& children = *node.field("children");
        arrive(
            node, children,
            changedChildren(node, children, row.name == "addChildren", std::get<std::vector<Node*>>(value)),
            waiting);
    } else if (row.name.starts_with("set_")) {
        const FieldRow* const kept = node.field(std::string_view(row.name).substr(4));
        if (!kept || kept->type != row.type || !mayHold(node, *kept, value)) return;
        node.put(kept->slot, value);
        ++changes_;
    }
}

/// One node of a kind is bound; viewpoints alone have a use for it.
void SceneEvents::bind(Node& node, bool isBound, Waiting& waiting)
{
    if (!isOf(&node, "X3DViewpointNode") || isBound == (boundViewpoint_ == &node)) return;
    const auto tell = [&](Node& viewpoint, bool isTrue) {
        waiting.push_back({&viewpoint, viewpoint.field("isBound")->slot, truthValue(isTrue)});
        waiting.push_back({&viewpoint, viewpoint.field("bindTime")->slot, timeValue(time_)});
    };
    if (boundViewpoint_) tell(*boundViewpoint_, false);
    boundViewpoint_ = isBound ? &node : nullptr;
    if (isBound) tell(node, true);
    ++changes_;
}

} // namespace vo
