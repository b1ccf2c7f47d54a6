#include "draw/compositing_state.h"

#include "draw/read_depths.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace vo {

namespace {

GLint integer(const GladGLContext& gl, GLenum name)
{
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

struct Equation
{
    GLint mode, source, destination;
    friend bool operator==(const Equation&, const Equation&) = default;
};

constexpr Equation kOver{GL_FUNC_ADD, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
constexpr Equation kOpacity{GL_FUNC_ADD, GL_ONE, GL_ONE_MINUS_SRC_ALPHA};
constexpr Equation kKept{GL_FUNC_ADD, GL_ZERO, GL_ONE};
constexpr Equation kSum{GL_FUNC_ADD, GL_ONE, GL_ONE};
constexpr Equation kAlphaSum{GL_FUNC_ADD, GL_SRC_ALPHA, GL_ONE};

/// The buffer that fragments go to is one of numbers of fixed point, which clamp.
bool clampsColors(const GladGLContext& gl, bool ownFramebuffer)
{
    if (!ownFramebuffer) return true;
    GLint type = GL_FLOAT;
    const auto buffer = static_cast<GLenum>(integer(gl, GL_DRAW_BUFFER0));
    if (buffer == GL_NONE) return false;
    gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer,
                                           GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    return type != GL_FLOAT;
}

bool stencilIsKept(const GladGLContext& gl)
{
    constexpr GLenum operations[] = {
        GL_STENCIL_FAIL,      GL_STENCIL_PASS_DEPTH_FAIL,      GL_STENCIL_PASS_DEPTH_PASS,
        GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS};
    return std::ranges::all_of(operations, [&](GLenum name) { return integer(gl, name) == GL_KEEP; });
}

std::string switchedOn(const ContextRecord& context)
{
    struct Switch
    {
        GLenum name;
        const char* text;
        bool fixedFunction;
    };
    constexpr Switch switches[] = {
        {GL_CULL_FACE, "faces are culled", false},
        {GL_COLOR_LOGIC_OP, "a logic operation is on", false},
        {GL_DEPTH_CLAMP, "depths are clamped", false},
        {GL_RASTERIZER_DISCARD, "fragments are discarded", false},
        {GL_POLYGON_SMOOTH, "polygons are smoothed", false},
        {GL_POLYGON_OFFSET_FILL, "polygons have an offset", false},
        {GL_FRAMEBUFFER_SRGB, "colours are coded as sRGB", false},
        {GL_ALPHA_TEST, "an alpha test is on", true},
        {GL_POLYGON_STIPPLE, "polygons are stippled", true},
    };
    for (const auto& [name, text, fixedFunction] : switches)
        if (!(context.core && fixedFunction) && context.gl.IsEnabled(name)) return text;
    return "";
}

std::string countedFragments(const GladGLContext& gl)
{
    for (const GLenum target : {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED}) {
        GLint query = 0;
        gl.GetQueryiv(target, GL_CURRENT_QUERY, &query);
        if (query != 0) return "fragments or primitives are counted by a query";
    }
    return "";
}

/// Neither selected, nor drawn as lines or points.
std::string obstacleInPolygons(const ContextRecord& context)
{
    const GladGLContext& gl = context.gl;
    if (!context.core && integer(gl, GL_RENDER_MODE) != GL_RENDER) return "the render mode is not GL_RENDER";
    GLint modes[2] = {GL_FILL, GL_FILL};
    gl.GetIntegerv(GL_POLYGON_MODE, modes);
    if (modes[0] != GL_FILL || (!context.core && modes[1] != GL_FILL)) return "polygons are not filled";
    return "";
}

bool writesDepths(const GladGLContext& gl)
{
    GLboolean written = GL_FALSE;
    gl.GetBooleanv(GL_DEPTH_WRITEMASK, &written);
    return written;
}

std::string obstacleInFramebuffer(const GladGLContext& gl)
{
    if (integer(gl, GL_SAMPLE_BUFFERS) > 0) return "pixels have several samples";
    if (integer(gl, GL_DRAW_BUFFER1) != GL_NONE) return "fragments go to several buffers";
    return "";
}

std::string obstacleInDepth(const GladGLContext& gl, CompositingState& state)
{
    state.depthTest = gl.IsEnabled(GL_DEPTH_TEST) && hasDepthBuffer(gl);
    if (!state.depthTest) return "";
    if (writesDepths(gl)) return "depths are written";
    const GLint function = integer(gl, GL_DEPTH_FUNC);
    if (function == GL_ALWAYS) {
        state.depthTest = false;
        return "";
    }
    if (function != GL_LESS && function != GL_LEQUAL) return "the depth test is neither LESS nor LEQUAL";
    state.depthOrEqual = function == GL_LEQUAL;
    gl.GetDoublev(GL_DEPTH_RANGE, state.depthRange);
    return "";
}

void readClipPlanes(const GladGLContext& gl, const DrawState& draw, CompositingState& state)
{
    state.clipPlanes.clear();
    for (int i = 0; i < draw.clipPlaneCount; ++i)
        if (gl.IsEnabled(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i)))
            state.clipPlanes.push_back(draw.clipPlanes[static_cast<std::size_t>(i)]);
}

} // namespace

std::optional<Blending> readBlending(const ContextRecord& context)
{
    const GladGLContext& gl = context.gl;
    if (!gl.IsEnabled(GL_BLEND)) return std::nullopt;
    const Equation color{integer(gl, GL_BLEND_EQUATION_RGB), integer(gl, GL_BLEND_SRC_RGB),
                         integer(gl, GL_BLEND_DST_RGB)};
    const Equation alpha{integer(gl, GL_BLEND_EQUATION_ALPHA), integer(gl, GL_BLEND_SRC_ALPHA),
                         integer(gl, GL_BLEND_DST_ALPHA)};
    if (color == kOver || color == kOpacity) {
        const CastBlending over = color == kOver ? CastBlending::over : CastBlending::premultiplied;
        if (alpha == kOver) return Blending{over, AlphaRule::squared};
        if (alpha == kOpacity) return Blending{over, AlphaRule::opacity};
        if (alpha == kKept) return Blending{over, AlphaRule::kept};
        return std::nullopt;
    }
    if (color.mode != alpha.mode) return std::nullopt;
    if (color.mode == GL_MAX) return Blending{CastBlending::max};
    if (color.mode == GL_MIN) return Blending{CastBlending::min};
    if (color == kSum && alpha == kSum) return Blending{CastBlending::sum};
    if (color == kAlphaSum && alpha == kAlphaSum) return Blending{CastBlending::alphaSum};
    return std::nullopt;
}

std::string readCompositingState(const ContextRecord& context, const DrawState& draw, bool unbounded,
                                 CompositingState& state)
{
    const GladGLContext& gl = context.gl;
    if (const std::string obstacle = obstacleInPolygons(context); !obstacle.empty()) return obstacle;
    if (draw.textureMatrix != glm::mat4(1.0f)) return "there is a texture matrix";
    const std::optional<Blending> blending = readBlending(context);
    if (!blending) return "fragments are blended in another way than over, max, min and sum";
    state.blending = *blending;
    if (const std::string obstacle = switchedOn(context); !obstacle.empty()) return obstacle;
    if (gl.IsEnabled(GL_STENCIL_TEST) && !stencilIsKept(gl)) return "the stencil buffer is written";
    if (const std::string obstacle = obstacleInFramebuffer(gl); !obstacle.empty()) return obstacle;
    const bool ownFramebuffer = integer(gl, GL_DRAW_FRAMEBUFFER_BINDING) != 0;
    if (unbounded && clampsColors(gl, ownFramebuffer))
        return "colours may lie outside 0 to 1, where the framebuffer clamps them";
    if (const std::string obstacle = obstacleInDepth(gl, state); !obstacle.empty()) return obstacle;
    if (const std::string obstacle = countedFragments(gl); !obstacle.empty()) return obstacle;
    gl.GetIntegerv(GL_VIEWPORT, state.viewport);
    readClipPlanes(gl, draw, state);
    return "";
}

bool clearFragmentsLeaveNoTrace(const ContextRecord& context)
{
    const GladGLContext& gl = context.gl;
    if (gl.IsEnabled(GL_COLOR_LOGIC_OP)) return false;
    if (gl.IsEnabled(GL_STENCIL_TEST) && !stencilIsKept(gl)) return false;
    if (gl.IsEnabled(GL_DEPTH_TEST) && writesDepths(gl)) return false;
    const std::optional<Blending> blending = readBlending(context);
    return blending && (blending->color == CastBlending::over || blending->color == CastBlending::alphaSum) &&
           obstacleInPolygons(context).empty();
}

int alphaSource(const Blending& blending)
{
    if (!hidesBehind(blending.color)) return 0;
    switch (blending.alpha) {
    case AlphaRule::squared: return 1;
    case AlphaRule::opacity: return 2;
    case AlphaRule::kept: return 3;
    }
    return 1;
}

ScopedJoinedBlending::ScopedJoinedBlending(const GladGLContext& gl, const Blending& blending) : gl_(gl)
{
    constexpr GLenum names[4] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA};
    for (std::size_t i = 0; i < 4; ++i)
        factors_[i] = static_cast<GLenum>(integer(gl, names[i]));
    if (hidesBehind(blending.color)) gl.BlendFunc(GL_ONE, GL_SRC1_COLOR);
    if (blending.color == CastBlending::alphaSum) gl.BlendFunc(GL_ONE, GL_ONE);
}

ScopedJoinedBlending::~ScopedJoinedBlending()
{
    gl_.BlendFuncSeparate(factors_[0], factors_[1], factors_[2], factors_[3]);
}

bool framebufferIsComplete(const ContextRecord& context)
{
    return context.gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

} // namespace vo
