#pragma once

#include "style/styled_scene.h"

#include <memory>

namespace vo {

/// Draws scenes through OpenGL, in the context that is current, over what the framebuffer has, whose depths
/// count: first opaque surfaces, which write depths, then all that is translucent, by depth. That is
/// joined in 32-bit floats, and blended into the framebuffer once. Volumes are drawn ray by ray, or slice by
/// slice where samples of others may lie between theirs (draw/hit_plan.h). Clears nothing. All state is given
/// back; scissor, stencil and colour mask of the program stay in force. Programs stay until it goes, textures
/// until some pictures had no use for them; it lives in one context.
///
/// Where a framebuffer has several samples a pixel, translucent things are the same for all of them.
/// Crossings of values between two tetrahedra are found by the places of the nearer one.
class SceneDrawer
{
public:
    SceneDrawer();
    ~SceneDrawer();
    SceneDrawer(const SceneDrawer&) = delete;
    SceneDrawer& operator=(const SceneDrawer&) = delete;

    /// The viewport becomes width x height of the scene. Throws std::runtime_error with the driver's words.
    void draw(const StyledScene& scene);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace vo
