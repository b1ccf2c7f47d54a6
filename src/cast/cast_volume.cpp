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
    keepsClearVoxels = keepsClear && (beginsWithVoxel || chain.front()->keepsClearVoxels());
}

CastVolume::CastVolume(const StyledVolume& volume, const SceneRays& rays)
    : styled(&volume), localFromEye(glm::inverse(volume.worldFromLocal) * rays.worldFromEye()),
      edgesFromEye(localFromEye * rays.shift())
{
    for (const glm::dvec4& plane : volume.clipPlanes)
        eyePlanes.push_back(plane * rays.worldFromEye() * rays.shift());
    for (const StyleChain& chain : volume.surfaces ? volume.surfaces->chains : volume.chains)
        plans.emplace_back(chain);
    const VoxelSize& size = volume.voxels->size;
    const glm::vec3 edges = volume.dimensions / glm::vec3(size.x, size.y, size.z);
    shortestEdge = std::min({edges.x, edges.y, edges.z});
    if (volume.surfaces && volume.surfaces->gradients && isUsable(*volume.surfaces->gradients))
        gradients = SurfaceNormals(volume.surfaces->gradients);
}

void CastVolume::findClear(std::span<const std::uint64_t> chainsIn)
{
    const bool one = styled->voxels->components == 1;
    const bool samples = !styled->surfaces && !styled->projection;
    if (one && samples) clear = ClearValues(plans);
    if (styled->tetras || voxels->blocks().ranges.empty()) return;
    if (samples) {
        blocks = ClearBlocks(voxels->blocks(), clearValuesOf(plans, styled->voxels->components), chainsIn);
    } else if (styled->surfaces) {
        if (one) blocks = ClearBlocks(voxels->blocks(), *styled->surfaces);
    } else if (one && projectsVoxels()) {
        leapsByValue = true;
        blocks = ClearBlocks(voxels->blocks(), styled->projection->type);
    }
}

/// A sample's part in the projection follows from its value alone, wherever on the ray it is.
bool CastVolume::projectsVoxels() const
{
    if (std::any_of(plans.begin(), plans.end(), [](const ChainPlan& plan) { return !plan.chain.empty(); }))
        return false;
    if (styled->projection->type == RayProjection::Type::average) return !styled->segments;
    return !(styled->projection->intensityThreshold > 0.0f);
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
