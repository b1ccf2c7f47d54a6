#include "style/glsl_chain.h"
#include "style/power.h"
#include "style/shine.h"
#include "style/styles.h"
#include "style/surface_normals.h"

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

// Cg = CE + the light of all (kLitByGlsl), at most 1; Og = Ov (1 - transparency).
const char* const kGlsl = R"(
vec4 shaded(vec4 color, StyleSample s, vec3 n, vec3 CD, vec3 CE, vec3 CS, float Ca, float exponent, float opacity,
            vec4 through0, vec4 through1)
{
    vec3 sum = CE;
    for (int i = 0; i < lightCount; ++i) {
        float through = i < 4 ? through0[i] : i < 8 ? through1[i - 4] : 1.0;
        sum += litBy(lights[i], s.position, n, s.V, CD, CS, Ca, exponent, through);
    }
    return vec4(min(sum, 1.0), color.a * opacity);
}
)";

/// What of each light comes through to samples.
using Through = std::array<std::array<BatchFloats, 4>, kMostLights / 4>;

class ShadedStyle final : public Style
{
public:
    explicit ShadedStyle(Shaded fields) : fields_(std::move(fields)), normals_(fields_.surfaceNormals) {}

    bool needsNormal() const override { return fields_.lighting && !normals_.given(); }
    bool needsPosition() const override { return fields_.lighting; }
    const VoxelTexture* surfaceNormals() const override
    {
        return fields_.lighting ? normals_.texture() : nullptr;
    }
    bool asksForShadows() const override { return fields_.lighting && fields_.shadows; }
    std::shared_ptr<const Style> withShadows(const ShadowTextures& textures) const override;
    void apply(const StyleSurroundings& surroundings, SampleBatch& samples) const override;
    void write(GlslChain& chain) const override;

private:
    void light(const StyleSurroundings& surroundings, SampleBatch& samples) const;
    void addLight(const StyleLight& light, const SampleBatch& samples, const BatchVectors& n,
                  const BatchVectors& CD, const BatchFloats* through, BatchVectors& sum) const;
    void findThrough(const SampleBatch& samples, Through& through) const;
    std::string writeThrough(GlslChain& chain, std::size_t texture) const;

    Shaded fields_;
    SurfaceNormals normals_;
};

/// (N.H)^exponent, 0 where N.H is.
void specularOf(const SampleBatch& samples, const BatchVectors& n, const BatchVectors& L, float exponent,
                BatchFloats& specular)
{
    BatchVectors H;
    BatchFloats nH, square;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < kBatchSize; ++i)
            H[axis][i] = L[axis][i] + samples.V[axis][i];
    facing(n, H, nH);
    facing(H, H, square);
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i)
        specular[i] = nH[i] > 0.0f ? raised(nH[i] / std::sqrt(square[i]), exponent) : 0.0f;
}

void ShadedStyle::addLight(const StyleLight& light, const SampleBatch& samples, const BatchVectors& n,
                           const BatchVectors& CD, const BatchFloats* through, BatchVectors& sum) const
{
    Shine shine;
    BatchFloats nL, specular{};
    shineOf(light, samples, shine);
    facing(n, shine.L, nL);
    if (fields_.specular != glm::vec3(0.0f))
        specularOf(samples, n, shine.L, 128.0f * fields_.shininess, specular);
    const float ambient = light.ambientIntensity * fields_.ambientIntensity;
    for (int channel = 0; channel < 3; ++channel) {
        const auto c = static_cast<std::size_t>(channel);
        const float glow = fields_.specular[channel] * light.intensity;
        for (std::size_t i = 0; i < kBatchSize; ++i) {
            const float direct = light.intensity * std::max(nL[i], 0.0f) * CD[c][i] + glow * specular[i];
            sum[c][i] += shine.strength[i] * light.color[channel] *
                         (ambient * CD[c][i] + (through ? (*through)[i] : 1.0f) * direct);
        }
    }
}

void ShadedStyle::findThrough(const SampleBatch& samples, Through& through) const
{
    const auto& [textures, box] = fields_.shadowTextures;
    if (textures.empty()) return;
    BatchVectors place;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < kBatchSize; ++i)
            place[axis][i] = (samples.position[axis][i] - box.low[static_cast<int>(axis)]) /
                             box.sides[static_cast<int>(axis)];
    for (std::size_t i = 0; i < std::min(through.size(), textures.size()); ++i) {
        for (BatchFloats& numbers : through[i])
            numbers.fill(1.0f);
        sampleTexture(*textures[i], samples.count, place, through[i]);
    }
}

void ShadedStyle::light(const StyleSurroundings& surroundings, SampleBatch& samples) const
{
    BatchVectors room;
    const BatchVectors& n = normals_.of(samples, room);
    const BatchVectors CD = samples.Cv;
    for (int channel = 0; channel < 3; ++channel)
        samples.Cv[static_cast<std::size_t>(channel)].fill(fields_.emissive[channel]);
    Through through;
    findThrough(samples, through);
    const std::size_t inShadow = std::min(kMostLights, 4 * fields_.shadowTextures.textures.size());
    for (std::size_t i = 0; i < surroundings.lights.size(); ++i)
        addLight(surroundings.lights[i], samples, n, CD, i < inShadow ? &through[i / 4][i % 4] : nullptr,
                 samples.Cv);
    for (BatchFloats& channel : samples.Cv)
        for (float& value : channel)
            value = std::min(value, 1.0f);
}

void ShadedStyle::apply(const StyleSurroundings& surroundings, SampleBatch& samples) const
{
    if (fields_.hasMaterial)
        for (int channel = 0; channel < 3; ++channel)
            samples.Cv[static_cast<std::size_t>(channel)].fill(fields_.diffuse[channel]);
    if (fields_.lighting) light(surroundings, samples);
    for (float& opacity : samples.Ov)
        opacity *= 1.0f - fields_.transparency;
}

std::shared_ptr<const Style> ShadedStyle::withShadows(const ShadowTextures& textures) const
{
    if (!asksForShadows()) return nullptr;
    Shaded fields = fields_;
    fields.shadowTextures = textures;
    return makeStyle(std::move(fields));
}

/// A texture answers 0 for components that it lacks; no light has their number.
std::string ShadedStyle::writeThrough(GlslChain& chain, std::size_t texture) const
{
    const auto& [textures, box] = fields_.shadowTextures;
    if (texture >= textures.size()) return "vec4(1.0)";
    const std::string place = "(s.position - " + chain.uniform(box.low) + ") / " + chain.uniform(box.sides);
    return "styleTexture(" + chain.texture(textures[texture]) + ", " + place + ")";
}

void ShadedStyle::write(GlslChain& chain) const
{
    const std::string CD = fields_.hasMaterial ? chain.uniform(fields_.diffuse) : "color.rgb";
    const std::string opacity = chain.uniform(1.0f - fields_.transparency);
    if (!fields_.lighting) {
        chain.statement("color = vec4(" + CD + ", color.a * " + opacity + ");");
        return;
    }
    chain.function("raised", kRaisedGlsl);
    chain.function("directionTo", kDirectionToGlsl);
    chain.function("strengthOf", kStrengthOfGlsl);
    chain.function("litBy", kLitByGlsl);
    chain.function("shaded", kGlsl);
    chain.step("shaded",
               {normals_.write(chain), CD, chain.uniform(fields_.emissive), chain.uniform(fields_.specular),
                chain.uniform(fields_.ambientIntensity), chain.uniform(128.0f * fields_.shininess), opacity,
                writeThrough(chain, 0), writeThrough(chain, 1)});
}

} // namespace

std::shared_ptr<const Style> makeStyle(Shaded fields)
{
    return std::make_shared<ShadedStyle>(std::move(fields));
}

} // namespace vo
