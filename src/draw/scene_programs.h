#pragma once

#include "draw/scene_context.h"
#include "style/glsl_chain.h"
#include "style/style.h"

#include <glm/mat4x4.hpp>

#include <map>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>

namespace vo {

/// A linked program; names of uniforms that it does not use are passed over. What is set goes to the program
/// that is in use, so use() comes first.
class SceneProgram
{
public:
    SceneProgram(const GladGLContext& gl, GLuint name) : gl_(gl), name_(name) {}

    void use() const { gl_.UseProgram(name_); }
    void set(const std::string& name, int value);
    void set(const std::string& name, float value);
    void set(const std::string& name, const glm::vec2& value);
    void set(const std::string& name, const glm::vec3& value);
    void set(const std::string& name, const glm::vec4& value);
    void set(const std::string& name, const glm::mat3& value);
    void set(const std::string& name, const glm::mat4& value);
    void set(const std::string& name, std::span<const float> values);
    void set(const std::string& name, std::span<const glm::vec3> values);
    void set(const std::string& name, std::span<const glm::vec4> values);
    void set(const GlslChain::Uniform& uniform);
    /// lightCount and lights[].
    void set(std::span<const StyleLight> lights);

private:
    GLint location(const std::string& name);

    const GladGLContext& gl_;
    GLuint name_;
    std::unordered_map<std::string, GLint> locations_;
};

/// Programs by their texts.
class ScenePrograms
{
public:
    explicit ScenePrograms(const SceneContext& context) : context_(context) {}
    ~ScenePrograms();
    ScenePrograms(const ScenePrograms&) = delete;
    ScenePrograms& operator=(const ScenePrograms&) = delete;

    /// Compiled when it is asked for first. Throws std::runtime_error with the driver's words.
    SceneProgram& find(const std::string& vertexText, const std::string& fragmentText);

private:
    struct Linked
    {
        GLuint name;
        std::unique_ptr<SceneProgram> program;
    };

    const SceneContext& context_;
    std::map<std::string, Linked> linked_;
};

/// GLSL that declares StyleLight and `lights`: room for 8, or for as many as there are.
std::string lightDeclarations(std::size_t lights);
/// GLSL that declares clipPlanes[] and `bool isClipped(vec4 point)`.
std::string clipPlaneDeclarations(std::size_t planes);

} // namespace vo
