// Values and gradients of voxels against double precision, by each instruction set.

#include "cast/padded_voxels.h"
#include "style/styles.h"
#include "styled_scenes.h"
#include "support/each_target.h"
#include "support/sample_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace {

using namespace styled_scenes;
using vo::test::forTargets;
using vo::test::somePlaces;

float bumps(const glm::vec3& p, int)
{
    return 0.5f + 0.3f * std::sin(7.0f * p.x) * std::cos(6.0f * p.y) +
           0.2f * std::sin(8.0f * p.z + 2.0f * p.x);
}

std::shared_ptr<vo::VoxelTexture> shortsOf(const vo::VoxelTexture& floats)
{
    auto texture = std::make_shared<vo::VoxelTexture>(floats);
    texture->kind = vo::TexelKind::uint16;
    texture->texels.resize(floats.texels.size() / 2);
    for (std::size_t i = 0; i < floats.texels.size() / sizeof(float); ++i) {
        float number;
        std::memcpy(&number, floats.texels.data() + i * sizeof number, sizeof number);
        const auto whole = static_cast<std::uint16_t>(std::lround(number * 65535.0f));
        std::memcpy(texture->texels.data() + i * sizeof whole, &whole, sizeof whole);
    }
    return texture;
}

double voxelAt(const vo::VoxelTexture& texture, std::array<int, 3> voxel)
{
    std::size_t index = 0;
    for (const int axis : {2, 1, 0}) {
        const auto a = static_cast<std::size_t>(axis);
        const int size = texture.size[axis];
        const int at =
            texture.repeats[a] ? (voxel[a] % size + size) % size : std::clamp(voxel[a], 0, size - 1);
        index = index * static_cast<std::size_t>(size) + static_cast<std::size_t>(at);
    }
    const std::byte* const from = texture.texels.data() + index * bytesOf(texture.kind);
    std::uint16_t whole = 0;
    float number = 0.0f;
    switch (texture.kind) {
    case vo::TexelKind::uint8: return static_cast<double>(*from) / 255.0;
    case vo::TexelKind::uint16: std::memcpy(&whole, from, sizeof whole); return whole / 65535.0;
    case vo::TexelKind::float32: break;
    }
    std::memcpy(&number, from, sizeof number);
    return static_cast<double>(number);
}

/// The value at a place, seen from `moved` voxels away.
double valueAt(const vo::VoxelTexture& texture, const glm::dvec3& place, const std::array<int, 3>& moved)
{
    std::array<int, 3> first{};
    std::array<double, 3> weight{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(axis);
        double p = place[a];
        if (texture.repeats[axis]) p -= std::floor(p);
        p = std::min(std::max(0.0, p), 1.0) * texture.size[a];
        p = texture.nearest ? std::min(std::floor(p), texture.size[a] - 1.0) : p - 0.5;
        first[axis] = static_cast<int>(std::floor(p));
        weight[axis] = p - first[axis];
    }
    double sum = 0.0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        std::array<int, 3> voxel = first;
        double part = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool farther = corner >> axis & 1u;
            voxel[axis] += moved[axis] + (farther ? 1 : 0);
            part *= farther ? weight[axis] : 1.0 - weight[axis];
        }
        sum += part * voxelAt(texture, voxel);
    }
    return sum;
}

void expectValues(const vo::VoxelTexture& texture, const vo::PaddedGrid& grid)
{
    const vo::BatchVectors place = somePlaces();
    for (const int count : {vo::kBatchSize, 5}) {
        vo::BatchFloats value{};
        vo::BatchVectors change{};
        sampleValues(grid, count, place, value);
        sampleChanges(grid, count, place, change);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const glm::dvec3 at(place[0][i], place[1][i], place[2][i]);
            ASSERT_NEAR(value[i], valueAt(texture, at, {}), 1e-5) << i;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                std::array<int, 3> before{}, after{};
                before[axis] = -1;
                after[axis] = 1;
                ASSERT_NEAR(change[axis][i],
                            (valueAt(texture, at, after) - valueAt(texture, at, before)) / 2.0, 1e-5)
                    << i << ", axis " << axis;
            }
        }
    }
}

TEST(PaddedVoxels, valuesAndChangesAreThoseOfDoublePrecision)
{
    const vo::VoxelSize size{9, 7, 6};
    const auto floats = textureOf(size, 1, bumps);
    for (const auto& plain : {bytesOf(size, 1, bumps), shortsOf(*floats), floats})
        for (const bool nearest : {false, true})
            for (const bool repeats : {false, true}) {
                vo::VoxelTexture texture = *plain;
                texture.nearest = nearest;
                texture.repeats = {repeats, false, repeats};
                const vo::PaddedVoxels voxels(texture, 1);
                SCOPED_TRACE(std::to_string(bytesOf(texture.kind)) + " bytes, nearest " +
                             std::to_string(nearest) + ", repeats " + std::to_string(repeats));
                forTargets([&] { expectValues(texture, voxels.grid()); });
            }
}

// Volumes of more than 2 GiB are read in another way.
TEST(PaddedVoxels, farOffsetsReadTheSame)
{
    const vo::VoxelSize size{9, 7, 6};
    const auto floats = textureOf(size, 1, bumps);
    for (const auto& texture : {bytesOf(size, 1, bumps), shortsOf(*floats), floats}) {
        const vo::PaddedVoxels voxels(*texture, 1);
        EXPECT_FALSE(voxels.grid().far);
        vo::PaddedGrid grid = voxels.grid();
        grid.far = true;
        forTargets([&] { expectValues(*texture, grid); });
    }
}

TEST(PaddedVoxels, placesThatAreNoNumbersAreAtTheEdge)
{
    const auto texture = bytesOf({4, 4, 4}, 1, bumps);
    const vo::PaddedVoxels voxels(*texture, 1);
    vo::BatchVectors place{};
    place[0].fill(std::numeric_limits<float>::quiet_NaN());
    place[1].fill(std::numeric_limits<float>::infinity());
    place[2].fill(-std::numeric_limits<float>::infinity());
    forTargets([&] {
        vo::BatchFloats value{};
        voxels.values(vo::kBatchSize, place, value);
        for (const float number : value)
            ASSERT_NEAR(number, voxelAt(*texture, {0, 3, 0}), 1e-6);
    });
}

TEST(PaddedVoxels, pictureIsTheSameForEachInstructionSet)
{
    vo::Shaded shaded;
    shaded.lighting = true;
    vo::StyledScene scene = perspectiveScene();
    vo::StyledVolume volume = boxOf(bytesOf({16, 12, 10}, 1, bumps));
    volume.chains = {{makeStyle(shaded)}};
    volume.surroundings.lights.emplace_back();
    scene.volumes.push_back(volume);
    const vo::ScenePicture first = castOf(scene);
    EXPECT_GT(*std::max_element(first.rgba.begin(), first.rgba.end()), 0.2f);
    forTargets([&] {
        const vo::ScenePicture picture = castOf(scene);
        for (std::size_t i = 0; i < first.rgba.size(); ++i)
            ASSERT_NEAR(picture.rgba[i], first.rgba[i], 1e-4f) << i;
    });
}

} // namespace
