#include "cast/cast_volume.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vo {

namespace {

bool isPositive(double number)
{
    return number > 0.0 && std::isfinite(number);
}

std::size_t nearestTexel(float place, int size, bool repeats)
{
    if (repeats) place -= std::floor(place);
    const float inside = std::min(std::max(0.0f, place), 1.0f) * static_cast<float>(size);
    return static_cast<std::size_t>(std::min(static_cast<int>(inside), size - 1));
}

/// From 0 to 1 for whole numbers.
float numberIn(const VoxelTexture& texture, std::size_t index)
{
    const std::byte* const at = texture.texels.data() + index * bytesOf(texture.kind);
    std::uint16_t two = 0;
    float four = 0.0f;
    switch (texture.kind) {
    case TexelKind::uint8: return static_cast<float>(*at) / 255.0f;
    case TexelKind::uint16: std::memcpy(&two, at, sizeof two); return static_cast<float>(two) / 65535.0f;
    case TexelKind::float32: std::memcpy(&four, at, sizeof four); return four;
    }
    return 0.0f;
}

} // namespace

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
    if (volume.tetras) tetras.emplace(*volume.tetras, localFromEye);
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

int CastVolume::chainAt(const glm::vec3& place) const
{
    if (!styled->segments) return 0;
    const Segments& segments = *styled->segments;
    const VoxelTexture& texture = *segments.identifiers;
    std::size_t texel = 0;
    for (const int axis : {2, 1, 0})
        texel =
            texel * static_cast<std::size_t>(texture.size[axis]) +
            nearestTexel(place[axis], texture.size[axis], texture.repeats[static_cast<std::size_t>(axis)]);
    texel =
        texel * static_cast<std::size_t>(texture.components) + static_cast<std::size_t>(segments.component);
    const float id = std::round(numberIn(texture, texel) * segments.scale);
    const bool listed = id >= 0.0f && id < static_cast<float>(segments.chainOf.size());
    const int chain = listed ? segments.chainOf[static_cast<std::size_t>(id)] : segments.beyond;
    return chain < static_cast<int>(plans.size()) ? chain : -1;
}

bool isCast(const StyledVolume& volume)
{
    if (volume.stipple || !volume.voxels || !isUsable(*volume.voxels)) return false;
    if (!isInvertible(volume.worldFromLocal)) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (!isPositive(static_cast<double>(volume.dimensions[axis]))) return false;
    if (volume.segments) {
        const auto& texture = volume.segments->identifiers;
        if (!texture || !isUsable(*texture)) return false;
        if (volume.segments->component < 0 || volume.segments->component >= texture->components) return false;
    }
    if (volume.surfaces && volume.surfaces->chains.empty()) return false;
    return isPositive(volume.unitLength) && isPositive(volume.spacing) && !volume.chains.empty();
}

} // namespace vo
