#include "style/glsl_chain.h"
#include "style/shadow_textures.h"
#include "style/styled_voxels.h"
#include "style/styles.h"
#include "style/transfer_function.h"

#include <algorithm>
#include <string>
#include <utility>

namespace vo {

namespace {

const char* const kNormalGlsl = R"(
float brightness1(vec4 voxel) { return voxel.r; }
float brightness3(vec4 voxel) { return (voxel.r + voxel.g + voxel.b) / 3.0; }
void setNormal(vec3 difference, inout StyleSample s)
{
    s.gradient = length(difference);
    s.n = s.gradient < 1e-6 ? vec3(0.0) : -difference / s.gradient;
}
)";

// w1 and w2 weigh the colour so far and that of the other voxels.
const char* const kGlsl = R"(
vec4 blended(vec4 v, vec4 b, float w1, float w2) { return clamp(v * w1 + b * w2, 0.0, 1.0); }
)";

class BlendedStyle final : public Style
{
public:
    explicit BlendedStyle(Blended fields);

    bool needsPosition() const override;
    bool keepsClear() const override { return fields_.voxels == nullptr; }
    bool asksForShadows() const override { return vo::asksForShadows(fields_.chain); }
    std::shared_ptr<const Style> withShadows(const ShadowTextures& textures) const override;
    void apply(const StyleSurroundings& surroundings, SampleBatch& samples) const override;
    void write(GlslChain& chain) const override;

private:
    bool chainNeedsNormal() const;
    void writeNormal(GlslChain& chain, const std::string& voxels) const;

    Blended fields_;
    TransferFunction table1_, table2_; ///< of the weights
    glm::vec3 perDifference_{0.0f};    ///< of two values two voxels apart, Df
};

BlendedStyle::BlendedStyle(Blended fields)
    : fields_(std::move(fields)), table1_(fields_.weightTransferFunction1, 2),
      table2_(fields_.weightTransferFunction2, 2)
{
    fields_.chain = effectiveChain(fields_.chain);
    if (!fields_.voxels) return;
    glm::vec3 edges;
    for (int axis = 0; axis < 3; ++axis)
        edges[axis] = fields_.dimensions[axis] / static_cast<float>(fields_.voxels->size[axis]);
    perDifference_ = 0.5f * std::min({edges.x, edges.y, edges.z}) / edges;
}

bool BlendedStyle::needsPosition() const
{
    return std::ranges::any_of(fields_.chain, [](const auto& style) { return style->needsPosition(); });
}

std::shared_ptr<const Style> BlendedStyle::withShadows(const ShadowTextures& textures) const
{
    if (!asksForShadows()) return nullptr;
    Blended fields = fields_;
    fields.chain = chainWithShadows(fields_.chain, textures);
    return makeStyle(std::move(fields));
}

bool BlendedStyle::chainNeedsNormal() const
{
    return std::ranges::any_of(fields_.chain, [](const auto& style) { return style->needsNormal(); });
}

/// w1 is read from its table at (Ov, Ob), w2 at (Ob, Ov): `own` and `others`. Without a table: the constant.
void weigh(Blended::Weight function, float constant, const TransferFunction& table, const BatchFloats& own,
           const BatchFloats& others, const SampleBatch& samples, const SampleBatch& other,
           BatchFloats& weights)
{
    weights.fill(constant);
    switch (function) {
    case Blended::Weight::constant: return;
    case Blended::Weight::alpha0: weights = samples.Ov; return;
    case Blended::Weight::alpha1: weights = other.Ov; return;
    case Blended::Weight::oneMinusAlpha0:
    case Blended::Weight::oneMinusAlpha1: {
        const bool first = function == Blended::Weight::oneMinusAlpha0;
        const BatchFloats& opacity = first ? samples.Ov : other.Ov;
        for (std::size_t i = 0; i < kBatchSize; ++i)
            weights[i] = 1.0f - opacity[i];
        return;
    }
    case Blended::Weight::table: break;
    }
    if (!table) return;
    BatchVectors place{own, others, {}};
    std::array<BatchFloats, 4> texels{};
    table.sample(samples.count, place, texels);
    weights = texels[0];
}

void BlendedStyle::apply(const StyleSurroundings& surroundings, SampleBatch& samples) const
{
    if (!fields_.voxels) return;
    SampleBatch other = samples;
    sampleTexture(*fields_.voxels, samples.count, samples.place, other.voxel);
    if (chainNeedsNormal()) findNormals(*fields_.voxels, fields_.dimensions, other);
    firstColor(fields_.voxels->components, other);
    for (const auto& style : fields_.chain)
        style->apply(surroundings, other);
    BatchFloats w1, w2;
    weigh(fields_.weightFunction1, fields_.weightConstant1, table1_, samples.Ov, other.Ov, samples, other,
          w1);
    weigh(fields_.weightFunction2, fields_.weightConstant2, table2_, other.Ov, samples.Ov, samples, other,
          w2);
    const auto join = [&](BatchFloats& v, const BatchFloats& b) {
        for (std::size_t i = 0; i < kBatchSize; ++i)
            v[i] = std::clamp(v[i] * w1[i] + b[i] * w2[i], 0.0f, 1.0f);
    };
    for (std::size_t channel = 0; channel < 3; ++channel)
        join(samples.Cv[channel], other.Cv[channel]);
    join(samples.Ov, other.Ov);
}

void BlendedStyle::writeNormal(GlslChain& chain, const std::string& voxels) const
{
    const VoxelTexture& texture = *fields_.voxels;
    chain.function("setNormal", kNormalGlsl);
    const std::string brightness = texture.components < 3 ? "brightness1(" : "brightness3(";
    std::string differences;
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 step(0.0f);
        step[axis] = 1.0f / static_cast<float>(texture.size[axis]);
        const std::string name = chain.uniform(step);
        const auto value = [&](const char* sign) {
            return brightness + "styleTexture(" + voxels + ", s.place" + sign + name + "))";
        };
        differences += (axis == 0 ? "" : ", ") + value(" + ") + " - " + value(" - ");
    }
    chain.statement("setNormal(" + chain.uniform(perDifference_) + " * vec3(" + differences + "), s);");
}

std::string weightInGlsl(GlslChain& chain, Blended::Weight function, float constant,
                         const TransferFunction& table, const char* place)
{
    switch (function) {
    case Blended::Weight::alpha0: return "colorBefore.a";
    case Blended::Weight::alpha1: return "color.a";
    case Blended::Weight::oneMinusAlpha0: return "1.0 - colorBefore.a";
    case Blended::Weight::oneMinusAlpha1: return "1.0 - color.a";
    case Blended::Weight::table:
        if (table) return table.write(chain, place) + ".r";
        break;
    case Blended::Weight::constant: break;
    }
    return chain.uniform(constant);
}

void BlendedStyle::write(GlslChain& chain) const
{
    if (!fields_.voxels) return;
    const std::string voxels = chain.texture(fields_.voxels);
    chain.function("blended", kGlsl);
    chain.statement("{ vec4 colorBefore = color; StyleSample before = s;");
    if (chainNeedsNormal()) writeNormal(chain, voxels);
    chain.statement("s.voxel = styleTexture(" + voxels + ", s.place);");
    chain.statement("color = firstColor" + std::to_string(fields_.voxels->components) + "(s.voxel);");
    for (const auto& style : fields_.chain)
        style->write(chain);
    const std::string w1 = weightInGlsl(chain, fields_.weightFunction1, fields_.weightConstant1, table1_,
                                        "vec3(colorBefore.a, color.a, 0.0)");
    const std::string w2 = weightInGlsl(chain, fields_.weightFunction2, fields_.weightConstant2, table2_,
                                        "vec3(color.a, colorBefore.a, 0.0)");
    chain.statement("color = blended(colorBefore, color, " + w1 + ", " + w2 + ");");
    chain.statement("s = before; }");
}

} // namespace

std::shared_ptr<const Style> makeStyle(Blended fields)
{
    return std::make_shared<BlendedStyle>(std::move(fields));
}

} // namespace vo
