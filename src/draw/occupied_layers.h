#pragma once

#include "cast/clear_blocks.h"
#include "draw/volume_layers.h"
#include "polygonize/slice_occupied.h"

namespace vo {

/// As cutLayers(), of the samples of a box, without what of its planes lies in clear blocks. False: that
/// would be little, and `layers` means nothing. Throws as cutLayers() does.
bool cutOccupiedLayers(const StyledScene& scene, const StyledVolume& volume, const ClearBlocks& clear,
                       OccupiedSlicer& slicer, VolumeLayers& layers);

} // namespace vo
