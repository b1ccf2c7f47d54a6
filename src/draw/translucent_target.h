#pragma once

#include "draw/scene_resources.h"

#include <optional>

namespace vo {

/// Where all that is translucent is joined in 32-bit floats before the caller's framebuffer, whose colours
/// may have 8 bits, gets it; with the depths that are there. For the scope of a ScopedSceneState.
class TranslucentTarget
{
public:
    explicit TranslucentTarget(SceneResources& resources) : resources_(resources) {}
    ~TranslucentTarget();
    TranslucentTarget(const TranslucentTarget&) = delete;
    TranslucentTarget& operator=(const TranslucentTarget&) = delete;

    /// Copies the depths of the framebuffer that is bound for drawing, from its lower left corner on; then
    /// its own framebuffer is bound, and clear. False: it has none or they cannot be had, and those
    /// here are the farthest. Throws std::runtime_error if the driver has no such framebuffer.
    bool begin(int width, int height);
    /// Binds its framebuffer with the depths, to test against them; or without them, so that textures may be
    /// read: also its own of depths, which is bound to the unit then.
    void bindWithDepths() const;
    void bindWithoutDepths() const;
    void bindDepths(int unit) const;
    GLuint depths() const { return depths_; }
    GLuint colors() const { return colors_; }
    /// Binds the caller's framebuffer again, and blends over it what was drawn.
    void show();
    /// Binds the caller's framebuffer again, if it is not.
    void end();

private:
    struct Caller
    {
        GLint draw = 0, read = 0;
        GLboolean mask[4]{};
    };

    void makeTarget(int width, int height, GLenum depthFormat);
    void release();
    bool copyDepths() const;

    SceneResources& resources_;
    SceneArrays triangle_{resources_.context};
    std::optional<Caller> caller_; ///< what is to be given back
    GLuint withDepths_ = 0, withoutDepths_ = 0, colors_ = 0, depths_ = 0;
    GLenum depthFormat_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace vo
