#include "style/styles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vo {
namespace {

constexpr float kNear = 2e-6f;
constexpr double kPi = std::numbers::pi;

/// One sample of a grey volume: colour 0.8 0.4 0.2, opacity 0.5, the eye along +z, n turned away from it by
/// `angle`.
SampleBatch sampleTurnedBy(double angle)
{
    SampleBatch samples{};
    samples.count = 1;
    samples.voxel[0][0] = 0.25f;
    samples.V[2][0] = 1.0f;
    samples.n[0][0] = static_cast<float>(std::sin(angle));
    samples.n[2][0] = static_cast<float>(std::cos(angle));
    samples.gradient[0] = 0.3f;
    samples.Cv[0][0] = 0.8f;
    samples.Cv[1][0] = 0.4f;
    samples.Cv[2][0] = 0.2f;
    samples.Ov[0] = 0.5f;
    return samples;
}

template <class Fields>
glm::vec4 applied(const Fields& fields, SampleBatch samples, const StyleSurroundings& surroundings = {})
{
    makeStyle(fields)->apply(surroundings, samples);
    return {samples.Cv[0][0], samples.Cv[1][0], samples.Cv[2][0], samples.Ov[0]};
}

void expectColor(const glm::vec4& color, const glm::vec4& expected)
{
    for (int channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(color[channel], expected[channel], kNear) << "channel " << channel;
}

TexturePointer texture(VoxelSize size, int components, const std::vector<std::uint8_t>& texels)
{
    auto made = std::make_shared<VoxelTexture>();
    made->size = size;
    made->components = components;
    for (const std::uint8_t texel : texels)
        made->texels.push_back(static_cast<std::byte>(texel));
    return made;
}

SampleBatch withoutNormal()
{
    SampleBatch samples = sampleTurnedBy(0.0);
    samples.n[2][0] = 0.0f;
    return samples;
}

StyleSurroundings lightFrom(const glm::vec3& place)
{
    StyleLight light;
    light.direction = -place;
    return {{light}};
}

TEST(OpacityMap, withoutFunctionIsTheVoxelItself)
{
    expectColor(applied(OpacityMap{}, sampleTurnedBy(0.0)), {0.25f, 0.25f, 0.25f, 0.25f});
}

TEST(OpacityMap, of2005IsOpaqueAtZero)
{
    expectColor(applied(OpacityMap{{}, true, 1}, sampleTurnedBy(0.0)), {0.25f, 0.25f, 0.25f, 0.75f});
}

TEST(OpacityMap, luminanceOfAFunctionIsOpaque)
{
    const OpacityMap map{texture({2, 1, 1}, 1, {0, 255})};
    // 0.25 is the centre of the first of two texels.
    expectColor(applied(map, sampleTurnedBy(0.0)), {0, 0, 0, 1});
    SampleBatch middle = sampleTurnedBy(0.0);
    middle.voxel[0][0] = 0.5f;
    expectColor(applied(map, middle), {0.5f, 0.5f, 0.5f, 1});
}

TEST(OpacityMap, texelsOfTwoToFourComponentsGiveTheirColor)
{
    const SampleBatch samples = sampleTurnedBy(0.0);
    expectColor(applied(OpacityMap{texture({1, 1, 1}, 2, {51, 102})}, samples), {0.2f, 0.2f, 0.2f, 0.4f});
    expectColor(applied(OpacityMap{texture({1, 1, 1}, 3, {51, 102, 0})}, samples), {0.2f, 0.4f, 0, 1});
    expectColor(applied(OpacityMap{texture({1, 1, 1}, 4, {51, 102, 0, 153})}, samples),
                {0.2f, 0.4f, 0, 0.6f});
}

TEST(OpacityMap, valuesAtTheEdgeDoNotWrapRound)
{
    auto function = std::make_shared<VoxelTexture>(*texture({2, 1, 1}, 1, {0, 255}));
    function->repeats = {true, true, true};
    SampleBatch samples = sampleTurnedBy(0.0);
    samples.voxel[0][0] = 0.0f;
    expectColor(applied(OpacityMap{function}, samples), {0, 0, 0, 1});
    samples.voxel[0][0] = 1.0f;
    expectColor(applied(OpacityMap{function}, samples), {1, 1, 1, 1});
}

TEST(OpacityMap, componentsOfTheVoxelAreCoordinates)
{
    const TexturePointer function = texture({2, 2, 2}, 1, {0, 10, 20, 30, 40, 50, 60, 70});
    SampleBatch samples = sampleTurnedBy(0.0);
    samples.voxel[0][0] = 1.0f;
    samples.voxel[1][0] = 1.0f;
    samples.voxel[2][0] = 1.0f;
    samples.voxel[3][0] = 0.5f;
    const float unit = 1.0f / 255.0f;
    EXPECT_NEAR(applied(OpacityMap{function, false, 1}, samples).r, 10 * unit, kNear);
    EXPECT_NEAR(applied(OpacityMap{function, false, 2}, samples).r, 30 * unit, kNear);
    EXPECT_NEAR(applied(OpacityMap{function, false, 3}, samples).r, 70 * unit, kNear);
    expectColor(applied(OpacityMap{function, false, 4}, samples), {70 * unit, 70 * unit, 70 * unit, 0.5f});
}

TEST(OpacityMap, inTheMiddleOfAChainItReplacesWhatCameBefore)
{
    const StyleChain chain{makeStyle(BoundaryEnhancement{}), makeStyle(OpacityMap{}), makeStyle(Cartoon{})};
    const StyleChain effective = effectiveChain(chain);
    ASSERT_EQ(effective.size(), 2u);
    EXPECT_EQ(effective[0], chain[1]);
    EXPECT_EQ(effective[1], chain[2]);
    EXPECT_EQ(effectiveChain({chain[0], chain[2]}).size(), 2u);
}

TEST(BoundaryEnhancement, opacityGrowsWithTheGradient)
{
    expectColor(applied(BoundaryEnhancement{}, sampleTurnedBy(0.0)),
                {0.8f, 0.4f, 0.2f, 0.5f * (0.2f + 0.9f * 0.09f)});
}

TEST(BoundaryEnhancement, opacityEndsAtOne)
{
    EXPECT_EQ(applied(BoundaryEnhancement{1.0f, 100.0f, 1.0f}, sampleTurnedBy(0.0)).a, 1.0f);
}

TEST(BoundaryEnhancement, factorZeroMakesEveryGradientOne)
{
    SampleBatch samples = sampleTurnedBy(0.0);
    samples.gradient[0] = 0.0f;
    EXPECT_NEAR(applied(BoundaryEnhancement{0.2f, 0.5f, 0.0f}, samples).a, 0.35f, kNear);
}

TEST(Cartoon, defaultsHaveTheFourTonesOfTheProposal)
{
    constexpr std::array kTones{1.0f, 0.625f, 0.375f, 0.0f};
    for (int part = 0; part < 4; ++part)
        for (const double within : {0.01, 0.5, 0.99}) {
            const float tone = kTones[static_cast<std::size_t>(part)];
            expectColor(applied(Cartoon{}, sampleTurnedBy((part + within) * kPi / 8)),
                        {tone, tone, tone, 0.5f});
        }
}

TEST(Cartoon, oneStepIsTheOrthogonalColor)
{
    const Cartoon cartoon{{1, 0, 0, 1}, {0, 1, 0, 0.5f}, 1, {}};
    for (const double angle : {0.0, 0.7, 1.57})
        expectColor(applied(cartoon, sampleTurnedBy(angle)), {0, 1, 0, 0.25f});
}

TEST(Cartoon, twoStepsAreTheTwoColors)
{
    const Cartoon cartoon{{1, 0, 0, 1}, {0, 1, 0, 1}, 2, {}};
    expectColor(applied(cartoon, sampleTurnedBy(0.78)), {0, 1, 0, 0.5f});
    expectColor(applied(cartoon, sampleTurnedBy(0.79)), {1, 0, 0, 0.5f});
}

TEST(Cartoon, huesAreMixedTheShortWay)
{
    // From magenta (300 degrees) to yellow (60) by red; the middle of three parts.
    const Cartoon cartoon{{1, 1, 0, 1}, {1, 0, 1, 0}, 3, {}};
    expectColor(applied(cartoon, sampleTurnedBy(kPi / 4)), {1, 0, 0, 0.25f});
}

TEST(Cartoon, aGreyTakesTheOthersHue)
{
    // White to blue: half the saturation in the middle.
    const Cartoon cartoon{{0, 0, 1, 1}, {1, 1, 1, 1}, 3, {}};
    expectColor(applied(cartoon, sampleTurnedBy(kPi / 4)), {0.5f, 0.5f, 1, 0.5f});
}

TEST(Cartoon, backsAndSamplesWithoutNormalAreNotDrawn)
{
    EXPECT_EQ(applied(Cartoon{}, sampleTurnedBy(1.58)).a, 0.0f);
    EXPECT_EQ(applied(Cartoon{}, withoutNormal()).a, 0.0f);
}

TEST(EdgeEnhancement, colorsBeyondTheThresholdOnly)
{
    const EdgeEnhancement edge{{1, 0, 0.5f, 1}, 0.4f, {}};
    expectColor(applied(edge, sampleTurnedBy(0.39)), {0.8f, 0.4f, 0.2f, 0.5f});
    // At a third of a right angle's cosine: 60 degrees.
    expectColor(applied(edge, sampleTurnedBy(kPi / 3)), {0.9f, 0.2f, 0.35f, 0.5f});
    expectColor(applied(edge, sampleTurnedBy(kPi * 2 / 3)), {0.9f, 0.2f, 0.35f, 0.5f});
}

TEST(EdgeEnhancement, thresholdBeyondARightAngleChangesNothing)
{
    expectColor(applied(EdgeEnhancement{{1, 0, 0, 1}, 3.0f, {}}, sampleTurnedBy(kPi / 2)),
                {0.8f, 0.4f, 0.2f, 0.5f});
}

TEST(EdgeEnhancement, withoutNormalTheColorStays)
{
    expectColor(applied(EdgeEnhancement{}, withoutNormal()), {0.8f, 0.4f, 0.2f, 0.5f});
}

TEST(SilhouetteEnhancement, opacityIsRetainedAndGrowsTowardsTheRim)
{
    const SilhouetteEnhancement silhouette{0.25f, 0.5f, 2.0f, {}};
    EXPECT_NEAR(applied(silhouette, sampleTurnedBy(0.0)).a, 0.5f * 0.25f, kNear);
    EXPECT_NEAR(applied(silhouette, sampleTurnedBy(kPi / 3)).a, 0.5f * (0.25f + 0.5f * 0.25f), kNear);
    EXPECT_NEAR(applied(silhouette, sampleTurnedBy(kPi / 2)).a, 0.5f * 0.75f, kNear);
    EXPECT_NEAR(applied(silhouette, withoutNormal()).a, 0.5f * 0.25f, kNear);
}

TEST(ToneMapped, warmFacesTheLight)
{
    expectColor(applied(ToneMapped{}, sampleTurnedBy(0.0), lightFrom({0, 0, 1})), {1, 1, 0, 0.5f});
    expectColor(applied(ToneMapped{}, sampleTurnedBy(0.0), lightFrom({0, 0, -1})), {0, 0, 1, 0.5f});
    expectColor(applied(ToneMapped{}, withoutNormal(), lightFrom({0, 0, 1})), {0.5f, 0.5f, 0.5f, 0.5f});
}

TEST(ToneMapped, lightsAddUpToOne)
{
    StyleSurroundings two = lightFrom({0, 0, 1});
    two.lights.push_back(two.lights[0]);
    const ToneMapped dim{{0, 0, 0, 0}, {0.25f, 0.75f, 0.5f, 0}, {}};
    expectColor(applied(dim, sampleTurnedBy(0.0), two), {0.5f, 1, 1, 0.5f});
    expectColor(applied(dim, sampleTurnedBy(0.0)), {0, 0, 0, 0.5f});
}

TEST(SurfaceNormals, ofTheStyleTakeThePlaceOfTheSamples)
{
    // 255 127 127 points along +x, nearly: the eye sees its rim.
    const TexturePointer rim = texture({1, 1, 1}, 3, {255, 127, 127});
    const SilhouetteEnhancement silhouette{0.0f, 1.0f, 1.0f, rim};
    EXPECT_NEAR(applied(silhouette, sampleTurnedBy(0.0)).a, 0.5f, 2.5e-3f);
    EXPECT_FALSE(makeStyle(silhouette)->needsNormal());
    EXPECT_TRUE(makeStyle(silhouette)->needsPosition());
    const TexturePointer none = texture({1, 1, 1}, 3, {127, 128, 127});
    EXPECT_EQ(applied(SilhouetteEnhancement{0.0f, 1.0f, 1.0f, none}, sampleTurnedBy(1.0)).a, 0.0f);
    const TexturePointer tooFew = texture({1, 1, 1}, 2, {255, 127});
    EXPECT_TRUE(makeStyle(SilhouetteEnhancement{0.0f, 1.0f, 1.0f, tooFew})->needsNormal());
}

TEST(Style, clearSamplesStayClear)
{
    SampleBatch samples = sampleTurnedBy(1.0);
    samples.Ov[0] = 0.0f;
    for (const auto& style :
         {makeStyle(BoundaryEnhancement{}), makeStyle(Cartoon{}), makeStyle(EdgeEnhancement{}),
          makeStyle(SilhouetteEnhancement{1, 1, 1, {}}), makeStyle(ToneMapped{}), makeStyle(Shaded{})}) {
        EXPECT_TRUE(style->keepsClear());
        SampleBatch changed = samples;
        style->apply(lightFrom({0, 0, 1}), changed);
        EXPECT_EQ(changed.Ov[0], 0.0f);
    }
}

} // namespace
} // namespace vo
