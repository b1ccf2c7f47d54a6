#include "style/surface_normals.h"

#include "style/glsl_chain.h"

#include <cmath>
#include <utility>

namespace vo {

namespace {

/// Below this length a texel gives no direction: 0 has none of the numbers of 8 bits, 127 and 128 come
/// nearest.
constexpr float kLeastLength = 0.01f;

const char* const kGlsl = R"(
vec3 givenNormal(vec3 texel)
{
    vec3 direction = 2.0 * texel - 1.0;
    float size = length(direction);
    return size < 0.01 ? vec3(0.0) : direction / size;
}
)";

} // namespace

SurfaceNormals::SurfaceNormals(TexturePointer texture) : texture_(std::move(texture))
{
    if (texture_ && texture_->components < 3) texture_.reset();
}

const BatchVectors& SurfaceNormals::of(const SampleBatch& samples, BatchVectors& room) const
{
    if (!texture_) return samples.n;
    std::array<BatchFloats, 4> texels{};
    sampleTexture(*texture_, samples.count, samples.place, texels);
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        const float x = 2.0f * texels[0][i] - 1.0f;
        const float y = 2.0f * texels[1][i] - 1.0f;
        const float z = 2.0f * texels[2][i] - 1.0f;
        const float length = std::sqrt(x * x + y * y + z * z);
        const float scale = length < kLeastLength ? 0.0f : 1.0f / length;
        room[0][i] = x * scale;
        room[1][i] = y * scale;
        room[2][i] = z * scale;
    }
    return room;
}

std::string SurfaceNormals::write(GlslChain& chain) const
{
    if (!texture_) return "s.n";
    chain.function("givenNormal", kGlsl);
    return "givenNormal(styleTexture(" + chain.texture(texture_) + ", s.place).rgb)";
}

void facing(const BatchVectors& n, const BatchVectors& V, BatchFloats& cosines)
{
    for (std::size_t i = 0; i < kBatchSize; ++i)
        cosines[i] = n[0][i] * V[0][i] + n[1][i] * V[1][i] + n[2][i] * V[2][i];
}

} // namespace vo
