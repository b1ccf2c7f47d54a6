#pragma once

#include <map>
#include <memory>

#include "x3d/pointer_sensors.h"
#include "x3d/scene_events.h"
#include "x3d/styled_view.h"

namespace vo {

/// What a view keeps of one scene: its events, and what it was made into.
class ViewSession
{
public:
    explicit ViewSession(std::shared_ptr<Scene> scene)
        : scene_(std::move(scene)), view_(*scene_), events_(*scene_), pointer_(*scene_, events_)
    {
    }

    const std::shared_ptr<Scene>& scene() const { return scene_; }
    SceneView& view() { return view_; }
    SceneEvents& events() { return events_; }
    PointerSensors& pointer() { return pointer_; }

    /// What engines draw now. Where LODs and OctTrees show another level than before, they say so, and what
    /// that sets counts already.
    StyledScene styledScene(ViewRequest request);

private:
    bool sendLevels();

    std::shared_ptr<Scene> scene_;
    SceneView view_;
    SceneEvents events_;
    PointerSensors pointer_;
    std::map<const Node*, int> levels_; // as they were told
};

/// A sphere round all that is drawn, in the world; a negative radius where there is nothing.
struct SceneBounds
{
    glm::dvec3 center{0.0};
    double radius = -1;
};
SceneBounds boundsOf(const StyledScene& scene);

} // namespace vo
