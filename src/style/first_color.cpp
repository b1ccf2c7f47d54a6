#include "style/style.h"

namespace vo {

const char* const kFirstColorGlsl = R"(
vec4 firstColor1(vec4 voxel) { return voxel.rrrr; }
vec4 firstColor2(vec4 voxel) { return voxel.rrrg; }
vec4 firstColor3(vec4 voxel) { return vec4(voxel.rgb, (voxel.r + voxel.g + voxel.b) / 3.0); }
vec4 firstColor4(vec4 voxel) { return voxel; }
)";

void firstColor(int components, SampleBatch& samples)
{
    const auto& [r, g, b, a] = samples.voxel;
    for (std::size_t channel = 0; channel < 3; ++channel)
        samples.Cv[channel] = components < 3 ? r : samples.voxel[channel];
    switch (components) {
    case 1: samples.Ov = r; break;
    case 2: samples.Ov = g; break;
    case 3:
        for (std::size_t i = 0; i < kBatchSize; ++i)
            samples.Ov[i] = (r[i] + g[i] + b[i]) / 3.0f;
        break;
    default: samples.Ov = a;
    }
}

} // namespace vo
