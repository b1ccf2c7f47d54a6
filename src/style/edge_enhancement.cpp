#include "style/glsl_chain.h"
#include "style/styles.h"
#include "style/surface_normals.h"

#include <cmath>

namespace vo {

namespace {

// Cg = Cv where |n.V| >= cos(gradientThreshold) or nothing faces anywhere, else Cv |n.V| + edgeColor (1 -
// |n.V|).
const char* const kGlsl = R"(
vec4 edgeEnhancement(vec4 color, StyleSample s, vec3 n, vec3 edgeColor, float cosine)
{
    float nV = abs(dot(n, s.V));
    return nV >= cosine || n == vec3(0.0) ? color : vec4(mix(edgeColor, color.rgb, nV), color.a);
}
)";

class EdgeEnhancementStyle final : public Style
{
public:
    explicit EdgeEnhancementStyle(const EdgeEnhancement& fields)
        : edgeColor_(fields.edgeColor), cosine_(std::cos(fields.gradientThreshold)),
          normals_(fields.surfaceNormals)
    {
    }

    bool needsNormal() const override { return !normals_.given(); }
    bool needsPosition() const override { return true; }
    const VoxelTexture* surfaceNormals() const override { return normals_.texture(); }
    void apply(const StyleSurroundings&, SampleBatch& samples) const override;

    void write(GlslChain& chain) const override
    {
        chain.function("edgeEnhancement", kGlsl);
        chain.step("edgeEnhancement",
                   {normals_.write(chain), chain.uniform(edgeColor_), chain.uniform(cosine_)});
    }

private:
    glm::vec3 edgeColor_;
    float cosine_; ///< of the threshold
    SurfaceNormals normals_;
};

void EdgeEnhancementStyle::apply(const StyleSurroundings&, SampleBatch& samples) const
{
    BatchVectors room;
    const BatchVectors& n = normals_.of(samples, room);
    BatchFloats nV;
    facing(n, samples.V, nV);
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        const bool none = isNone(n, i);
        const float cosine = std::abs(nV[i]);
        nV[i] = cosine >= cosine_ || none ? 1.0f : cosine;
    }
    for (int channel = 0; channel < 3; ++channel) {
        BatchFloats& Cv = samples.Cv[static_cast<std::size_t>(channel)];
        for (std::size_t i = 0; i < kBatchSize; ++i)
            Cv[i] = Cv[i] * nV[i] + edgeColor_[channel] * (1.0f - nV[i]);
    }
}

} // namespace

std::shared_ptr<const Style> makeStyle(EdgeEnhancement fields)
{
    return std::make_shared<EdgeEnhancementStyle>(fields);
}

} // namespace vo
