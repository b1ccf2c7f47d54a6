#pragma once

#include "polygonize/polygon_stack.h"
#include "polygonize/sampling_planes.h"
#include "style/styled_scene.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace vo {

class StackSlicer;

/// What of a volume is drawn at once: a range of the indices, of one of its planes; of what is drawn ray by
/// ray, all of it.
struct SliceLayer
{
    double depth;
    std::size_t first, count;
    /// What is seen lies at `depth`, or up to this far behind it.
    double reach = 0.0;
};

/// Polygons of a volume on its planes. Records are three floats, the position in voxels from the lower corner
/// of the box; those of tetrahedra have a place and placeFromLocal (three columns) before it.
struct VolumeLayers
{
    PolygonStack stack;
    std::vector<SliceLayer> layers; ///< from the farthest
    double middlePlane = 0.0;       ///< as sampleDepth() counts them
    int valuesPerRecord = 3;
};

/// The planes that meet a volume, as sampleDepth() counts them; depthRow is that of its voxels.
struct PlaneRange
{
    glm::dvec4 depthRow;
    double first, last;
    double nearest, farthest; ///< of what is seen of it

    std::size_t count() const { return first <= last ? static_cast<std::size_t>(last - first) + 1 : 0; }
    /// In voxels. There is one at least.
    PlaneFamily family(double spacing) const;
};

/// As far as the projection shows them. Throws std::runtime_error where there are too many.
PlaneRange planesOf(const StyledScene& scene, const StyledVolume& volume);

/// Local position of positions in voxels.
glm::dmat4 localFromVoxel(const StyledVolume& volume);

/// Cuts a volume by its planes, as far as the projection shows them. Surfaces of values lie between one and
/// the next. Throws std::runtime_error where there are too many.
void cutLayers(const StyledScene& scene, const StyledVolume& volume, StackSlicer& slicer,
               VolumeLayers& layers);
/// One layer for what is drawn ray by ray and has no polygons, or none.
void countPlanes(const StyledScene& scene, const StyledVolume& volume, VolumeLayers& layers);
/// A run of the indices that lies in one of the planes becomes a layer.
void appendLayer(const StyledVolume& volume, const glm::dvec4& depthRow, const PolygonStack::Run& run,
                 VolumeLayers& layers);
/// The plane of a layer that cutLayers() made, as sampleDepth() counts them.
double planeOf(const SliceLayer& layer, const StyledVolume& volume);

} // namespace vo
