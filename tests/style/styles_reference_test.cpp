#include "style_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vo::test {
namespace {

/// What styles must not read is not a number.
void fillBatch(const std::vector<ReferenceSample>& samples, std::size_t first, SampleBatch& batch)
{
    batch.count = static_cast<int>(std::min<std::size_t>(kBatchSize, samples.size() - first));
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
        const ReferenceSample& sample = samples[first + i];
        for (int c = 0; c < 4; ++c)
            batch.voxel[static_cast<std::size_t>(c)][i] = static_cast<float>(sample.voxel[c]);
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            batch.place[a][i] = static_cast<float>(sample.place[axis]);
            batch.position[a][i] = static_cast<float>(sample.position[axis]);
            batch.V[a][i] = static_cast<float>(sample.V[axis]);
            batch.n[a][i] = static_cast<float>(sample.n[axis]);
            batch.Cv[a][i] = static_cast<float>(sample.Cv[axis]);
        }
        batch.gradient[i] = static_cast<float>(sample.gradient);
        batch.Ov[i] = static_cast<float>(sample.Ov);
    }
}

void forget(BatchVectors& vectors)
{
    for (BatchFloats& floats : vectors)
        floats.fill(std::numeric_limits<float>::quiet_NaN());
}

std::vector<glm::vec4> applied(const StyleCase& styleCase, const std::vector<ReferenceSample>& samples)
{
    const StyleChain chain = styleCase.chain();
    std::vector<glm::vec4> colors;
    for (std::size_t first = 0; first < samples.size(); first += kBatchSize) {
        SampleBatch batch{};
        fillBatch(samples, first, batch);
        const auto needs = [&](auto question) {
            return std::any_of(chain.begin(), chain.end(), [&](const auto& s) { return question(*s); });
        };
        if (!needs([](const Style& style) { return style.needsNormal(); })) {
            forget(batch.n);
            batch.gradient.fill(std::numeric_limits<float>::quiet_NaN());
        }
        if (!needs([](const Style& style) { return style.needsPosition(); })) {
            forget(batch.position);
            forget(batch.V);
        }
        for (const auto& style : chain)
            style->apply(styleCase.surroundings, batch);
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
            colors.emplace_back(batch.Cv[0][i], batch.Cv[1][i], batch.Cv[2][i], batch.Ov[i]);
    }
    return colors;
}

TEST(Styles, agreeWithTheReferenceSampleBySample)
{
    const std::vector<ReferenceSample> samples = caseSamples();
    for (const StyleCase& styleCase : styleCases()) {
        const double likeness = psnr(referenceColors(styleCase, samples), applied(styleCase, samples));
        EXPECT_GT(likeness, 100.0) << styleCase.name;
    }
}

} // namespace
} // namespace vo::test
