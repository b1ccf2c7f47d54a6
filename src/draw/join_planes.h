#pragma once

#include "draw/scene_resources.h"
#include "style/styled_scene.h"

#include <cstddef>
#include <functional>

namespace vo {

/// Joins the samples of all rays of a picture that are drawn plane by plane: projections of tetrahedra. Some
/// planes at a time are drawn into layers of a texture, which are then gone through front to back.
class PlaneJoiner
{
public:
    explicit PlaneJoiner(SceneResources& resources) : resources_(resources) {}
    ~PlaneJoiner();
    PlaneJoiner(const PlaneJoiner&) = delete;
    PlaneJoiner& operator=(const PlaneJoiner&) = delete;

    struct Planes
    {
        int width = 0, height = 0;
        GLuint depths = 0; ///< a texture: what is behind these is left out
        std::size_t count = 0;
        std::function<double(std::size_t)> number; ///< of a plane, from the nearest
        std::function<void()> use;                 ///< makes what draws planes ready
        /// Draws the samples of a plane, each a value (red) and an opacity (green), which may not blend.
        std::function<void(std::size_t)> draw;
    };

    /// Leaves a framebuffer of its own bound. Throws std::runtime_error if the driver has none.
    void join(const RayProjection& projection, const Planes& planes);
    /// Draws all rays.
    void draw(const RayProjection& projection);
    /// Writes what a ProjectionMerger keeps of rays; they begin at their first plane.
    void keep(const RayProjection& projection, double spacing);

private:
    /// What is known of rays so far.
    struct State
    {
        GLuint framebuffer = 0, values = 0, counts = 0;
    };

    void prepare(int width, int height);
    void release();
    void drawLayers(const Planes& planes, std::size_t first, std::size_t count);
    void addLayers(const RayProjection& projection, const Planes& planes, std::size_t first,
                   std::size_t count);
    void bindState(const State& state, SceneProgram& program) const;
    SceneProgram& drawState(const RayProjection& projection, const char* mainFunction);
    void drawTriangle();

    SceneResources& resources_;
    SceneArrays triangle_{resources_.context};
    GLuint layersFramebuffer_ = 0, layers_ = 0;
    int layerCount_ = 0, width_ = 0, height_ = 0;
    State states_[2];
    std::size_t newest_ = 0;
};

} // namespace vo
