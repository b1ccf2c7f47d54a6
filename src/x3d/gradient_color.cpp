#include "x3d/gradient_color.h"

#include "style/glsl_chain.h"

#include <algorithm>

namespace vo {
namespace {

// A leap from 0 to 1 between two neighbours is |Df| = 1/2 at both: no change along an edge is larger.
const char* const kGlsl = R"(
vec4 gradientColor(vec4 color, StyleSample s, vec4 most)
{
    return vec4(mix(color.rgb, most.rgb, most.a * min(2.0 * s.gradient, 1.0)), color.a);
}
)";

class GradientColor final : public Style
{
public:
    explicit GradientColor(const glm::vec4& color) : color_(color) {}

    bool needsNormal() const override { return true; }
    bool needsPosition() const override { return false; }

    void apply(const StyleSurroundings&, SampleBatch& samples) const override
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i) {
            const float part = color_.a * std::min(2.0f * samples.gradient[i], 1.0f);
            for (int channel = 0; channel < 3; ++channel) {
                float& color = samples.Cv[static_cast<std::size_t>(channel)][i];
                color += part * (color_[channel] - color);
            }
        }
    }

    void write(GlslChain& chain) const override
    {
        chain.function("gradientColor", kGlsl);
        chain.step("gradientColor", {chain.uniform(color_)});
    }

private:
    glm::vec4 color_;
};

} // namespace

std::shared_ptr<const Style> gradientColor(const glm::vec4& color)
{
    return std::make_shared<GradientColor>(color);
}

} // namespace vo
