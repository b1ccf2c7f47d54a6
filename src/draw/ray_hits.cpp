#include "draw/ray_hits.h"

#include "draw/scoped_state.h"
#include "draw/translucent_target.h"
#include "draw/volume_shaders.h"

#include <stdexcept>
#include <string>

namespace vo {

const char* const kReachedGlsl = R"(
uniform sampler2D reached;
uniform float source;
const float kNoHit = 1e30;
vec4 lastReached()
{
    return texelFetch(reached, ivec2(gl_FragCoord.xy), 0);
}
bool isOwn(vec4 last)
{
    return last.y == source;
}
bool isAtBeginning(vec4 last)
{
    return last.y < -1.5;
}
bool isNextWanted(vec4 last)
{
    return isOwn(last) || isAtBeginning(last);
}
// Whether something at a depth is behind a hit. Sources that are one place have depths that are rounded in
// different ways: they are in the order of their numbers, which is that of the scene.
bool isBehind(float depth, float source, vec2 hit)
{
    float behind = depth - hit.x;
    return abs(behind) > 2e-6 * abs(hit.x) ? behind > 0.0 : source > hit.y;
}
)";

namespace {

constexpr float kNoHit = 1e30f;

constexpr const char* kForgetMain = R"(
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 hit;
void main()
{
    if (!isNextWanted(lastReached())) discard;
    color = vec4(0.0);
    hit = vec4(kNoHit, 0.0, 0.0, 0.0);
}
)";

// Nobody's hit is wanted where what is in front is opaque.
constexpr const char* kChooseMain = R"(
uniform sampler2D seen;
uniform sampler2DArray hits;
layout(location = 0) out vec4 next;
void main()
{
    const float kOpaque = 1.0 - 1.0 / 4096.0;
    vec4 last = lastReached();
    bool isDone = texelFetch(seen, ivec2(gl_FragCoord.xy), 0).a >= kOpaque;
    next = vec4(isDone ? last.x : kNoHit, -1.0, 0.0, 0.0);
    if (isDone || last.x >= kNoHit) return;
    for (int i = 0; i < SOURCES; ++i) {
        vec4 hit = texelFetch(hits, ivec3(gl_FragCoord.xy, i), 0);
        if (hit.x < kNoHit && isBehind(next.x, next.y, vec2(hit.x, float(i)))) next = vec4(hit.x, float(i), hit.zw);
    }
    next.x = max(next.x, last.x);
}
)";

constexpr const char* kAdvanceMain = R"(
uniform sampler2D next;
uniform sampler2DArray colors;
layout(location = 0) out vec4 fragment;
void main()
{
    float from = texelFetch(next, ivec2(gl_FragCoord.xy), 0).y;
    if (from < 0.0) discard;
    fragment = texelFetch(colors, ivec3(gl_FragCoord.xy, int(from)), 0);
}
)";

GLuint makeTexture(const GladGLContext& gl, GLenum kind)
{
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(kind, texture);
    filterNone(gl, kind);
    return texture;
}

void checkFramebuffer(const GladGLContext& gl, int width, int height)
{
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("the driver has no framebuffer of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " floats for hits");
}

} // namespace

RayHits::~RayHits()
{
    if (resources_.context.isCurrent()) release();
}

void RayHits::release()
{
    const GladGLContext& gl = resources_.context.gl;
    for (State& state : states_) {
        gl.DeleteFramebuffers(1, &state.framebuffer);
        gl.DeleteTextures(1, &state.texture);
        state = {};
    }
    gl.DeleteFramebuffers(1, &framebuffer_);
    for (GLuint* const texture : {&colors_, &hits_, &depths_}) {
        gl.DeleteTextures(1, texture);
        *texture = 0;
    }
    gl.DeleteQueries(1, &query_);
    framebuffer_ = query_ = 0;
    width_ = height_ = 0;
}

void RayHits::makeTextures(int width, int height, std::size_t sources)
{
    release();
    const GladGLContext& gl = resources_.context.gl;
    const ScopedUploadState upload(gl, resources_.context.core);
    gl.ActiveTexture(GL_TEXTURE0);
    for (GLuint* const texture : {&colors_, &hits_}) {
        *texture = makeTexture(gl, GL_TEXTURE_2D_ARRAY);
        gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, width, height, static_cast<GLsizei>(sources), 0,
                      GL_RGBA, GL_FLOAT, nullptr);
    }
    depths_ = makeTexture(gl, GL_TEXTURE_2D);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                  nullptr);
    for (State& state : states_) {
        state.texture = makeTexture(gl, GL_TEXTURE_2D);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl.GenFramebuffers(1, &state.framebuffer);
        gl.BindFramebuffer(GL_FRAMEBUFFER, state.framebuffer);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, state.texture, 0);
        checkFramebuffer(gl, width, height);
    }
    gl.GenFramebuffers(1, &framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_, 0);
    constexpr GLenum kBoth[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl.DrawBuffers(2, kBoth);
    width_ = width;
    height_ = height;
    sources_ = sources;
}

void RayHits::begin(int width, int height, std::size_t sources)
{
    const GladGLContext& gl = resources_.context.gl;
    if (width != width_ || height != height_ || sources != sources_) makeTextures(width, height, sources);
    // Of each kind the caller may have one under way.
    GLint active = 0;
    gl.GetQueryiv(GL_ANY_SAMPLES_PASSED, GL_CURRENT_QUERY, &active);
    queryKind_ = active != 0 ? GL_SAMPLES_PASSED : GL_ANY_SAMPLES_PASSED;
    gl.DeleteQueries(1, &query_);
    gl.GenQueries(1, &query_);
    constexpr float kBeginning[4] = {-kNoHit, -2.0f, 0.0f, 0.0f};
    gl.BindFramebuffer(GL_FRAMEBUFFER, states_[newest_].framebuffer);
    gl.ClearBufferfv(GL_COLOR, 0, kBeginning);
    constexpr float kClear[4] = {}, kNone[4] = {kNoHit, 0.0f, 0.0f, 0.0f};
    for (std::size_t source = 0; source < sources_; ++source) {
        bind(source);
        gl.ClearBufferfv(GL_COLOR, 0, kClear);
        gl.ClearBufferfv(GL_COLOR, 1, kNone);
    }
}

SceneProgram& RayHits::use(const char* mainFunction)
{
    const std::string version = "#version 330 core\n";
    SceneProgram& program = resources_.programs.find(version + kPictureVertexShader,
                                                     version + "#define SOURCES " + std::to_string(sources_) +
                                                         "\n" + kReachedGlsl + mainFunction);
    program.use();
    return program;
}

void RayHits::bindTexture(int unit, GLenum kind, GLuint texture, const char* name,
                          SceneProgram& program) const
{
    resources_.context.gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    resources_.context.gl.BindTexture(kind, texture);
    program.set(name, unit);
}

void RayHits::bindReached(int unit, std::size_t source, SceneProgram& program) const
{
    bindTexture(unit, GL_TEXTURE_2D, reached(), "reached", program);
    program.set("source", static_cast<float>(source));
}

void RayHits::drawTriangle()
{
    triangle_.sendPictureTriangle();
    resources_.context.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void RayHits::bind(std::size_t source)
{
    const GladGLContext& gl = resources_.context.gl;
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const auto layer = static_cast<GLint>(source);
    gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colors_, 0, layer);
    gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, hits_, 0, layer);
    checkFramebuffer(gl, width_, height_);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_DEPTH_TEST);
}

void RayHits::bindForgetful(std::size_t source)
{
    const GladGLContext& gl = resources_.context.gl;
    bind(source);
    gl.DepthMask(GL_TRUE);
    constexpr float kFarthest = 1.0f;
    gl.ClearBufferfv(GL_DEPTH, 0, &kFarthest);
    bindReached(0, source, use(kForgetMain));
    drawTriangle();
}

void RayHits::chooseNext(const TranslucentTarget& target)
{
    const GladGLContext& gl = resources_.context.gl;
    gl.BindFramebuffer(GL_FRAMEBUFFER, states_[1 - newest_].framebuffer);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_DEPTH_TEST);
    SceneProgram& program = use(kChooseMain);
    bindReached(0, sources_, program);
    bindTexture(1, GL_TEXTURE_2D, target.colors(), "seen", program);
    bindTexture(2, GL_TEXTURE_2D_ARRAY, hits_, "hits", program);
    drawTriangle();
}

bool RayHits::advance(const TranslucentTarget& target)
{
    const GladGLContext& gl = resources_.context.gl;
    target.bindWithoutDepths();
    SceneProgram& program = use(kAdvanceMain);
    bindTexture(0, GL_TEXTURE_2D, next(), "next", program);
    bindTexture(1, GL_TEXTURE_2D_ARRAY, colors_, "colors", program);
    gl.BeginQuery(queryKind_, query_);
    drawTriangle();
    gl.EndQuery(queryKind_);
    newest_ = 1 - newest_;
    GLuint any = 0;
    gl.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &any);
    return any != 0;
}

} // namespace vo
