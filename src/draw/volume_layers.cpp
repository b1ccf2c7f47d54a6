#include "draw/volume_layers.h"

#include "draw/scene_view_point.h"
#include "polygonize/slice_stack.h"
#include "style/seen_part.h"
#include "style/tetra_corners.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace vo {

namespace {

constexpr double kMostPlanes = 1 << 20;
constexpr int kTetraValues = 15; ///< place, placeFromLocal, position

glm::dvec3 sizeOf(const StyledVolume& volume)
{
    const VoxelSize& size = volume.voxels->size;
    return {size.x, size.y, size.z};
}

/// Tetrahedra and their records.
struct Body
{
    std::vector<float> records;
    std::vector<int> indices;
    int values = 3;
    Box bounds;

    TetraView view() const { return {records, values, indices, -1}; }
};

Body boxBody(const StyledVolume& volume)
{
    Body body;
    body.bounds = {glm::dvec3(0.0), sizeOf(volume)};
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            body.records.push_back((corner >> axis & 1) ? static_cast<float>(body.bounds.upper[axis]) : 0.0f);
    body.indices = {0, 1, 2, 4, 3, 2, 1, 7, 5, 4, 7, 1, 6, 7, 4, 2, 1, 2, 4, 7};
    return body;
}

/// Those without volume are seen from nowhere.
void appendTetra(const StyledVolume& volume, std::size_t tetra, Body& body)
{
    const std::optional<TetraCorners> corners = cornersOf(*volume.tetras, tetra);
    const std::optional<glm::dmat4> gauge = corners ? corners->placeFromLocal() : std::nullopt;
    if (!gauge) return;
    const auto append = [&body](const glm::dvec3& values) {
        for (int axis = 0; axis < 3; ++axis)
            body.records.push_back(static_cast<float>(values[axis]));
    };
    for (std::size_t i = 0; i < 4; ++i) {
        body.indices.push_back(static_cast<int>(body.indices.size()));
        append(corners->places[i]);
        for (int column = 0; column < 3; ++column)
            append(glm::dvec3((*gauge)[column]));
        const glm::dvec3 voxel =
            (corners->positions[i] / glm::dvec3(volume.dimensions) + 0.5) * sizeOf(volume);
        append(voxel);
        body.bounds.lower = glm::min(body.bounds.lower, voxel);
        body.bounds.upper = glm::max(body.bounds.upper, voxel);
    }
}

Body tetraBody(const StyledVolume& volume)
{
    Body body;
    body.values = kTetraValues;
    for (std::size_t tetra = 0; 4 * tetra + 3 < volume.tetras->indices.size(); ++tetra)
        appendTetra(volume, tetra, body);
    // Cutting to the bounds is to change nothing.
    body.bounds.lower -= 1.0;
    body.bounds.upper += 1.0;
    return body;
}

Body bodyOf(const StyledVolume& volume)
{
    return volume.tetras ? tetraBody(volume) : boxBody(volume);
}

} // namespace

PlaneRange planesOf(const StyledScene& scene, const StyledVolume& volume)
{
    const glm::dvec4 depthRow = depthRowOf(scene, volume.worldFromLocal * localFromVoxel(volume));
    const auto part = seenPart(scene, volume);
    if (!part) return {depthRow, 0.0, -1.0, 0.0, 0.0};
    const double first = std::ceil(part->nearest / volume.spacing - 0.5);
    const double last = std::floor(part->farthest / volume.spacing - 0.5);
    if (last - first >= kMostPlanes)
        throw std::runtime_error("a volume has " + std::to_string(last - first + 1.0) +
                                 " sampling planes, at most " + std::to_string(kMostPlanes) + " are drawn");
    return {depthRow, first, last, part->nearest, part->farthest};
}

PlaneFamily PlaneRange::family(double spacing) const
{
    return {glm::dvec3(depthRow), sampleDepth(spacing, last) - depthRow.w, spacing,
            static_cast<int>(count())};
}

glm::dmat4 localFromVoxel(const StyledVolume& volume)
{
    const glm::dvec3 edge = glm::dvec3(volume.dimensions) / sizeOf(volume);
    return glm::scale(glm::translate(glm::dmat4(1.0), -0.5 * glm::dvec3(volume.dimensions)), edge);
}

void countPlanes(const StyledScene& scene, const StyledVolume& volume, VolumeLayers& layers)
{
    layers.layers.clear();
    const PlaneRange planes = planesOf(scene, volume);
    layers.middlePlane = std::round(0.5 * (planes.first + planes.last));
    if (planes.count() > 0)
        layers.layers.push_back({planes.nearest, 0, planes.count(), planes.farthest - planes.nearest});
}

double planeOf(const SliceLayer& layer, const StyledVolume& volume)
{
    return std::round(layer.depth / volume.spacing - 0.5);
}

void appendLayer(const StyledVolume& volume, const glm::dvec4& depthRow, const PolygonStack::Run& run,
                 VolumeLayers& layers)
{
    const std::size_t record = layers.stack.indices[run.first];
    const float* position =
        layers.stack.records.data() + (record + 1) * static_cast<std::size_t>(layers.valuesPerRecord) - 3;
    const double depth = glm::dot(depthRow, glm::dvec4(position[0], position[1], position[2], 1.0));
    const double spacing = volume.spacing;
    layers.layers.push_back({sampleDepth(spacing, std::round(depth / spacing - 0.5)), run.first, run.count,
                             volume.surfaces ? spacing : 0.0});
}

void cutLayers(const StyledScene& scene, const StyledVolume& volume, StackSlicer& slicer,
               VolumeLayers& layers)
{
    layers.layers.clear();
    const Body body = bodyOf(volume);
    layers.valuesPerRecord = body.values;
    const PlaneRange range = planesOf(scene, volume);
    if (range.count() == 0) return;
    const Box box = body.bounds;
    if (!slicer
             .slice(body.view(), {&box, 1}, range.family(volume.spacing), StackOrder::bySample, 0,
                    layers.stack)
             .complete)
        throw std::runtime_error("a volume has more slices than fit into memory");
    for (const PolygonStack::Run& run : layers.stack.runs)
        appendLayer(volume, range.depthRow, run, layers);
}

} // namespace vo
