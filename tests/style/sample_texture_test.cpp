// Texels of textures against double precision, by each instruction set.

#include "style/style.h"
#include "style/styled_voxels.h"
#include "support/each_target.h"
#include "support/reference_styles.h"
#include "support/sample_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace {

using vo::test::forTargets;
using vo::test::somePlaces;

template <class T>
void fillTexels(vo::VoxelTexture& texture, double full)
{
    texture.texels.resize(
        static_cast<std::size_t>(texture.size.x) * static_cast<std::size_t>(texture.size.y) *
        static_cast<std::size_t>(texture.size.z) * static_cast<std::size_t>(texture.components) * sizeof(T));
    for (std::size_t i = 0; i < texture.texels.size() / sizeof(T); ++i) {
        const auto number = static_cast<T>(full * std::fmod(0.31 + 0.618034 * static_cast<double>(i), 1.0));
        std::memcpy(texture.texels.data() + i * sizeof(T), &number, sizeof(T));
    }
}

vo::VoxelTexture textureOf(const vo::VoxelSize& size, int components, vo::TexelKind kind)
{
    vo::VoxelTexture texture;
    texture.size = size;
    texture.components = components;
    texture.kind = kind;
    switch (kind) {
    case vo::TexelKind::uint8: fillTexels<std::uint8_t>(texture, 255.9); break;
    case vo::TexelKind::uint16: fillTexels<std::uint16_t>(texture, 65535.9); break;
    case vo::TexelKind::float32: fillTexels<float>(texture, 1.0); break;
    }
    return texture;
}

void expectTexels(const vo::VoxelTexture& texture)
{
    const vo::BatchVectors place = somePlaces();
    for (const int count : {vo::kBatchSize, 5}) {
        std::array<vo::BatchFloats, 4> texels{};
        sampleTexture(texture, count, place, texels);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const glm::dvec4 expected =
                vo::test::referenceTexel(texture, {place[0][i], place[1][i], place[2][i]});
            for (std::size_t c = 0; c < static_cast<std::size_t>(texture.components); ++c)
                ASSERT_NEAR(texels[c][i], expected[static_cast<int>(c)], 1e-5) << i << ", component " << c;
        }
    }
}

TEST(SampleTexture, texelsAreThoseOfDoublePrecision)
{
    using Kind = vo::TexelKind;
    // The smaller ones have fewer bytes than are read at once, or just as many.
    for (const vo::VoxelSize& size : {vo::VoxelSize{7, 6, 5}, {5, 1, 1}, {2, 1, 1}, {1, 1, 1}})
        for (const Kind kind : {Kind::uint8, Kind::uint16, Kind::float32})
            for (const int components : {1, 2, 3, 4}) {
                vo::VoxelTexture texture = textureOf(size, components, kind);
                SCOPED_TRACE(std::to_string(size.x) + " wide, " + std::to_string(components) + " of " +
                             std::to_string(bytesOf(kind)) + " bytes");
                forTargets([&] { expectTexels(texture); });
                texture.repeats = {true, false, true};
                forTargets([&] { expectTexels(texture); });
                texture.nearest = true;
                forTargets([&] { expectTexels(texture); });
                texture.repeats = {};
                forTargets([&] { expectTexels(texture); });
            }
}

TEST(SampleTexture, componentsThatItLacksStay)
{
    const vo::VoxelTexture texture = textureOf({3, 3, 3}, 2, vo::TexelKind::uint8);
    forTargets([&] {
        std::array<vo::BatchFloats, 4> texels{};
        texels[2].fill(7.0f);
        sampleTexture(texture, vo::kBatchSize, somePlaces(), texels);
        EXPECT_EQ(texels[2][0], 7.0f);
    });
}

TEST(SampleTexture, placesThatAreNoNumbersAreAtTheEdge)
{
    const vo::VoxelTexture texture = textureOf({4, 4, 4}, 1, vo::TexelKind::uint8);
    vo::BatchVectors place{};
    place[0].fill(std::numeric_limits<float>::quiet_NaN());
    place[1].fill(std::numeric_limits<float>::infinity());
    place[2].fill(-std::numeric_limits<float>::infinity());
    const double expected = vo::test::referenceTexel(texture, {-1.0, 2.0, -1.0}).x;
    forTargets([&] {
        std::array<vo::BatchFloats, 4> texels{};
        sampleTexture(texture, vo::kBatchSize, place, texels);
        for (const float texel : texels[0])
            ASSERT_NEAR(texel, expected, 1e-6);
    });
}

/// Identifiers in the second of two components; `full` is what 1 stands for.
template <class T>
vo::Segments segmentsOf(vo::TexelKind kind, float full, const std::vector<T>& numbers)
{
    auto texture = std::make_shared<vo::VoxelTexture>();
    texture->size = {static_cast<int>(numbers.size()), 1, 1};
    texture->components = 2;
    texture->kind = kind;
    texture->texels.resize(2 * numbers.size() * sizeof(T));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        std::memcpy(texture->texels.data() + (2 * i + 1) * sizeof(T), &numbers[i], sizeof(T));
    return {texture, 1, full, {}, 3};
}

/// Of number i there is chain i % 5, as long as numbers are listed.
template <class T>
void expectChains(vo::Segments segments, const std::vector<T>& numbers, std::size_t listed)
{
    for (std::size_t i = 0; i < listed; ++i)
        segments.chainOf.push_back(static_cast<int>(i % 5));
    for (std::size_t texel = 0; texel < numbers.size(); ++texel) {
        const auto number = std::round(static_cast<double>(numbers[texel]));
        const bool isListed = number >= 0.0 && number < static_cast<double>(listed);
        const int chain = isListed ? static_cast<int>(std::fmod(number, 5.0)) : 3;
        ASSERT_EQ(chainOfTexel(segments, texel, 4), chain < 4 ? chain : -1) << number;
    }
}

TEST(Segments, everyNumberHasItsChain)
{
    std::vector<std::uint8_t> bytes(256);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    for (const std::size_t listed : {0u, 100u, 256u, 300u})
        expectChains(segmentsOf(vo::TexelKind::uint8, 255.0f, bytes), bytes, listed);
    std::vector<std::uint16_t> words(65536);
    std::iota(words.begin(), words.end(), std::uint16_t{0});
    for (const std::size_t listed : {4097u, 65536u})
        expectChains(segmentsOf(vo::TexelKind::uint16, 65535.0f, words), words, listed);
    const std::vector<float> floats{0.0f, 1.4f, 1.6f, 98.0f, 99.0f, -3.0f, 1e9f, std::nanf("")};
    expectChains(segmentsOf(vo::TexelKind::float32, 1.0f, floats), floats, 99);
}

} // namespace
