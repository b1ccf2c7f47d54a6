#pragma once

#include "style/style.h"

#include <string>

namespace vo {

class GlslChain;

/// Texels of a function at values, as at texture coordinates. A value at the edge has the last texel, even
/// where the texture repeats: values do not. `place` is changed to that end.
void sampleFunction(const VoxelTexture& function, int count, BatchVectors& place,
                    std::array<BatchFloats, 4>& texels);
/// The same as an expression, a vec4; `place` is one too, a vec3.
std::string writeFunction(GlslChain& chain, const std::shared_ptr<const VoxelTexture>& function,
                          const std::string& place);

} // namespace vo
