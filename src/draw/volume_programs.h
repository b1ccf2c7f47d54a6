#pragma once

#include "draw/chain_functions.h"
#include "style/glsl_chain.h"
#include "style/styled_scene.h"

#include <string>

namespace vo {

/// Where the parts of a vertex record of slices lie. Places of its own, and how they change with the local
/// position (three columns), are those of tetrahedra.
enum SliceAttribute : unsigned { kSliceVoxel = 0, kSlicePlace = 1, kSlicePlaceFromLocal = 2 };

/// The texts of a volume's program, and what its chains have of uniforms and textures.
struct VolumeProgram
{
    std::string vertexText, fragmentText;
    GlslChain chains;
    std::vector<int> chainNumberOf;   ///< ChainFunctions::numberOf
    std::vector<glm::vec4> chainRows; ///< ChainFunctions::rows
};

/// Whether all samples of a ray become one colour.
bool isProjected(const StyledVolume& volume);

/// How a volume is drawn: slice by slice, as samples or as surfaces between a slice and the next one behind;
/// the same ray by ray, all of a pixel at once; a projection, ray by ray; or the samples of single slices,
/// from which a projection is made later. Rays are for boxes. They draw triangles over the picture, corners
/// of which are attribute 0.
enum class VolumeWay { slices, rays, projectedRays, planeSamples };

/// What of a ray is drawn at once: all; the part behind the hit that is reached, up to the next one; or the
/// next hit, of a surface of values or of a projection (draw/ray_hits.h).
enum class RayReach { whole, betweenHits, nextHit };

struct ProgramRequest
{
    VolumeWay way = VolumeWay::slices;
    bool leaps = false;              ///< of rays: over blocks that are clear
    bool mergedLater = false;        ///< of projectedRays: not drawn, but kept for others to be put in front
    RayReach part = RayReach::whole; ///< of rays, and nextHit of projectedRays
};

VolumeProgram volumeProgram(const StyledVolume& volume, const ProgramRequest& request);

} // namespace vo
