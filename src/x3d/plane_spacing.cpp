#include "x3d/plane_spacing.h"

#include "style/seen_part.h"
#include "x3d/node_transform.h"

#include <algorithm>

namespace vo {

namespace {

/// In the way of a ray that crosses the volume. An opacity that is constant is off by 1/64 of its exponent.
constexpr double kFewPlanes = 32.0;
/// The same where voxels are small: as long as a ray takes.
constexpr double kManyPlanes = 4096.0;
/// Of all that is seen of it, some of which any ray meets: polygons, where planes are drawn one by one.
constexpr double kMostPlanes = 131072.0;

} // namespace

double usualSampling(const StyledVolume& volume)
{
    const auto readsNormals = [](const StyleChain& chain) {
        return std::ranges::any_of(
            chain, [](const auto& style) { return style->needsNormal() || style->surfaceNormals(); });
    };
    const bool isSampled = !volume.surfaces && !volume.stipple;
    return isSampled && std::ranges::any_of(volume.chains, readsNormals) ? 0.5 : 1.0;
}

PlaneSpacing planeSpacing(const StyledScene& scene, const StyledVolume& volume, double sampling)
{
    const double edge = volume.unitLength * smallestScale(volume.worldFromLocal);
    const auto part = seenPart(scene, volume);
    if (!part || !(part->crossing > 0.0)) return {sampling * edge, true};
    const double wanted = sampling * std::min(edge, part->crossing / kFewPlanes);
    const double distance = std::max({wanted, std::min(sampling, 1.0) * part->crossing / kManyPlanes,
                                      (part->farthest - part->nearest) / kMostPlanes});
    return {distance, distance <= std::max(wanted, part->crossing)};
}

} // namespace vo
