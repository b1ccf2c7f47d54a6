#pragma once

#include "appearance/convert_voxels.h"
#include "cast/ray_cast.h"
#include "support/compare.h"
#include "support/fields.h"
#include "support/reference.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// A scene of the reference as a request to the CPU engine: a volume in bricks, a box of five tetrahedra.
namespace cast_scene {

using vo::test::Field;
using vo::test::Scene;

struct Storage
{
    vo::VoxelFormat format{vo::Channels::intensity, vo::VoxelType::uint8};
    vo::TexelFormat texel = vo::TexelFormat::intensity;
    int split = 1;   ///< bricks along each axis
    int overlap = 1; ///< voxels
};

/// What a request borrows. Not to be copied.
struct RequestOfScene
{
    std::vector<std::vector<std::byte>> memory;
    std::vector<vo::CastBrick> bricks;
    std::vector<vo::Box> boxes;
    std::vector<float> records;
    std::vector<int> indices;
    vo::Table table;
    vo::CastRequest request;

    RequestOfScene(const Scene& scene, const Storage& storage)
    {
        table.rgba = scene.table;
        setBricks(*scene.volume, storage, scene);
        setGeometry(scene);
        request.model = glm::make_mat4(scene.view.model.data());
        request.projection = glm::make_mat4(scene.view.projection.data());
        request.width = scene.width;
        request.height = scene.height;
        request.tetras = {records, 3, indices};
        request.clipBoxes = boxes;
        request.bricks = bricks;
        setSampling(scene);
        if (scene.classification == vo::test::Classification::postInterpolation)
            request.shading.table = &table;
        request.shading.color = glm::vec4(glm::make_vec4(scene.color.data()));
        switch (scene.compositing) {
        case vo::test::Compositing::over: request.blending = vo::CastBlending::over; break;
        case vo::test::Compositing::premultiplied: request.blending = vo::CastBlending::premultiplied; break;
        case vo::test::Compositing::max: request.blending = vo::CastBlending::max; break;
        case vo::test::Compositing::min: request.blending = vo::CastBlending::min; break;
        case vo::test::Compositing::sum: request.blending = vo::CastBlending::sum; break;
        }
    }
    RequestOfScene(const RequestOfScene&) = delete;

private:
    void setSampling(const Scene& scene)
    {
        switch (scene.planes) {
        case vo::test::SamplingPlanes::viewportAligned: break;
        case vo::test::SamplingPlanes::axisAligned:
            request.sampling.mode = vo::SamplingMode::axisAligned;
            break;
        case vo::test::SamplingPlanes::spherical: request.sampling.mode = vo::SamplingMode::spherical; break;
        }
        request.sampling.period = scene.period;
        request.sampling.maxSamples = scene.maxSamples;
        request.sampling.stackAxis = scene.stackAxis;
    }

    void setBricks(const Field& field, const Storage& storage, const Scene& scene)
    {
        const glm::ivec3 volume(field.size.x, field.size.y, field.size.z);
        glm::ivec3 split(storage.split), overlap(storage.overlap);
        if (scene.stackAxis >= 0) {
            split[scene.stackAxis] = volume[scene.stackAxis];
            overlap[scene.stackAxis] = 0;
        }
        const auto start = [&](int i, int axis) { return i * (volume[axis] - overlap[axis]) / split[axis]; };
        for (int z = 0; z < split.z; ++z)
            for (int y = 0; y < split.y; ++y)
                for (int x = 0; x < split.x; ++x) {
                    const glm::ivec3 lower(start(x, 0), start(y, 1), start(z, 2));
                    const glm::ivec3 upper =
                        glm::ivec3(start(x + 1, 0), start(y + 1, 1), start(z + 1, 2)) + overlap;
                    addBrick(field, storage, scene, lower, upper, overlap);
                }
        for (std::size_t i = 0; i < bricks.size(); ++i)
            bricks[i].texels.voxels = memory[i];
    }

    void addBrick(const Field& field, const Storage& storage, const Scene& scene, const glm::ivec3& lower,
                  const glm::ivec3& upper, const glm::ivec3& overlap)
    {
        const glm::ivec3 size = upper - lower;
        std::vector<std::byte>& own = memory.emplace_back();
        std::vector<float> rgba;
        for (int z = lower.z; z < upper.z; ++z)
            for (int y = lower.y; y < upper.y; ++y)
                for (int x = lower.x; x < upper.x; ++x)
                    for (int c = 0; c < 4; ++c)
                        rgba.push_back(field.at(x, y, z,
                                                field.channels == 4   ? c
                                                : field.channels == 2 ? c / 3
                                                                      : 0));
        own.resize(rgba.size() / 4 * vo::voxelBytes(storage.format));
        encode(rgba, storage.format, own);
        vo::CastBrick brick;
        brick.id = memory.size();
        brick.version = 1;
        brick.texels.size = {size.x, size.y, size.z};
        brick.texels.format = storage.format;
        brick.texels.texel = storage.texel;
        if (scene.classification == vo::test::Classification::preInterpolation) {
            brick.texels.classified = &table;
            brick.tableSerial = 1;
        }
        brick.origin = lower;
        brick.size = size;
        brick.thinAxis = scene.stackAxis;
        bricks.push_back(brick);
        boxes.push_back(
            {glm::dvec3(lower) + 0.5 * glm::dvec3(overlap), glm::dvec3(upper) - 0.5 * glm::dvec3(overlap)});
    }

    static void encode(const std::vector<float>& rgba, vo::VoxelFormat format,
                       std::vector<std::byte>& voxels);

    void setGeometry(const Scene& scene)
    {
        if (!scene.geometry.empty()) {
            for (const vo::test::Tetrahedron& tetra : scene.geometry)
                for (const glm::dvec3& corner : tetra) {
                    indices.push_back(static_cast<int>(records.size() / 3));
                    for (int axis = 0; axis < 3; ++axis)
                        records.push_back(static_cast<float>(corner[axis]));
                }
            return;
        }
        const std::array<int, 3> size{scene.volume->size.x, scene.volume->size.y, scene.volume->size.z};
        for (unsigned corner = 0; corner < 8; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis)
                records.push_back(corner >> axis & 1u ? static_cast<float>(size[axis]) : 0.0f);
        indices = {0, 3, 5, 6, 1, 0, 3, 5, 2, 0, 6, 3, 4, 0, 5, 6, 7, 3, 6, 5};
    }
};

inline void RequestOfScene::encode(const std::vector<float>& rgba, vo::VoxelFormat format,
                                   std::vector<std::byte>& voxels)
{
    vo::encodeVoxels(rgba.data(), rgba.size() / 4, format, voxels);
}

/// The whole viewport over a background, four floats a pixel: what a float target would hold, had it been
/// filled with the background before.
inline std::vector<float> blended(const vo::CastPicture& picture, const Scene& scene)
{
    const auto pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
    std::vector<float> target(4 * pixels, 0.0f);
    for (std::size_t i = 0; i < 4 * pixels; ++i)
        if (i % 4 < 3) target[i] = static_cast<float>(scene.background[i % 4]);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float* from = picture.rgbt.data() +
                                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                     static_cast<std::size_t>(x));
            float* to = target.data() +
                        4 * (static_cast<std::size_t>(y + picture.y) * static_cast<std::size_t>(scene.width) +
                             static_cast<std::size_t>(x + picture.x));
            for (std::size_t c = 0; c < 3; ++c)
                switch (scene.compositing) {
                case vo::test::Compositing::over:
                case vo::test::Compositing::premultiplied: to[c] = from[c] + from[3] * to[c]; break;
                case vo::test::Compositing::max: to[c] = std::max(from[c], to[c]); break;
                case vo::test::Compositing::min: to[c] = std::min(from[c], to[c]); break;
                case vo::test::Compositing::sum: to[c] += from[c]; break;
                }
        }
    return target;
}

} // namespace cast_scene
