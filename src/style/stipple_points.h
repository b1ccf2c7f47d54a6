#pragma once

#include "style/styled_scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace vo {

/// A point of a stippled volume.
struct StipplePoint
{
    glm::vec3 position; ///< local
    glm::vec3 color;
};

/// Most points that a voxel has where all of the proposal's factors are 1.
constexpr float kStippleMost = 16.0f;
/// Points of one volume at most: where there would be more, all voxels have fewer in the same proportion.
constexpr std::size_t kStipplePoints = std::size_t{1} << 24;

/// The points of a volume that has StippleFactors, as the scene's viewer is to see them: opaque, a pixel
/// each. A voxel has N = kStippleMost Tb Ts Td Tl Tr Ti of them, at most four times kStippleMost, spread
/// evenly over its box. The equations are those of the proposal of 2005 (section 4.10), in which
///
/// - Cv is the voxel's opacity after the volume's chain, of a unit of length; the points have its colour;
/// - Df is the gradient as styles have it in |Df|, and -n in Df.V;
/// - Tb has its second term where n is turned at least gradientThreshold away from the line of sight;
/// - Td: z is how far the voxel is in front of the volume's farthest corner, a the same of the nearest;
/// - Tl: n.Li, 0 where it is negative, in place of Li.Df; a factor for each light;
/// - Tr: 1 without StippleFactors::originalDistance.
///
/// Where points lie, and which of a voxel's come first, depends on the voxel alone: if the view changes, few
/// come or go. The box of the volume is filled, within its clip planes; segments and tetrahedra are not
/// looked at. In up to `threads` threads (0: the usual number), the same points for any. Throws
/// std::bad_alloc.
std::vector<StipplePoint> stipplePoints(const StyledScene& scene, const StyledVolume& volume, int threads);

} // namespace vo
