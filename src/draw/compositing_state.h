#pragma once

#include "cast/cast_request.h"
#include "draw/context_record.h"
#include "draw/draw_state.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vo {

/// What the blend state does to the alpha that is there.
enum class AlphaRule {
    squared, ///< GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, or with other equations that of the colours
    opacity, ///< GL_ONE, GL_ONE_MINUS_SRC_ALPHA: what hides the background
    kept,    ///< GL_ZERO, GL_ONE
};

struct Blending
{
    CastBlending color = CastBlending::over;
    AlphaRule alpha = AlphaRule::squared;
};

/// Where the alpha of joined fragments is from, 0: that of the fragments as they add up; with over 1: what
/// GL_SRC_ALPHA leaves; 2: the part of the background that they hide; 3: the framebuffer's stays.
int alphaSource(const Blending& blending);

/// Blends joined fragments as `blending` does single ones, while the scope lasts. With over, a shader gives
/// what shows through as its second colour (index 1).
class ScopedJoinedBlending
{
public:
    ScopedJoinedBlending(const GladGLContext& gl, const Blending& blending);
    ~ScopedJoinedBlending();
    ScopedJoinedBlending(const ScopedJoinedBlending&) = delete;
    ScopedJoinedBlending& operator=(const ScopedJoinedBlending&) = delete;

private:
    const GladGLContext& gl_;
    std::array<GLenum, 4> factors_{};
};

/// The caller's blend state if it is one of those in which fragments can be joined before they are drawn: of
/// the colours over (premultiplied or not), max, min, sum or alphaSum, and with over a rule for alpha.
/// Nothing for all others.
std::optional<Blending> readBlending(const ContextRecord& context);

/// The caller's state as far as it decides how fragments join what is there.
struct CompositingState
{
    Blending blending;
    bool depthTest = false;
    bool depthOrEqual = false;
    GLdouble depthRange[2] = {0.0, 1.0};
    GLint viewport[4] = {0, 0, 0, 0};
    std::vector<glm::vec4> clipPlanes; ///< those that are enabled, in eye space
};

/// Why a picture drawn at once would differ from slices drawn one by one in this state; empty when it would
/// not, and `state` is filled then. `unbounded`: fragments may have colours outside 0 to 1.
std::string readCompositingState(const ContextRecord& context, const DrawState& draw, bool unbounded,
                                 CompositingState& state);

/// Whether a filled fragment with an alpha of exactly 0 changes nothing in the framebuffer, whatever its
/// colour. Queries that count fragments are not asked about.
bool clearFragmentsLeaveNoTrace(const ContextRecord& context);

/// Whether OpenGL draws into the framebuffer that is bound for drawing.
bool framebufferIsComplete(const ContextRecord& context);

} // namespace vo
