#include "cast/ray_projection.h"

namespace vo {

bool JoinedSamples::endsAbove() const
{
    return projection_.type != RayProjection::Type::average && projection_.intensityThreshold > 0.0f &&
           last_.value > sign_ * projection_.intensityThreshold;
}

void JoinedSamples::add(double depth, float intensity, float opacity)
{
    if (decided_) return;
    if (count_ == 0) depth_ = depth;
    const Candidate sample{sign_ * intensity, opacity, depth};
    intensities_ += static_cast<double>(intensity);
    opacities_ += static_cast<double>(opacity);
    if (count_ > 0 && endsAbove() && sample.value < last_.value) {
        decided_ = true;
        return;
    }
    if (count_ == 0 || sample.value > best_.value) best_ = sample;
    last_ = sample;
    ++count_;
}

void JoinedSamples::addIdle(std::int64_t samples)
{
    count_ += samples;
    opacities_ += static_cast<double>(samples);
}

float JoinedSamples::intensity() const
{
    if (projection_.type == RayProjection::Type::average)
        return static_cast<float>(intensities_ / static_cast<double>(count_));
    return sign_ * chosen().value;
}

double standingDepth(const StyledVolume& volume, double entry, const JoinedSamples& joined)
{
    if (volume.tetras) return joined.depth();
    // Faces of two volumes that lie in one plane are at one depth.
    return static_cast<double>(static_cast<float>(entry));
}

float JoinedSamples::opacity() const
{
    if (projection_.type == RayProjection::Type::average)
        return static_cast<float>(opacities_ / static_cast<double>(count_));
    return chosen().opacity;
}

} // namespace vo
