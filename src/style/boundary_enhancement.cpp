#include "style/glsl_chain.h"
#include "style/power.h"
#include "style/styles.h"

#include <algorithm>

namespace vo {

namespace {

// Og = Ov (kgc + kgs |Df|^kge), at most 1.
const char* const kGlsl = R"(
vec4 boundaryEnhancement(vec4 color, StyleSample s, float kgc, float kgs, float kge)
{
    return vec4(color.rgb, min(color.a * (kgc + kgs * raised(s.gradient, kge)), 1.0));
}
)";

class BoundaryEnhancementStyle final : public Style
{
public:
    explicit BoundaryEnhancementStyle(BoundaryEnhancement fields) : fields_(fields) {}

    bool needsNormal() const override { return true; }
    bool needsPosition() const override { return false; }

    void apply(const StyleSurroundings&, SampleBatch& samples) const override
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i) {
            const float boundary =
                fields_.boundaryOpacity * raised(samples.gradient[i], fields_.opacityFactor);
            samples.Ov[i] = std::min(samples.Ov[i] * (fields_.retainedOpacity + boundary), 1.0f);
        }
    }

    void write(GlslChain& chain) const override
    {
        chain.function("raised", kRaisedGlsl);
        chain.function("boundaryEnhancement", kGlsl);
        chain.step("boundaryEnhancement",
                   {chain.uniform(fields_.retainedOpacity), chain.uniform(fields_.boundaryOpacity),
                    chain.uniform(fields_.opacityFactor)});
    }

private:
    BoundaryEnhancement fields_;
};

} // namespace

std::shared_ptr<const Style> makeStyle(BoundaryEnhancement fields)
{
    return std::make_shared<BoundaryEnhancementStyle>(fields);
}

} // namespace vo
