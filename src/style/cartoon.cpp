#include "style/glsl_chain.h"
#include "style/hsv_color.h"
#include "style/styles.h"
#include "style/surface_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vo {

namespace {

constexpr float kQuarterTurn = std::numbers::pi_v<float> / 2.0f;

// `ends` are orthogonalColor and parallelColor as hue (0 to 6), saturation, value, alpha: the way from the
// one hue to the other is the short one already.
const char* const kGlsl = R"(
vec4 cartoonColor(vec4 hsva)
{
    vec3 k = mod(vec3(5.0, 3.0, 1.0) + hsva.x, 6.0);
    return vec4(hsva.z - hsva.z * hsva.y * clamp(min(k, 4.0 - k), 0.0, 1.0), hsva.a);
}
vec4 cartoon(vec4 color, StyleSample s, vec3 n, vec4 orthogonal, vec4 parallel, vec4 orthogonalHsva,
             vec4 parallelHsva, float steps)
{
    float nV = dot(n, s.V);
    if (nV < 0.0 || n == vec3(0.0)) return vec4(0.0);
    float part = min(floor(acos(min(nV, 1.0)) / 1.57079633 * steps), steps - 1.0);
    vec4 tone = part == 0.0 ? orthogonal
              : part == steps - 1.0 ? parallel
              : cartoonColor(mix(orthogonalHsva, parallelHsva, (part + 0.5) / steps));
    return vec4(tone.rgb, color.a * tone.a);
}
)";

class CartoonStyle final : public Style
{
public:
    explicit CartoonStyle(const Cartoon& fields);

    bool needsNormal() const override { return !normals_.given(); }
    bool needsPosition() const override { return true; }
    const VoxelTexture* surfaceNormals() const override { return normals_.texture(); }
    void apply(const StyleSurroundings&, SampleBatch& samples) const override;
    void write(GlslChain& chain) const override;

private:
    int partOf(float nV) const;

    std::vector<glm::vec4> tones_; ///< of the parts, from where the normal faces the eye
    glm::vec4 orthogonalHsva_, parallelHsva_;
    SurfaceNormals normals_;
};

CartoonStyle::CartoonStyle(const Cartoon& fields) : normals_(fields.surfaceNormals)
{
    const glm::vec4 &first = fields.orthogonalColor, &last = fields.parallelColor;
    const HsvRamp ramp{glm::dvec3(first), glm::dvec3(last)};
    orthogonalHsva_ = glm::vec4(glm::vec3(ramp.from), first.a);
    parallelHsva_ = glm::vec4(glm::vec3(ramp.to), last.a);
    const int steps = std::max(fields.colorSteps, 1);
    for (int part = 0; part < steps; ++part) {
        const double middle = (part + 0.5) / steps;
        tones_.emplace_back(glm::vec3(ramp.rgbAt(middle)),
                            std::lerp(first.a, last.a, static_cast<float>(middle)));
    }
    tones_.back() = last;
    tones_.front() = first;
}

int CartoonStyle::partOf(float nV) const
{
    const auto steps = static_cast<int>(tones_.size());
    const float part = std::acos(std::min(nV, 1.0f)) / kQuarterTurn * static_cast<float>(steps);
    return std::min(static_cast<int>(part), steps - 1);
}

void CartoonStyle::apply(const StyleSurroundings&, SampleBatch& samples) const
{
    BatchVectors room;
    const BatchVectors& n = normals_.of(samples, room);
    BatchFloats nV;
    facing(n, samples.V, nV);
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i) {
        const bool none = isNone(n, i);
        const bool seen = nV[i] >= 0.0f && !none;
        const glm::vec4 tone = seen ? tones_[static_cast<std::size_t>(partOf(nV[i]))] : glm::vec4(0.0f);
        samples.Cv[0][i] = tone.r;
        samples.Cv[1][i] = tone.g;
        samples.Cv[2][i] = tone.b;
        samples.Ov[i] *= tone.a;
    }
}

void CartoonStyle::write(GlslChain& chain) const
{
    chain.function("cartoon", kGlsl);
    chain.step("cartoon", {normals_.write(chain), chain.uniform(tones_.front()), chain.uniform(tones_.back()),
                           chain.uniform(orthogonalHsva_), chain.uniform(parallelHsva_),
                           chain.uniform(static_cast<float>(tones_.size()))});
}

} // namespace

std::shared_ptr<const Style> makeStyle(Cartoon fields)
{
    return std::make_shared<CartoonStyle>(fields);
}

} // namespace vo
