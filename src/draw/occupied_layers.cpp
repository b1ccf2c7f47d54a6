#include "draw/occupied_layers.h"

#include "cast/padded_voxels.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

/// An edge of a triangle costs as much as fragments over so many voxels squared do for each voxel of its
/// length.
constexpr double kCostOfEdge = 0.25;
constexpr double kLeastGain = 0.9;

/// Blocks begin so far, in voxels, before the voxels do.
double blockShift(const StyledVolume& volume)
{
    return PaddedVoxels::kPadding - (volume.voxels->nearest ? 0.0 : 0.5);
}

OccupiedCells cellsOf(const ClearBlocks& clear)
{
    OccupiedCells cells;
    cells.side = 1 << PaddedVoxels::kBlockShift;
    cells.count = {clear.count().x, clear.count().y, clear.count().z};
    cells.occupied.resize(cells.count.count());
    std::transform(clear.distances().begin(),
                   clear.distances().begin() + static_cast<std::ptrdiff_t>(cells.occupied.size()),
                   cells.occupied.begin(), [](std::uint8_t distance) { return distance == 0 ? 1 : 0; });
    return cells;
}

/// Runs of the triangles that lie in one plane each.
void appendLayers(const StyledVolume& volume, const glm::dvec4& depthRow, VolumeLayers& layers)
{
    const PolygonStack& stack = layers.stack;
    const auto planeOfTriangle = [&](std::size_t first) {
        const float* position = stack.records.data() + 3 * std::size_t{stack.indices[first]};
        const double depth = glm::dot(depthRow, glm::dvec4(position[0], position[1], position[2], 1.0));
        return std::round(depth / volume.spacing - 0.5);
    };
    for (std::size_t first = 0; first < stack.indices.size();) {
        const double plane = planeOfTriangle(first);
        std::size_t end = first + 3;
        while (end < stack.indices.size() && planeOfTriangle(end) == plane)
            end += 3;
        appendLayer(volume, depthRow, {0, first, end - first}, layers);
        first = end;
    }
}

} // namespace

bool cutOccupiedLayers(const StyledScene& scene, const StyledVolume& volume, const ClearBlocks& clear,
                       OccupiedSlicer& slicer, VolumeLayers& layers)
{
    layers.layers.clear();
    layers.stack.clear();
    layers.valuesPerRecord = 3;
    const PlaneRange range = planesOf(scene, volume);
    if (range.count() == 0) return true;
    const double shift = blockShift(volume);
    const VoxelSize& size = volume.voxels->size;
    const Box box{glm::dvec3(shift), shift + glm::dvec3(size.x, size.y, size.z)};
    PlaneFamily planes = range.family(volume.spacing);
    planes.first += glm::dot(planes.normal, glm::dvec3(shift));
    OccupiedSlices slices;
    if (!slicer.slice(box, {&box, 1}, cellsOf(clear), planes, slices)) return false;
    if (slices.area + kCostOfEdge * slices.perimeter > kLeastGain * slices.wholeArea) return false;
    layers.stack.records.resize(slices.positions.size());
    std::ranges::transform(slices.positions, layers.stack.records.all().begin(),
                           [shift](float at) { return static_cast<float>(at - shift); });
    layers.stack.indices.resize(slices.indices.size());
    std::ranges::copy(slices.indices, layers.stack.indices.all().begin());
    appendLayers(volume, range.depthRow, layers);
    return true;
}

} // namespace vo
