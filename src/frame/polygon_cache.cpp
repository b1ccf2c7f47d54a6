#include "frame/polygon_cache.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

bool sameBoxes(std::span<const Box> a, std::span<const Box> b)
{
    return std::ranges::equal(
        a, b, [](const Box& p, const Box& q) { return p.lower == q.lower && p.upper == q.upper; });
}

bool sameSampling(const SamplingRequest& a, const SamplingRequest& b)
{
    return a.mode == b.mode && a.space == b.space && a.period == b.period && a.maxSamples == b.maxSamples &&
           a.stackAxis == b.stackAxis;
}

bool sameCamera(const Camera& a, const Camera& b)
{
    return a.perspective == b.perspective && a.eye == b.eye && a.direction == b.direction &&
           a.depthNormal == b.depthNormal && a.nearDepth == b.nearDepth && a.farDepth == b.farDepth;
}

bool withinDegrees(const Camera& a, const Camera& b, double threshold)
{
    if (a.perspective != b.perspective) return false;
    const double cosine = std::clamp(glm::dot(a.direction, b.direction), -1.0, 1.0);
    return std::acos(cosine) * 180.0 / std::acos(-1.0) <= threshold;
}

glm::dvec3 centreOfBox(const TetraView& tetras)
{
    glm::dvec3 lower(HUGE_VAL), upper(-HUGE_VAL);
    for (const int vertex : tetras.indices) {
        const glm::dvec3 p = tetras.position(vertex);
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    return 0.5 * (lower + upper);
}

/// Shells stay round the eye that they were made for: it may move by `threshold` degrees as seen from
/// `centre`, in any direction.
bool eyeStays(const Camera& a, const Camera& b, const glm::dvec3& centre, double threshold)
{
    if (a.eye == b.eye) return true;
    const double radians = std::min(threshold, 45.0) * std::acos(-1.0) / 180.0;
    return glm::distance(a.eye, b.eye) <= std::tan(radians) * glm::distance(a.eye, centre);
}

} // namespace

class PolygonCache::Collector final : public FaceSink
{
public:
    explicit Collector(PolygonCache& cache) : cache_(cache) {}

    bool append(int brick, int sample, std::span<const float> records) override
    {
        const auto values = static_cast<std::size_t>(cache_.valuesPerVertex_);
        const std::size_t first = cache_.records_.size() / values;
        const std::size_t count = records.size() / values;
        if (first + count > UINT32_MAX) return false;
        cache_.records_.insert(cache_.records_.end(), records.begin(), records.end());
        cache_.polygons_.push_back(
            {brick, sample, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
        return true;
    }

private:
    PolygonCache& cache_;
};

bool PolygonCache::update(const PolygonRequest& request, double threshold)
{
    if (isCurrent(request, threshold)) return false;
    remember(request);
    records_.clear();
    polygons_.clear();
    Collector collector(*this);
    const PolygonizeResult result = polygonize(request.tetras, request.clipBoxes, request.camera,
                                               request.sampling, workspace_, collector);
    samples_ = result.samples;
    sortIntoBins(request.clipBoxes.size(), result.samples);
    valid_ = true;
    return true;
}

bool PolygonCache::isCurrent(const PolygonRequest& request, double threshold) const
{
    if (!valid_ || valuesPerVertex_ != request.tetras.valuesPerVertex ||
        voxelColumn_ != request.tetras.voxelColumn)
        return false;
    const bool cameraFits = threshold > 0 ? withinDegrees(keyCamera_, request.camera, threshold)
                                          : sameCamera(keyCamera_, request.camera);
    const bool eyeFits = request.sampling.mode != SamplingMode::spherical || !request.camera.perspective ||
                         eyeStays(keyCamera_, request.camera, centreOfBox(request.tetras), threshold);
    return cameraFits && eyeFits && sameSampling(keySampling_, request.sampling) &&
           sameBoxes(keyBoxes_, request.clipBoxes) &&
           std::ranges::equal(keyIndices_, request.tetras.indices) &&
           std::ranges::equal(keyRecords_, request.tetras.records);
}

void PolygonCache::remember(const PolygonRequest& request)
{
    valid_ = false;
    valuesPerVertex_ = request.tetras.valuesPerVertex;
    voxelColumn_ = request.tetras.voxelColumn;
    keyRecords_.assign(request.tetras.records.begin(), request.tetras.records.end());
    keyIndices_.assign(request.tetras.indices.begin(), request.tetras.indices.end());
    keyBoxes_.assign(request.clipBoxes.begin(), request.clipBoxes.end());
    keyCamera_ = request.camera;
    keySampling_ = request.sampling;
}

/// A counting sort by brick and sample, then each polygon as a fan.
void PolygonCache::sortIntoBins(std::size_t brickCount, int samples)
{
    const auto perBrick = static_cast<std::size_t>(std::max(samples, 1));
    bricksInterleave_ = voxelColumn_ >= 0 && brickCount > 1;
    const auto bin = [&](const Polygon& p) {
        const auto brick = static_cast<std::size_t>(p.brick), sample = static_cast<std::size_t>(p.sample);
        return bricksInterleave_ ? sample * brickCount + brick : brick * perBrick + sample;
    };
    binStarts_.assign(brickCount * perBrick + 1, 0);
    for (const Polygon& p : polygons_)
        ++binStarts_[bin(p) + 1];
    for (std::size_t i = 1; i < binStarts_.size(); ++i)
        binStarts_[i] += binStarts_[i - 1];
    order_.resize(polygons_.size());
    for (std::size_t i = 0; i < polygons_.size(); ++i)
        order_[binStarts_[bin(polygons_[i])]++] = static_cast<std::uint32_t>(i);

    indices_.clear();
    runs_.clear();
    int lastSample = 0;
    for (const std::uint32_t number : order_) {
        const Polygon& p = polygons_[number];
        const bool goesOn =
            !runs_.empty() && runs_.back().brick == p.brick && (!bricksInterleave_ || lastSample == p.sample);
        if (!goesOn) runs_.push_back({p.brick, indices_.size(), 0});
        lastSample = p.sample;
        for (std::uint32_t i = 1; i + 1 < p.count; ++i)
            for (const std::uint32_t vertex : {p.first + i, p.first + i + 1, p.first})
                indices_.push_back(vertex);
        runs_.back().count = indices_.size() - runs_.back().first;
    }
}

} // namespace vo
