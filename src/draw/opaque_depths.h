#pragma once

#include "draw/draw_stipples.h"
#include "draw/scene_resources.h"
#include "style/styled_scene.h"

namespace vo {

/// The eye depths of a scene's opaque surfaces and stipples, a texture of the picture's size: infinite where
/// there is none.
class OpaqueDepths
{
public:
    explicit OpaqueDepths(SceneResources& resources) : resources_(resources) {}
    ~OpaqueDepths();
    OpaqueDepths(const OpaqueDepths&) = delete;
    OpaqueDepths& operator=(const OpaqueDepths&) = delete;

    /// Draws them into a framebuffer of its own; the caller's is bound again afterwards. Throws
    /// std::runtime_error if the driver has no such framebuffer.
    void draw(const StyledScene& scene, SceneArrays& arrays, DrawnStipples& stipples);
    /// As a sampler2D. The caller's binding is not given back: ScopedSceneState does that.
    void bind(int unit) const;

private:
    void makeTarget(int width, int height);
    void release();

    SceneResources& resources_;
    GLuint framebuffer_ = 0, texture_ = 0, depthBuffer_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace vo
