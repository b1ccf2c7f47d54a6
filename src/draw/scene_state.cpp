#include "draw/scene_state.h"

namespace vo {

namespace {

/// Switched off for the scene, or switched by it.
constexpr GLenum kCapabilities[] = {
    GL_BLEND,
    GL_DEPTH_TEST,
    GL_CULL_FACE,
    GL_COLOR_LOGIC_OP,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_SMOOTH,
    GL_DEPTH_CLAMP,
    GL_PRIMITIVE_RESTART,
    GL_RASTERIZER_DISCARD,
    GL_CLIP_DISTANCE0,
    GL_CLIP_DISTANCE1,
    GL_CLIP_DISTANCE2,
    GL_CLIP_DISTANCE3,
    GL_CLIP_DISTANCE4,
    GL_CLIP_DISTANCE5,
    GL_CLIP_DISTANCE6,
    GL_CLIP_DISTANCE7,
    GL_PROGRAM_POINT_SIZE,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_COVERAGE,
};
/// Of compatibility contexts alone.
constexpr GLenum kLegacyCapabilities[] = {GL_ALPHA_TEST, GL_POLYGON_STIPPLE, GL_POINT_SMOOTH,
                                          GL_POINT_SPRITE};

} // namespace

ScopedSceneState::ScopedSceneState(const SceneContext& context) : context_(context), gl_(context.gl)
{
    const auto switchOff = [this](GLenum name) {
        capabilities_.push_back({name, gl_.IsEnabled(name)});
        if (capabilities_.back().on) gl_.Disable(name);
    };
    for (const GLenum name : kCapabilities)
        switchOff(name);
    if (!context_.core)
        for (const GLenum name : kLegacyCapabilities)
            switchOff(name);
    gl_.GetIntegerv(GL_CURRENT_PROGRAM, &program_);
    gl_.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertexArray_);
    gl_.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &arrayBuffer_);
    saveUnits();
    saveBlending();
    saveRasterizing();
}

ScopedSceneState::~ScopedSceneState()
{
    restoreRasterizing();
    restoreBlending();
    restoreUnits();
    gl_.BindVertexArray(static_cast<GLuint>(vertexArray_));
    gl_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(arrayBuffer_));
    gl_.UseProgram(static_cast<GLuint>(program_));
    for (const auto& [name, on] : capabilities_)
        if (on)
            gl_.Enable(name);
        else
            gl_.Disable(name);
}

void ScopedSceneState::saveUnits()
{
    gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &activeTexture_);
    units_.resize(static_cast<std::size_t>(context_.mostUnits));
    for (GLuint unit = 0; unit < units_.size(); ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.GetIntegerv(GL_TEXTURE_BINDING_3D, &units_[unit].texture3d);
        gl_.GetIntegerv(GL_TEXTURE_BINDING_2D, &units_[unit].texture2d);
        gl_.GetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &units_[unit].texture2dArray);
        gl_.GetIntegerv(GL_SAMPLER_BINDING, &units_[unit].sampler);
        gl_.BindSampler(unit, 0);
    }
}

void ScopedSceneState::restoreUnits() const
{
    for (GLuint unit = 0; unit < units_.size(); ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.BindTexture(GL_TEXTURE_3D, static_cast<GLuint>(units_[unit].texture3d));
        gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(units_[unit].texture2d));
        gl_.BindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(units_[unit].texture2dArray));
        gl_.BindSampler(unit, static_cast<GLuint>(units_[unit].sampler));
    }
    gl_.ActiveTexture(static_cast<GLenum>(activeTexture_));
}

void ScopedSceneState::saveBlending()
{
    gl_.GetIntegerv(GL_BLEND_SRC_RGB, &blendFactors_[0]);
    gl_.GetIntegerv(GL_BLEND_DST_RGB, &blendFactors_[1]);
    gl_.GetIntegerv(GL_BLEND_SRC_ALPHA, &blendFactors_[2]);
    gl_.GetIntegerv(GL_BLEND_DST_ALPHA, &blendFactors_[3]);
    gl_.GetIntegerv(GL_BLEND_EQUATION_RGB, &blendEquations_[0]);
    gl_.GetIntegerv(GL_BLEND_EQUATION_ALPHA, &blendEquations_[1]);
}

void ScopedSceneState::restoreBlending() const
{
    const auto factor = [this](std::size_t i) { return static_cast<GLenum>(blendFactors_[i]); };
    gl_.BlendFuncSeparate(factor(0), factor(1), factor(2), factor(3));
    gl_.BlendEquationSeparate(static_cast<GLenum>(blendEquations_[0]),
                              static_cast<GLenum>(blendEquations_[1]));
}

void ScopedSceneState::saveRasterizing()
{
    gl_.GetIntegerv(GL_DEPTH_FUNC, &depthFunction_);
    gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    gl_.GetIntegerv(GL_FRONT_FACE, &frontFace_);
    gl_.GetIntegerv(GL_POLYGON_MODE, polygonModes_.data());
    gl_.GetIntegerv(GL_VIEWPORT, viewport_.data());
    gl_.GetFloatv(GL_POINT_SIZE, &pointSize_);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.FrontFace(GL_CCW);
    gl_.PointSize(1.0f);
}

void ScopedSceneState::restoreRasterizing() const
{
    gl_.DepthFunc(static_cast<GLenum>(depthFunction_));
    gl_.DepthMask(depthMask_);
    gl_.FrontFace(static_cast<GLenum>(frontFace_));
    gl_.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    gl_.PointSize(pointSize_);
    const auto front = static_cast<GLenum>(polygonModes_[0]), back = static_cast<GLenum>(polygonModes_[1]);
    if (context_.core || front == back) {
        gl_.PolygonMode(GL_FRONT_AND_BACK, front);
        return;
    }
    gl_.PolygonMode(GL_FRONT, front);
    gl_.PolygonMode(GL_BACK, back);
}

} // namespace vo
