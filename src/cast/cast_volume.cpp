#include "cast/cast_volume.h"

#include "style/styled_voxels.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

ChainPlan::ChainPlan(const StyleChain& whole) : chain(effectiveChain(whole))
{
    while (withoutNormals < chain.size() && !chain[withoutNormals]->needsNormal())
        ++withoutNormals;
    keepsClear =
        std::all_of(chain.begin(), chain.end(), [](const auto& style) { return style->keepsClear(); });
    needsPosition =
        std::any_of(chain.begin(), chain.end(), [](const auto& style) { return style->needsPosition(); });
    beginsWithVoxel = chain.empty() || !chain.front()->replacesColor();
}

CastVolume::CastVolume(const StyledVolume& volume, const SceneRays& rays)
    : styled(&volume), localFromEye(glm::inverse(volume.worldFromLocal) * rays.worldFromEye())
{
    for (const glm::dvec4& plane : volume.clipPlanes)
        eyePlanes.push_back(plane * rays.worldFromEye());
    for (const StyleChain& chain : volume.surfaces ? volume.surfaces->chains : volume.chains)
        plans.emplace_back(chain);
    const VoxelSize& size = volume.voxels->size;
    const glm::vec3 edges = volume.dimensions / glm::vec3(size.x, size.y, size.z);
    shortestEdge = std::min({edges.x, edges.y, edges.z});
    if (volume.surfaces && volume.surfaces->gradients && isUsable(*volume.surfaces->gradients))
        gradients = SurfaceNormals(volume.surfaces->gradients);
}

void CastVolume::findClear()
{
    if (styled->voxels->components != 1) return;
    const bool samples = !styled->surfaces && !styled->projection;
    if (samples) clear = ClearValues(plans);
    if (styled->tetras || voxels->blocks().ranges.empty()) return;
    if (styled->surfaces) blocks = ClearBlocks(voxels->blocks(), *styled->surfaces);
    if (samples) blocks = ClearBlocks(voxels->blocks(), clear);
}

void CastVolume::read(int count, const BatchVectors& place, std::array<BatchFloats, 4>& voxel) const
{
    const VoxelTexture& texture = *styled->voxels;
    if (texture.components == 1) return voxels->values(count, place, voxel[0]);
    sampleTexture(texture, count, place, voxel);
    if (texture.kind != TexelKind::float32) return;
    for (std::size_t c = 0; c < static_cast<std::size_t>(texture.components); ++c)
        for (float& number : voxel[c])
            number = std::isfinite(number) ? number : 0.0f;
}

bool isCast(const StyledVolume& volume)
{
    return !volume.stipple && isSound(volume);
}

} // namespace vo
