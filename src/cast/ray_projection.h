#pragma once

#include "style/styled_scene.h"

#include <cstdint>

namespace vo {

/// Joins the samples of a ray to one.
class JoinedSamples
{
public:
    explicit JoinedSamples(const RayProjection& projection)
        : projection_(projection), sign_(projection.type == RayProjection::Type::min ? -1.0f : 1.0f)
    {
    }

    void add(double depth, float intensity, float opacity);
    /// Samples that change no maximum and no minimum; in a mean they count as opaque ones of 0.
    void addIdle(std::int64_t samples);
    /// No sample that may come changes the result.
    bool decided() const { return decided_; }

    bool empty() const { return count_ == 0; }
    double depth() const { return depth_; } ///< of the first sample
    float intensity() const;
    float opacity() const;
    /// Of the sample that is chosen; of those of a mean, the one that adds most to it.
    double chosenDepth() const { return chosen().depth; }

private:
    struct Candidate
    {
        float value = 0.0f; ///< the greater, the better
        float opacity = 0.0f;
        double depth = 0.0;
    };
    /// The last sample is chosen if the ray ends there.
    bool endsAbove() const;
    const Candidate& chosen() const { return decided_ || endsAbove() ? last_ : best_; }

    RayProjection projection_;
    float sign_;
    std::int64_t count_ = 0;
    double depth_ = 0.0;
    bool decided_ = false;
    Candidate best_, last_;
    double intensities_ = 0.0, opacities_ = 0.0;
};

/// The depth at which a projection stands among other things: where its ray enters the box, which
/// neighbouring pixels do at neighbouring depths whatever the planes; of tetrahedra that of the first sample.
double standingDepth(const StyledVolume& volume, double entry, const JoinedSamples& joined);

} // namespace vo
