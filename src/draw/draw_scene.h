#pragma once

#include "style/styled_scene.h"

#include <memory>

namespace vo {

/// Draws scenes by slices through OpenGL, in the context that is current, over what the framebuffer has:
/// opaque surfaces first, then slices of all volumes and what of translucent surfaces lies between them, the
/// farthest first. Needs a depth buffer. All state is given back. Textures and programs stay until it goes;
/// it lives in one context.
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
