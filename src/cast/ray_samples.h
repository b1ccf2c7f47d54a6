#pragma once

#include "cast/ray_path.h"

namespace vo {

/// Samples of one ray on their way through styles.
struct RaySamples
{
    SampleBatch batch{};
    std::array<double, kBatchSize> depth{};
    std::array<int, kBatchSize> tetra{};          ///< that has them, or below 0
    std::array<int, kBatchSize> chain{};          ///< number of a plan of the volume
    std::array<std::size_t, kBatchSize> number{}; ///< among all that were collected together

    /// Copies what is known before styles come to it, and Cv and Ov.
    void copy(const RaySamples& from, std::size_t source, std::size_t target, int components);
};

/// Makes colours of samples by the chains of a volume; each thread has its own.
class SampleShader
{
public:
    explicit SampleShader(const CastVolume& volume) : volume_(volume) {}

    /// Sets Cv and Ov of all samples, whose voxel, place, depth, tetra and chain are known; of those that
    /// turn out clear Ov alone.
    void shade(const DepthRay& local, RaySamples& samples);
    /// The same for samples on surfaces: those where the gradient is smaller than the surfaces' tolerance
    /// become clear.
    void shadeSurfaces(const DepthRay& local, RaySamples& samples);

private:
    void shadeChain(const DepthRay& local, const ChainPlan& plan, RaySamples& samples);
    void findNormals(RaySamples& samples) const;
    void apply(const ChainPlan& plan, std::size_t from, std::size_t to, SampleBatch& batch) const;
    template <class Shade>
    void forChains(RaySamples& samples, const Shade& shade);

    const CastVolume& volume_;
    RaySamples group_;
};

} // namespace vo
