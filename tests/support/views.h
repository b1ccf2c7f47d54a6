#pragma once

#include "core/volume_size.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace vo::test {

/// Sixteen numbers column by column, as OpenGL takes them.
using Matrix = std::array<double, 16>;

Matrix identity();
/// a * b: what b does comes first.
Matrix multiply(const Matrix& a, const Matrix& b);
Matrix translation(double x, double y, double z);
Matrix scaling(double x, double y, double z);
/// As glRotated.
Matrix rotation(double degrees, double x, double y, double z);
/// As glOrtho.
Matrix ortho(double left, double right, double bottom, double top, double near, double far);
/// As glFrustum.
Matrix frustum(double left, double right, double bottom, double top, double near, double far);
/// As gluPerspective.
Matrix perspective(double degreesHigh, double aspect, double near, double far);

/// A view of a volume: both matrices, from the volume's own frame (voxels) to the screen.
struct View
{
    Matrix model = identity();
    Matrix projection = identity();
};

struct Angles
{
    double latitude = 0.0;  ///< degrees
    double longitude = 0.0; ///< degrees
};

/// What the guide's programs do: the volume's centre comes to the origin, is scaled, turned by -longitude
/// round z and by -latitude - 90 round x. At (0, 0) x points right, z up and y away from the viewer.
Matrix guideModel(const Angles& angles, const VoxelSize& volume, const glm::dvec3& scale = glm::dvec3(1.0));

/// Half the diagonal of the scaled volume: half the smaller side of the window.
double halfDiagonal(const VoxelSize& volume, const glm::dvec3& scale = glm::dvec3(1.0));

/// The demos' orthographic view: the volume's centre in the middle, half the smaller side of the window as
/// long as half the diagonal of the scaled volume.
View orthographicView(const Angles& angles, const VoxelSize& volume, int width, int height,
                      const glm::dvec3& scale = glm::dvec3(1.0));
/// A perspective view, `degreesHigh` over the smaller side, from where the ball around the volume just fits.
View perspectiveView(const Angles& angles, const VoxelSize& volume, int width, int height, double degreesHigh,
                     const glm::dvec3& scale = glm::dvec3(1.0));

/// Every 30 degrees round the volume, level, from above at 90 degrees and from below at -40: 36.
std::vector<Angles> fixedViews();
/// Directions spread evenly over the sphere, the same for the same seed everywhere.
std::vector<Angles> randomViews(int count, unsigned seed);
/// Any turn of space, the same for the same seed everywhere.
Matrix randomRotation(unsigned seed);

} // namespace vo::test
