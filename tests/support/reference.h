#pragma once

#include "support/fields.h"
#include "support/views.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace vo::test {

/// spherical: concentric shells round the eye of a perspective view, spheres where the period is the same on
/// all axes; for the whole volume only.
enum class SamplingPlanes { viewportAligned, axisAligned, spherical };
enum class Classification { none, preInterpolation, postInterpolation };
/// over: source alpha over one minus source alpha. max, min: GL_MAX, GL_MIN of what is drawn. sum: GL_ONE,
/// GL_ONE.
/// premultiplied: over, with colours that are not weighted with alpha.
enum class Compositing { over, max, min, sum, premultiplied };

using Tetrahedron = std::array<glm::dvec3, 4>;

/// What is to be drawn. All positions in voxels: voxel i spans [i, i + 1] and is centred at i + 0.5.
struct Scene
{
    const Field* volume = nullptr;
    View view;
    int width = 0; ///< pixels
    int height = 0;

    SamplingPlanes planes = SamplingPlanes::viewportAligned;
    /// Voxels along each axis; nothing: exactly maxSamples planes.
    std::optional<glm::dvec3> period = glm::dvec3(1.0);
    int maxSamples = std::numeric_limits<int>::max();
    /// 0, 1 or 2: a stack of two-dimensional textures across that axis, planes (axisAligned) at 1/2 + m *
    /// period, bilinear in the slice that holds the plane. -1: a three-dimensional texture.
    int stackAxis = -1;

    /// Layers shared by bricks; the picture shows [overlap/2, size - overlap/2] on each axis that is thicker
    /// than 1 and not the stack's.
    int overlap = 0;
    /// Tetrahedra that do not overlap; none: the whole volume.
    std::vector<Tetrahedron> geometry;

    /// The texture has no alpha of its own: (r, g, b, 1). A table before interpolation reads voxels, and
    /// replaces it.
    bool opaqueTexture = false;
    Classification classification = Classification::none;
    /// Entries of red, green, blue, alpha; entry i stands for i / (n - 1). Each component reads its own
    /// column.
    std::vector<float> table;
    std::array<double, 4> color{1.0, 1.0, 1.0, 1.0}; ///< multiplies each sample

    Compositing compositing = Compositing::over;
    std::array<double, 3> background{0.0, 0.0, 0.0};

    /// What shows at a point of space, in place of the volume there; nothing where nothing is drawn. The
    /// planes stay those of the geometry, and `volume` gives no more than the size of the scene.
    std::function<std::optional<std::array<double, 4>>(const glm::dvec3&)> sampleAt;
};

/// Rows from the bottom, four numbers a pixel: the red, green and blue that a float target would hold, and an
/// opacity: 1 - product of (1 - alpha) for over, max, min or sum of the alphas for the others, 0 where
/// nothing was drawn.
struct Picture
{
    int width = 0;
    int height = 0;
    std::vector<double> rgba;
    /// 1 where pictures can be compared, 0 within 1/200 pixel of the edge of a slice; with shells, also where
    /// the ray enters or leaves the volume within 1/48 step of a sample.
    std::vector<std::uint8_t> unmasked;

    const double* pixel(int x, int y) const;
    bool isUnmasked(int x, int y) const;
};

/// The planes of a scene, from the farthest: the points p with dot(normal, p) = offsets[k]. The normal points
/// away from the viewer and is scaled so that offsets are lengths along the line of sight.
struct ReferencePlanes
{
    glm::dvec3 normal{0.0, 0.0, 1.0};
    std::vector<double> offsets;
};

ReferencePlanes referencePlanes(const Scene& scene);

/// The shells of a spherical scene, from the farthest: the points p with length((p - eye) / scale) =
/// radii[k].
struct ReferenceShells
{
    glm::dvec3 eye{0.0};
    glm::dvec3 scale{1.0};
    std::vector<double> radii;
    double spacing = 0.0;
};

ReferenceShells referenceShells(const Scene& scene);

/// The scene in double precision: samples, exact trilinear and clamped at the volume's edge, where the ray
/// through each pixel's centre meets the planes, from the farthest to the nearest.
Picture referencePicture(const Scene& scene);

/// The sample of a scene at a point (voxels), before the current colour.
std::array<double, 4> referenceSample(const Scene& scene, const glm::dvec3& point);

} // namespace vo::test
