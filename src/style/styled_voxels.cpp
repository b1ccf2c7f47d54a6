#include "style/styled_voxels.h"

#include "core/invertible.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace vo {

namespace {

constexpr float kLeastGradient = 1e-6f;

bool isPositive(double number)
{
    return number > 0.0 && std::isfinite(number);
}

bool isSound(const Segments& segments)
{
    const auto& texture = segments.identifiers;
    return texture && isUsable(*texture) && segments.component >= 0 &&
           segments.component < texture->components;
}

std::size_t nearestTexel(float place, int size, bool repeats)
{
    if (repeats) place -= std::floor(place);
    const float inside = std::min(std::max(0.0f, place), 1.0f) * static_cast<float>(size);
    return static_cast<std::size_t>(std::min(static_cast<int>(inside), size - 1));
}

} // namespace

bool isSound(const StyledVolume& volume)
{
    if (!volume.voxels || !isUsable(*volume.voxels) || volume.chains.empty()) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (!isPositive(static_cast<double>(volume.dimensions[axis]))) return false;
    if (volume.segments && !isSound(*volume.segments)) return false;
    if (volume.surfaces && volume.surfaces->chains.empty()) return false;
    return isPositive(volume.unitLength) && isPositive(volume.spacing) && isInvertible(volume.worldFromLocal);
}

bool isSound(const StyledSurface& surface)
{
    const std::size_t count = surface.positions.size();
    const auto isWhole = [count](const auto& list) { return list.empty() || list.size() == count; };
    return isInvertible(surface.worldFromLocal) && isWhole(surface.normals) && isWhole(surface.colors) &&
           std::ranges::all_of(surface.triangles, [count](int corner) {
               return corner >= 0 && static_cast<std::size_t>(corner) < count;
           });
}

namespace {

/// A segment's number, from the component of this index; the greatest where it is none that can be listed.
std::size_t segmentAt(const Segments& segments, std::size_t index)
{
    const VoxelTexture& texture = *segments.identifiers;
    // Every voxel is asked for its number: whole ones need no rounding.
    if (texture.kind == TexelKind::uint8 && segments.scale == 255.0f)
        return std::to_integer<std::size_t>(texture.texels[index]);
    if (texture.kind == TexelKind::uint16 && segments.scale == 65535.0f) {
        std::uint16_t whole = 0;
        std::memcpy(&whole, texture.texels.data() + index * sizeof whole, sizeof whole);
        return whole;
    }
    const float id = std::round(numberAt(texture, index) * segments.scale);
    const bool isListed = id >= 0.0f && id < static_cast<float>(segments.chainOf.size());
    return isListed ? static_cast<std::size_t>(id) : std::numeric_limits<std::size_t>::max();
}

} // namespace

int chainOfTexel(const Segments& segments, std::size_t texel, int chains)
{
    const auto components = static_cast<std::size_t>(segments.identifiers->components);
    const std::size_t id =
        segmentAt(segments, texel * components + static_cast<std::size_t>(segments.component));
    const int chain = id < segments.chainOf.size() ? segments.chainOf[id] : segments.beyond;
    return chain < chains ? chain : -1;
}

int chainAt(const StyledVolume& volume, const glm::vec3& place)
{
    if (!volume.segments) return 0;
    const Segments& segments = *volume.segments;
    const VoxelTexture& texture = *segments.identifiers;
    std::size_t texel = 0;
    for (const int axis : {2, 1, 0})
        texel =
            texel * static_cast<std::size_t>(texture.size[axis]) +
            nearestTexel(place[axis], texture.size[axis], texture.repeats[static_cast<std::size_t>(axis)]);
    return chainOfTexel(segments, texel, static_cast<int>(volume.chains.size()));
}

void findChanges(const VoxelTexture& voxels, SampleBatch& batch)
{
    const glm::vec3 size(voxels.size.x, voxels.size.y, voxels.size.z);
    const std::size_t used = voxels.components < 3 ? 1 : 3;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        std::array<std::array<BatchFloats, 4>, 2> texels{};
        for (std::size_t side = 0; side < 2; ++side) {
            BatchVectors place = batch.place;
            for (float& coordinate : place[a])
                coordinate += (side == 0 ? -1.0f : 1.0f) / size[axis];
            sampleTexture(voxels, batch.count, place, texels[side]);
        }
        for (std::size_t i = 0; i < kBatchSize; ++i) {
            float difference = 0.0f;
            for (std::size_t c = 0; c < used; ++c)
                difference += texels[1][c][i] - texels[0][c][i];
            batch.n[a][i] = 0.5f * difference / static_cast<float>(used);
        }
    }
}

void normalsFromChanges(SampleBatch& batch)
{
    auto& [x, y, z] = batch.n;
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        const float length = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        batch.gradient[i] = length;
        for (BatchFloats& component : batch.n)
            component[i] = length < kLeastGradient ? 0.0f : -component[i] / length;
    }
}

void findNormals(const VoxelTexture& voxels, const glm::vec3& dimensions, SampleBatch& batch)
{
    findChanges(voxels, batch);
    const glm::vec3 edges = dimensions / glm::vec3(voxels.size.x, voxels.size.y, voxels.size.z);
    const float shortest = std::min({edges.x, edges.y, edges.z});
    for (int axis = 0; axis < 3; ++axis)
        for (float& change : batch.n[static_cast<std::size_t>(axis)])
            change *= shortest / edges[axis];
    normalsFromChanges(batch);
}

} // namespace vo
