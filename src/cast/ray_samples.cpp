#include "cast/ray_samples.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

/// Position and V. The ray leads through the eye, in local space too.
void placeSamples(const DepthRay& local, RaySamples& samples)
{
    const glm::vec3 view(glm::normalize(-local.direction));
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        samples.batch.V[a].fill(view[axis]);
        for (std::size_t i = 0; i < static_cast<std::size_t>(samples.batch.count); ++i)
            samples.batch.position[a][i] =
                static_cast<float>(local.origin[axis] + local.direction[axis] * samples.depth[i]);
    }
}

/// Moves those with opacity to the front; the others are left behind.
void dropClear(RaySamples& samples, int components)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples.batch.count); ++i) {
        if (!(samples.batch.Ov[i] > 0.0f)) continue;
        if (kept != i) samples.copy(samples, i, kept, components);
        ++kept;
    }
    samples.batch.count = static_cast<int>(kept);
}

} // namespace

void RaySamples::copy(const RaySamples& from, std::size_t source, std::size_t target, int components)
{
    for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
        batch.voxel[c][target] = from.batch.voxel[c][source];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        batch.place[axis][target] = from.batch.place[axis][source];
        batch.Cv[axis][target] = from.batch.Cv[axis][source];
    }
    batch.Ov[target] = from.batch.Ov[source];
    depth[target] = from.depth[source];
    tetra[target] = from.tetra[source];
    chain[target] = from.chain[source];
    number[target] = from.number[source];
}

/// Calls shade(plan, group) for the samples of each chain, and brings back what it makes of them.
template <class Shade>
void SampleShader::forChains(RaySamples& samples, const Shade& shade)
{
    if (volume_.plans.size() == 1) return shade(volume_.plans[0], samples);
    const auto count = static_cast<std::size_t>(samples.batch.count);
    std::array<bool, kBatchSize> done{};
    for (std::size_t first = 0; first < count; ++first) {
        if (done[first]) continue;
        std::size_t taken = 0;
        for (std::size_t i = first; i < count; ++i) {
            if (samples.chain[i] != samples.chain[first]) continue;
            group_.copy(samples, i, taken, volume_.styled->voxels->components);
            group_.number[taken++] = i;
            samples.batch.Ov[i] = 0.0f;
            done[i] = true;
        }
        group_.batch.count = static_cast<int>(taken);
        shade(volume_.plans[static_cast<std::size_t>(samples.chain[first])], group_);
        for (std::size_t i = 0; i < static_cast<std::size_t>(group_.batch.count); ++i) {
            const std::size_t to = group_.number[i];
            for (std::size_t c = 0; c < 3; ++c)
                samples.batch.Cv[c][to] = group_.batch.Cv[c][i];
            samples.batch.Ov[to] = group_.batch.Ov[i];
        }
    }
}

void SampleShader::shade(const DepthRay& local, RaySamples& samples)
{
    forChains(samples, [&](const ChainPlan& plan, RaySamples& group) { shadeChain(local, plan, group); });
}

void SampleShader::shadeChain(const DepthRay& local, const ChainPlan& plan, RaySamples& samples)
{
    const std::size_t steps = plan.chain.size();
    firstColor(volume_.styled->voxels->components, samples.batch);
    if (plan.needsPosition) placeSamples(local, samples);
    apply(plan, 0, plan.withoutNormals, samples.batch);
    if (plan.withoutNormals == steps) return;
    const bool clearStays =
        plan.keepsClear && !volume_.styled->projection && (plan.withoutNormals > 0 || plan.beginsWithVoxel);
    if (clearStays) {
        const int before = samples.batch.count;
        dropClear(samples, volume_.styled->voxels->components);
        if (plan.needsPosition && samples.batch.count != before) placeSamples(local, samples);
    }
    findNormals(samples);
    apply(plan, plan.withoutNormals, steps, samples.batch);
}

void SampleShader::shadeSurfaces(const DepthRay& local, RaySamples& samples)
{
    const float tolerance = volume_.styled->surfaces->surfaceTolerance;
    forChains(samples, [&](const ChainPlan& plan, RaySamples& group) {
        placeSamples(local, group);
        findNormals(group);
        const BatchFloats gradient = group.batch.gradient;
        if (volume_.gradients.given()) {
            BatchVectors room;
            group.batch.n = volume_.gradients.of(group.batch, room);
        }
        firstColor(volume_.styled->voxels->components, group.batch);
        apply(plan, 0, plan.chain.size(), group.batch);
        for (std::size_t i = 0; i < kBatchSize; ++i)
            if (gradient[i] < tolerance) group.batch.Ov[i] = 0.0f;
    });
}

void SampleShader::apply(const ChainPlan& plan, std::size_t from, std::size_t to, SampleBatch& batch) const
{
    for (std::size_t i = from; i < to && batch.count > 0; ++i)
        plan.chain[i]->apply(volume_.styled->surroundings, batch);
}

void SampleShader::findNormals(RaySamples& samples) const
{
    constexpr float kLeastGradient = 1e-6f;
    const VoxelSize& voxels = volume_.styled->voxels->size;
    const glm::vec3 size(voxels.x, voxels.y, voxels.z);
    SampleBatch& batch = samples.batch;
    volume_.voxels->changes(batch.count, batch.place, batch.n);
    auto& [x, y, z] = batch.n;
    const glm::vec3 boxScale = size / volume_.styled->dimensions * volume_.shortestEdge;
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
        glm::vec3 change(x[i], y[i], z[i]);
        if (samples.tetra[i] < 0) {
            change *= boxScale;
        } else {
            const glm::mat3 placeFromLocal(
                volume_.tetras->placeFromLocal(static_cast<std::uint32_t>(samples.tetra[i])));
            change = change * size * placeFromLocal * volume_.shortestEdge;
        }
        const float length = glm::length(change);
        const float scale = length >= kLeastGradient ? -1.0f / length : 0.0f;
        batch.gradient[i] = length;
        x[i] = change.x * scale;
        y[i] = change.y * scale;
        z[i] = change.z * scale;
    }
}

} // namespace vo
