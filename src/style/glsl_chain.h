#pragma once

#include "style/style.h"
#include "style/table_stack.h"

#include <glm/vec2.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace vo {

/// Collects the GLSL of chains of styles, for one program. A style adds its function once and a call of it,
/// with uniforms of its own:
///
///     chain.function("edgeEnhancement", "vec4 edgeEnhancement(vec4 color, StyleSample s, vec4 edgeColor,
///     float threshold) {...}"); chain.step("edgeEnhancement", {chain.uniform(edgeColor_),
///     chain.uniform(threshold_)});
///
/// makes `color = edgeEnhancement(color, s, u0, u1);`. What functions may use is declared before them:
///
///     struct StyleSample { vec4 voxel; vec3 place, position, V, n; float gradient; };
///     struct StyleLight { int kind; vec3 color; float intensity, ambientIntensity; vec3 position, direction,
///     attenuation;
///                         float radius, beamWidth, cutOffAngle; };   // kind: 0 directional, 1 point, 2 spot
///     const int kMostLights = 8; uniform int lightCount; uniform StyleLight lights[kMostLights];
///     vec4 styleTexture(sampler3D texture, vec3 place);  // clamped, repeated and filtered as the texture
///     says
class GlslChain
{
public:
    using Value = std::variant<int, float, glm::vec2, glm::vec3, glm::vec4>;
    struct Uniform
    {
        std::string name;
        Value value;
    };
    struct Texture
    {
        std::string name; ///< of a sampler3D, whatever its dimensions
        std::shared_ptr<const VoxelTexture> texture;
    };

    GlslChain() = default;
    /// Tables of values are read from a stack.
    explicit GlslChain(std::shared_ptr<TableStack> tables) : tables_(std::move(tables)) {}

    /// Nothing: each table is a texture of its own.
    const std::shared_ptr<TableStack>& tableStack() const { return tables_; }

    /// Defines a function, once for each name.
    void function(std::string_view name, std::string_view text);
    /// Their names.
    std::string uniform(const Value& value);
    std::string texture(std::shared_ptr<const VoxelTexture> texture);
    /// Adds `color = name(color, s, arguments...);`.
    void step(std::string_view name, const std::vector<std::string>& arguments);
    /// Adds a statement as it is.
    void statement(std::string_view text);

    /// Begins chains that are written as one, since they differ in their uniforms alone: in those whose
    /// number, from 0 on, is set in `differ`. A chain has a row of vec4 for these, which `chainNumber(int)`
    /// answers. To be declared before: `sampler3D chainNumbers`, and kListPlaceGlsl (texel_list.h).
    void beginRow(std::vector<bool> differ);

    /// Ends a chain: `vec4 NAME(vec4 color, StyleSample s)`, which has the steps so far and returns the
    /// color. After beginRow() `vec4 NAME(int row, vec4 color, StyleSample s)`, with the number of the row's
    /// first vec4.
    void endFunction(std::string_view name);

    const std::string& declarations() const { return declarations_; } ///< of uniforms
    const std::string& functions() const { return functions_; }
    const std::vector<Uniform>& uniforms() const { return uniforms_; }
    const std::vector<Texture>& textures() const { return textures_; }

private:
    std::string numberInRow(const Value& value);

    std::shared_ptr<TableStack> tables_;
    std::string declarations_, functions_, steps_;
    bool hasRow_ = false;
    std::vector<bool> differ_;
    std::size_t asked_ = 0, inRow_ = 0; ///< uniforms since beginRow(), and those of them in the row
    std::string rowReads_;
    std::vector<std::string> defined_;
    std::vector<Uniform> uniforms_;
    std::vector<Texture> textures_;
};

} // namespace vo
