#include "style/tetra_slice.h"

#include "style/tetra_corners.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// Of weights of corners: no centre falls between two tetrahedra that share a face.
constexpr double kSlack = 1e-9;

/// Texels from the first to the last.
struct TexelRange
{
    int first, last;
};

double centerOf(const ShadowGrid& grid, int axis, int texel)
{
    return static_cast<double>(grid.box.low[axis]) + (texel + 0.5) * static_cast<double>(grid.edges[axis]);
}

/// Those along an axis whose centres may lie in the tetrahedron.
TexelRange rangeOf(const TetraCorners& corners, const ShadowGrid& grid, int axis, int count)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const glm::dvec3& corner : corners.positions) {
        low = std::min(low, corner[axis]);
        high = std::max(high, corner[axis]);
    }
    const auto texelAt = [&](double position) {
        const double texel = std::floor((position - static_cast<double>(grid.box.low[axis])) /
                                        static_cast<double>(grid.edges[axis]));
        return static_cast<int>(std::clamp(texel, 0.0, static_cast<double>(count - 1)));
    };
    return {texelAt(low), texelAt(high)};
}

void addTetra(const TetraCorners& corners, int tetra, const ShadowGrid& grid, int z, TetraSlice& slice)
{
    const glm::dmat3 weightsFromEdges = glm::inverse(corners.edges());
    const std::array<glm::dvec3, 4>& places = corners.places;
    const glm::dmat3 placeEdges(places[1] - places[0], places[2] - places[0], places[3] - places[0]);
    const TexelRange across = rangeOf(corners, grid, 0, grid.size.x);
    const TexelRange up = rangeOf(corners, grid, 1, grid.size.y);
    for (int y = up.first; y <= up.last; ++y)
        for (int x = across.first; x <= across.last; ++x) {
            const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.size.x) +
                               static_cast<std::size_t>(x);
            if (slice.tetras[texel] >= 0) continue;
            const glm::dvec3 center(centerOf(grid, 0, x), centerOf(grid, 1, y), centerOf(grid, 2, z));
            const glm::dvec3 weights = weightsFromEdges * (center - corners.positions[0]);
            if (!(std::min({weights.x, weights.y, weights.z, 1.0 - weights.x - weights.y - weights.z}) >=
                  -kSlack))
                continue;
            slice.tetras[texel] = tetra;
            slice.places[texel] = places[0] + placeEdges * weights;
        }
}

} // namespace

TetraSlicer::TetraSlicer(const StyledTetras& tetras, const ShadowGrid& grid)
    : tetras_(tetras), grid_(grid), near_(static_cast<std::size_t>(grid.size.z))
{
    for (std::size_t tetra = 0; 4 * tetra + 4 <= tetras.indices.size(); ++tetra) {
        const std::optional<TetraCorners> corners = cornersOf(tetras, tetra);
        if (!corners || !corners->placeFromLocal()) continue;
        const TexelRange slices = rangeOf(*corners, grid, 2, grid.size.z);
        for (int z = slices.first; z <= slices.last; ++z)
            near_[static_cast<std::size_t>(z)].push_back(static_cast<int>(tetra));
    }
}

TetraSlice TetraSlicer::slice(int z) const
{
    const std::size_t texels =
        static_cast<std::size_t>(grid_.size.x) * static_cast<std::size_t>(grid_.size.y);
    TetraSlice slice{std::vector(texels, -1), std::vector(texels, glm::vec3(0.0f))};
    for (const int tetra : near_[static_cast<std::size_t>(z)])
        addTetra(*cornersOf(tetras_, static_cast<std::size_t>(tetra)), tetra, grid_, z, slice);
    return slice;
}

std::optional<LocalBox> boundsOf(const StyledTetras& tetras)
{
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t tetra = 0; 4 * tetra + 4 <= tetras.indices.size(); ++tetra) {
        const std::optional<TetraCorners> corners = cornersOf(tetras, tetra);
        if (!corners || !corners->placeFromLocal()) continue;
        for (const glm::dvec3& corner : corners->positions) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    const LocalBox box{low, high - low};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.sides[axis] > 0.0f) || !std::isfinite(box.sides[axis])) return {};
    return box;
}

} // namespace vo
