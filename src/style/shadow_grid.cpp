#include "style/shadow_grid.h"

#include "core/parallel.h"
#include "style/styled_voxels.h"
#include "style/surface_normals.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// In longest edges of texels.
constexpr float kOffset = 1.5f;
/// Light ends where less than this comes through.
constexpr float kLeastThrough = 1e-3f;
/// No texel is darker: beside a clear one it would be thicker than it is.
const float kMostDepth = -std::log(kLeastThrough);

VoxelSize gridSize(const glm::vec3& dimensions)
{
    const float longest = std::max({dimensions.x, dimensions.y, dimensions.z});
    const auto texels = [&](float side) {
        return std::clamp(static_cast<int>(std::ceil(kShadowTexels * (side / longest))), 1, kShadowTexels);
    };
    return {texels(dimensions.x), texels(dimensions.y), texels(dimensions.z)};
}

glm::vec3 gridEdges(const glm::vec3& dimensions)
{
    const VoxelSize size = gridSize(dimensions);
    return dimensions / glm::vec3(size.x, size.y, size.z);
}

float longestEdge(const glm::vec3& edges)
{
    return std::max({edges.x, edges.y, edges.z});
}

// From voxels to what stands in the way

bool needNormals(const StyleChain& chain)
{
    return std::ranges::any_of(chain, [](const auto& style) { return style->needsPosition(); });
}

void findPositions(const StyledVolume& volume, SampleBatch& batch)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        for (std::size_t i = 0; i < kBatchSize; ++i)
            batch.position[a][i] = (batch.place[a][i] - 0.5f) * volume.dimensions[axis];
    }
}

/// Sets what chains read of the samples that have a place.
void fillSamples(const StyledVolume& volume, bool withNormals, SampleBatch& batch)
{
    sampleTexture(*volume.voxels, batch.count, batch.place, batch.voxel);
    findPositions(volume, batch);
    if (withNormals) findNormals(*volume.voxels, volume.dimensions, batch);
    batch.V = batch.n;
    for (std::size_t i = 0; i < kBatchSize; ++i)
        if (isNone(batch.n, i)) batch.V[2][i] = 1.0f;
}

void applyChain(const StyledVolume& volume, const StyleChain& chain, SampleBatch& batch)
{
    firstColor(volume.voxels->components, batch);
    for (const auto& style : chain)
        style->apply({}, batch);
}

/// Rows of the grid, opacities or values.
class GridFiller
{
public:
    GridFiller(const StyledVolume& volume, ShadowGrid& grid) : volume_(volume), grid_(grid)
    {
        for (const glm::dvec4& plane : volume.clipPlanes)
            clipPlanes_.push_back(plane * volume.worldFromLocal);
        needsNormals_ = std::ranges::any_of(volume.chains, needNormals);
    }

    void fillRow(int y, int z) const
    {
        const VoxelSize& size = grid_.size;
        const std::size_t row =
            (static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(y)) *
            static_cast<std::size_t>(size.x);
        SampleBatch batch{};
        for (int first = 0; first < size.x; first += kBatchSize) {
            batch.count = std::min(kBatchSize, size.x - first);
            for (std::size_t i = 0; i < kBatchSize; ++i) {
                batch.place[0][i] =
                    (static_cast<float>(first) + static_cast<float>(i) + 0.5f) / static_cast<float>(size.x);
                batch.place[1][i] = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.y);
                batch.place[2][i] = (static_cast<float>(z) + 0.5f) / static_cast<float>(size.z);
            }
            float* const to = grid_.texels.data() + row + static_cast<std::size_t>(first);
            if (grid_.hasSurfaces)
                writeValues(batch, to);
            else
                writeDepths(batch, to);
        }
    }

private:
    void writeValues(SampleBatch& batch, float* to) const
    {
        sampleTexture(*volume_.voxels, batch.count, batch.place, batch.voxel);
        findPositions(volume_, batch);
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
            to[i] = isClipped(batch, i) ? std::numeric_limits<float>::quiet_NaN() : batch.voxel[0][i];
    }

    void writeDepths(SampleBatch& batch, float* to) const
    {
        fillSamples(volume_, needsNormals_, batch);
        BatchFloats opacity{};
        if (volume_.segments)
            findOpacityOfSegments(batch, opacity);
        else {
            applyChain(volume_, volume_.chains[0], batch);
            opacity = batch.Ov;
        }
        const auto unit = static_cast<float>(volume_.unitLength);
        const float most = kMostDepth / std::max(unit, longestEdge(grid_.edges));
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
            const float clear = 1.0f - std::clamp(opacity[i], 0.0f, 1.0f);
            const bool isSeen = opacity[i] > 0.0f && !isClipped(batch, i);
            to[i] = isSeen ? std::min(-std::log(clear) / unit, most) : 0.0f;
        }
    }

    void findOpacityOfSegments(const SampleBatch& batch, BatchFloats& opacity) const
    {
        std::array<int, kBatchSize> chainOf{};
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
            chainOf[i] = chainAt(volume_, {batch.place[0][i], batch.place[1][i], batch.place[2][i]});
        const auto count = static_cast<std::ptrdiff_t>(batch.count);
        for (int number = 0; number < static_cast<int>(volume_.chains.size()); ++number) {
            if (std::find(chainOf.begin(), chainOf.begin() + count, number) == chainOf.begin() + count)
                continue;
            SampleBatch styled = batch;
            applyChain(volume_, volume_.chains[static_cast<std::size_t>(number)], styled);
            for (std::size_t i = 0; i < kBatchSize; ++i)
                if (chainOf[i] == number) opacity[i] = styled.Ov[i];
        }
    }

    bool isClipped(const SampleBatch& batch, std::size_t i) const
    {
        const glm::dvec4 position(batch.position[0][i], batch.position[1][i], batch.position[2][i], 1.0);
        return std::ranges::any_of(clipPlanes_,
                                   [&](const glm::dvec4& plane) { return glm::dot(plane, position) < 0.0; });
    }

    const StyledVolume& volume_;
    ShadowGrid& grid_;
    std::vector<glm::dvec4> clipPlanes_; ///< local
    bool needsNormals_ = false;
};

/// What comes through each surface, seen along its normal.
std::vector<ShadowGrid::Surface> surfacesOf(const StyledVolume& volume)
{
    const IsoSurfaces& surfaces = *volume.surfaces;
    std::vector<ShadowGrid::Surface> all;
    for (std::size_t i = 0; i < surfaces.values.size(); ++i) {
        SampleBatch batch{};
        batch.count = 1;
        for (BatchFloats& component : batch.voxel)
            component.fill(surfaces.values[i]);
        for (BatchFloats& coordinate : batch.place)
            coordinate.fill(0.5f);
        batch.n[2].fill(1.0f);
        batch.V[2].fill(1.0f);
        batch.gradient.fill(1.0f);
        applyChain(volume, surfaces.chains[std::min(i, surfaces.chains.size() - 1)], batch);
        all.push_back({surfaces.values[i], 1.0f - std::clamp(batch.Ov[0], 0.0f, 1.0f)});
    }
    return all;
}

// From a texel to the light

/// Steps from the centre of a texel, each to the next plane of texels along one axis.
struct LightSteps
{
    std::size_t axis = 0, across = 1, up = 2;
    long sign = 1;
    std::array<float, 3> step{}; ///< in texels
    float length = 0.0f;         ///< local, of a step
    float first = 0.0f;          ///< where shadows begin, in steps
    float last = 0.0f;           ///< where the box ends, or the light stands
};

class LightWalk
{
public:
    LightWalk(const ShadowGrid& grid, const StyleLight& light)
        : grid_(grid), light_(light), offset_(kOffset * longestEdge(grid.edges)),
          size_{grid.size.x, grid.size.y, grid.size.z}, stride_{1, size_[0], size_[0] * size_[1]}
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            next_[axis] = size_[axis] > 1 ? stride_[axis] : 0;
            highest_[axis] = std::nextafter(static_cast<float>(size_[axis] - 1), 0.0f);
        }
    }

    float throughTo(const std::array<long, 3>& texel) const
    {
        const LightSteps steps = stepsFrom(texel);
        if (!(steps.last > steps.first)) return 1.0f;
        return grid_.hasSurfaces ? throughSurfaces(texel, steps) : throughSamples(texel, steps);
    }

private:
    LightSteps stepsFrom(const std::array<long, 3>& texel) const
    {
        glm::vec3 way = -light_.direction;
        if (light_.kind != StyleLight::Kind::directional)
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                const float middle = 0.5f * static_cast<float>(size_[a]);
                const float position = (static_cast<float>(texel[a]) + 0.5f - middle) * grid_.edges[axis];
                way[axis] = light_.position[axis] - position;
            }
        const glm::vec3 inTexels = way / grid_.edges;
        const glm::vec3 sizes = glm::abs(inTexels);
        LightSteps steps;
        steps.axis = sizes.x >= sizes.y && sizes.x >= sizes.z ? 0 : sizes.y >= sizes.z ? 1 : 2;
        const float most = sizes[static_cast<int>(steps.axis)];
        if (!(most > 0.0f) || !std::isfinite(glm::length(way))) return steps;
        steps.across = steps.axis == 0 ? 1 : 0;
        steps.up = steps.axis == 2 ? 1 : 2;
        steps.sign = inTexels[static_cast<int>(steps.axis)] > 0.0f ? 1 : -1;
        steps.length = glm::length(way) / most;
        steps.first = offset_ / steps.length;
        steps.last =
            light_.kind == StyleLight::Kind::directional ? std::numeric_limits<float>::infinity() : most;
        for (std::size_t a = 0; a < 3; ++a) {
            const float step = inTexels[static_cast<int>(a)] / most;
            const float room = step > 0.0f ? static_cast<float>(size_[a] - texel[a]) - 0.5f
                                           : static_cast<float>(texel[a]) + 0.5f;
            steps.step[a] = step;
            if (step != 0.0f) steps.last = std::min(steps.last, room / std::abs(step));
        }
        return steps;
    }

    /// Where a coordinate lies: the first neighbour's offset, and the second's weight.
    struct Between
    {
        long offset;
        float weight;
    };

    Between betweenAt(std::size_t axis, float coordinate) const
    {
        const float inside = std::max(std::min(coordinate, highest_[axis]), 0.0f);
        const auto low = static_cast<int>(inside);
        return {low * stride_[axis], inside - static_cast<float>(low)};
    }

    /// The grid `number` steps away: linear between four texels of a plane.
    float gridAt(const std::array<long, 3>& texel, const LightSteps& steps, long number) const
    {
        const auto coordinate = [&](std::size_t axis) {
            return static_cast<float>(texel[axis]) + steps.step[axis] * static_cast<float>(number);
        };
        const long plane = std::clamp(texel[steps.axis] + steps.sign * number, 0L, size_[steps.axis] - 1);
        const Between u = betweenAt(steps.across, coordinate(steps.across));
        const Between v = betweenAt(steps.up, coordinate(steps.up));
        const long right = next_[steps.across], above = next_[steps.up];
        const float* const at = grid_.texels.data() + plane * stride_[steps.axis] + u.offset + v.offset;
        const float low = at[0] + (at[right] - at[0]) * u.weight;
        const float high = at[above] + (at[above + right] - at[above]) * u.weight;
        return low + (high - low) * v.weight;
    }

    /// A sample counts for the part of the way to the middles between it and its neighbours.
    float throughSamples(const std::array<long, 3>& texel, const LightSteps& steps) const
    {
        const float most = kMostDepth / steps.length;
        float sum = 0.0f;
        const auto begin = static_cast<long>(std::ceil(steps.first - 0.5f));
        for (long number = begin; static_cast<float>(number) - 0.5f < steps.last && sum < most; ++number) {
            const auto middle = static_cast<float>(number);
            const float part = std::min(middle + 0.5f, steps.last) - std::max(middle - 0.5f, steps.first);
            sum += std::max(part, 0.0f) * gridAt(texel, steps, number);
        }
        return std::exp(-sum * steps.length);
    }

    float throughSurfaces(const std::array<long, 3>& texel, const LightSteps& steps) const
    {
        float through = 1.0f;
        auto number = static_cast<long>(std::ceil(steps.first));
        float before = gridAt(texel, steps, number);
        for (++number; static_cast<float>(number) <= steps.last && through >= kLeastThrough; ++number) {
            const float here = gridAt(texel, steps, number);
            for (const ShadowGrid::Surface& surface : grid_.surfaces)
                if ((before < surface.value && here >= surface.value) ||
                    (before >= surface.value && here < surface.value))
                    through *= surface.through;
            before = here;
        }
        return through;
    }

    const ShadowGrid& grid_;
    const StyleLight& light_;
    float offset_;
    std::array<long, 3> size_, stride_, next_{};
    std::array<float, 3> highest_{}; ///< coordinates that have a neighbour above
};

} // namespace

float shadowOffset(const glm::vec3& dimensions)
{
    return kOffset * longestEdge(gridEdges(dimensions));
}

ShadowGrid shadowGridOf(const StyledVolume& volume, int threads)
{
    ShadowGrid grid;
    grid.size = gridSize(volume.dimensions);
    grid.edges = gridEdges(volume.dimensions);
    grid.texels.resize(grid.size.count());
    grid.hasSurfaces = volume.surfaces.has_value();
    if (grid.hasSurfaces) grid.surfaces = surfacesOf(volume);
    const GridFiller filler(volume, grid);
    parallelFor(static_cast<std::size_t>(grid.size.z), threads, [&](std::size_t z) {
        for (int y = 0; y < grid.size.y; ++y)
            filler.fillRow(y, static_cast<int>(z));
    });
    return grid;
}

std::vector<std::uint16_t> lightThrough(const ShadowGrid& grid, const StyleLight& light, int threads)
{
    std::vector<std::uint16_t> through(grid.size.count());
    const LightWalk walk(grid, light);
    parallelFor(static_cast<std::size_t>(grid.size.z), threads, [&](std::size_t z) {
        std::size_t to = z * static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y);
        for (long y = 0; y < grid.size.y; ++y)
            for (long x = 0; x < grid.size.x; ++x)
                through[to++] = static_cast<std::uint16_t>(
                    std::lround(65535.0f * walk.throughTo({x, y, static_cast<long>(z)})));
    });
    return through;
}

} // namespace vo
