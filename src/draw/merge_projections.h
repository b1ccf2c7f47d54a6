#pragma once

#include "draw/scene_resources.h"

#include <cstddef>

namespace vo {

/// Keeps projections that may hide each other or stand between other things: a layer of a texture for each,
/// with one grey, one opacity and the depth at which the ray begins for every pixel. They are then drawn
/// depth by depth; what begins in the same range of depths is in the order of these depths in each pixel, and
/// at one depth the first layer is in front.
class ProjectionMerger
{
public:
    explicit ProjectionMerger(SceneResources& resources) : resources_(resources) {}
    ~ProjectionMerger();
    ProjectionMerger(const ProjectionMerger&) = delete;
    ProjectionMerger& operator=(const ProjectionMerger&) = delete;

    /// Room for so many, which may be none. Throws std::runtime_error if the driver has not as much.
    void prepare(int width, int height, std::size_t count);
    /// Binds a framebuffer that keeps one projection, clear so far. It is not to be blended into.
    void bind(std::size_t layer) const;
    /// Makes its program ready.
    void use();
    /// Draws what begins at depths from `nearest` on, up to `farthest`.
    void draw(double nearest, double farthest);

private:
    void release();

    SceneResources& resources_;
    SceneArrays triangle_{resources_.context};
    SceneProgram* program_ = nullptr;
    GLuint framebuffer_ = 0, layers_ = 0;
    int width_ = 0, height_ = 0;
    std::size_t count_ = 0;
};

} // namespace vo
