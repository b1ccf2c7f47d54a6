#pragma once

#include "style/styles.h"

#include <string>

namespace vo {

class GlslChain;

/// The normals that a style reads: those of its own texture where the scene gives one, else those of the
/// samples.
class SurfaceNormals
{
public:
    /// A texture of less than three components counts as none.
    explicit SurfaceNormals(TexturePointer texture);

    bool given() const { return texture_ != nullptr; }
    const VoxelTexture* texture() const { return texture_.get(); }

    /// Unit vectors, or 0 0 0; `room` holds them if they come from the texture.
    const BatchVectors& of(const SampleBatch& samples, BatchVectors& room) const;
    /// The same as an expression, a vec3.
    std::string write(GlslChain& chain) const;

private:
    TexturePointer texture_;
};

/// A sample without a normal has 0 0 0.
inline bool isNone(const BatchVectors& n, std::size_t sample)
{
    return n[0][sample] == 0.0f && n[1][sample] == 0.0f && n[2][sample] == 0.0f;
}

/// n.V of each sample.
void facing(const BatchVectors& n, const BatchVectors& V, BatchFloats& cosines);

} // namespace vo
