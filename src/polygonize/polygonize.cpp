#include "polygonize/polygonize.h"

#include "polygonize/box_cutter.h"
#include "polygonize/polygonize_facets.h"
#include "polygonize/polygonize_shells.h"
#include "polygonize/slice_tetra.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace vo {

struct PolygonizeWorkspace::Private
{
    BoxCutter cutter;
    std::vector<double> corners; ///< the records of one tetrahedron
    CutPolygon slice;
};

PolygonizeWorkspace::PolygonizeWorkspace() : d(std::make_unique<Private>()) {}
PolygonizeWorkspace::~PolygonizeWorkspace() = default;

namespace {

/// One tetrahedron, read from the caller's floats: positively oriented, or flat.
struct Corners
{
    std::array<const double*, 4> records;
    std::array<double, 4> offsets; ///< dot(normal, position)
    bool flat;
};

glm::dvec3 positionOf(const double* record, int values)
{
    return {record[values - 3], record[values - 2], record[values - 1]};
}

Corners readTetra(const TetraView& tetras, int tetra, const glm::dvec3& normal, std::vector<double>& storage)
{
    const int values = tetras.valuesPerVertex;
    const auto size = static_cast<std::size_t>(values);
    if (storage.size() < 4 * size) storage.resize(4 * size);
    Corners corners;
    std::array<glm::dvec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
        const float* source = tetras.record(tetras.indices[static_cast<std::size_t>(tetra) * 4 + i]);
        double* record = storage.data() + i * size;
        for (std::size_t value = 0; value < size; ++value)
            record[value] = static_cast<double>(source[value]) + 0.0; // -0 and 0 are one place
        p[i] = positionOf(record, values);
        corners.records[i] = record;
        corners.offsets[i] = glm::dot(normal, p[i]);
    }
    const double volume = glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0]));
    corners.flat = !(std::abs(volume) > 0.0) || !std::isfinite(volume);
    if (volume < 0.0) {
        std::swap(corners.records[0], corners.records[1]);
        std::swap(corners.offsets[0], corners.offsets[1]);
    }
    return corners;
}

class Polygonizer
{
public:
    Polygonizer(const TetraView& tetras, const DepthRange& set, PolygonizeWorkspace::Private& memory,
                FaceSink& sink)
        : tetras_(tetras), nearest_(set.nearest), memory_(memory), sink_(sink)
    {
    }

    /// False: the sink had no room.
    bool sliceWithPlanes(int tetra, const PlaneFamily& planes)
    {
        const Corners corners = readTetra(tetras_, tetra, planes.normal, memory_.corners);
        if (corners.flat) return true;
        const auto [low, high] = std::minmax_element(corners.offsets.begin(), corners.offsets.end());
        // A plane more at either end than rounding may miss; slicing tells which ones meet the tetrahedron.
        const double begin = std::ceil((planes.first - *high) / planes.spacing - 1e-6);
        const double end = std::floor((planes.first - *low) / planes.spacing + 1e-6);
        const int firstPlane = begin > 0.0 ? static_cast<int>(std::min<double>(begin, planes.count)) : 0;
        const int lastPlane = end < planes.count ? static_cast<int>(std::max(end, -1.0)) : planes.count - 1;
        for (int k = firstPlane; k <= lastPlane; ++k) {
            slice(corners, planes.offset(k));
            if (memory_.slice.count == 0) continue;
            if (!memory_.cutter.cut(memory_.slice, k, sink_)) return false;
        }
        return true;
    }

private:
    /// Of two tetrahedra that share a face, the one before the plane (nearer the viewer) yields it. Nothing
    /// lies before the set's nearest plane: there the one behind does.
    void slice(const Corners& corners, double offset)
    {
        auto records = corners.records;
        std::array<double, 4> distances;
        for (std::size_t i = 0; i < 4; ++i)
            distances[i] = corners.offsets[i] - offset;
        if (offset <= nearest_) {
            for (double& distance : distances)
                distance = -distance;
            std::swap(records[0], records[1]);
            std::swap(distances[0], distances[1]);
        }
        sliceTetra(records.data(), distances.data(), tetras_.valuesPerVertex, memory_.slice,
                   tetras_.voxelColumn);
    }

    const TetraView& tetras_;
    double nearest_;
    PolygonizeWorkspace::Private& memory_;
    FaceSink& sink_;
};

} // namespace

PolygonizeResult polygonize(const TetraView& tetras, std::span<const Box> clipBoxes, const Camera& camera,
                            const SamplingRequest& request, PolygonizeWorkspace& workspace, FaceSink& sink)
{
    workspace.d->cutter.assign(clipBoxes);
    if (request.mode == SamplingMode::spherical && camera.perspective) {
        const ShellFamily shells = samplingShells(tetras, camera, request);
        const glm::dvec3 along = shells.frame[0] * shells.scale; // as far as one unit of the scaled space
        const bool complete = polygonizeShells(tetras, shells, request, workspace.d->cutter, sink);
        return {shells.count, shells.spacing * glm::length(along), complete};
    }
    const SamplingAxis axis = samplingAxis(tetras, camera, request);
    const PlaneFamily planes = samplingPlanes(tetras, axis, camera, request);
    PolygonizeResult result{planes.count, planes.spacing, true};

    Polygonizer polygonizer(tetras, axis.set, *workspace.d, sink);
    for (int tetra = 0; tetra < tetras.tetraCount() && result.complete; ++tetra) {
        const bool own = request.space == SamplingSpace::primitive;
        result.complete =
            polygonizer.sliceWithPlanes(tetra, own ? primitivePlanes(tetras, tetra, axis, request) : planes);
    }
    return result;
}

PolygonizeResult polygonize(const TetraView& tetras, std::span<const Box> clipBoxes,
                            const PlaneFamily& planes, PolygonizeWorkspace& workspace, FaceSink& sink)
{
    workspace.d->cutter.assign(clipBoxes);
    PolygonizeResult result{planes.count, planes.spacing, true};
    Polygonizer polygonizer(tetras, rangeOfSet(tetras, planes.normal), *workspace.d, sink);
    for (int tetra = 0; tetra < tetras.tetraCount() && result.complete; ++tetra)
        result.complete = polygonizer.sliceWithPlanes(tetra, planes);
    return result;
}

PolygonizeResult polygonize(const TetraView& tetras, std::span<const Box> clipBoxes, FacetSource& surfaces,
                            int count, PolygonizeWorkspace& workspace, FaceSink& sink)
{
    workspace.d->cutter.assign(clipBoxes);
    return {count, 0.0, polygonizeFacets(tetras, surfaces, count, workspace.d->cutter, sink)};
}

} // namespace vo
