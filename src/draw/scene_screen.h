#pragma once

#include "cast/cast_depth.h"
#include "style/styled_scene.h"

#include <memory>

namespace vo {

/// Where scenes are seen: the framebuffer of the current context, which may be drawn into or shown a picture.
/// It lives in the context that was current at its first use; everything throws std::runtime_error without
/// one.
class SceneScreen
{
public:
    SceneScreen();
    ~SceneScreen();
    SceneScreen(const SceneScreen&) = delete;
    SceneScreen& operator=(const SceneScreen&) = delete;

    /// Draws a scene (SceneDrawer).
    void draw(const StyledScene& scene);
    /// The depths that are there, of width x height pixels from the lower left corner; empty without a depth
    /// buffer. Valid until it is called again.
    CastDepth readDepths(int width, int height);
    /// Blends a finished picture over what is there, without a look at depths: it has what they leave. The
    /// viewport becomes its size; all state is given back.
    void show(const ScenePicture& picture);
    /// Whether the environment's VO_ENGINE says cast, or OpenGL runs on the processor and it does not say
    /// slices: then a finished picture is there sooner.
    bool prefersCasting();

private:
    struct Private;
    Private& opened();
    std::unique_ptr<Private> d;
};

} // namespace vo
