#include "cast/styled_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

constexpr int kChunk = 16;
/// A ray that asks for more samples than this is left out: such spacings are mistakes.
constexpr double kMostPlanes = 1 << 24;

/// The part of a ray with all three numbers from 0 to 1.
void cutToUnitCube(const DepthRay& place, DepthRange& depths)
{
    for (int axis = 0; axis < 3; ++axis) {
        depths.cut(place.origin[axis], place.direction[axis]);
        depths.cut(1.0 - place.origin[axis], -place.direction[axis]);
    }
}

float finiteOrZero(float number)
{
    return std::isfinite(number) ? number : 0.0f;
}

/// What firstColor takes for the opacity.
float firstOpacity(int components, const SampleBatch& samples, std::size_t i)
{
    const auto& voxel = samples.voxel;
    switch (components) {
    case 1: return voxel[0][i];
    case 2: return voxel[1][i];
    case 3: return voxel[0][i] + voxel[1][i] + voxel[2][i];
    default: return voxel[3][i];
    }
}

} // namespace

StyledRay::StyledRay(const CastVolume& volume) : volume_(volume) {}

bool StyledRay::begin(const DepthRay& ray, DepthRange depths)
{
    const StyledVolume& styled = *volume_.styled;
    for (const glm::dvec4& plane : volume_.eyePlanes)
        depths.cut(glm::dot(glm::dvec3(plane), ray.origin) + plane.w,
                   glm::dot(glm::dvec3(plane), ray.direction));
    local_ = transformed(volume_.localFromEye, ray);
    const glm::dvec3 size(styled.dimensions);
    place_ = {local_.origin / size + 0.5, local_.direction / size};
    cutToUnitCube(place_, depths);
    if (depths.empty()) return false;
    const double first = std::ceil(depths.begin / styled.spacing - 0.5);
    const double last = std::floor(depths.end / styled.spacing - 0.5);
    if (!(first <= last) || last - first > kMostPlanes || std::abs(first) > 1e15) return false;
    plane_ = static_cast<std::int64_t>(first);
    lastPlane_ = static_cast<std::int64_t>(last);
    stepLength_ = glm::length(local_.direction) * styled.spacing / styled.unitLength;
    wanted_ = kChunk;
    return true;
}

bool StyledRay::next(FragmentRun& run)
{
    run.count = run.next = 0;
    while (run.count == 0) {
        gather();
        if (batch_.count == 0) return false;
        shade();
        emit(run);
        wanted_ = std::min(2 * wanted_, kBatchSize);
    }
    return true;
}

void StyledRay::gather()
{
    batch_.count = 0;
    while (batch_.count + kChunk <= wanted_ && plane_ <= lastPlane_) {
        const int count = static_cast<int>(std::min<std::int64_t>(kChunk, lastPlane_ - plane_ + 1));
        takeChunk(count);
        plane_ += count;
    }
}

void StyledRay::takeChunk(int count)
{
    const VoxelTexture& texture = *volume_.styled->voxels;
    const double spacing = volume_.styled->spacing;
    const glm::dvec3 start = place_.at(sampleDepth(spacing, static_cast<double>(plane_)));
    for (int axis = 0; axis < 3; ++axis) {
        const auto from = static_cast<float>(start[axis]);
        const auto step = static_cast<float>(place_.direction[axis] * spacing);
        for (std::size_t i = 0; i < kChunk; ++i)
            chunk_.place[static_cast<std::size_t>(axis)][i] = from + static_cast<float>(i) * step;
    }
    if (texture.components == 1)
        volume_.voxels->values(count, chunk_.place, chunk_.voxel[0]);
    else
        sampleTexture(texture, count, chunk_.place, chunk_.voxel);
    const bool dropsClear = volume_.plans[0].keepsClear && volume_.plans[0].beginsWithVoxel;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (dropsClear && firstOpacity(texture.components, chunk_, i) <= 0.0f) continue;
        const auto to = static_cast<std::size_t>(batch_.count++);
        for (std::size_t c = 0; c < static_cast<std::size_t>(texture.components); ++c)
            batch_.voxel[c][to] = finiteOrZero(chunk_.voxel[c][i]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            batch_.place[axis][to] = chunk_.place[axis][i];
        depth_[to] = sampleDepth(spacing, static_cast<double>(plane_ + static_cast<std::int64_t>(i)));
    }
}

void StyledRay::shade()
{
    const ChainPlan& plan = volume_.plans[0];
    const StyleChain& chain = plan.chain;
    firstColor(volume_.styled->voxels->components, batch_);
    placeSamples();
    applyStyles(chain, 0, plan.withoutNormals);
    if (plan.withoutNormals == chain.size()) return;
    if (plan.keepsClear) dropClear();
    findNormals();
    applyStyles(chain, plan.withoutNormals, chain.size());
}

void StyledRay::applyStyles(const StyleChain& chain, std::size_t from, std::size_t to)
{
    for (std::size_t i = from; i < to && batch_.count > 0; ++i)
        chain[i]->apply(volume_.styled->surroundings, batch_);
}

/// Position and V of all samples. The ray leads through the eye, in local space too.
void StyledRay::placeSamples()
{
    const glm::vec3 view(glm::normalize(-local_.direction));
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        batch_.V[a].fill(view[axis]);
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch_.count); ++i)
            batch_.position[a][i] =
                static_cast<float>(local_.origin[axis] + local_.direction[axis] * depth_[i]);
    }
}

void StyledRay::dropClear()
{
    std::size_t to = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch_.count); ++i) {
        if (!(batch_.Ov[i] > 0.0f)) continue;
        for (BatchFloats& component : batch_.voxel)
            component[to] = component[i];
        for (BatchVectors* vectors : {&batch_.place, &batch_.position, &batch_.Cv})
            for (BatchFloats& component : *vectors)
                component[to] = component[i];
        batch_.Ov[to] = batch_.Ov[i];
        depth_[to] = depth_[i];
        ++to;
    }
    batch_.count = static_cast<int>(to);
}

void StyledRay::findNormals()
{
    constexpr float kLeastGradient = 1e-6f;
    volume_.voxels->changes(batch_.count, batch_.place, batch_.n);
    auto& [x, y, z] = batch_.n;
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch_.count); ++i) {
        const glm::vec3 change = glm::vec3(x[i], y[i], z[i]) * volume_.changeScale;
        const float length = glm::length(change);
        const float scale = length >= kLeastGradient ? -1.0f / length : 0.0f;
        batch_.gradient[i] = length;
        x[i] = change.x * scale;
        y[i] = change.y * scale;
        z[i] = change.z * scale;
    }
}

void StyledRay::emit(FragmentRun& run) const
{
    const auto units = static_cast<float>(stepLength_);
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch_.count); ++i) {
        const float opacity = std::min(batch_.Ov[i], 1.0f);
        if (!(opacity > 0.0f)) continue;
        const float alpha = opacity < 1.0f ? -std::expm1(units * std::log1p(-opacity)) : 1.0f;
        const auto to = static_cast<std::size_t>(run.count++);
        run.depth[to] = depth_[i];
        run.color[to] =
            glm::vec4(batch_.Cv[0][i] * alpha, batch_.Cv[1][i] * alpha, batch_.Cv[2][i] * alpha, alpha);
    }
}

} // namespace vo
