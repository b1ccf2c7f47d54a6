#include "style/glsl_chain.h"
#include "style/shine.h"
#include "style/styles.h"
#include "style/surface_normals.h"

#include <algorithm>

namespace vo {

namespace {

// cc = (1 + Li.n) / 2; Cg = sum of cc warm + (1 - cc) cool, at most 1.
const char* const kGlsl = R"(
vec4 toneMapped(vec4 color, StyleSample s, vec3 n, vec3 coolColor, vec3 warmColor)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lightCount; ++i)
        sum += mix(coolColor, warmColor, 0.5 + 0.5 * dot(directionTo(lights[i], s.position), n));
    return vec4(min(sum, 1.0), color.a);
}
)";

class ToneMappedStyle final : public Style
{
public:
    explicit ToneMappedStyle(const ToneMapped& fields)
        : coolColor_(fields.coolColor), warmColor_(fields.warmColor), normals_(fields.surfaceNormals)
    {
    }

    bool needsNormal() const override { return !normals_.given(); }
    bool needsPosition() const override { return true; }
    const VoxelTexture* surfaceNormals() const override { return normals_.texture(); }
    void apply(const StyleSurroundings& surroundings, SampleBatch& samples) const override;

    void write(GlslChain& chain) const override
    {
        chain.function("directionTo", kDirectionToGlsl);
        chain.function("toneMapped", kGlsl);
        chain.step("toneMapped",
                   {normals_.write(chain), chain.uniform(coolColor_), chain.uniform(warmColor_)});
    }

private:
    glm::vec3 coolColor_, warmColor_;
    SurfaceNormals normals_;
};

void ToneMappedStyle::apply(const StyleSurroundings& surroundings, SampleBatch& samples) const
{
    BatchVectors room;
    const BatchVectors& n = normals_.of(samples, room);
    for (BatchFloats& channel : samples.Cv)
        channel.fill(0.0f);
    for (const StyleLight& light : surroundings.lights) {
        BatchVectors L;
        BatchFloats cc;
        directionsTo(light, samples, L);
        facing(L, n, cc);
        for (int channel = 0; channel < 3; ++channel) {
            BatchFloats& Cv = samples.Cv[static_cast<std::size_t>(channel)];
            const float middle = 0.5f * (warmColor_[channel] + coolColor_[channel]);
            const float half = 0.5f * (warmColor_[channel] - coolColor_[channel]);
            for (std::size_t i = 0; i < kBatchSize; ++i)
                Cv[i] += middle + half * cc[i];
        }
    }
    for (BatchFloats& channel : samples.Cv)
        for (float& value : channel)
            value = std::min(value, 1.0f);
}

} // namespace

std::shared_ptr<const Style> makeStyle(ToneMapped fields)
{
    return std::make_shared<ToneMappedStyle>(fields);
}

} // namespace vo
