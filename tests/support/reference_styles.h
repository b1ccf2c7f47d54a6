#pragma once

#include "style/styles.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <memory>
#include <variant>
#include <vector>

/// The equations of the styles in double precision, written apart from src/style. A picture knows styles
/// behind pointers; the reference knows the fields of those that styleWithReference() made.
namespace vo::test {

using ReferenceStyle = std::variant<OpacityMap, BoundaryEnhancement, Cartoon, EdgeEnhancement,
                                    SilhouetteEnhancement, ToneMapped, Shaded, Blended>;

/// The style as the library makes it. The reference keeps its fields, and the style, as long as the program
/// runs.
std::shared_ptr<const Style> styleWithReference(const ReferenceStyle& fields);

/// A sample on its way through a chain; names and spaces as in SampleBatch.
struct ReferenceSample
{
    glm::dvec4 voxel{0.0};
    glm::dvec3 place{0.0}, position{0.0}, V{0.0}, n{0.0};
    double gradient = 0.0;
    glm::dvec3 Cv{0.0};
    double Ov = 0.0;
    std::vector<double> lightThrough; ///< of each light, for shadows; missing: all of it
};

/// Sets Cv and Ov from the voxel.
void referenceFirstColor(int components, ReferenceSample& sample);
void referenceStep(const ReferenceStyle& style, const StyleSurroundings& surroundings,
                   ReferenceSample& sample);
/// Styles of styleWithReference(), in order; others throw std::invalid_argument.
void referenceChain(const StyleChain& chain, const StyleSurroundings& surroundings, ReferenceSample& sample);

/// A texture at a place, as voxel_texture.h says; components it lacks are 0.
glm::dvec4 referenceTexel(const VoxelTexture& texture, const glm::dvec3& place);
/// The same where it is read otherwise than it says itself.
struct TextureReading
{
    std::array<bool, 3> repeats{};
    bool nearest = false;
};
glm::dvec4 referenceTexel(const VoxelTexture& texture, const glm::dvec3& place,
                          const TextureReading& reading);
/// The normal that a texel 0 to 1 stands for: unit, or 0.
glm::dvec3 referenceNormal(const glm::dvec4& texel);
/// Df in local space: central differences of the value, one voxel to each side, over the shortest edge of a
/// voxel in a box of `dimensions`.
glm::dvec3 referenceGradient(const VoxelTexture& voxels, const glm::dvec3& dimensions,
                             const glm::dvec3& place, const glm::dmat3& placeFromLocal);
/// Sets n and gradient.
void setNormal(const glm::dvec3& gradient, ReferenceSample& sample);

/// CE + sum over lights, at most 1: of Shaded and of surfaces. All in one space. `through`: see lightThrough.
struct ReferenceMaterial
{
    glm::dvec3 diffuse{0.0}, emissive{0.0}, specular{0.0};
    double ambientIntensity = 0.0, shininess = 0.0;
};
glm::dvec3 referenceLit(const ReferenceMaterial& material, const std::vector<StyleLight>& lights,
                        const glm::dvec3& position, const glm::dvec3& n, const glm::dvec3& V,
                        const std::vector<double>& through = {});
/// The unit vector from a position to a light.
glm::dvec3 referenceWayTo(const StyleLight& light, const glm::dvec3& position);

} // namespace vo::test
