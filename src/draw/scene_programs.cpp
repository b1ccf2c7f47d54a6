#include "draw/scene_programs.h"

#include "core/log.h"
#include "draw/link_program.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace vo {

GLint SceneProgram::location(const std::string& name)
{
    const auto found = locations_.find(name);
    if (found != locations_.end()) return found->second;
    return locations_.emplace(name, gl_.GetUniformLocation(name_, name.c_str())).first->second;
}

void SceneProgram::set(const std::string& name, int value)
{
    gl_.Uniform1i(location(name), value);
}

void SceneProgram::set(const std::string& name, float value)
{
    gl_.Uniform1f(location(name), value);
}

void SceneProgram::set(const std::string& name, const glm::vec2& value)
{
    gl_.Uniform2fv(location(name), 1, glm::value_ptr(value));
}

void SceneProgram::set(const std::string& name, const glm::vec3& value)
{
    gl_.Uniform3fv(location(name), 1, glm::value_ptr(value));
}

void SceneProgram::set(const std::string& name, const glm::vec4& value)
{
    gl_.Uniform4fv(location(name), 1, glm::value_ptr(value));
}

void SceneProgram::set(const std::string& name, const glm::mat3& value)
{
    gl_.UniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void SceneProgram::set(const std::string& name, const glm::mat4& value)
{
    gl_.UniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void SceneProgram::set(const std::string& name, std::span<const float> values)
{
    if (!values.empty()) gl_.Uniform1fv(location(name), static_cast<GLsizei>(values.size()), values.data());
}

void SceneProgram::set(const std::string& name, std::span<const glm::vec3> values)
{
    if (values.empty()) return;
    gl_.Uniform3fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}

void SceneProgram::set(const std::string& name, std::span<const glm::vec4> values)
{
    if (values.empty()) return;
    gl_.Uniform4fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}

void SceneProgram::set(const GlslChain::Uniform& uniform)
{
    std::visit([&](const auto& value) { set(uniform.name, value); }, uniform.value);
}

void SceneProgram::set(std::span<const StyleLight> lights)
{
    set("lightCount", static_cast<int>(lights.size()));
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const StyleLight& light = lights[i];
        const std::string prefix = "lights[" + std::to_string(i) + "].";
        set(prefix + "kind", static_cast<int>(light.kind));
        set(prefix + "color", light.color);
        set(prefix + "intensity", light.intensity);
        set(prefix + "ambientIntensity", light.ambientIntensity);
        set(prefix + "position", light.position);
        set(prefix + "direction", light.direction);
        set(prefix + "attenuation", light.attenuation);
        set(prefix + "radius", light.radius);
        set(prefix + "beamWidth", light.beamWidth);
        set(prefix + "cutOffAngle", light.cutOffAngle);
    }
}

ScenePrograms::~ScenePrograms()
{
    if (!context_.isCurrent()) return;
    for (const auto& [text, linked] : linked_)
        context_.gl.DeleteProgram(linked.name);
}

SceneProgram& ScenePrograms::find(const std::string& vertexText, const std::string& fragmentText)
{
    const std::string key = vertexText + fragmentText;
    const auto found = linked_.find(key);
    if (found != linked_.end()) return *found->second.program;
    debug(2, "compiling a program for a scene");
    const GLuint name = linkProgram(context_.gl, vertexText, fragmentText);
    Linked linked{name, std::make_unique<SceneProgram>(context_.gl, name)};
    return *linked_.emplace(key, std::move(linked)).first->second.program;
}

std::string lightDeclarations(std::size_t lights)
{
    return R"(
struct StyleLight {
    int kind;
    vec3 color;
    float intensity, ambientIntensity;
    vec3 position, direction, attenuation;
    float radius, beamWidth, cutOffAngle;
};
const int kMostLights = )" +
           std::to_string(std::max(lights, kMostLights)) + R"(;
uniform int lightCount;
uniform StyleLight lights[kMostLights];
)";
}

std::string clipPlaneDeclarations(std::size_t planes)
{
    if (planes == 0) return "bool isClipped(vec4 point) { return false; }\n";
    const std::string count = std::to_string(planes);
    return "uniform vec4 clipPlanes[" + count +
           "];\nbool isClipped(vec4 point)\n{\n    for (int i = 0; i < " + count +
           "; ++i)\n        if (dot(clipPlanes[i], point) < 0.0) return true;\n    return false;\n}\n";
}

} // namespace vo
