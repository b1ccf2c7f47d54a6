#pragma once

#include "style/sample_batch.h"
#include "style/voxel_texture.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace vo {

class GlslChain;

/// A light of X3D, in the space of what it shines on.
struct StyleLight
{
    enum class Kind { directional, point, spot };
    Kind kind = Kind::directional;
    glm::vec3 color{1.0f};
    float intensity = 1.0f;
    float ambientIntensity = 0.0f;
    glm::vec3 position{0.0f};               ///< point and spot
    glm::vec3 direction{0.0f, 0.0f, -1.0f}; ///< in which it shines, unit; directional and spot
    glm::vec3 attenuation{1.0f, 0.0f, 0.0f};
    float radius = 100.0f;       ///< beyond it point and spot shine on nothing
    float beamWidth = 0.589049f; ///< radians; spot
    float cutOffAngle = 1.570796f;
};

/// So many lights shine on one thing at the most: programs have room for them, and shadows.
constexpr std::size_t kMostLights = 8;

/// What styles know beyond the sample, in local space.
struct StyleSurroundings
{
    std::vector<StyleLight> lights;
};

/// A box along the axes of local space.
struct LocalBox
{
    glm::vec3 low{-0.5f}, sides{1.0f};
};

/// What of each light comes through a volume to the positions of a box, which each texture fills: light i in
/// component i % 4 of texture i / 4, 0 to 1. Lights that have none shine unhindered.
struct ShadowTextures
{
    std::vector<std::shared_ptr<const VoxelTexture>> textures;
    LocalBox box;
};

/// One style: what it makes of the colour and the opacity of samples, once as C++ and once as GLSL. Both say
/// the same (docs/x3d.md has the equations).
class Style
{
public:
    virtual ~Style() = default;
    /// Reads n or gradient of the samples.
    virtual bool needsNormal() const { return false; }
    /// Reads position, or V.
    virtual bool needsPosition() const { return needsNormal(); }
    /// Surface normals that the scene gives: texels 0 to 1 stand for -1 to 1, in local space. The style reads
    /// them itself, in place of n, and then does not ask for n by needsNormal().
    virtual const VoxelTexture* surfaceNormals() const { return nullptr; }
    /// What came before is lost: it sets colour and opacity from the voxel.
    virtual bool replacesColor() const { return false; }
    /// A sample without opacity stays without. One that replacesColor() says so too: in an effectiveChain()
    /// it stands first or nowhere, so engines leave out clear samples after the first step alone.
    virtual bool keepsClear() const { return true; }
    /// No sample has opacity after it whose voxel, of one component, or whose firstColor()'s opacity, of
    /// several, lies within low to high: known of styles that replaceColor().
    virtual bool isClear(float low, float high) const { return low > high; }
    /// What firstColor() makes clear is clear after it: known of styles that replaceColor(), for voxels of
    /// several components.
    virtual bool keepsClearVoxels() const { return false; }
    /// The volume shadows what this style lights: it needs withShadows().
    virtual bool asksForShadows() const { return false; }
    /// The same style with shadows; nothing where it has no use for them.
    virtual std::shared_ptr<const Style> withShadows(const ShadowTextures&) const { return nullptr; }
    /// Changes Cv and Ov of all samples.
    virtual void apply(const StyleSurroundings& surroundings, SampleBatch& samples) const = 0;
    /// Adds its function and its call (glsl_chain.h).
    virtual void write(GlslChain& chain) const = 0;
};

/// Styles one after the other, begun by what firstColor() makes of the voxel. Borrowed pointers live as long.
using StyleChain = std::vector<std::shared_ptr<const Style>>;

/// The chain from the last style on that replaces the colour, or all of it: the picture is the same. What
/// engines are given.
StyleChain effectiveChain(const StyleChain& chain);

/// What a voxel is before any style: L has the colour L and the opacity L; LA, RGB (opacity: the mean of the
/// three) and RGBA as they are. Sets Cv and Ov.
void firstColor(int components, SampleBatch& samples);
/// Its GLSL: vec4 firstColor1(vec4 voxel) to firstColor4.
extern const char* const kFirstColorGlsl;

/// A texture at places: up to four components each, and those that are missing stay as they are.
void sampleTexture(const VoxelTexture& texture, int count, const BatchVectors& place,
                   std::array<BatchFloats, 4>& components);

} // namespace vo
