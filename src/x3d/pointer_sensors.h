#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "x3d/scene_events.h"

namespace vo {

/// Where a pointing device meets the scene.
struct PointedPlace
{
    std::vector<const Node*> path; ///< a root first, what was met last
    glm::dvec3 world{0.0};
    glm::vec3 normal{0.0f}; ///< of the node met, in its coordinates
    glm::vec2 texturePlace{0.0f};
};

/// The TouchSensors of a scene, moved over, pressed and let go. What is met belongs to the sensors that stand
/// beside it or, where there are none, beside the nearest node above it.
class PointerSensors
{
public:
    PointerSensors(Scene& scene, SceneEvents& events) : scene_(scene), events_(events) {}

    /// To where something is met, or nothing is. Whether there is a sensor.
    bool move(const std::optional<PointedPlace>& place);
    void press();
    void release();

private:
    struct Touched
    {
        std::vector<Node*> sensors;
        std::vector<const Node*> above; ///< them, a root first
    };
    Touched sensorsOf(const PointedPlace& place) const;
    void send(const std::vector<Node*>& sensors, const char* field, const FieldValue& value);

    Scene& scene_;
    SceneEvents& events_;
    std::vector<Node*> over_, active_;
};

} // namespace vo
