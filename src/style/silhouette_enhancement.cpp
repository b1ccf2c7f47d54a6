#include "style/glsl_chain.h"
#include "style/power.h"
#include "style/styles.h"
#include "style/surface_normals.h"

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

// Og = Ov (ksc + kss (1 - |n.V|)^kse), at most 1. Without a normal as if facing the eye.
const char* const kGlsl = R"(
vec4 silhouetteEnhancement(vec4 color, StyleSample s, vec3 n, float ksc, float kss, float kse)
{
    float turned = n == vec3(0.0) ? 0.0 : 1.0 - abs(dot(n, s.V));
    return vec4(color.rgb, min(color.a * (ksc + kss * raised(turned, kse)), 1.0));
}
)";

class SilhouetteEnhancementStyle final : public Style
{
public:
    explicit SilhouetteEnhancementStyle(const SilhouetteEnhancement& fields)
        : fields_(fields), normals_(fields.surfaceNormals)
    {
    }

    bool needsNormal() const override { return !normals_.given(); }
    bool needsPosition() const override { return true; }
    const VoxelTexture* surfaceNormals() const override { return normals_.texture(); }
    void apply(const StyleSurroundings&, SampleBatch& samples) const override;

    void write(GlslChain& chain) const override
    {
        chain.function("raised", kRaisedGlsl);
        chain.function("silhouetteEnhancement", kGlsl);
        chain.step("silhouetteEnhancement",
                   {normals_.write(chain), chain.uniform(fields_.retainedOpacity),
                    chain.uniform(fields_.boundaryOpacity), chain.uniform(fields_.sharpness)});
    }

private:
    SilhouetteEnhancement fields_;
    SurfaceNormals normals_;
};

void SilhouetteEnhancementStyle::apply(const StyleSurroundings&, SampleBatch& samples) const
{
    BatchVectors room;
    const BatchVectors& n = normals_.of(samples, room);
    BatchFloats nV;
    facing(n, samples.V, nV);
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples.count); ++i) {
        const bool none = isNone(n, i);
        const float turned = none ? 0.0f : 1.0f - std::abs(nV[i]);
        const float boundary = fields_.boundaryOpacity * raised(turned, fields_.sharpness);
        samples.Ov[i] = std::min(samples.Ov[i] * (fields_.retainedOpacity + boundary), 1.0f);
    }
}

} // namespace

std::shared_ptr<const Style> makeStyle(SilhouetteEnhancement fields)
{
    return std::make_shared<SilhouetteEnhancementStyle>(fields);
}

} // namespace vo
