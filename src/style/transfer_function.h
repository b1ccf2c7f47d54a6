#pragma once

#include "style/style.h"

#include <glm/vec4.hpp>

#include <memory>
#include <string>
#include <vector>

namespace vo {

class GlslChain;

/// A texture that is read at values in place of coordinates. A value at the edge has the last texel, even
/// where the texture repeats: values do not.
class TransferFunction
{
public:
    TransferFunction() = default;
    /// Values change along the first `axes` axes alone, and are 0 along the others.
    TransferFunction(std::shared_ptr<const VoxelTexture> texture, int axes);

    explicit operator bool() const { return texture_ != nullptr; }
    int components() const { return texture_->components; }
    /// All values from low to high along the one axis have an alpha of 0; false where there are more axes.
    bool isClear(float low, float high) const;

    /// The texels of `count` values; `place` is changed on the way.
    void sample(int count, BatchVectors& place, std::array<BatchFloats, 4>& texels) const;
    /// The same as an expression, a vec4; `place` is one too, a vec3.
    std::string write(GlslChain& chain, const std::string& place) const;

private:
    float halfTexel(int axis) const { return 0.5f / static_cast<float>(texture_->size[axis]); }
    void sampleRow(int count, const BatchFloats& values, std::array<BatchFloats, 4>& texels) const;

    std::shared_ptr<const VoxelTexture> texture_;
    int axes_ = 1;
    std::vector<glm::vec4> row_; ///< all texels, where one axis counts
};

} // namespace vo
