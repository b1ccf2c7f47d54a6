#include "draw/draw_state.h"

#include "polygonize/camera.h"

namespace vo {

namespace {

constexpr int kClipPlanes = 8;

glm::dmat4 getMatrix(const GladGLContext& gl, GLenum name)
{
    glm::dmat4 matrix{1.0};
    gl.GetDoublev(name, &matrix[0][0]);
    return matrix;
}

void readFixedFunctionState(const ContextRecord& context, DrawState& state)
{
    const GladGLContext& gl = context.gl;
    state.model = getMatrix(gl, GL_MODELVIEW_MATRIX);
    state.projection = getMatrix(gl, GL_PROJECTION_MATRIX);
    state.textureMatrix = glm::mat4(getMatrix(gl, GL_TEXTURE_MATRIX));
    gl.GetFloatv(GL_CURRENT_COLOR, &state.color[0]);
    for (int i = 0; i < state.clipPlaneCount; ++i) {
        glm::dvec4 plane(0.0);
        gl.GetClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), &plane[0]);
        state.clipPlanes[static_cast<std::size_t>(i)] = glm::vec4(plane);
    }
    GLint shadeModel = GL_SMOOTH;
    gl.GetIntegerv(GL_SHADE_MODEL, &shadeModel);
    state.flat = shadeModel == GL_FLAT;
}

void readFixedFunctionTexturing(const GladGLContext& gl, DrawState& state)
{
    state.texturing = gl.IsEnabled(GL_TEXTURE_3D)   ? Texturing::threeDimensional
                      : gl.IsEnabled(GL_TEXTURE_2D) ? Texturing::twoDimensional
                                                    : Texturing::none;
    GLint environment = GL_MODULATE;
    gl.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &environment);
    state.replace = environment == GL_REPLACE;
    state.texgen = gl.IsEnabled(GL_TEXTURE_GEN_S);
    if (!state.texgen) return;
    constexpr GLenum coordinates[] = {GL_S, GL_T, GL_R};
    for (std::size_t i = 0; i < 3; ++i)
        gl.GetTexGenfv(coordinates[i], GL_OBJECT_PLANE, &state.texgenPlanes[i][0]);
}

} // namespace

DrawState readDrawState(const ContextRecord& context)
{
    const GladGLContext& gl = context.gl;
    DrawState state;
    GLint unit = GL_TEXTURE0, units = 2;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    gl.GetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    state.voxelUnit = unit - GL_TEXTURE0;
    state.tableUnit = (state.voxelUnit + 1) % units;
    for (int i = 0; i < kClipPlanes; ++i)
        if (gl.IsEnabled(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i))) state.clipPlaneCount = i + 1;
    GLint modes[2] = {GL_FILL, 0};
    gl.GetIntegerv(GL_POLYGON_MODE, modes);
    const bool alike = context.core || modes[0] == modes[1];
    state.polygonMode = alike ? static_cast<GLenum>(modes[0]) : GL_FILL;

    if (context.core) {
        const ContextState& s = context.state;
        state.model = s.model;
        state.projection = s.projection;
        state.textureMatrix = glm::mat4(s.texture);
        state.color = s.color;
        for (std::size_t i = 0; i < s.clipPlanes.size(); ++i)
            state.clipPlanes[i] = glm::vec4(s.clipPlanes[i]);
    } else {
        readFixedFunctionState(context, state);
    }
    readBoundTexture(context, state);
    return state;
}

void setOpacityPerLength(const ContextRecord& context, const glm::dmat3& gauge, DrawState& state)
{
    if (!(context.state.unitLength > 0.0)) return;
    const std::optional<Camera> camera = findCamera(state.model, state.projection);
    if (!camera) return;
    state.opacityPerLength = true;
    state.sampleGauge = glm::mat3(gauge * context.state.unitLength);
    state.viewer = camera->perspective ? glm::vec4(glm::vec3(camera->eye), 1.0f)
                                       : glm::vec4(glm::vec3(camera->direction), 0.0f);
}

void readBoundTexture(const ContextRecord& context, DrawState& state)
{
    const GladGLContext& gl = context.gl;
    if (context.core) {
        const ContextState& s = context.state;
        state.texturing = s.enabledTarget == GL_TEXTURE_3D   ? Texturing::threeDimensional
                          : s.enabledTarget == GL_TEXTURE_2D ? Texturing::twoDimensional
                                                             : Texturing::none;
        state.texgen = s.texgen;
        state.texgenPlanes = s.texgenPlanes;
    } else {
        readFixedFunctionTexturing(gl, state);
    }
    if (state.texturing == Texturing::none) return;
    GLint bound = 0;
    gl.GetIntegerv(state.texturing == Texturing::threeDimensional ? GL_TEXTURE_BINDING_3D
                                                                  : GL_TEXTURE_BINDING_2D,
                   &bound);
    const auto name = static_cast<GLuint>(bound);
    state.oneChannel = false;
    state.textureHasAlpha = true;
    const auto id = context.textureIds.find(name);
    if (id == context.textureIds.end()) return;
    const ResidentTexture& texture = context.textures.at(id->second);
    state.oneChannel = texture.oneChannel;
    state.textureHasAlpha = texture.hasAlpha;
}

} // namespace vo
