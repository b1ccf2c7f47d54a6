#include "style/styled_voxels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vo {

namespace {

constexpr float kLeastGradient = 1e-6f;

} // namespace

bool hasWholeVoxels(const StyledVolume& volume)
{
    if (!volume.voxels) return false;
    const VoxelTexture& voxels = *volume.voxels;
    if (voxels.components < 1 || voxels.components > 4) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (voxels.size[axis] < 1 || !(volume.dimensions[axis] > 0.0f) ||
            !std::isfinite(volume.dimensions[axis]))
            return false;
    const std::uint64_t bytes = bytesOf(voxels.kind) * static_cast<std::uint64_t>(voxels.components);
    return voxels.size.count() <= voxels.texels.size() / bytes;
}

void findNormals(const VoxelTexture& voxels, const glm::vec3& dimensions, SampleBatch& batch)
{
    const glm::vec3 size(voxels.size.x, voxels.size.y, voxels.size.z);
    const glm::vec3 edges = dimensions / size;
    const float shortest = std::min({edges.x, edges.y, edges.z});
    batch.gradient.fill(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        std::array<std::array<BatchFloats, 4>, 2> texels{};
        for (std::size_t side = 0; side < 2; ++side) {
            BatchVectors place = batch.place;
            for (float& coordinate : place[a])
                coordinate += (side == 0 ? -1.0f : 1.0f) / size[axis];
            sampleTexture(voxels, batch.count, place, texels[side]);
        }
        const std::size_t used = voxels.components < 3 ? 1 : 3;
        const float scale = -0.5f * shortest / edges[axis] / static_cast<float>(used);
        for (std::size_t i = 0; i < kBatchSize; ++i) {
            float difference = 0.0f;
            for (std::size_t c = 0; c < used; ++c)
                difference += texels[1][c][i] - texels[0][c][i];
            batch.n[a][i] = difference * scale;
            batch.gradient[i] += batch.n[a][i] * batch.n[a][i];
        }
    }
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        const float length = std::sqrt(batch.gradient[i]);
        batch.gradient[i] = length;
        for (BatchFloats& component : batch.n)
            component[i] = length < kLeastGradient ? 0.0f : component[i] / length;
    }
}

} // namespace vo
