#pragma once

#include "style/styled_scene.h"

#include <memory>

namespace vo {

/// Draws scenes by slices through OpenGL, in the context that is current, over what the framebuffer has:
/// opaque surfaces first, then slices of all volumes and what of translucent surfaces lies between them, the
/// farthest first. Needs a depth buffer, whose depths count, and clears nothing. All state is given back;
/// scissor, stencil and colour mask of the program stay in force. Programs stay until it goes, textures until
/// some pictures had no use for them; it lives in one context.
///
/// Left out: projections of tetrahedra. Crossings of values between two tetrahedra are found by the places of
/// the nearer one.
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
