#include "x3d/fixed_opacity.h"

#include "style/glsl_chain.h"

namespace vo {
namespace {

class FixedOpacity : public Style
{
public:
    explicit FixedOpacity(float opacity) : opacity_(opacity) {}

    bool keepsClear() const override { return opacity_ == 0.0f; }

    void apply(const StyleSurroundings&, SampleBatch& samples) const override
    {
        samples.Ov.fill(opacity_);
        for (BatchFloats& channel : samples.Cv)
            for (float& number : channel)
                number *= opacity_;
    }

    void write(GlslChain& chain) const override
    {
        chain.function("fixedOpacity", "vec4 fixedOpacity(vec4 color, StyleSample s, float opacity)\n"
                                       "{\n    return vec4(color.rgb * opacity, opacity);\n}\n");
        chain.step("fixedOpacity", {chain.uniform(opacity_)});
    }

private:
    float opacity_;
};

} // namespace

std::shared_ptr<const Style> fixedOpacity(float opacity)
{
    return std::make_shared<FixedOpacity>(opacity);
}

} // namespace vo
