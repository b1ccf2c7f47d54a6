#pragma once

#include "polygonize/polygon_stack.h"
#include "style/styled_scene.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace vo {

class StackSlicer;

/// What of a volume lies on one of its planes: a range of the indices. Of a projection: planes, counted from
/// the farthest; drawn are rays whose first sample is there.
struct SliceLayer
{
    double depth;
    std::size_t first, count;
};

/// Polygons of a volume on its planes. Records are three floats, the position in voxels from the lower corner
/// of the box; those of tetrahedra have a place and placeFromLocal (three columns) before it.
struct VolumeLayers
{
    PolygonStack stack;
    std::vector<SliceLayer> layers; ///< from the farthest
    double lastPlane = 0.0;         ///< the farthest, as sampleDepth() counts them
    double middlePlane = 0.0;
    int valuesPerRecord = 3;
};

/// Local position of positions in voxels.
glm::dmat4 localFromVoxel(const StyledVolume& volume);

/// Cuts a volume by its planes, as far as the projection shows them. Throws std::runtime_error where there
/// are too many.
void cutLayers(const StyledScene& scene, const StyledVolume& volume, StackSlicer& slicer,
               VolumeLayers& layers);
/// Layers of what is drawn ray by ray and has no polygons, at most so many.
void countLayers(const StyledScene& scene, const StyledVolume& volume, std::size_t most,
                 VolumeLayers& layers);
/// The plane of a layer that cutLayers() made, as sampleDepth() counts them.
double planeOf(const SliceLayer& layer, const StyledVolume& volume);

} // namespace vo
