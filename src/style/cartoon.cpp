#include "style/glsl_chain.h"
#include "style/styles.h"
#include "style/surface_normals.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
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

/// Hue (0 to 6, red at 0), saturation, value and alpha.
glm::vec4 hsvaOf(const glm::vec4& rgba)
{
    const float most = std::max({rgba.r, rgba.g, rgba.b});
    const float range = most - std::min({rgba.r, rgba.g, rgba.b});
    if (range <= 0.0f) return {0.0f, 0.0f, most, rgba.a};
    float hue = 0.0f;
    if (most == rgba.r)
        hue = (rgba.g - rgba.b) / range;
    else if (most == rgba.g)
        hue = (rgba.b - rgba.r) / range + 2.0f;
    else
        hue = (rgba.r - rgba.g) / range + 4.0f;
    return {hue < 0.0f ? hue + 6.0f : hue, range / most, most, rgba.a};
}

glm::vec4 rgbaOf(const glm::vec4& hsva)
{
    const auto channel = [&](float offset) {
        const float turned = offset + hsva.x;
        const float k = turned - 6.0f * std::floor(turned / 6.0f);
        return hsva.z - hsva.z * hsva.y * std::clamp(std::min(k, 4.0f - k), 0.0f, 1.0f);
    };
    return {channel(5.0f), channel(3.0f), channel(1.0f), hsva.a};
}

/// A grey has no hue and takes the other's; else the hues lie at most half a turn apart.
void joinHues(glm::vec4& a, glm::vec4& b)
{
    if (a.y == 0.0f) a.x = b.x;
    if (b.y == 0.0f) b.x = a.x;
    if (b.x - a.x > 3.0f) a.x += 6.0f;
    if (a.x - b.x > 3.0f) b.x += 6.0f;
}

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

CartoonStyle::CartoonStyle(const Cartoon& fields)
    : orthogonalHsva_(hsvaOf(fields.orthogonalColor)), parallelHsva_(hsvaOf(fields.parallelColor)),
      normals_(fields.surfaceNormals)
{
    joinHues(orthogonalHsva_, parallelHsva_);
    const int steps = std::max(fields.colorSteps, 1);
    for (int part = 0; part < steps; ++part) {
        const float middle = (static_cast<float>(part) + 0.5f) / static_cast<float>(steps);
        tones_.push_back(rgbaOf(glm::mix(orthogonalHsva_, parallelHsva_, middle)));
    }
    tones_.back() = fields.parallelColor;
    tones_.front() = fields.orthogonalColor;
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
