#include "x3d/pointer_sensors.h"

#include <algorithm>
#include <glm/gtc/matrix_inverse.hpp>

#include "x3d/node_transform.h"
#include "x3d/node_values.h"

namespace vo {
namespace {

std::vector<Node*> enabledSensors(const std::vector<Node*>& nodes)
{
    std::vector<Node*> sensors;
    std::ranges::copy_if(nodes, std::back_inserter(sensors), [](const Node* node) {
        return isOf(node, "TouchSensor") && boolOf(*node, "enabled", true);
    });
    return sensors;
}

std::vector<Node*> childrenOf(const Node& node)
{
    return node.inlined.empty() ? nodesOf(node, "children") : node.inlined;
}

glm::dmat4 worldFromBelow(const std::vector<const Node*>& above)
{
    glm::dmat4 matrix(1.0);
    for (const Node* const node : above)
        if (isOf(node, "Transform")) matrix *= transformMatrix(*node);
    return matrix;
}

FieldValue vectorValue(const glm::dvec3& v)
{
    return std::vector<float>{float(v.x), float(v.y), float(v.z)};
}

} // namespace

PointerSensors::Touched PointerSensors::sensorsOf(const PointedPlace& place) const
{
    for (std::size_t depth = place.path.size(); depth-- > 0;) {
        auto sensors = enabledSensors(depth == 0 ? scene_.roots : childrenOf(*place.path[depth - 1]));
        if (sensors.empty()) continue;
        return {std::move(sensors), {place.path.begin(), place.path.begin() + std::ptrdiff_t(depth)}};
    }
    return {};
}

void PointerSensors::send(const std::vector<Node*>& sensors, const char* field, const FieldValue& value)
{
    std::vector<SceneEvent> sent;
    for (Node* const sensor : sensors)
        sent.push_back({sensor, sensor->field(field)->slot, value});
    events_.send(std::move(sent));
}

bool PointerSensors::move(const std::optional<PointedPlace>& place)
{
    const Touched touched = place ? sensorsOf(*place) : Touched();
    const auto without = [](std::vector<Node*> some, const std::vector<Node*>& others) {
        std::erase_if(some, [&](Node* each) { return std::ranges::find(others, each) != others.end(); });
        return some;
    };
    send(without(over_, touched.sensors), "isOver", truthValue(false));
    send(without(touched.sensors, over_), "isOver", truthValue(true));
    over_ = touched.sensors;
    if (over_.empty()) return false;
    const glm::dmat4 belowFromWorld = glm::inverse(worldFromBelow(touched.above));
    const glm::dmat4 belowFromNode = belowFromWorld * worldFromBelow(place->path);
    const glm::dvec3 normal = glm::inverseTranspose(glm::dmat3(belowFromNode)) * glm::dvec3(place->normal);
    const double length = glm::length(normal);
    send(over_, "hitPoint_changed", vectorValue(glm::dvec3(belowFromWorld * glm::dvec4(place->world, 1.0))));
    send(over_, "hitNormal_changed", vectorValue(length > 0 ? normal / length : normal));
    send(over_, "hitTexCoord_changed",
         FieldValue(std::vector<float>{place->texturePlace.x, place->texturePlace.y}));
    return true;
}

void PointerSensors::press()
{
    active_ = over_;
    send(active_, "isActive", truthValue(true));
}

void PointerSensors::release()
{
    const auto pressed = std::exchange(active_, {});
    send(pressed, "isActive", truthValue(false));
    std::vector<Node*> touched;
    std::ranges::copy_if(pressed, std::back_inserter(touched),
                         [&](Node* sensor) { return std::ranges::find(over_, sensor) != over_.end(); });
    send(touched, "touchTime", timeValue(events_.time()));
}

} // namespace vo
