#pragma once

#include "polygonize/polygon_stack.h"
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

/// Local position of positions in voxels.
glm::dmat4 localFromVoxel(const StyledVolume& volume);

/// Cuts a volume by its planes, as far as the projection shows them. Surfaces of values lie between one and
/// the next. Throws std::runtime_error where there are too many.
void cutLayers(const StyledScene& scene, const StyledVolume& volume, StackSlicer& slicer,
               VolumeLayers& layers);
/// One layer for what is drawn ray by ray and has no polygons, or none.
void countPlanes(const StyledScene& scene, const StyledVolume& volume, VolumeLayers& layers);
/// The plane of a layer that cutLayers() made, as sampleDepth() counts them.
double planeOf(const SliceLayer& layer, const StyledVolume& volume);

} // namespace vo
