#include "style/glsl_chain.h"
#include "style/styles.h"
#include "style/transfer_function.h"

#include <algorithm>
#include <string>

namespace vo {

namespace {

const char* const kWithoutFunctionGlsl = R"(
vec4 opaqueAtZero(vec4 color, StyleSample s) { return vec4(color.rgb, 1.0 - color.a); }
)";

/// The voxel's components that are places in the function.
std::string placeInGlsl(int voxelComponents)
{
    constexpr std::array kPlaces{"vec3(s.voxel.r, 0.0, 0.0)", "vec3(s.voxel.rg, 0.0)", "s.voxel.rgb",
                                 "s.voxel.rgb"};
    return kPlaces.at(static_cast<std::size_t>(voxelComponents - 1));
}

/// What a texel of the function stands for.
const char* colorOfTexelGlsl(int components)
{
    constexpr std::array kColors{
        "vec4 texelColor1(vec4 texel) { return vec4(texel.rrr, 1.0); }",
        "vec4 texelColor2(vec4 texel) { return texel.rrrg; }",
        "vec4 texelColor3(vec4 texel) { return vec4(texel.rgb, 1.0); }",
        "vec4 texelColor4(vec4 texel) { return texel; }",
    };
    return kColors.at(static_cast<std::size_t>(components - 1));
}

class OpacityMapStyle final : public Style
{
public:
    explicit OpacityMapStyle(const OpacityMap& fields)
        : function_(fields.transferFunction, fields.voxelComponents), opaqueAtZero_(fields.opaqueAtZero),
          voxelComponents_(fields.voxelComponents)
    {
    }

    bool replacesColor() const override { return true; }
    bool isClear(float low, float high) const override
    {
        if (function_ && voxelComponents_ == 1) return function_.isClear(low, high);
        return keepsClearVoxels() ? high <= 0.0f : !function_ && low >= 1.0f;
    }
    bool keepsClearVoxels() const override { return function_ ? voxelComponents_ == 4 : !opaqueAtZero_; }
    void apply(const StyleSurroundings&, SampleBatch& samples) const override;
    void write(GlslChain& chain) const override;

private:
    void applyFunction(SampleBatch& samples) const;

    TransferFunction function_;
    bool opaqueAtZero_;
    int voxelComponents_;
};

void OpacityMapStyle::apply(const StyleSurroundings&, SampleBatch& samples) const
{
    if (function_) {
        applyFunction(samples);
        return;
    }
    firstColor(voxelComponents_, samples);
    if (!opaqueAtZero_) return;
    for (float& opacity : samples.Ov)
        opacity = 1.0f - opacity;
}

void OpacityMapStyle::applyFunction(SampleBatch& samples) const
{
    BatchVectors place{};
    for (int axis = 0; axis < std::min(voxelComponents_, 3); ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        for (std::size_t i = 0; i < kBatchSize; ++i)
            place[a][i] = samples.voxel[a][i];
    }
    std::array<BatchFloats, 4> texels{};
    const int components = function_.components();
    function_.sample(samples.count, place, texels);
    for (std::size_t channel = 0; channel < 3; ++channel)
        samples.Cv[channel] = components < 3 ? texels[0] : texels[channel];
    if (components == 2 || components == 4)
        samples.Ov = texels[static_cast<std::size_t>(components - 1)];
    else
        samples.Ov.fill(1.0f);
    if (voxelComponents_ < 4) return;
    for (std::size_t i = 0; i < kBatchSize; ++i)
        samples.Ov[i] *= samples.voxel[3][i];
}

void OpacityMapStyle::write(GlslChain& chain) const
{
    if (!function_) {
        chain.statement("color = firstColor" + std::to_string(voxelComponents_) + "(s.voxel);");
        if (!opaqueAtZero_) return;
        chain.function("opaqueAtZero", kWithoutFunctionGlsl);
        chain.step("opaqueAtZero", {});
        return;
    }
    const int components = function_.components();
    const std::string colorOf = "texelColor" + std::to_string(components);
    chain.function(colorOf, colorOfTexelGlsl(components));
    const std::string texel = function_.write(chain, placeInGlsl(voxelComponents_));
    chain.statement("color = " + colorOf + "(" + texel + ");");
    if (voxelComponents_ == 4) chain.statement("color.a *= s.voxel.a;");
}

} // namespace

std::shared_ptr<const Style> makeStyle(OpacityMap fields)
{
    return std::make_shared<OpacityMapStyle>(fields);
}

} // namespace vo
