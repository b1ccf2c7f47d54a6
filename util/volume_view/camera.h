#pragma once

#include "matrix.h"

/// Where the vogl programs look from: the volume's centre in the middle of the picture, turned about it.
namespace vo {

/// Turned as the guide does: by longitude about z, then by -90 - latitude about x, so that at 0 0 z points up
/// and y away from the eye.
struct Orientation
{
    /// Degrees.
    double latitude = 0;
    double longitude = 0;
};

/// A volume as it is drawn: `size` voxels, spaced by `scale`.
struct Model
{
    std::array<double, 3> size{1, 1, 1};
    std::array<double, 3> scale{1, 1, 1};
    /// Radius of the sphere round all that is drawn, in that of the volume.
    double margin = 1;
};

/// Half the diagonal of the scaled volume, times the margin: all fits into this sphere, however it is turned.
double boundingRadius(const Model& model);

/// The view volume. The sphere round the volume just fits into the smaller side of the picture, and between
/// the near and the far plane.
struct ViewVolume
{
    /// Half sides at distance `distance` (orthographic: at any).
    double halfWidth;
    double halfHeight;
    /// From the eye to the volume's centre; 0 for an orthographic view.
    double distance;
    /// Distances from the eye; an orthographic view begins behind it.
    double nearDistance;
    double farDistance;
};

/// `degrees` is the whole angle over the smaller side, below 180; 0: orthographic. Width and height in
/// pixels.
ViewVolume viewVolume(const Model& model, double degrees, int width, int height);

/// From voxels to eye space, the eye at the origin looking along -z.
Matrix modelViewMatrix(const Model& model, const Orientation& orientation, const ViewVolume& view);
Matrix projectionMatrix(const ViewVolume& view);

} // namespace vo
