#pragma once

#include "draw/scene_resources.h"
#include "style/styled_scene.h"

namespace vo {

/// The points of all stippled volumes of a picture: opaque, a pixel each.
class DrawnStipples
{
public:
    explicit DrawnStipples(SceneResources& resources) : resources_(resources), arrays_(resources.context) {}

    void prepare(const StyledScene& scene);
    /// With the depth test that is set.
    void draw(const StyledScene& scene);

private:
    SceneResources& resources_;
    SceneArrays arrays_;
    GLsizei count_ = 0;
};

} // namespace vo
