#include "cast/styled_rays.h"

#include "cast/ray_projection.h"
#include "style/styled_voxels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// What firstColor takes for the opacity.
float firstOpacity(int components, const std::array<BatchFloats, 4>& voxel, std::size_t i)
{
    switch (components) {
    case 1: return voxel[0][i];
    case 2: return voxel[1][i];
    case 3: return voxel[0][i] + voxel[1][i] + voxel[2][i];
    default: return voxel[3][i];
    }
}

glm::vec3 colorOf(const SampleBatch& batch, std::size_t i)
{
    return {batch.Cv[0][i], batch.Cv[1][i], batch.Cv[2][i]};
}

} // namespace

StyledRay::StyledRay(const CastVolume& volume) : volume_(volume), path_(volume), shader_(volume)
{
    const auto drops = [](const ChainPlan& plan) { return plan.keepsClearVoxels; };
    dropsFirstClear_ =
        !volume.styled->projection && std::all_of(volume.plans.begin(), volume.plans.end(), drops);
}

bool StyledRay::begin(const DepthRay& ray, RayPart depths, double opaque, std::span<const TetraSpan> spans)
{
    // A surface may lie before what is opaque and the sample after it behind.
    if (!volume_.styled->surfaces) depths.end = std::min(depths.end, opaque);
    opaque_ = opaque;
    crossings_.clear();
    crossing_ = 0;
    before_.reset();
    projected_ = false;
    projectedValues_ = {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    wanted_ = kChunkSize;
    if (!path_.begin(ray, depths, spans)) return false;
    units_ = static_cast<float>(path_.unitsOfSample());
    series_[0] = units_;
    for (std::size_t i = 1; i < 4; ++i)
        series_[i] = series_[i - 1] * (static_cast<float>(i) - units_) / static_cast<float>(i + 1);
    return true;
}

bool StyledRay::next(FragmentRun& run)
{
    run.count = run.next = 0;
    if (volume_.styled->projection && !volume_.styled->surfaces) return project(run);
    while (run.count == 0) {
        const bool surfaces = volume_.styled->surfaces.has_value();
        if (surfaces ? !collectCrossings() : !collectSamples()) return false;
        if (surfaces)
            shader_.shadeSurfaces(path_.local(), samples_);
        else
            shader_.shade(path_.local(), samples_);
        emit(run);
    }
    return true;
}

/// Fills samples_; false if there are no more.
bool StyledRay::collectSamples()
{
    samples_.batch.count = 0;
    while (samples_.batch.count + kChunkSize <= wanted_ && path_.next(chunk_))
        for (std::size_t i = 0; i < static_cast<std::size_t>(chunk_.count); ++i)
            if (!isClear(i)) take(chunk_, i);
    // Rays that end soon shade little, those that do not shade many samples at a time.
    wanted_ = std::min(2 * wanted_, kBatchSize);
    return samples_.batch.count > 0;
}

bool StyledRay::isClear(std::size_t i) const
{
    const int components = volume_.styled->voxels->components;
    if (components == 1) return volume_.clear.has(chunk_.voxel[0][i]);
    return dropsFirstClear_ && firstOpacity(components, chunk_.voxel, i) <= 0.0f;
}

void StyledRay::take(const SampleChunk& chunk, std::size_t i)
{
    const int chain = chainAt(*volume_.styled, {chunk.place[0][i], chunk.place[1][i], chunk.place[2][i]});
    if (chain < 0) return;
    const auto to = static_cast<std::size_t>(samples_.batch.count++);
    for (std::size_t c = 0; c < static_cast<std::size_t>(volume_.styled->voxels->components); ++c)
        samples_.batch.voxel[c][to] = chunk.voxel[c][i];
    for (std::size_t axis = 0; axis < 3; ++axis)
        samples_.batch.place[axis][to] = chunk.place[axis][i];
    samples_.depth[to] = path_.depthOf(chunk.plane + static_cast<std::int64_t>(i));
    samples_.tetra[to] = path_.piece(chunk.piece).tetra;
    samples_.chain[to] = chain;
}

/// 1 - (1 - opacity)^units: the binomial series where its fifth term is below 1e-6.
float StyledRay::alphaOf(float opacity) const
{
    if (opacity > 0.125f || units_ > 4.0f) return -std::expm1(units_ * std::log1p(-opacity));
    const auto& [first, second, third, fourth] = series_;
    return opacity * (first + opacity * (second + opacity * (third + opacity * fourth)));
}

void StyledRay::emit(FragmentRun& run) const
{
    const SampleBatch& batch = samples_.batch;
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
        const float opacity = std::min(batch.Ov[i], 1.0f);
        if (!(opacity > 0.0f)) continue;
        const bool ofLength = opacity < 1.0f && !volume_.styled->surfaces;
        const float alpha = ofLength ? alphaOf(opacity) : opacity;
        run.add(samples_.depth[i], colorOf(batch, i), alpha);
    }
}

bool StyledRay::project(FragmentRun& run)
{
    if (projected_) return false;
    projected_ = true;
    JoinedSamples joined(*volume_.styled->projection);
    const int components = volume_.styled->voxels->components;
    while (!joined.decided() && collectSamples()) {
        shader_.shade(path_.local(), samples_);
        const SampleBatch& batch = samples_.batch;
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
            float opacity = batch.Ov[i];
            if (volume_.plans[static_cast<std::size_t>(samples_.chain[i])].chain.empty())
                opacity =
                    components % 2 == 0 ? batch.voxel[static_cast<std::size_t>(components - 1)][i] : 1.0f;
            joined.add(samples_.depth[i], (batch.Cv[0][i] + batch.Cv[1][i] + batch.Cv[2][i]) / 3.0f, opacity);
        }
        if (volume_.leapsByValue) leapOverIdle();
        joined.addIdle(path_.takeLeapt());
    }
    joined.addIdle(path_.takeLeapt());
    if (joined.empty()) return false;
    run.add(standingDepth(*volume_.styled, path_.piece(0).depths.begin, joined),
            glm::vec3(joined.intensity()), std::clamp(joined.opacity(), 0.0f, 1.0f));
    return true;
}

/// From here on the path leaves out what changes nothing after the samples so far.
void StyledRay::leapOverIdle()
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    auto& [low, high] = projectedValues_;
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples_.batch.count); ++i) {
        low = std::min(low, samples_.batch.voxel[0][i]);
        high = std::max(high, samples_.batch.voxel[0][i]);
    }
    switch (volume_.styled->projection->type) {
    case RayProjection::Type::max: return path_.leapOver({-kInfinity, high});
    case RayProjection::Type::min: return path_.leapOver({low, kInfinity});
    case RayProjection::Type::average: return path_.leapOver({0.0f, 0.0f});
    }
}

/// Fills samples_ with the places of surfaces; false if there are no more.
bool StyledRay::collectCrossings()
{
    do {
        if (crossing_ == crossings_.size()) {
            crossings_.clear();
            crossing_ = 0;
            while (crossings_.empty()) {
                if (!path_.next(chunk_)) return false;
                findCrossings(chunk_);
            }
        }
    } while (!placeCrossings());
    return true;
}

void StyledRay::findCrossings(const SampleChunk& chunk)
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk.count); ++i) {
        const Before sample{chunk.plane + static_cast<std::int64_t>(i), chunk.voxel[0][i]};
        if (before_ && before_->plane + 1 == sample.plane) cross(*before_, sample);
        before_ = sample;
    }
}

void StyledRay::cross(const Before& before, const Before& after)
{
    const std::vector<float>& values = volume_.styled->surfaces->values;
    const double spacing = volume_.styled->spacing;
    const std::size_t first = crossings_.size();
    for (std::size_t surface = 0; surface < values.size(); ++surface) {
        const float value = values[surface];
        if ((before.value < value) == (after.value < value)) continue;
        const double part = (static_cast<double>(value) - static_cast<double>(before.value)) /
                            (static_cast<double>(after.value) - static_cast<double>(before.value));
        crossings_.push_back({path_.depthOf(before.plane) + part * spacing, surface});
    }
    std::stable_sort(crossings_.begin() + static_cast<std::ptrdiff_t>(first), crossings_.end(),
                     [](const Crossing& a, const Crossing& b) { return a.depth < b.depth; });
}

bool StyledRay::placeCrossings()
{
    const auto last = static_cast<int>(volume_.plans.size()) - 1;
    SampleBatch& batch = samples_.batch;
    batch.count = 0;
    for (; crossing_ < crossings_.size() && batch.count < kBatchSize; ++crossing_) {
        const Crossing& crossing = crossings_[crossing_];
        const RayPath::Piece* const piece = path_.pieceAt(crossing.depth);
        if (!piece || crossing.depth > opaque_) continue;
        const auto to = static_cast<std::size_t>(batch.count++);
        const glm::vec3 place(piece->place.at(crossing.depth));
        for (int axis = 0; axis < 3; ++axis)
            batch.place[static_cast<std::size_t>(axis)][to] = place[axis];
        samples_.depth[to] = crossing.depth;
        samples_.tetra[to] = piece->tetra;
        samples_.chain[to] =
            std::min(static_cast<int>(std::min<std::size_t>(crossing.surface, 1 << 30)), last);
    }
    volume_.read(batch.count, batch.place, batch.voxel);
    return batch.count > 0;
}

} // namespace vo
