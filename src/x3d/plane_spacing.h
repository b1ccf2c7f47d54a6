#pragma once

#include "style/styled_scene.h"

namespace vo {

/// How far apart a user wants sampling planes, in shortest edges of a voxel.
constexpr double kLeastSampling = 0.01, kMostSampling = 100.0;

/// What it is where nobody says: 1, and 1/2 where styles read normals, which shows rings on smooth surfaces
/// otherwise. Surfaces of values are found between planes.
double usualSampling(const StyledVolume& volume);

/// Where the planes of a volume lie in one view.
struct PlaneSpacing
{
    double distance = 1.0;
    /// Rays across the volume meet a plane: it is not thinner than what the work allows.
    bool meetsVolume = true;
};
/// The message where they do not.
constexpr const char* kPlanesMissVolume =
    "expected a volume thicker than a part in 131072 of its depth in the "
    "view, found a thinner one: it is drawn with gaps";

/// Planes are `sampling` of the shortest edges of a voxel in the world apart, but at least 32 to `sampling`
/// lie in the way of a ray that crosses the volume: a sheet is seen as thick as it is. There are no more than
/// 4096 in it (with a `sampling` below 1 as many times more), and 131072 in all of what is seen.
PlaneSpacing planeSpacing(const StyledScene& scene, const StyledVolume& volume, double sampling);

} // namespace vo
