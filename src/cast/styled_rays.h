#pragma once

#include "cast/ray_samples.h"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <vector>

namespace vo {

/// What a ray meets in one volume: colours multiplied by their opacity, by rising eye depth.
struct FragmentRun
{
    int count = 0, next = 0;
    std::array<double, kBatchSize> depth;
    std::array<glm::vec4, kBatchSize> color;

    bool atEnd() const { return next >= count; }
    void add(double at, const glm::vec3& rgb, float alpha)
    {
        const auto i = static_cast<std::size_t>(count++);
        depth[i] = at;
        color[i] = glm::vec4(rgb * alpha, alpha);
    }
};

/// Walks one ray after the other through a volume; each thread has its own.
class StyledRay
{
public:
    explicit StyledRay(const CastVolume& volume);

    /// Starts a ray of eye space that reaches to `opaque`, or the end of `depths`; false if it meets nothing.
    bool begin(const DepthRay& ray, RayPart depths, double opaque, std::span<const TetraSpan> spans);
    /// The next fragments of the ray; false if there are no more.
    bool next(FragmentRun& run);

private:
    /// Where the voxels cross the value of a surface.
    struct Crossing
    {
        double depth;
        std::size_t surface;
    };
    struct Before
    {
        std::int64_t plane;
        float value;
    };

    bool collectSamples();
    void take(const SampleChunk& chunk, std::size_t i);
    bool isClear(std::size_t i) const;
    float alphaOf(float opacity) const;
    void emit(FragmentRun& run) const;

    bool collectCrossings();
    void findCrossings(const SampleChunk& chunk);
    void cross(const Before& before, const Before& after);
    bool placeCrossings();

    /// Joins all samples to one fragment.
    bool project(FragmentRun& run);
    void leapOverIdle();

    const CastVolume& volume_;
    RayPath path_;
    SampleShader shader_;
    SampleChunk chunk_;
    RaySamples samples_;
    int wanted_ = 0; ///< samples of the next batch
    bool dropsFirstClear_ = false;
    bool projected_ = false;
    VoxelBlocks::Range projectedValues_{}; ///< so far
    float units_ = 1.0f;
    std::array<float, 4> series_{};
    double opaque_ = 0.0;
    std::optional<Before> before_;
    std::vector<Crossing> crossings_;
    std::size_t crossing_ = 0; ///< the next one to be shaded
};

} // namespace vo
