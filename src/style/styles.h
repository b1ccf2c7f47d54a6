#pragma once

#include "style/style.h"

#include <memory>

/// The styles of X3D, one file each. Fields have the names and the meaning of the standard; where a field is
/// a texture, nothing stands for NULL; surface normals of less than three components count as none.
namespace vo {

using TexturePointer = std::shared_ptr<const VoxelTexture>;

struct OpacityMap
{
    TexturePointer transferFunction; ///< L indexes S; LA: S, T; RGB: S, T, R; RGBA too
    /// Without a function: clear at 0 and opaque at 1 (ISO), or the other way round (2005).
    bool opaqueAtZero = false;
    int voxelComponents = 1;
};

struct BoundaryEnhancement
{
    float retainedOpacity = 0.2f, boundaryOpacity = 0.9f, opacityFactor = 2.0f;
};

struct Cartoon
{
    glm::vec4 parallelColor{0, 0, 0, 1}, orthogonalColor{1, 1, 1, 1};
    int colorSteps = 4;
    TexturePointer surfaceNormals;
};

struct EdgeEnhancement
{
    glm::vec4 edgeColor{0, 0, 0, 1};
    float gradientThreshold = 0.4f;
    TexturePointer surfaceNormals;
};

struct SilhouetteEnhancement
{
    float retainedOpacity = 1.0f, boundaryOpacity = 0.0f, sharpness = 0.5f;
    TexturePointer surfaceNormals;
};

struct ToneMapped
{
    glm::vec4 coolColor{0, 0, 1, 0}, warmColor{1, 1, 0, 0};
    TexturePointer surfaceNormals;
};

struct Shaded
{
    bool lighting = false;
    /// Of the material; without one, diffuse is the colour so far.
    bool hasMaterial = false;
    float ambientIntensity = 0.2f, shininess = 0.2f, transparency = 0.0f;
    glm::vec3 diffuse{0.8f}, emissive{0.0f}, specular{0.0f};
    TexturePointer surfaceNormals;
    bool shadows = false;          ///< of the volume itself, if lit
    ShadowTextures shadowTextures; ///< none: nothing is in shadow
};

/// Weights of BlendedVolumeStyle: of the colour so far (1) and of that of other voxels (2).
struct Blended
{
    enum class Weight { constant, alpha0, alpha1, oneMinusAlpha0, oneMinusAlpha1, table };
    TexturePointer voxels;
    glm::vec3 dimensions{1.0f}; ///< of the volume, for the gradient of these voxels
    StyleChain chain;           ///< of them
    Weight weightFunction1 = Weight::constant, weightFunction2 = Weight::constant;
    float weightConstant1 = 0.5f, weightConstant2 = 0.5f;
    TexturePointer weightTransferFunction1, weightTransferFunction2;
};

std::shared_ptr<const Style> makeStyle(OpacityMap fields);
std::shared_ptr<const Style> makeStyle(BoundaryEnhancement fields);
std::shared_ptr<const Style> makeStyle(Cartoon fields);
std::shared_ptr<const Style> makeStyle(EdgeEnhancement fields);
std::shared_ptr<const Style> makeStyle(SilhouetteEnhancement fields);
std::shared_ptr<const Style> makeStyle(ToneMapped fields);
std::shared_ptr<const Style> makeStyle(Shaded fields);
std::shared_ptr<const Style> makeStyle(Blended fields);

} // namespace vo
