#include "draw/join_planes.h"

#include "draw/scoped_state.h"
#include "draw/volume_shaders.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace vo {

namespace {

constexpr int kMostLayers = 16;
constexpr std::size_t kMostBytes = std::size_t{64} << 20;
/// Stands where a layer has no sample.
constexpr float kNothing = -3e38f;

constexpr const char* kStateFunctions = R"(
uniform sampler2D values, counts;
Joined joinedSoFar()
{
    vec4 value = texelFetch(values, ivec2(gl_FragCoord.xy), 0), count = texelFetch(counts, ivec2(gl_FragCoord.xy), 0);
    return Joined(value.x, value.y, value.z, value.w, count.x, count.y, count.z > 0.5);
}
)";

constexpr const char* kAddMain = R"(
uniform sampler2DArray layers;
uniform int layerCount;
uniform float planes[MOST_LAYERS];
layout(location = 0) out vec4 value;
layout(location = 1) out vec4 count;
void main()
{
    Joined all = joinedSoFar();
    for (int i = 0; i < layerCount; ++i) {
        vec2 sampled = texelFetch(layers, ivec3(gl_FragCoord.xy, i), 0).rg;
        if (sampled.x > -1e38) join(all, sampled.x, sampled.y, planes[i]);
    }
    value = vec4(all.best, all.opacity, all.before, all.opacityBefore);
    count = vec4(all.count, all.first, all.found ? 1.0 : 0.0, 0.0);
}
)";

constexpr const char* kShowMain = R"(
layout(location = 0) out vec4 fragment;
void main()
{
    Joined all = joinedSoFar();
    if (all.count == 0.0) discard;
    fragment = colorOf(all);
}
)";

// As in kProjectionMain.
constexpr const char* kKeepMain = R"(
uniform float spacing;
layout(location = 0) out vec4 fragment;
void main()
{
    Joined all = joinedSoFar();
    if (all.count == 0.0) discard;
    fragment = vec4(colorOf(all).ra, (all.first + 0.5) * spacing, 1.0);
}
)";

SceneProgram& programOf(ScenePrograms& programs, const RayProjection& projection, const char* mainFunction)
{
    const std::string version = "#version 330 core\n";
    return programs.find(version + kPictureVertexShader,
                         version + "#define MOST_LAYERS " + std::to_string(kMostLayers) + "\n#define TYPE " +
                             std::to_string(static_cast<int>(projection.type)) + "\n" + kJoinFunctions +
                             kStateFunctions + mainFunction);
}

GLuint makeFloats(const GladGLContext& gl, int width, int height)
{
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    filterNone(gl, GL_TEXTURE_2D);
    return texture;
}

} // namespace

PlaneJoiner::~PlaneJoiner()
{
    if (resources_.context.isCurrent()) release();
}

void PlaneJoiner::release()
{
    const GladGLContext& gl = resources_.context.gl;
    gl.DeleteFramebuffers(1, &layersFramebuffer_);
    gl.DeleteTextures(1, &layers_);
    for (State& state : states_) {
        gl.DeleteFramebuffers(1, &state.framebuffer);
        gl.DeleteTextures(1, &state.values);
        gl.DeleteTextures(1, &state.counts);
        state = {};
    }
    layersFramebuffer_ = layers_ = 0;
    width_ = height_ = 0;
}

void PlaneJoiner::prepare(int width, int height)
{
    if (width == width_ && height == height_) return;
    release();
    const GladGLContext& gl = resources_.context.gl;
    const ScopedUploadState upload(gl, resources_.context.core);
    const std::size_t layer =
        std::size_t{8} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    layerCount_ = static_cast<int>(std::clamp<std::size_t>(kMostBytes / layer, 2, kMostLayers));
    gl.ActiveTexture(GL_TEXTURE0);
    gl.GenTextures(1, &layers_);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, layers_);
    gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RG32F, width, height, layerCount_, 0, GL_RG, GL_FLOAT, nullptr);
    filterNone(gl, GL_TEXTURE_2D_ARRAY);
    gl.GenFramebuffers(1, &layersFramebuffer_);
    for (State& state : states_) {
        state.values = makeFloats(gl, width, height);
        state.counts = makeFloats(gl, width, height);
        gl.GenFramebuffers(1, &state.framebuffer);
        gl.BindFramebuffer(GL_FRAMEBUFFER, state.framebuffer);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, state.values, 0);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, state.counts, 0);
        constexpr GLenum kBoth[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        gl.DrawBuffers(2, kBoth);
        if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("the driver has no framebuffer of " + std::to_string(width) + " x " +
                                     std::to_string(height) + " floats");
    }
    width_ = width;
    height_ = height;
}

void PlaneJoiner::drawLayers(const Planes& planes, std::size_t first, std::size_t count)
{
    const GladGLContext& gl = resources_.context.gl;
    gl.BindFramebuffer(GL_FRAMEBUFFER, layersFramebuffer_);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, planes.depths, 0);
    gl.Enable(GL_DEPTH_TEST);
    planes.use();
    constexpr float kClear[4] = {kNothing, 0.0f, 0.0f, 0.0f};
    for (std::size_t i = 0; i < count; ++i) {
        gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, layers_, 0, static_cast<GLint>(i));
        gl.ClearBufferfv(GL_COLOR, 0, kClear);
        planes.draw(first + i);
    }
    gl.Disable(GL_DEPTH_TEST);
}

void PlaneJoiner::bindState(const State& state, SceneProgram& program) const
{
    const GladGLContext& gl = resources_.context.gl;
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, state.values);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_2D, state.counts);
    program.set("values", 0);
    program.set("counts", 1);
}

void PlaneJoiner::addLayers(const RayProjection& projection, const Planes& planes, std::size_t first,
                            std::size_t count)
{
    const GladGLContext& gl = resources_.context.gl;
    SceneProgram& program = programOf(resources_.programs, projection, kAddMain);
    program.use();
    bindState(states_[newest_], program);
    gl.ActiveTexture(GL_TEXTURE2);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, layers_);
    program.set("layers", 2);
    program.set("layerCount", static_cast<int>(count));
    program.set("intensityThreshold", projection.intensityThreshold);
    std::vector<float> numbers;
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(static_cast<float>(planes.number(first + i)));
    program.set("planes", std::span<const float>(numbers));
    newest_ = 1 - newest_;
    gl.BindFramebuffer(GL_FRAMEBUFFER, states_[newest_].framebuffer);
    drawTriangle();
}

void PlaneJoiner::join(const RayProjection& projection, const Planes& planes)
{
    const GladGLContext& gl = resources_.context.gl;
    prepare(planes.width, planes.height);
    gl.BindFramebuffer(GL_FRAMEBUFFER, states_[newest_].framebuffer);
    constexpr float kNone[4] = {};
    gl.ClearBufferfv(GL_COLOR, 0, kNone);
    gl.ClearBufferfv(GL_COLOR, 1, kNone);
    gl.Disable(GL_BLEND);
    const auto most = static_cast<std::size_t>(layerCount_);
    for (std::size_t first = 0; first < planes.count; first += most) {
        const std::size_t count = std::min(most, planes.count - first);
        drawLayers(planes, first, count);
        addLayers(projection, planes, first, count);
    }
    gl.Enable(GL_BLEND);
}

SceneProgram& PlaneJoiner::drawState(const RayProjection& projection, const char* mainFunction)
{
    SceneProgram& program = programOf(resources_.programs, projection, mainFunction);
    program.use();
    bindState(states_[newest_], program);
    program.set("intensityThreshold", projection.intensityThreshold);
    return program;
}

void PlaneJoiner::draw(const RayProjection& projection)
{
    drawState(projection, kShowMain);
    drawTriangle();
}

void PlaneJoiner::keep(const RayProjection& projection, double spacing)
{
    drawState(projection, kKeepMain).set("spacing", static_cast<float>(spacing));
    drawTriangle();
}

void PlaneJoiner::drawTriangle()
{
    triangle_.sendPictureTriangle();
    resources_.context.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace vo
