#pragma once

#include "style/style.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace vo {

/// Rays are joined to one colour by a maximum, minimum or mean (ProjectionVolumeStyle), which then goes over
/// what lies behind the place where the ray enters the volume: its box, as far as it is seen and not clipped;
/// of tetrahedra, behind the first sample. It is a grey: of the mean of a sample's red, green and blue after
/// the chain. Its opacity is that of the voxel (second of two components, fourth of four, else 1) where the
/// chain is empty, else that after the chain, as it is and for no length; of the sample that was chosen, or
/// the mean of all. Samples behind an opaque surface are not looked at.
struct RayProjection
{
    enum class Type { max, min, average };
    Type type = Type::max;
    /// Above 0: the first local maximum above it, or the first local minimum below it: the first sample
    /// beyond the threshold after which the ray ends or turns back. None: the greatest, or the least, of all.
    float intensityThreshold = 0.0f;
};

/// Surfaces where the first component of the voxels crosses a value. chains[i] belongs to values[i]; the last
/// one to all values after it. A crossing lies between two neighbouring samples of a ray, both in the volume,
/// one below the value and one not, where the line between the two has the value; its opacity is that after
/// the chain, for no length.
struct IsoSurfaces
{
    std::vector<float> values;                     ///< rising
    std::vector<StyleChain> chains;                ///< at least one
    float surfaceTolerance = 0.0f;                 ///< crossings with a smaller |Df| are none
    std::shared_ptr<const VoxelTexture> gradients; ///< normals of them, 0 to 1 for -1 to 1; may be missing
};

/// Voxels have the style of their segment. The nearest texel of `identifiers`, of their component
/// `component`, is the number: texel value * scale, rounded. chainOf[id]: which of the volume's chains; -1:
/// the segment is not drawn. Numbers past the end have the chain `beyond`.
struct Segments
{
    std::shared_ptr<const VoxelTexture> identifiers;
    int component = 0;
    float scale = 255.0f;
    std::vector<int> chainOf;
    int beyond = 0;
};

/// Factors of StippleVolumeStyle, by the names of the proposal of 2005.
struct StippleFactors
{
    float distanceFactor = 1.0f, interiorFactor = 1.0f, lightingFactor = 1.0f, resolutionFactor = 1.0f;
    float gradientThreshold = 0.4f;
    float gradientRetainedOpacity = 1.0f, gradientBoundaryOpacity = 0.0f, gradientOpacityFactor = 1.0f;
    float silhouetteRetainedOpacity = 1.0f, silhouetteBoundaryOpacity = 0.0f, silhouetteOpacityFactor = 1.0f;
    /// Dnear + d0: from the eye to the volume's centre, along the view, when the scene began; 0: as it is
    /// now.
    float originalDistance = 0.0f;
    std::shared_ptr<const VoxelTexture> surfaceNormals;
};

/// Other geometry than the box of a volume: tetrahedra with local positions and texture coordinates at their
/// corners.
struct StyledTetras
{
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> places;
    std::vector<int> indices; ///< four a tetrahedron
};

/// A volume as it is drawn. The box lies round the local origin, dimensions wide: place = position /
/// dimensions + 1/2.
struct StyledVolume
{
    glm::dmat4 worldFromLocal{1.0};
    glm::vec3 dimensions{1.0f};
    std::shared_ptr<const VoxelTexture> voxels;
    std::shared_ptr<const StyledTetras> tetras; ///< nothing: the box
    std::vector<StyleChain> chains{1};          ///< one, or those that segments have
    std::optional<Segments> segments;
    std::optional<RayProjection> projection;
    std::optional<IsoSurfaces> surfaces;   ///< in place of chains
    std::optional<StippleFactors> stipple; ///< points in place of samples
    std::vector<glm::dvec4> clipPlanes;    ///< world; kept where dot(plane, p) >= 0
    StyleSurroundings surroundings;        ///< local
    /// The length, local, of which opacities are meant: a voxel's shortest edge, dimensions / size.
    double unitLength = 1.0;
    /// Distance of sampling planes along the view in the world: unitLength in the world, if not finer.
    double spacing = 1.0;
    int id = 0; ///< for picking: which node
};

/// Triangles with a material, or points and lines of them.
struct StyledSurface
{
    glm::dmat4 worldFromLocal{1.0};
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< unit, one a position
    std::vector<glm::vec4> colors;  ///< one a position in place of diffuse and transparency, or none
    std::vector<int> triangles;     ///< three a triangle, counterclockwise from outside
    bool lit = true;                ///< else emissive alone
    bool solid = true;              ///< seen from outside alone
    float ambientIntensity = 0.2f, shininess = 0.2f, transparency = 0.0f;
    glm::vec3 diffuse{0.8f}, emissive{0.0f}, specular{0.0f};
    std::vector<StyleLight> lights;     ///< world
    std::vector<glm::dvec4> clipPlanes; ///< world
    int id = 0;

    /// Nothing shows through a triangle, given where it begins in `triangles`.
    bool isOpaque(std::size_t first) const
    {
        const auto isSolid = [this](int corner) {
            return colors[static_cast<std::size_t>(corner)].a >= 1.0f;
        };
        const auto corners = triangles.begin() + static_cast<std::ptrdiff_t>(first);
        return colors.empty() ? transparency <= 0.0f : std::all_of(corners, corners + 3, isSolid);
    }
};

/// Sky and ground colours, from the zenith and the nadir down and up (Background of X3D).
struct SkyColors
{
    std::vector<float> skyAngles, groundAngles;  ///< radians, rising
    std::vector<glm::vec3> sky{glm::vec3(0.0f)}; ///< one more than angles
    std::vector<glm::vec3> ground;               ///< one more than angles, or none
    glm::dmat3 worldFromBackground{1.0};
    float opacity = 1.0f; ///< of the sky: 0 leaves the picture clear
};

/// All that one picture needs: no files, no nodes. Of samples at the same depth those of the volume that
/// comes first in the list are in front.
struct StyledScene
{
    int width = 512, height = 512;
    glm::dmat4 eyeFromWorld{1.0}; ///< a rigid motion: the eye at the origin looks along -z
    glm::dmat4 clipFromEye{1.0};
    SkyColors background;
    std::vector<StyledVolume> volumes;
    std::vector<StyledSurface> surfaces;
};

/// Where the samples of a volume lie: on planes across the view at eye depths -z = (k + 1/2) * spacing, k any
/// whole number, the same for all volumes of one spacing. A sample counts for the part of its ray between the
/// middles to its neighbours, so its opacity is 1 - (1 - Ov)^(length / unitLength), that length in local
/// space.
inline double sampleDepth(double spacing, double k)
{
    return (k + 0.5) * spacing;
}

/// A pixel whose centre lies on an edge (of a volume's box, a tetrahedron, a triangle, at a clip plane)
/// belongs to one of its two sides: to what is on its right, or above it where the edge is level. It looks
/// for edges, and for nothing else, this far past its centre: far more than rounding moves them, far less
/// than the steps in which OpenGL places corners; and less up than to the right.
constexpr double kPixelsPastCenter = 1.0 / 2048.0, kPixelsAboveCenter = kPixelsPastCenter / 2.0;

/// A picture: red, green, blue (multiplied by alpha) and alpha, rows from the bottom; and the depth in eye
/// space of what was seen first with an opacity of at least 1/2 so far, or infinity.
struct ScenePicture
{
    int width = 0, height = 0;
    std::vector<float> rgba;
    std::vector<float> depth;
};

} // namespace vo
