#include "style/shadow_grid.h"

#include "core/parallel.h"
#include "style/styled_voxels.h"
#include "style/surface_normals.h"
#include "style/tetra_corners.h"
#include "style/tetra_slice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// In longest edges of texels, or lengths of voxels. Of a face whose opacity rises over a voxel, samples a
/// voxel apart towards a light head-on lose less than 3/255 of it; with 1, up to 22/255.
constexpr float kOffset = 1.5f;

VoxelSize gridSize(const glm::vec3& sides)
{
    const float longest = std::max({sides.x, sides.y, sides.z});
    const auto texels = [&](float side) {
        return std::clamp(static_cast<int>(std::ceil(kShadowTexels * (side / longest))), 1, kShadowTexels);
    };
    return {texels(sides.x), texels(sides.y), texels(sides.z)};
}

glm::vec3 gridEdges(const glm::vec3& sides)
{
    const VoxelSize size = gridSize(sides);
    return sides / glm::vec3(size.x, size.y, size.z);
}

float longestEdge(const glm::vec3& edges)
{
    return std::max({edges.x, edges.y, edges.z});
}

/// The length, along a unit vector, of a way that is one cell long where cells are cubes of edge 1.
float edgeAlong(const glm::vec3& way, const glm::vec3& edges)
{
    return 1.0f / glm::length(way / edges);
}

// From voxels to what stands in the way

bool needNormals(const StyleChain& chain)
{
    return std::ranges::any_of(chain, [](const auto& style) { return style->needsPosition(); });
}

/// Texels of a row, as samples, and the tetrahedra that they lie in.
struct RowBatch
{
    SampleBatch samples{};
    std::array<int, kBatchSize> tetras{}; ///< below 0: in none. Of volumes without, 0
};

void lookAlongNormals(SampleBatch& batch)
{
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

/// Slices of the grid, opacities or values.
class GridFiller
{
public:
    GridFiller(const StyledVolume& volume, ShadowGrid& grid)
        : volume_(volume), grid_(grid),
          voxelCounts_(volume.voxels->size.x, volume.voxels->size.y, volume.voxels->size.z)
    {
        for (const glm::dvec4& plane : volume.clipPlanes)
            clipPlanes_.push_back(plane * volume.worldFromLocal);
        needsNormals_ = std::ranges::any_of(volume.chains, needNormals);
        if (volume.tetras) tetras_.emplace(*volume.tetras, grid);
        const glm::vec3 edges = volume.dimensions / voxelCounts_;
        shortestEdge_ = std::min({edges.x, edges.y, edges.z});
    }

    void fillSlice(int z) const
    {
        const TetraSlice slice = tetras_ ? tetras_->slice(z) : TetraSlice();
        for (int y = 0; y < grid_.size.y; ++y)
            for (int first = 0; first < grid_.size.x; first += kBatchSize) {
                const VoxelSize& size = grid_.size;
                RowBatch row;
                row.samples.count = std::min(kBatchSize, size.x - first);
                placeTexels({first, y, z}, row.samples);
                const std::size_t inSlice = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                                            static_cast<std::size_t>(first);
                if (tetras_) moveIntoTetras(slice, inSlice, row);
                const std::size_t before = static_cast<std::size_t>(z) * static_cast<std::size_t>(size.x) *
                                           static_cast<std::size_t>(size.y);
                float* const to = grid_.texels.data() + before + inSlice;
                if (grid_.hasSurfaces)
                    writeValues(row, to);
                else
                    writeDepths(row, to);
            }
    }

private:
    /// Positions of texels from the first on along x, and places in the volume's box.
    void placeTexels(const std::array<int, 3>& first, SampleBatch& batch) const
    {
        const std::array<int, 3> size{grid_.size.x, grid_.size.y, grid_.size.z};
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t i = 0; i < kBatchSize; ++i) {
                const int axis = static_cast<int>(a);
                const float texel = static_cast<float>(first[a]) + (a == 0 ? static_cast<float>(i) : 0.0f);
                batch.place[a][i] = (texel + 0.5f) / static_cast<float>(size[a]);
                batch.position[a][i] = grid_.box.low[axis] + batch.place[a][i] * grid_.box.sides[axis];
            }
    }

    static void moveIntoTetras(const TetraSlice& slice, std::size_t first, RowBatch& row)
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.samples.count); ++i) {
            row.tetras[i] = slice.tetras[first + i];
            for (std::size_t a = 0; a < 3; ++a)
                row.samples.place[a][i] = slice.places[first + i][static_cast<int>(a)];
        }
    }

    void writeValues(RowBatch& row, float* to) const
    {
        SampleBatch& batch = row.samples;
        sampleTexture(*volume_.voxels, batch.count, batch.place, batch.voxel);
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
            to[i] = isThere(row, i) ? batch.voxel[0][i] : std::numeric_limits<float>::quiet_NaN();
    }

    void writeDepths(RowBatch& row, float* to) const
    {
        SampleBatch& batch = row.samples;
        sampleTexture(*volume_.voxels, batch.count, batch.place, batch.voxel);
        if (needsNormals_) findNormalsOf(row);
        lookAlongNormals(batch);
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
            const bool isSeen = opacity[i] > 0.0f && isThere(row, i);
            to[i] = isSeen ? std::min(-std::log(clear) / unit, most) : 0.0f;
        }
    }

    void findNormalsOf(RowBatch& row) const
    {
        if (!volume_.tetras) {
            findNormals(*volume_.voxels, volume_.dimensions, row.samples);
            return;
        }
        findChanges(*volume_.voxels, row.samples);
        BatchVectors& n = row.samples.n;
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.samples.count); ++i) {
            if (row.tetras[i] < 0) continue;
            const auto corners = cornersOf(*volume_.tetras, static_cast<std::size_t>(row.tetras[i]));
            const glm::mat3 placeFromLocal(corners.value().placeFromLocal().value());
            const glm::vec3 change =
                glm::vec3(n[0][i], n[1][i], n[2][i]) * voxelCounts_ * placeFromLocal * shortestEdge_;
            for (std::size_t a = 0; a < 3; ++a)
                n[a][i] = change[static_cast<int>(a)];
        }
        normalsFromChanges(row.samples);
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

    /// In the volume, and not clipped.
    bool isThere(const RowBatch& row, std::size_t i) const
    {
        const auto& [x, y, z] = row.samples.position;
        const glm::dvec4 position(x[i], y[i], z[i], 1.0);
        return row.tetras[i] >= 0 && std::ranges::all_of(clipPlanes_, [&](const glm::dvec4& plane) {
                   return glm::dot(plane, position) >= 0.0;
               });
    }

    const StyledVolume& volume_;
    ShadowGrid& grid_;
    std::vector<glm::dvec4> clipPlanes_; ///< local
    std::optional<TetraSlicer> tetras_;
    glm::vec3 voxelCounts_;
    float shortestEdge_ = 0.0f;
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

} // namespace

std::optional<LocalBox> shadowBoxOf(const StyledVolume& volume)
{
    if (volume.tetras) return boundsOf(*volume.tetras);
    return LocalBox{-0.5f * volume.dimensions, volume.dimensions};
}

float shadowOffset(const ShadowGrid& grid, const glm::vec3& wayToLight)
{
    const glm::vec3 way = glm::normalize(wayToLight);
    return kOffset * std::max(edgeAlong(way, grid.edges), edgeAlong(way, grid.voxelEdges));
}

ShadowGrid emptyShadowGrid(const StyledVolume& volume, const LocalBox& box)
{
    ShadowGrid grid;
    grid.box = box;
    grid.size = gridSize(box.sides);
    grid.edges = gridEdges(box.sides);
    const VoxelSize& voxels = volume.voxels->size;
    grid.voxelEdges = volume.dimensions / glm::vec3(voxels.x, voxels.y, voxels.z);
    return grid;
}

ShadowGrid shadowGridOf(const StyledVolume& volume, int threads)
{
    const std::optional<LocalBox> box = shadowBoxOf(volume);
    if (!box) return {};
    ShadowGrid grid = emptyShadowGrid(volume, *box);
    grid.texels.resize(grid.size.count());
    grid.hasSurfaces = volume.surfaces.has_value();
    if (grid.hasSurfaces) grid.surfaces = surfacesOf(volume);
    const GridFiller filler(volume, grid);
    parallelFor(static_cast<std::size_t>(grid.size.z), threads,
                [&](std::size_t z) { filler.fillSlice(static_cast<int>(z)); });
    return grid;
}

} // namespace vo
