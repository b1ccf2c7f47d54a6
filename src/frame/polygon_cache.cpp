#include "frame/polygon_cache.h"

#include "core/serial.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vo {

namespace {

/// More tetrahedra are looked at for a convex body only if they come a second time: that takes longer than
/// slicing them once.
constexpr int kFewTetras = 1000;

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

Box boundsOf(const TetraView& tetras)
{
    Box box{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
    for (const int vertex : tetras.indices) {
        const glm::dvec3 p = tetras.position(vertex);
        box = {glm::min(box.lower, p), glm::max(box.upper, p)};
    }
    return box;
}

glm::dvec3 centreOfBox(const TetraView& tetras)
{
    const Box box = boundsOf(tetras);
    return 0.5 * (box.lower + box.upper);
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
        const auto values = static_cast<std::size_t>(cache_.keyTetras_.valuesPerVertex());
        const std::size_t first = cache_.stack_.records.size() / values;
        const std::size_t count = records.size() / values;
        if (first + count > UINT32_MAX) return false;
        std::ranges::copy(records, cache_.stack_.records.grow(records.size()));
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
    bricksInterleave_ = keyTetras_.voxelColumn() >= 0 && request.clipBoxes.size() > 1;
    if (request.sampling.mode == SamplingMode::spherical && request.camera.perspective)
        cutShells(request);
    else if (!sliceAsOneBody(request))
        samples_ = slicer_
                       .slice(request.tetras, request.clipBoxes, request.camera, request.sampling,
                              bricksInterleave_ ? StackOrder::bySample : StackOrder::byBrick, 0, stack_)
                       .samples;
    valid_ = true;
    serial_ = newSerial();
    return true;
}

void PolygonCache::cutShells(const PolygonRequest& request)
{
    stack_.clear();
    polygons_.clear();
    Collector collector(*this);
    const PolygonizeResult result = polygonize(request.tetras, request.clipBoxes, request.camera,
                                               request.sampling, workspace_, collector);
    samples_ = result.samples;
    sortIntoBins(request.clipBoxes.size(), result.samples);
}

/// False: the tetrahedra are no such body, or the request speaks of them one by one.
bool PolygonCache::sliceAsOneBody(const PolygonRequest& request)
{
    const SamplingRequest& sampling = request.sampling;
    if (sampling.space == SamplingSpace::primitive || request.tetras.valuesPerVertex != 3) return false;
    boxes_.assign(request.clipBoxes);
    if (!boxes_.standApart() || !body(request.tetras)) return false;
    const SamplingAxis axis = samplingAxis(request.tetras, request.camera, sampling);
    const PlaneFamily planes = samplingPlanes(request.tetras, axis, request.camera, sampling);
    convexSlicer_.slice(*body_, boundsOf(request.tetras), planes, axis.set.nearest, boxes_, stack_);
    bricksInterleave_ = false; // its coordinates are its positions
    samples_ = planes.count;
    return true;
}

const std::optional<ConvexSet>& PolygonCache::body(const TetraView& tetras)
{
    const bool worthwhile = tetras.tetraCount() <= kFewTetras || framesOfTetras_ > 1;
    if (!bodySought_ && worthwhile) {
        body_ = convexSet(tetras);
        bodySought_ = true;
    }
    return body_;
}

bool PolygonCache::isCurrent(const PolygonRequest& request, double threshold) const
{
    if (!valid_) return false;
    const bool cameraFits = threshold > 0 ? withinDegrees(keyCamera_, request.camera, threshold)
                                          : sameCamera(keyCamera_, request.camera);
    const bool eyeFits = request.sampling.mode != SamplingMode::spherical || !request.camera.perspective ||
                         eyeStays(keyCamera_, request.camera, centreOfBox(request.tetras), threshold);
    return cameraFits && eyeFits && sameSampling(keySampling_, request.sampling) &&
           sameBoxes(keyBoxes_, request.clipBoxes) && keyTetras_.equal(request.tetras);
}

void PolygonCache::remember(const PolygonRequest& request)
{
    valid_ = false;
    if (keyTetras_.renew(request.tetras)) {
        framesOfTetras_ = 0;
        bodySought_ = false;
        body_.reset();
    }
    framesOfTetras_ = std::min(framesOfTetras_ + 1, 2);
    keyBoxes_.assign(request.clipBoxes.begin(), request.clipBoxes.end());
    keyCamera_ = request.camera;
    keySampling_ = request.sampling;
}

/// A counting sort by brick and sample, then each polygon as a fan.
void PolygonCache::sortIntoBins(std::size_t brickCount, int samples)
{
    const auto perBrick = static_cast<std::size_t>(std::max(samples, 1));
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

    int lastSample = 0;
    for (const std::uint32_t number : order_) {
        const Polygon& p = polygons_[number];
        const bool goesOn = !stack_.runs.empty() && stack_.runs.back().brick == p.brick &&
                            (!bricksInterleave_ || lastSample == p.sample);
        if (!goesOn) stack_.runs.push_back({p.brick, stack_.indices.size(), 0});
        lastSample = p.sample;
        for (std::uint32_t i = 1; i + 1 < p.count; ++i)
            std::ranges::copy(std::array{p.first + i, p.first + i + 1, p.first}, stack_.indices.grow(3));
        stack_.runs.back().count = stack_.indices.size() - stack_.runs.back().first;
    }
}

} // namespace vo
