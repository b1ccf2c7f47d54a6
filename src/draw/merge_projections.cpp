#include "draw/merge_projections.h"

#include "draw/scoped_state.h"
#include "draw/volume_shaders.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace vo {

namespace {

// Faces that lie in one plane may differ by the rounding of depths.
constexpr const char* kFragmentShader = R"(
uniform sampler2DArray projections;
uniform vec2 depths;
layout(location = 0) out vec4 fragment;

vec4 keptOf(int layer)
{
    vec4 kept = texelFetch(projections, ivec3(gl_FragCoord.xy, layer), 0);
    return kept.w > 0.0 && kept.z >= depths.x && kept.z < depths.y ? kept : vec4(0.0);
}

bool isBehind(float depth, float other)
{
    return depth > other + 2e-6 * abs(other);
}

// How much shows through what is in front of a projection.
float throughTo(vec4 kept, int layer)
{
    float through = 1.0;
    for (int other = 0; other < PROJECTIONS; ++other) {
        vec4 it = keptOf(other);
        bool inFront = isBehind(kept.z, it.z) || (other < layer && !isBehind(it.z, kept.z));
        if (other != layer && inFront) through *= 1.0 - it.y;
    }
    return through;
}

void main()
{
    fragment = vec4(0.0);
    bool any = false;
    for (int layer = 0; layer < PROJECTIONS; ++layer) {
        vec4 kept = keptOf(layer);
        if (kept.w == 0.0) continue;
        any = true;
        fragment += throughTo(kept, layer) * vec4(kept.xxx, kept.y);
    }
    if (!any) discard;
}
)";

} // namespace

ProjectionMerger::~ProjectionMerger()
{
    if (resources_.context.isCurrent()) release();
}

void ProjectionMerger::release()
{
    const GladGLContext& gl = resources_.context.gl;
    gl.DeleteFramebuffers(1, &framebuffer_);
    gl.DeleteTextures(1, &layers_);
    framebuffer_ = layers_ = 0;
    width_ = height_ = 0;
    count_ = 0;
}

void ProjectionMerger::prepare(int width, int height, std::size_t count)
{
    if (width == width_ && height == height_ && count == count_) return;
    release();
    if (count == 0) return;
    const GladGLContext& gl = resources_.context.gl;
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (count > static_cast<std::size_t>(std::max(most, 0)))
        throw std::runtime_error(std::to_string(count) + " projections stand among other things, " +
                                 "this driver merges " + std::to_string(most));
    const ScopedUploadState upload(gl, resources_.context.core);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.GenTextures(1, &layers_);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, layers_);
    gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, width, height, static_cast<GLsizei>(count), 0, GL_RGBA,
                  GL_FLOAT, nullptr);
    filterNone(gl, GL_TEXTURE_2D_ARRAY);
    gl.GenFramebuffers(1, &framebuffer_);
    width_ = width;
    height_ = height;
    count_ = count;
}

void ProjectionMerger::bind(std::size_t layer) const
{
    const GladGLContext& gl = resources_.context.gl;
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, layers_, 0, static_cast<GLint>(layer));
    constexpr float kNone[4] = {};
    gl.ClearBufferfv(GL_COLOR, 0, kNone);
}

void ProjectionMerger::use()
{
    const GladGLContext& gl = resources_.context.gl;
    const std::string version = "#version 330 core\n";
    program_ = &resources_.programs.find(version + kPictureVertexShader, version + "#define PROJECTIONS " +
                                                                             std::to_string(count_) + "\n" +
                                                                             kFragmentShader);
    program_->use();
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, layers_);
    program_->set("projections", 0);
    triangle_.sendPictureTriangle();
    gl.Disable(GL_DEPTH_TEST);
}

void ProjectionMerger::draw(double nearest, double farthest)
{
    const auto finite = [](double depth) { return static_cast<float>(std::clamp(depth, -1e38, 1e38)); };
    program_->set("depths", glm::vec2(finite(nearest), finite(farthest)));
    resources_.context.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace vo
