#pragma once

#include "style/styled_scene.h"

#include <span>
#include <vector>

namespace vo {

/// Where a volume stands among what else is translucent: nothing lies between parts of it; something may, and
/// all is drawn by depth; or rays go from hit to hit (draw/ray_hits.h), it being walked through in between,
/// or having hits itself, as surfaces of values do and projections, which have one.
enum class VolumePlace { alone, among, betweenHits, ofHits };

/// For each of the volumes that are drawn. Rays go from hit to hit where something stands among others,
/// unless samples of two volumes lie between each other, or there are tetrahedra, or much that has hits.
std::vector<VolumePlace> volumePlaces(const StyledScene& scene, std::span<const StyledVolume* const> volumes);

/// Whether rays stop at each translucent triangle of a scene without volumes: where there are not many one
/// behind the other.
bool facesHaveHits(const StyledScene& scene);

/// Numbers of those that are walked through, the nearest first.
std::vector<std::size_t> walkedNearestFirst(const StyledScene& scene,
                                            std::span<const StyledVolume* const> volumes,
                                            std::span<const VolumePlace> places);

} // namespace vo
