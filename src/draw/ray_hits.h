#pragma once

#include "draw/scene_resources.h"

#include <cstddef>

namespace vo {

class TranslucentTarget;

/// Goes along all rays of a picture at once, from hit to hit of what has surfaces, front to back. Sources
/// find hits: each keeps, for every pixel, the colour of the next one that is not reached yet, and where it
/// is. What has no single hits is walked through in between.
///
/// What is reached, and a hit, is four floats: the eye depth, the source (-1: nobody's, -2: at the
/// beginning), and two that are the source's own, by which it finds the next one.
class RayHits
{
public:
    explicit RayHits(SceneResources& resources) : resources_(resources) {}
    ~RayHits();
    RayHits(const RayHits&) = delete;
    RayHits& operator=(const RayHits&) = delete;

    /// Throws std::runtime_error if the driver has no such framebuffers.
    void begin(int width, int height, std::size_t sources);
    /// Binds what keeps the next hits of a source: colour (output 0) and hit (output 1). There are none at
    /// the beginning, and where the last one is reached the source puts others in their place.
    void bind(std::size_t source);
    /// The same, with depths of its own, for a source that draws hits where they are: none are there where
    /// the last one is reached.
    void bindForgetful(std::size_t source);
    /// The uniforms of kReachedGlsl, and its texture in this unit.
    void bindReached(int unit, std::size_t source, SceneProgram& program) const;
    /// The nearest hits of all become those that are next. `target` has what is in front.
    void chooseNext(const TranslucentTarget& target);
    /// Textures: what is reached, and what is next.
    GLuint reached() const { return states_[newest_].texture; }
    GLuint next() const { return states_[1 - newest_].texture; }
    /// Puts them behind what `target` has; they are reached then. False: there was none.
    bool advance(const TranslucentTarget& target);

private:
    struct State
    {
        GLuint framebuffer = 0, texture = 0;
    };

    void release();
    void makeTextures(int width, int height, std::size_t sources);
    SceneProgram& use(const char* mainFunction);
    void bindTexture(int unit, GLenum kind, GLuint texture, const char* name, SceneProgram& program) const;
    void drawTriangle();

    SceneResources& resources_;
    SceneArrays triangle_{resources_.context};
    State states_[2];
    std::size_t newest_ = 0, sources_ = 0;
    GLuint framebuffer_ = 0, colors_ = 0, hits_ = 0, depths_ = 0, query_ = 0;
    GLenum queryKind_ = GL_ANY_SAMPLES_PASSED;
    int width_ = 0, height_ = 0;
};

/// `vec4 lastReached()`, and of what it returns `bool isNextWanted(vec4)`, by the source at hand, `bool
/// isOwn(vec4)`, whether the last one was its own, and `bool isAtBeginning(vec4)`; `bool isBehind(float
/// depth, float source, vec2 hit)`; `const float kNoHit`, the depth where there is none; `uniform float
/// source`.
extern const char* const kReachedGlsl;

} // namespace vo
